//! Which queries have a result, where rounding does not decide.

use super::Iteration;
use super::formulas::Formula;
use pointcore_golden::reference::operators::covariance::{covariance, eigen, matrix_error, trace};
use pointcore_golden::reference::operators::plane::{normal_error, plane, weighted_normal};
use pointcore_golden::reference::operators::smooth::weight;
use pointcore_golden::reference::operators::sphere::Fit;
use pointcore_golden::reference::operators::weights::{Sums, weighs};

/// Squares and products of what is smaller may vanish, or of what is larger overflow, in every format.
const SMALL: f64 = 1e-18;
const LARGE: f64 = 1e18;

/// Whether a program has to find a query valid; nothing where rounding may decide, or validity means something else.
pub fn is_valid(formula: Formula, iteration: &Iteration<'_>) -> Option<bool> {
    let Iteration { query, cloud, settings, u, .. } = iteration;
    let position = query.position;
    if formula == Formula::Smooth {
        return weight(position, cloud, [settings[0], settings[1]]);
    }
    if matches!(formula, Formula::Density | Formula::Forces) {
        return None;
    }
    let inverse_radius2 = settings[0];
    if !weighs(position, cloud, inverse_radius2, *u)? {
        return Some(false);
    }
    let sums = Sums::new(position, cloud, inverse_radius2);
    match formula {
        Formula::Covariance | Formula::Normals => {
            let (mean, matrix) = covariance(position, cloud, inverse_radius2);
            let trace = trace(position, mean, cloud, inverse_radius2);
            let entries = matrix_error(&sums, trace, *u);
            let [a, b, c] = eigen(matrix).map(|(value, _)| value);
            let (spread, margin) = (a * b + b * c + a * c, 12.0 * (entries + u));
            let is_clear = trace > SMALL && entries < 1.0 / 16.0 && (spread - settings[1]).abs() > margin;
            is_clear.then_some(spread > settings[1])
        }
        Formula::Plane | Formula::Pattern => {
            let (mean, normal) = plane(position, cloud, inverse_radius2);
            let is_directed = u * normal_error(position, cloud, inverse_radius2) < 0.5;
            let magnitude = weighted_normal(position, cloud, inverse_radius2).length();
            let is_clear = is_directed && magnitude > SMALL && normal.dot(mean - position).abs() < LARGE;
            is_clear.then_some(true)
        }
        Formula::Sphere => {
            let fit = Fit::new(position, cloud, inverse_radius2, settings[1]);
            let is_clear = (SMALL..LARGE).contains(&fit.g.length()) && fit.is_met(&sums, settings[1], *u);
            is_clear.then_some(true)
        }
        Formula::Smooth | Formula::Density | Formula::Forces => None,
    }
}
