//! The plane that queries are projected onto (thesis 6.2).

use super::Point;
use super::weights::{Sums, theta};
use glam::DVec3;

/// The plane of equations 6.3 and 6.4 with the errata: the weighted mean, and the weighted normal, of length 1.
#[must_use]
pub fn plane(query: DVec3, cloud: &[Point], inverse_radius2: f64) -> (DVec3, DVec3) {
    let weight = |point: &Point| theta(point.position.distance_squared(query), inverse_radius2);
    let total: f64 = cloud.iter().map(weight).sum();
    let mean = cloud.iter().map(|point| weight(point) * point.position).sum::<DVec3>() / total;
    (mean, weighted_normal(query, cloud, inverse_radius2).normalize())
}

/// Σ θ n.
#[must_use]
pub fn weighted_normal(query: DVec3, cloud: &[Point], inverse_radius2: f64) -> DVec3 {
    let weight = |point: &Point| theta(point.position.distance_squared(query), inverse_radius2);
    cloud.iter().map(|point| weight(point) * point.normal()).sum()
}

/// By what the normal may be off: the sum in relation to its length, three times its components; and its normalization.
#[must_use]
pub fn normal_error(query: DVec3, cloud: &[Point], inverse_radius2: f64) -> f64 {
    let length = weighted_normal(query, cloud, inverse_radius2).length();
    let sums = Sums::new(query, cloud, inverse_radius2);
    3.0 * sums.error(0) / length + 5.0
}
