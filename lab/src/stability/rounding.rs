//! Running error analysis: a value with a bound on what the hardware's rounded operations can have made of it.
//!
//! Every operation on a format with precision `p` returns `(1 + δ)` times the exact result on its operands, `|δ| ≤ 2^−p`, plus at most the
//! smallest normal number where it underflows; a bound that reaches the largest number is infinite, and says nothing. docs/stability.md
//! derives closed forms.

use pointcore_contract::Format;
use pointcore_contract::splat::Division;
use std::ops::{Add, Div, Mul, Sub};

/// Room for the f64 arithmetic that evaluates value and bound.
const EVALUATION: f64 = 1.0 / (1_u64 << 48) as f64;

/// The bound itself is computed in f64.
const ROUNDED_UP: f64 = 1.0 + 1.0 / 1024.0;

/// Relative error of a reciprocal from a table and Newton steps, of which 0.565 units in the last place is known, in units of `2^−p`.
const RECIP_NEWTON_UNITS: f64 = 2.0 * 0.565;
/// That of a root by the reciprocal one, 0.576 units in the last place off, and a rounded product.
const SQRT_NEWTON_UNITS: f64 = 2.0 * 0.576 + 1.0;

/// A value and its bound.
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    /// The exact value, as f64 finds it.
    pub value: f64,
    /// How far the computed value may lie from it.
    pub error: f64,
    pub(super) unit: f64,
    /// What evaluating value and bound may add.
    pub(super) evaluation: f64,
}

impl Bounded {
    /// An exact number of a format.
    #[must_use]
    pub fn exact(format: Format, value: f64) -> Self {
        // A subnormal that reads as zero is off by its value.
        let error = if value != 0.0 && value.abs() < smallest() { smallest() } else { 0.0 };
        Self { value, error, unit: 0.5_f64.powi(format.mantissa as i32 + 1), evaluation: EVALUATION }
    }

    /// An exact number whose arithmetic is f64's own.
    #[must_use]
    pub fn in_f64(value: f64) -> Self {
        Self { value, error: 0.0, unit: f64::EPSILON / 2.0, evaluation: 0.0 }
    }

    fn rounded(self, value: f64, error: f64) -> Self {
        self.within(1.0, value, error)
    }

    /// The result of an operation that is off by so many `2^−p` of what it returns for operands as they are.
    fn within(self, units: f64, value: f64, error: f64) -> Self {
        let magnitude = value.abs() + error;
        if magnitude.is_nan() || magnitude >= largest() {
            return Self { value, error: f64::INFINITY, ..self };
        }
        Self {
            value,
            error: error + (units * self.unit + self.evaluation) * magnitude * ROUNDED_UP + smallest(),
            ..self
        }
    }

    /// `1/self`.
    #[must_use]
    pub fn recip(self, division: Division) -> Self {
        let units = match division {
            Division::Rounded => 1.0,
            Division::Newton => RECIP_NEWTON_UNITS,
        };
        Self { value: 1.0, error: 0.0, ..self }.quotient(self, units)
    }

    fn quotient(self, other: Self, units: f64) -> Self {
        let value = self.value / other.value;
        let least = other.value.abs() - other.error;
        if least <= 0.0 || least.is_nan() {
            return Self { value, error: f64::INFINITY, ..self };
        }
        self.within(units, value, (self.error + value.abs() * other.error) / least)
    }

    /// The root of a number that is not negative.
    #[must_use]
    pub fn sqrt(self, division: Division) -> Self {
        let units = match division {
            Division::Rounded => 1.0,
            Division::Newton => SQRT_NEWTON_UNITS,
        };
        let value = self.value.max(0.0).sqrt();
        // |√(v + e) − √v| ≤ min(√e, e/√v)
        let error = if value > 0.0 { (self.error / value).min(self.error.sqrt()) } else { self.error.sqrt() };
        self.within(units, value, error)
    }

    /// The largest magnitude that it may have as computed.
    #[must_use]
    pub fn most(self) -> f64 {
        self.value.abs() + self.error
    }

    /// The smallest one.
    #[must_use]
    pub fn least(self) -> f64 {
        (self.value.abs() - self.error).max(0.0)
    }

    /// The magnitude.
    #[must_use]
    pub fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }

    /// The sign, if rounding cannot have changed it.
    #[must_use]
    pub fn sign(self) -> Option<f64> {
        (self.value.abs() > self.error).then(|| self.value.signum())
    }

    /// Whether it lies above a limit, if rounding cannot have changed that.
    #[must_use]
    pub fn is_above(self, limit: f64) -> Option<bool> {
        ((self.value - limit).abs() > self.error).then_some(self.value > limit)
    }
}

/// The smallest normal number of every format with 8 exponent bits.
fn smallest() -> f64 {
    f64::from(f32::MIN_POSITIVE)
}

/// The largest one, of the narrowest of them.
fn largest() -> f64 {
    f64::from(f32::MAX) * (1.0 - 1.0 / 256.0)
}

impl Add for Bounded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.rounded(self.value + other.value, self.error + other.error)
    }
}

impl Sub for Bounded {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.rounded(self.value - other.value, self.error + other.error)
    }
}

impl Mul for Bounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let error = self.value.abs() * other.error + other.value.abs() * self.error + self.error * other.error;
        self.rounded(self.value * other.value, error)
    }
}

impl Div for Bounded {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        self.quotient(other, 1.0)
    }
}
