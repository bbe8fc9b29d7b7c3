//! Projection onto algebraic spheres: spheres come back, and every iteration is that of f64.

use super::surfaces::{Place, SURFACES, Shape, far, places};
use super::{FORMATS, Format, Operator, Point, random, rounded, unit};
use glam::DVec3;
use pointcore_golden::reference::operators::sphere::Fit;
use pointcore_golden::reference::operators::weights::Sums;

#[test]
fn every_iteration_is_that_of_f64() {
    let mut random = random();
    let mut compared = 0;
    for format in FORMATS {
        let u = unit(format);
        let far = (format.mantissa == Format::F32.mantissa).then(far);
        for place in places().into_iter().chain(far) {
            let radius = 1.3 * place.size * place.scale;
            for half_beta in [0.5, 0.25, 0.0] {
                let operator = Operator::new("apss", format, &[1.0 / (radius * radius), half_beta, 0.0]);
                for shape in SURFACES {
                    for _ in 0..5 {
                        let (start, cloud) = shape.neighborhood(&mut random, format, place);
                        let mut query = start.position;
                        for count in 1..=3 {
                            let outputs = operator.run(&start, &cloud, count);
                            if outputs.outcome.iterations < count {
                                break;
                            }
                            let fit = Fit::new(query, &cloud, operator.setting(0), half_beta);
                            let sums = Sums::new(query, &cloud, operator.setting(0));
                            let foot = query - fit.step() * fit.g.normalize();
                            let bound = fit.error(query, &sums, half_beta, u);
                            let found = outputs.vector("position");
                            let what = format!("{shape:?} at {place:?} in {format}, iteration {count}");
                            assert!(outputs.flag("valid"), "{what}");
                            assert!(found.distance(foot) <= bound, "{what}: {found}, not {foot} within {bound}");
                            // Far below what a plane instead of a sphere, or another weight, would make.
                            let own = bound - 2.0 * u * query.length();
                            let share = own / (place.size * place.scale);
                            assert!(share < 65536.0 * u, "{what}: the bound {bound} says little");
                            compared += 1;
                            query = found;
                        }
                    }
                }
            }
        }
    }
    assert!(compared > 900, "only {compared} iterations were compared");
}

/// Of points on a sphere with its normals, half of the last places of points and normals, all their sums, and where the
/// query stands: eight units in the last place of the largest coordinate.
#[test]
fn spheres_come_back_within_eight_units_in_the_last_place() {
    let mut random = random();
    for format in FORMATS {
        for (radius, center) in
            [(1.0, DVec3::ZERO), (0.37, DVec3::new(1.0, -2.0, 0.5)), (4e3, DVec3::new(1e3, 0.0, 9e3))]
        {
            let place = Place { points: 30, size: 0.6, scale: radius, origin: center };
            let inverse_radius2 = 1.0 / (0.8 * radius).powi(2);
            let operator = Operator::new("apss", format, &[inverse_radius2, 0.5, 0.0]);
            for _ in 0..100 {
                let (query, cloud) = Shape::Sphere.neighborhood(&mut random, format, place);
                let outputs = operator.run(&query, &cloud, 5);
                assert!(outputs.flag("valid"));
                let position = outputs.vector("position");
                let largest = (position.abs().max_element()).max(radius);
                let last_place = 2.0 * unit(format) * largest.log2().floor().exp2();
                let off = ((position - center).length() - radius).abs() / last_place;
                assert!(off <= 8.0, "{off} units in the last place off a sphere of radius {radius} in {format}");
                let normal = (position - center) / radius;
                let turn = outputs.vector("normal").distance(normal);
                assert!(turn < 1e3 * last_place / radius, "the normal is off by {turn} in {format}");
            }
        }
    }
}

#[test]
fn neighbors_at_one_place_have_no_curvature() {
    let operator = Operator::new("apss", Format::F32, &[1.0, 0.5, 1e-6]);
    let query = Point { position: DVec3::new(0.5, 0.5, 0.5), attributes: vec![] };
    let place = rounded(Format::F32, DVec3::new(0.75, 0.5, 0.5));
    let cloud = vec![Point::with_normal(place, DVec3::X); 5];
    let outputs = operator.run(&query, &cloud, 9);
    assert!(outputs.flag("valid"));
    assert_eq!((outputs.vector("position"), outputs.number("curvature")), (place, 0.0));
}
