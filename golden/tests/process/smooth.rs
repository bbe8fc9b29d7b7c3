//! Smoothing by predictions on neighbors' planes, against exponentials of f64.

use super::surfaces::{SURFACES, places};
use super::{FORMATS, Format, Operator, Point, random, unit};
use glam::DVec3;
use pointcore_golden::reference::operators::smooth::prediction;

/// The neighbors with areas behind their normals.
fn with_areas(cloud: Vec<Point>, area: impl Fn(usize) -> f64) -> Vec<Point> {
    let mut cloud = cloud;
    cloud.iter_mut().enumerate().for_each(|(index, point)| point.attributes.push(area(index)));
    cloud
}

#[test]
fn predictions_are_those_of_f64() {
    let mut random = random();
    for format in FORMATS {
        for place in places() {
            let size = place.size * place.scale;
            let operator = Operator::new("smooth", format, &[4.0 / (size * size), 60.0 / (size * size)]);
            for shape in SURFACES {
                let mut sharp = 0;
                for _ in 0..20 {
                    let (query, cloud) = shape.neighborhood(&mut random, format, place);
                    let cloud = with_areas(cloud, |index| [0.5, 1.0, 2.0][index % 3]);
                    let settings = [operator.setting(0), operator.setting(1)];
                    let (step, bound) = prediction(query.position, &cloud, settings, unit(format));
                    let outputs = operator.run(&query, &cloud, 1);
                    let off = outputs.vector("position").distance(query.position + step);
                    assert!(outputs.flag("valid") && off <= bound, "{shape:?} in {format}: off by {off}, not {bound}");
                    sharp += usize::from(bound < (0.01 + 256.0 * unit(format)) * size);
                }
                // Where hardly a neighbor is on the query's plane, all weights are of the order of the table's last
                // place.
                assert!(sharp > 10, "{shape:?} at {place:?} in {format}: only {sharp} bounds say much");
            }
        }
    }
}

/// Beside an edge, the plane on the query's own side decides, where a mean of positions would round it off.
#[test]
fn edges_stay() {
    let operator = Operator::new("smooth", Format::F32, &[1.0, 500.0]);
    let mut cloud = vec![];
    for i in 0..10 {
        for j in 0..10 {
            let (x, y) = (f64::from(i) * 0.1, f64::from(j) * 0.1);
            cloud.push(Point::with_normal(DVec3::new(x, y, 0.0), DVec3::Z));
            cloud.push(Point::with_normal(DVec3::new(0.0, y, -x), -DVec3::X));
        }
    }
    let cloud = with_areas(cloud, |_| 0.01);
    let query = Point { position: DVec3::new(0.3, 0.5, 0.01), attributes: vec![] };
    let position = operator.run(&query, &cloud, 1).vector("position");
    assert!(position.z.abs() < 0.001 && (position.x - 0.3).abs() < 0.001, "{position}");
}

#[test]
fn without_weight_a_point_stays_where_it_is() {
    let operator = Operator::new("smooth", Format::F32, &[1.0, 1.0]);
    let query = Point { position: DVec3::new(0.5, 0.25, 0.0), attributes: vec![] };
    let at = |x: f64, normal: DVec3, area: f64| {
        let mut point = Point::with_normal(query.position + DVec3::X * x, normal);
        point.attributes.push(area);
        point
    };
    let cases = [
        ("no neighbors", vec![]),
        ("far away", vec![at(5.0, DVec3::X, 1.0)]),
        ("no area", vec![at(0.5, DVec3::X, 0.0)]),
        ("a normal that is no number", vec![at(0.5, DVec3::X * f64::NAN, 1.0), at(0.25, DVec3::X, 1.0)]),
        ("a normal without end", vec![at(0.5, DVec3::X * f64::INFINITY, 1.0), at(0.25, DVec3::X, 1.0)]),
        ("an area that is no number", vec![at(0.5, DVec3::X, f64::NAN), at(0.25, DVec3::X, 1.0)]),
    ];
    for (what, cloud) in cases {
        let outputs = operator.run(&query, &cloud, 1);
        assert_eq!((outputs.flag("valid"), outputs.vector("position")), (false, query.position), "{what}");
    }
}
