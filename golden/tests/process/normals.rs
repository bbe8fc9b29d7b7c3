//! Normals: the direction of `covariance`, on the side of the viewpoint.

use super::covariance::LEAST_SPREAD;
use super::surfaces::{SURFACES, Shape, places};
use super::{FORMATS, Operator, decode, random, unit};
use glam::DVec3;

#[test]
fn normals_are_those_of_covariance_towards_the_viewpoint() {
    let mut random = random();
    let mut turned = [0; 2];
    for format in FORMATS {
        for place in places() {
            let radius = 1.1 * place.size * place.scale;
            let shared = [1.0 / (radius * radius), LEAST_SPREAD];
            let viewpoint = DVec3::new(3.0, 2.0, -4.0) * place.scale;
            let settings = [&shared[..], &viewpoint.to_array()].concat();
            let (normals, covariance) =
                (Operator::new("normals", format, &settings), Operator::new("covariance", format, &shared));
            let viewpoint = DVec3::from_array([2, 3, 4].map(|index| decode(format, normals.settings[index])));
            for shape in SURFACES {
                for _ in 0..10 {
                    let (query, cloud) = shape.neighborhood(&mut random, format, place);
                    let (found, unoriented) = (normals.run(&query, &cloud, 1), covariance.run(&query, &cloud, 1));
                    let (normal, direction) = (found.vector("normal"), unoriented.vector("normal"));
                    assert!(normal == direction || normal == -direction, "{normal} is not ±{direction}");
                    assert_eq!(found.flag("valid"), unoriented.flag("valid"));
                    assert_eq!(found.number("variation"), unoriented.number("variation"));
                    turned[usize::from(normal != direction)] += 1;
                    // A product of two vectors of three components, one of them a difference: six roundings.
                    let view = viewpoint - query.position;
                    let bound = -6.0 * unit(format) * view.length();
                    assert!(normal.dot(view) >= bound, "{shape:?}: {normal} is turned away from {view}");
                }
            }
        }
    }
    assert!(turned[0] > 50 && turned[1] > 50, "{turned:?} normals were kept and turned");
}

#[test]
fn a_line_has_no_normal() {
    let mut random = random();
    for place in places() {
        let radius = 1.1 * place.size * place.scale;
        let settings = [1.0 / (radius * radius), LEAST_SPREAD, 0.0, 0.0, 9.0];
        let operator = Operator::new("normals", super::Format::F32, &settings);
        let (query, cloud) = Shape::Line.neighborhood(&mut random, super::Format::F32, place);
        let outputs = operator.run(&query, &cloud, 1);
        assert_eq!((outputs.flag("valid"), outputs.vector("normal")), (false, DVec3::ZERO));
    }
}
