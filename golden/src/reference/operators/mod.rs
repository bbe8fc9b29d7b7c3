//! Operators on neighborhoods in f64, written from the formulas, and by what the library's programs may be off.
//!
//! Bounds are derived step by step from the unit of rounding `u`, from the sums of magnitudes that a program adds up
//! ([`weights::Sums`]) and from what the result is divided by. They hold for one iteration from a given position.

pub mod covariance;
pub mod fluid;
pub mod plane;
pub mod smooth;
pub mod sphere;
pub mod weights;

use glam::DVec3;
use pointcore_contract::Format;

/// A query or a neighbor: its position, and the words behind it.
#[derive(Clone, Debug)]
pub struct Point {
    /// Where it is.
    pub position: DVec3,
    /// The words behind its position.
    pub attributes: Vec<f64>,
}

impl Point {
    /// One whose attributes are a normal.
    #[must_use]
    pub fn with_normal(position: DVec3, normal: DVec3) -> Self {
        Self { position, attributes: normal.to_array().to_vec() }
    }

    /// The first three attributes.
    ///
    /// # Panics
    /// If there are not as many.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        DVec3::from_slice(&self.attributes)
    }
}

/// Half the distance from 1 to the next number.
#[must_use]
pub fn unit(format: Format) -> f64 {
    (-f64::from(format.mantissa) - 1.0).exp2()
}
