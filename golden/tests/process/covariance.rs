//! Covariance and its smallest eigenvector against Jacobi's method in f64.

use super::surfaces::{ALL, Place, SURFACES, Shape, far, places};
use super::weights::{Sums, theta};
use super::{FORMATS, Operator, Point, random, rounded, unit};
use glam::{DMat3, DVec3};

/// Sum of products of shares below which a neighborhood counts as a line.
pub const LEAST_SPREAD: f64 = 1.0 / 256.0;

/// Weighted mean, and covariance about it with a trace of 1.
pub fn covariance(query: DVec3, cloud: &[Point], inverse_radius2: f64) -> (DVec3, DMat3) {
    let weight = |point: &Point| theta(point.position.distance_squared(query), inverse_radius2);
    let total: f64 = cloud.iter().map(weight).sum();
    let mean = cloud.iter().map(|point| weight(point) * point.position).sum::<DVec3>() / total;
    let outer = |point: &Point| {
        let d = point.position - mean;
        weight(point) * DMat3::from_cols(d * d.x, d * d.y, d * d.z)
    };
    let sum = cloud.iter().map(outer).fold(DMat3::ZERO, |sum, term| sum + term);
    (mean, sum * (1.0 / (sum.x_axis.x + sum.y_axis.y + sum.z_axis.z)))
}

/// Eigenvalues in ascending order and their vectors, by Jacobi's rotations.
pub fn eigen(matrix: DMat3) -> [(f64, DVec3); 3] {
    let (mut a, mut vectors) = (matrix, DMat3::IDENTITY);
    for _ in 0..30 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let off = a.col(q)[p];
            if off == 0.0 {
                continue;
            }
            let angle = 0.5 * (2.0 * off).atan2(a.col(q)[q] - a.col(p)[p]);
            let mut rotation = DMat3::IDENTITY;
            rotation.col_mut(p)[p] = angle.cos();
            rotation.col_mut(q)[q] = angle.cos();
            rotation.col_mut(q)[p] = angle.sin();
            rotation.col_mut(p)[q] = -angle.sin();
            a = rotation.transpose() * a * rotation;
            vectors *= rotation;
        }
    }
    let mut pairs = [0, 1, 2].map(|axis| (a.col(axis)[axis], vectors.col(axis)));
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    pairs
}

/// By what the entries of the covariance may be off, with its trace as the unit: the sum of squares; the sum times the
/// mean, whose magnitudes are not above; three roundings of its difference and scaling. Twice, because the trace that
/// it is divided by is off, too.
pub fn matrix_error(sums: &Sums, trace: f64, u: f64) -> f64 {
    let mean_times_first = sums.first / sums.weight * sums.error(1) + sums.first * sums.mean_error();
    2.0 * u * (sums.error(2) + mean_times_first + 3.0 * sums.second) / trace
}

/// By what the direction may be off: entries of the adjugate are two products of entries of at most 1, so off by four
/// times as much and three roundings, relative to the gap of its eigenvalues λ3 (λ2 − λ1); every squaring adds five
/// roundings to a gap of at least 1 − λ1/λ2; what is left of the second direction after five squarings, twice because
/// the column is not shorter than 1/√3 where that is little; and the result's normalization. Matrix norms are three
/// times the largest entry.
pub fn angle_error(values: [f64; 3], matrix_error: f64, u: f64) -> f64 {
    let [least, middle, most] = values;
    let ratio = (least / middle).max(0.0);
    let rest = ratio.powi(32);
    let rest = if rest < 0.1 { rest } else { 1.0 };
    let adjugate = 3.0 * (4.0 * matrix_error + 3.0 * u) / (most * (middle - least));
    2.0 * (adjugate + 3.0 * 25.0 * u / (1.0 - ratio) + rest) + 4.0 * u
}

fn trace(query: DVec3, mean: DVec3, cloud: &[Point], inverse_radius2: f64) -> f64 {
    let weight = |point: &Point| theta(point.position.distance_squared(query), inverse_radius2);
    cloud.iter().map(|point| weight(point) * point.position.distance_squared(mean)).sum()
}

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
