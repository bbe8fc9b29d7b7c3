//! How the light that comes in at a time counts: `a(t)` of thesis eq. 4.2.

use super::interval::Interval;

/// The shutter's weight over the exposure, `a(τ) = exp(−f·τ²)`, whose integral over all of it is scaled to one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shutter {
    /// Open, then closed: every time counts alike, `f = 0`.
    #[default]
    Box,
    /// It opens and closes slowly: `f = 1`, the weight of thesis 4.4.4, cut off at both ends of the exposure.
    Gaussian,
}

impl Shutter {
    /// `f`.
    #[must_use]
    pub const fn falloff(self) -> f64 {
        match self {
            Self::Box => 0.0,
            Self::Gaussian => 1.0,
        }
    }

    /// `a(τ)` before it is scaled.
    #[must_use]
    pub fn weight(self, time: f64) -> f64 {
        (-self.falloff() * time * time).exp()
    }

    /// The integral of [`Self::weight`] over the exposure.
    #[must_use]
    pub fn total(self) -> f64 {
        match self {
            Self::Box => 2.0,
            Self::Gaussian => std::f64::consts::PI.sqrt() * libm::erf(1.0),
        }
    }

    /// The share of the light that comes in during a part of the exposure.
    #[must_use]
    pub fn share(self, part: Interval) -> f64 {
        match self {
            Self::Box => 0.5 * part.length(),
            Self::Gaussian => 0.5 * (libm::erf(part.end) - libm::erf(part.begin)) / libm::erf(1.0),
        }
    }
}
