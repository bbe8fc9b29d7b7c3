//! Smoothing by predictions on neighbors' planes (Jones, Durand and Desbrun 2003).

use super::Point;
use glam::DVec3;

/// By what `exp_neg` may be off.
const EXPONENTIAL: f64 = 1.0 / 8192.0;

/// Whether a neighbor has a weight; nothing where rounding decides.
#[must_use]
pub fn weight(query: DVec3, cloud: &[Point], [spatial, influence]: [f64; 2]) -> Option<bool> {
    if cloud.is_empty() {
        return Some(false);
    }
    let weight = |point: &Point| {
        let d = point.position - query;
        let height = point.normal().dot(d);
        point.attributes[3] * ((-spatial * d.length_squared() - influence * height * height).exp() - EXPONENTIAL)
    };
    // Of weights that are known not to be zero.
    (cloud.iter().map(weight).sum::<f64>() > f64::from(f32::EPSILON)).then_some(true)
}

/// The mean of predictions, relative to the query, and by what it may be off.
#[must_use]
pub fn prediction(query: DVec3, cloud: &[Point], [spatial, influence]: [f64; 2], u: f64) -> (DVec3, f64) {
    let terms: Vec<(f64, f64, DVec3, f64)> = cloud
        .iter()
        .map(|point| {
            let d = point.position - query;
            let height = point.normal().dot(d);
            let (near, similar) = (spatial * d.length_squared(), influence * height * height);
            let gaussian = (-near - similar).exp();
            // Ten roundings of the exponent, and those of the height, which are in relation to d.
            let exponent = 10.0 * u * (near + similar + influence * height.abs() * d.length());
            let area = point.attributes[3];
            (area * gaussian, height, point.normal(), area * (EXPONENTIAL + gaussian * exponent))
        })
        .collect();
    let weight: f64 = terms.iter().map(|(w, ..)| w).sum();
    let step = terms.iter().map(|&(w, height, normal, _)| w * height * normal).sum::<DVec3>() / weight;
    let off: f64 = terms.iter().map(|(_, height, _, error)| error * (height.abs() + step.length())).sum();
    let distance = |point: &Point| point.position.distance(query);
    let farthest = cloud.iter().map(distance).fold(0.0, f64::max);
    let roundings = (cloud.len() / 8 + 16) as f64;
    (step, off / weight + 2.0 * roundings * u * farthest + 2.0 * u * query.length())
}
