//! The squared distance of a sample from a moving splat, over time, and the integral of the kernel along it.
//!
//! On a splat that moves along a line with constant tangents, the place that a viewing ray meets moves along a line, too:
//! `(s, t)(τ) = (s0, t0) + τ·(s', t')`, even in perspective. With
//!
//! ```text
//! q0 = s0² + t0²     q1 = s0·s' + t0·t'     q2 = s'² + t'²     c = s0·t' − t0·s'
//! ```
//!
//! `ρ²(τ) = q0 + 2·q1·τ + q2·τ²`, and `c² = q0·q2 − q1²` without that difference's cancellation.

use super::interval::Interval;
use super::shutter::Shutter;

/// Below this width in units of the integrand's own, the difference of two error functions loses digits that two terms of its series have: the
/// series errs by the width's fourth power.
const NARROW: f64 = 1.0 / 1024.0;

/// `ρ²(τ)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SquaredDistance {
    constant: f64,
    half_slope: f64,
    square: f64,
    /// `c`.
    cross: f64,
}

impl SquaredDistance {
    /// That of a place on the splat that moves by `motion` in a unit of `τ`.
    #[must_use]
    pub fn of([s, t]: [f64; 2], motion: [f64; 2]) -> Self {
        let [ds, dt] = motion;
        Self { constant: s * s + t * t, half_slope: s * ds + t * dt, square: ds * ds + dt * dt, cross: s * dt - t * ds }
    }

    /// That of a splat that stands still.
    #[must_use]
    pub const fn still(squared: f64) -> Self {
        Self { constant: squared, half_slope: 0.0, square: 0.0, cross: 0.0 }
    }

    /// `ρ²` at a time.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        self.constant + time * (2.0 * self.half_slope + time * self.square)
    }

    /// The part of an interval in which `ρ² < 1`: the tube of eq. 4.22. The discriminant is `q2 − c²`.
    #[must_use]
    pub fn within_kernel(&self, interval: Interval) -> Option<Interval> {
        if self.square == 0.0 {
            return (self.constant < 1.0).then_some(interval);
        }
        let discriminant = self.square - self.cross * self.cross;
        if discriminant.is_nan() || discriminant <= 0.0 {
            return None;
        }
        // The root whose terms have one sign, and the other one by Vieta's formula: neither cancels.
        let far = -(self.half_slope + discriminant.sqrt().copysign(self.half_slope));
        let roots = [far / self.square, (self.constant - 1.0) / far];
        Interval::new(roots[0].min(roots[1]), roots[0].max(roots[1]))?.intersection(interval)
    }

    /// The times at which this is as large as another, in no order.
    #[must_use]
    pub fn crossings(&self, other: &Self) -> [Option<f64>; 2] {
        let constant = self.constant - other.constant;
        let half_slope = self.half_slope - other.half_slope;
        let square = self.square - other.square;
        if square == 0.0 {
            return [(half_slope != 0.0).then(|| -0.5 * constant / half_slope), None];
        }
        let discriminant = half_slope * half_slope - constant * square;
        if discriminant.is_nan() || discriminant < 0.0 {
            return [None; 2];
        }
        let far = -(half_slope + discriminant.sqrt().copysign(half_slope));
        [Some(far / square), (far != 0.0).then(|| constant / far)]
    }

    /// `∫ a(τ)·exp(−γ·ρ²(τ)) dτ` over an interval, with the whole exposure's `∫ a(τ) dτ` scaled to one: thesis eq. 4.19.
    ///
    /// With `F = γ·q2 + f` the exponent is `γ(γ·c² + f·q0)/F + (√F·τ + γ·q1/√F)²`. Of a box shutter (`f = 0`) `F` may vanish; then the integrand
    /// hardly changes, and below a narrow width there is its series about the interval's middle in the place of error functions.
    #[must_use]
    pub fn integral(&self, shutter: Shutter, gamma: f64, interval: Interval) -> f64 {
        let falloff = shutter.falloff();
        let steepness = gamma * self.square + falloff;
        let root = steepness.sqrt();
        let width = root * interval.length();
        let place = |time: f64| root * time + if root > 0.0 { gamma * self.half_slope / root } else { 0.0 };
        if width < NARROW {
            let time = interval.middle();
            let middle = (-(gamma * self.at(time) + falloff * time * time)).exp();
            let bend = (2.0 * place(time).powi(2) - 1.0) * width * width / 12.0;
            return middle * (1.0 + bend) * interval.length() / shutter.total();
        }
        let exponent = gamma * (gamma * self.cross * self.cross + falloff * self.constant) / steepness;
        let area = erf_difference(place(interval.begin), place(interval.end));
        let half_sqrt_pi = 0.5 * std::f64::consts::PI.sqrt();
        (-exponent).exp() * half_sqrt_pi * area / (root * shutter.total())
    }
}

/// `erf(end) − erf(begin)`; in one tail by the complement, whose small values have all their digits.
fn erf_difference(begin: f64, end: f64) -> f64 {
    if begin > 0.0 {
        libm::erfc(begin) - libm::erfc(end)
    } else if end < 0.0 {
        libm::erfc(-end) - libm::erfc(-begin)
    } else {
        libm::erf(end) - libm::erf(begin)
    }
}
