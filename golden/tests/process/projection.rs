//! Projection onto planes, for surfaces and for patterns on them, iteration by iteration against f64.

use super::surfaces::{SURFACES, Shape, far, places};
use super::{FORMATS, Format, Operator, Point, decode, encode, random, unit};
use glam::DVec3;
use pointcore_golden::reference::operators::plane::{normal_error, plane};
use pointcore_golden::reference::operators::weights::Sums;

/// Iterations that are compared.
const ITERATIONS: u32 = 4;

#[test]
fn every_iteration_is_that_of_f64() {
    let mut random = random();
    let mut compared = 0;
    for format in FORMATS {
        let u = unit(format);
        let far = (format.mantissa == Format::F32.mantissa).then(far);
        for place in places().into_iter().chain(far) {
            let radius = 1.3 * place.size * place.scale;
            let operator = Operator::new("mls", format, &[1.0 / (radius * radius), 1e-9 * place.scale]);
            for shape in SURFACES {
                for _ in 0..10 {
                    let (start, cloud) = shape.neighborhood(&mut random, format, place);
                    let mut query = start.position;
                    for count in 1..=ITERATIONS {
                        let outputs = operator.run(&start, &cloud, count);
                        if outputs.outcome.iterations < count {
                            break;
                        }
                        let (mean, normal) = plane(query, &cloud, operator.setting(0));
                        let foot = start.position + normal * normal.dot(mean - start.position);
                        let sums = Sums::new(query, &cloud, operator.setting(0));
                        let turn = u * normal_error(query, &cloud, operator.setting(0));
                        // The mean's error, the normal's times what is projected, once for the length and once for the
                        // direction; seven roundings of it, and one of the position.
                        let reach = (mean - start.position).length();
                        let bound = u * 2.0 * sums.mean_error()
                            + (2.0 * turn + 7.0 * u) * reach
                            + 3.0 * u * start.position.length();
                        let found = outputs.vector("position");
                        let what = format!("{shape:?} at {place:?} in {format}, iteration {count}");
                        assert!(outputs.flag("valid"), "{what}");
                        assert!(found.distance(foot) <= bound, "{what}: {found}, not {foot} within {bound}");
                        assert!(outputs.vector("normal").distance(normal) <= turn, "{what}: normal");
                        let residual = (outputs.number("residual") - normal.dot(mean - query)).abs();
                        assert!(residual <= bound, "{what}: the residual is off by {residual}");
                        compared += 1;
                        query = found;
                    }
                }
            }
        }
    }
    assert!(compared > 500, "only {compared} iterations were compared");
}

/// All points and their mean are on the plane, up to the rounding of coordinates; so is what is projected onto it.
#[test]
fn a_plane_is_its_own_surface_and_ends_the_iteration() {
    let mut random = random();
    for format in FORMATS {
        for place in places() {
            let radius = 1.3 * place.size * place.scale;
            let u = unit(format);
            let operator = Operator::new("mls", format, &[1.0 / (radius * radius), 64.0 * u * place.scale]);
            for _ in 0..20 {
                let (query, cloud) = Shape::Plane.neighborhood(&mut random, format, place);
                let outputs = operator.run(&query, &cloud, 20);
                let outcome = &outputs.outcome;
                assert!(!outcome.capped && outcome.iterations <= 3, "{outcome:?} in {format}");
                let normal = DVec3::new(0.3, -0.5, 0.8).normalize();
                let distance = outputs.vector("position").dot(normal).abs();
                assert!(distance < 8.0 * u * place.scale, "{distance} from the plane in {format} at {place:?}");
            }
        }
    }
}

#[test]
fn iterations_that_do_not_converge_are_capped() {
    let operator = Operator::new("mls", Format::F32, &[1.0, -1.0]);
    let (query, cloud) = Shape::Sphere.neighborhood(&mut random(), Format::F32, places()[0]);
    let outcome = operator.outcome(&query, &cloud, 7);
    assert_eq!((outcome.iterations, outcome.capped), (7, true), "no distance is below −1");
}

#[test]
fn without_weight_or_direction_a_query_stays_where_it_is() {
    for (name, settings) in [("mls", &[1.0, 0.0][..]), ("resample", &[1.0, 0.0]), ("apss", &[1.0, 0.5, 0.0])] {
        let operator = Operator::new(name, Format::F32, settings);
        let attributes = if name == "resample" { vec![0.25, 0.5] } else { vec![] };
        let query = Point { position: DVec3::new(0.5, 0.25, 0.125), attributes };
        let at = |x: f64, normal: DVec3| Point::with_normal(query.position + DVec3::X * x, normal);
        let nan = DVec3::new(0.0, f64::NAN, 0.0);
        let cases = [
            ("no neighbors", vec![]),
            ("beyond the radius", vec![at(1.0, DVec3::Z), at(3.0, DVec3::Z)]),
            ("normals that cancel", vec![at(0.5, DVec3::Z), at(-0.5, -DVec3::Z)]),
            ("a normal that is no number", vec![at(0.5, DVec3::Z), at(-0.5, nan)]),
            ("a normal without end", vec![at(0.5, DVec3::Z), at(-0.5, DVec3::X * f64::INFINITY)]),
            ("a position that is no number", vec![at(0.5, DVec3::Z), at(f64::NAN, DVec3::Z)]),
        ];
        for (what, cloud) in cases {
            let outputs = operator.run(&query, &cloud, 9);
            assert!(!outputs.flag("valid"), "{name}: {what}");
            assert_eq!(outputs.vector("position"), query.position, "{name}: {what}");
            assert_eq!(outputs.vector("normal"), DVec3::ZERO, "{name}: {what}");
            assert_eq!((outputs.outcome.iterations, outputs.outcome.capped), (1, false), "{name}: {what}");
        }
    }
}

/// The first iteration's place in the pattern: at the offsets from the foot, along two tangents at right angles.
#[test]
fn patterns_lie_on_the_tangent_plane_and_then_on_the_surface() {
    let mut random = random();
    for format in FORMATS {
        let u = unit(format);
        for place in places() {
            let radius = 1.3 * place.size * place.scale;
            let operator = Operator::new("resample", format, &[1.0 / (radius * radius), 0.0]);
            for shape in SURFACES {
                for _ in 0..10 {
                    let (mut query, cloud) = shape.neighborhood(&mut random, format, place);
                    let offsets = [random.f64() - 0.5, random.f64() - 0.5].map(|x| 0.2 * x * place.size * place.scale);
                    query.attributes = offsets.map(|x| decode(format, encode(format, x))).to_vec();
                    let (mean, normal) = plane(query.position, &cloud, operator.setting(0));
                    let sums = Sums::new(query.position, &cloud, operator.setting(0));
                    let turn = u * normal_error(query.position, &cloud, operator.setting(0));
                    let outputs = operator.run(&query, &cloud, 1);
                    let foot = query.position + normal * normal.dot(mean - query.position);
                    let offset = outputs.vector("position") - foot;
                    let length = query.attributes[0].hypot(query.attributes[1]);
                    // As for `mls`; the frame's derivatives by the normal are at most 3, and it has eight roundings.
                    let bound = u * 2.0 * sums.mean_error()
                        + (2.0 * turn + 7.0 * u) * (mean - query.position).length()
                        + (6.0 * turn + 8.0 * u) * length
                        + 4.0 * u * query.position.length();
                    let what = format!("{shape:?} at {place:?} in {format}");
                    assert!((offset.length() - length).abs() <= bound, "{what}: {offset} is not {length} long");
                    assert!(offset.dot(normal).abs() <= bound, "{what}: {offset} is not on the plane");
                    let again = operator.run(&query, &cloud, 2);
                    let (mean, normal) = plane(outputs.vector("position"), &cloud, operator.setting(0));
                    let surface = again.vector("position");
                    assert!((surface - mean).dot(normal).abs() <= 2.0 * bound, "{what}: not on the plane there");
                }
            }
        }
    }
}

/// Two queries with one offset each span the pattern: their tangents are at right angles.
#[test]
fn tangents_are_at_right_angles() {
    let mut random = random();
    for _ in 0..100 {
        let (query, cloud) = Shape::Sphere.neighborhood(&mut random, Format::F32, places()[0]);
        let operator = Operator::new("resample", Format::F32, &[2.0, 0.0]);
        let at = |u: f64, v: f64| {
            let query = Point { position: query.position, attributes: vec![u, v] };
            operator.run(&query, &cloud, 1).vector("position")
        };
        let (foot, first, second) = (at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0));
        let (first, second) = (first - foot, second - foot);
        // Twelve roundings of components of at most 2.
        let bound = 24.0 * unit(Format::F32);
        assert!(first.dot(second).abs() < bound && (first.length() - 1.0).abs() < bound, "{first}, {second}");
    }
}
