//! Covariance and its smallest eigenvector against Jacobi's method in f64.

use super::surfaces::{ALL, Place, SURFACES, Shape, far, places};
use super::{FORMATS, Operator, Point, random, rounded, unit};
use glam::DVec3;
use pointcore_golden::reference::operators::covariance::{angle_error, covariance, eigen, matrix_error, trace};
use pointcore_golden::reference::operators::weights::Sums;

/// Sum of products of shares below which a neighborhood counts as a line.
pub const LEAST_SPREAD: f64 = 1.0 / 256.0;

fn check(shape: Shape, place: Place, operator: &Operator, query: &Point, cloud: &[Point]) -> Option<bool> {
    let (u, inverse_radius2) = (unit(operator.format), operator.setting(0));
    let outputs = operator.run(query, cloud, 1);
    let (mean, matrix) = covariance(query.position, cloud, inverse_radius2);
    let pairs = eigen(matrix);
    let values = pairs.map(|(value, _)| value);
    let sums = Sums::new(query.position, cloud, inverse_radius2);
    let entries = matrix_error(&sums, trace(query.position, mean, cloud, inverse_radius2), u);
    let what = format!("{shape:?} at {place:?} in {}, eigenvalues {values:?}", operator.format);

    let mean_bound = u * (2.0 * sums.mean_error() + 2.0 * query.position.length());
    let mean_error = outputs.vector("mean").distance(mean);
    assert!(mean_error <= mean_bound, "{what}: mean off by {mean_error}, not {mean_bound}");

    let spread = values[0] * values[1] + values[0] * values[2] + values[1] * values[2];
    let spread_error = 12.0 * entries + 12.0 * u;
    if (spread - LEAST_SPREAD).abs() > spread_error {
        assert_eq!(outputs.flag("valid"), spread > LEAST_SPREAD, "{what}");
    }
    let normal = outputs.vector("normal");
    if !outputs.flag("valid") {
        assert_eq!((normal, outputs.number("variation")), (DVec3::ZERO, 0.0), "{what}");
        return None;
    }
    assert!((normal.length() - 1.0).abs() <= 5.0 * u, "{what}: {normal} is not of length 1");
    assert!(normal.max_element() >= -normal.min_element(), "{what}: {normal} has a negative largest component");
    let bound = angle_error(values, entries, u);
    let angle = normal.cross(pairs[0].1).length();
    assert!(angle <= bound, "{what}: direction off by {angle}, not {bound}");
    // Roundings rarely conspire: where the second direction is gone, 2u in relation to the gap is the most that was
    // measured.
    let gap = values[2] * (values[1] - values[0]);
    let is_sharp = values[0] < 0.3 * values[1];
    assert!(!is_sharp || angle <= 8.0 * u / gap, "{what}: direction off by {angle}, unusual at a gap of {gap}");
    // However close the eigenvalues are: of x = r³², the rest of the second direction, the column has at most x²/(1/3 −
    // x) in relation, and all of it from x = 1/3 on. Its share is above the least by 1/r − 1 = x^(−1/32) − 1: by 1/20
    // at most.
    let share = normal.dot(matrix * normal) / normal.length_squared();
    let excess = share - values[0];
    let backward = 60.0 * (entries + u) / values[2].sqrt();
    assert!(excess <= values[0] / 20.0 + backward, "{what}: the share is {excess} above the least");
    let share_error = (outputs.number("variation") - share).abs();
    assert!(share_error <= 9.0 * entries + 12.0 * u, "{what}: the share is off by {share_error}");
    Some(is_sharp)
}

#[test]
fn directions_and_shares_are_those_of_f64() {
    let mut random = random();
    for format in FORMATS {
        for place in places() {
            let radius = 1.1 * place.size * place.scale;
            let operator = Operator::new("covariance", format, &[1.0 / (radius * radius), LEAST_SPREAD]);
            for shape in ALL {
                let mut sharp = vec![];
                for _ in 0..20 {
                    let (query, cloud) = shape.neighborhood(&mut random, format, place);
                    sharp.extend(check(shape, place, &operator, &query, &cloud));
                }
                match shape {
                    Shape::Line => assert!(sharp.is_empty(), "a line has no normal"),
                    Shape::Noise => assert!(!sharp.is_empty(), "noise has a direction, if a bad one"),
                    _ => {
                        let count = sharp.iter().filter(|&&is_sharp| is_sharp).count();
                        assert!(count > 10, "{shape:?} at {place:?} in {format}: only {count} are like planes");
                    }
                }
            }
        }
    }
}

#[test]
fn far_from_the_origin_nothing_cancels() {
    let mut random = random();
    for shape in SURFACES {
        let place = far();
        let operator = Operator::new("covariance", super::Format::F32, &[1.0 / 0.3, LEAST_SPREAD]);
        for _ in 0..20 {
            let (query, cloud) = shape.neighborhood(&mut random, super::Format::F32, place);
            check(shape, place, &operator, &query, &cloud);
        }
    }
}

#[test]
fn what_has_no_direction_is_not_valid() {
    let format = super::Format::F32;
    let operator = Operator::new("covariance", format, &[1.0, LEAST_SPREAD]);
    let query = Point { position: DVec3::ONE, attributes: vec![] };
    let at = |position: DVec3| Point::with_normal(rounded(format, position), DVec3::Z);
    let same = vec![at(DVec3::ONE + 0.25 * DVec3::X); 9];
    let two = [vec![at(DVec3::ONE); 4], vec![at(DVec3::ONE + 0.3 * DVec3::Y); 3]].concat();
    let beyond = vec![at(DVec3::ONE + 2.0 * DVec3::X), at(5.0 * DVec3::Y)];
    let no_number = vec![at(DVec3::ONE), at(DVec3::new(f64::NAN, 0.0, 0.0)), at(DVec3::ZERO)];
    let cases =
        [("no neighbors", vec![]), ("one place", same), ("two places", two), ("beyond", beyond), ("NaN", no_number)];
    for (what, cloud) in cases {
        let outputs = operator.run(&query, &cloud, 1);
        assert!(!outputs.flag("valid"), "{what}");
        assert_eq!((outputs.vector("normal"), outputs.number("variation")), (DVec3::ZERO, 0.0), "{what}");
        assert!(outputs.vector("mean").is_finite(), "{what}");
        if what == "one place" {
            assert_eq!(outputs.vector("mean"), cloud[0].position);
        }
    }
}
