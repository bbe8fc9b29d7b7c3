//! Covariance and its smallest eigenvector, by Jacobi's method.

use super::Point;
use super::weights::{Sums, theta};
use glam::{DMat3, DVec3};

/// Weighted mean, and covariance about it with a trace of 1.
#[must_use]
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
#[must_use]
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
#[must_use]
pub fn matrix_error(sums: &Sums, trace: f64, u: f64) -> f64 {
    let mean_times_first = sums.first / sums.weight * sums.error(1) + sums.first * sums.mean_error();
    2.0 * u * (sums.error(2) + mean_times_first + 3.0 * sums.second) / trace
}

/// By what the direction may be off: entries of the adjugate are two products of entries of at most 1, so off by four
/// times as much and three roundings, relative to the gap of its eigenvalues λ3 (λ2 − λ1); every squaring adds five
/// roundings to a gap of at least 1 − λ1/λ2; what is left of the second direction after five squarings, twice because
/// the column is not shorter than 1/√3 where that is little; and the result's normalization. Matrix norms are three
/// times the largest entry.
#[must_use]
pub fn angle_error(values: [f64; 3], matrix_error: f64, u: f64) -> f64 {
    let [least, middle, most] = values;
    let ratio = (least / middle).max(0.0);
    let rest = ratio.powi(32);
    let rest = if rest < 0.1 { rest } else { 1.0 };
    let adjugate = 3.0 * (4.0 * matrix_error + 3.0 * u) / (most * (middle - least));
    2.0 * (adjugate + 3.0 * 25.0 * u / (1.0 - ratio) + rest) + 4.0 * u
}

/// Trace of the covariance before it is scaled.
#[must_use]
pub fn trace(query: DVec3, mean: DVec3, cloud: &[Point], inverse_radius2: f64) -> f64 {
    let weight = |point: &Point| theta(point.position.distance_squared(query), inverse_radius2);
    cloud.iter().map(|point| weight(point) * point.position.distance_squared(mean)).sum()
}
