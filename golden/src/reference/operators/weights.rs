//! The weights that most programs share, in f64, and what is known about their rounding.

use super::Point;
use glam::DVec3;

/// `f = max(0, 1 − d²/h²)` of a neighbor, from which its weight is made.
#[must_use]
pub fn falloff(distance2: f64, inverse_radius2: f64) -> f64 {
    (1.0 - distance2 * inverse_radius2).max(0.0)
}

/// θ = f⁴.
#[must_use]
pub fn theta(distance2: f64, inverse_radius2: f64) -> f64 {
    falloff(distance2, inverse_radius2).powi(4)
}

/// By what a weight may be off, in units of rounding and of f³.
///
/// d² has 5 roundings and twice the one of each difference, but at most 6 in relation; `d²/h²`, at most 1 where it
/// counts, has 7, the difference from 1 one more: f is off by 8u, f⁴ by 4 f³ · 8u and by its own three roundings, u f⁴
/// ≤ u f³ each.
const THETA: f64 = 35.0;

/// Roundings within which a neighbor at the end of the radius may weigh or not: twice those of f.
const AT_END: f64 = 16.0;

/// Whether a neighbor weighs something; nothing where rounding decides.
#[must_use]
pub fn weighs(query: DVec3, cloud: &[Point], inverse_radius2: f64, u: f64) -> Option<bool> {
    let within = |point: &Point| 1.0 - point.position.distance_squared(query) * inverse_radius2;
    let nearest = cloud.iter().map(within).fold(f64::NEG_INFINITY, f64::max);
    (nearest.abs() > AT_END * u).then_some(nearest > 0.0)
}

/// Sums of magnitudes over a neighborhood, from which bounds are made.
pub struct Sums {
    /// Σ θ.
    pub weight: f64,
    /// Σ θ |d|.
    pub first: f64,
    /// Σ θ d².
    pub second: f64,
    /// Σ f³, Σ f³ |d|, Σ f³ d².
    cubes: [f64; 3],
    /// Roundings of a sum: those of a partial sum, of the tree, and of a term: d, its square, products with the weight.
    roundings: f64,
}

impl Sums {
    /// Those around a query.
    #[must_use]
    pub fn new(query: DVec3, cloud: &[Point], inverse_radius2: f64) -> Self {
        let mut sums = Self { weight: 0.0, first: 0.0, second: 0.0, cubes: [0.0; 3], roundings: 0.0 };
        for point in cloud {
            let distance2 = point.position.distance_squared(query);
            let (f, distance) = (falloff(distance2, inverse_radius2), distance2.sqrt());
            sums.weight += f.powi(4);
            sums.first += f.powi(4) * distance;
            sums.second += f.powi(4) * distance2;
            [1.0, distance, distance2].iter().zip(&mut sums.cubes).for_each(|(x, cube)| *cube += f.powi(3) * x);
        }
        sums.roundings = (cloud.len() / 8 + 4) as f64 + 6.0;
        sums
    }

    /// By what Σ θ, Σ θ d or Σ θ d² may be off, in units of rounding; the power is that of d.
    #[must_use]
    pub fn error(&self, power: usize) -> f64 {
        let magnitude = [self.weight, self.first, self.second][power];
        self.roundings * magnitude + THETA * self.cubes[power]
    }

    /// By what the weighted mean of d may be off, in units of rounding: the sum's error and the weight's, and two
    /// roundings.
    #[must_use]
    pub fn mean_error(&self) -> f64 {
        let mean = self.first / self.weight;
        (self.error(1) + mean * self.error(0)) / self.weight + 2.0 * mean
    }
}
