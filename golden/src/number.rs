//! A floating-point value that knows its format, so that models read like the equations they state.
//!
//! Every operator rounds once, as in [`float`]. Both operands have the same format.

use crate::float;
use pointcore_contract::{Fixed, Format, Signedness};
use std::ops::{Add, Div, Mul, Sub};

/// A value of a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Number {
    format: Format,
    bits: u64,
}

impl Number {
    /// The value that `bits` encode.
    #[must_use]
    pub const fn new(format: Format, bits: u32) -> Self {
        Self { format, bits: bits as u64 }
    }

    /// `value · 2^−fraction` of an unsigned number of `width` bits, rounded.
    #[must_use]
    pub fn from_fixed(format: Format, value: u64, width: u32, fraction: u32) -> Self {
        Self { format, bits: float::from_fixed(format, value, Fixed { width, fraction, signed: Signedness::Unsigned }) }
    }

    /// `value · 2^−fraction`, rounded.
    #[must_use]
    pub fn from_signed(format: Format, value: i64, fraction: u32) -> Self {
        let fixed = Fixed { width: 64, fraction, signed: Signedness::Signed };
        Self { format, bits: float::from_fixed(format, value as u64, fixed) }
    }

    /// The encoding; every named format fits 32 bits.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.bits as u32
    }

    /// Its format.
    #[must_use]
    pub const fn format(self) -> Format {
        self.format
    }

    /// Another value of this format, the nearest to `value`.
    #[must_use]
    pub fn of(self, value: f32) -> Self {
        Self::new(Format::F32, value.to_bits()).convert(self.format)
    }

    /// The value rounded to `f32`, which is the value itself in every named format.
    #[must_use]
    pub fn value(self) -> f32 {
        f32::from_bits(self.convert(Format::F32).bits())
    }

    /// Truncated to an unsigned number of `width` bits, saturated; NaN becomes 0.
    #[must_use]
    pub fn to_fixed(self, width: u32, fraction: u32) -> u64 {
        float::to_fixed(self.format, self.bits, Fixed { width, fraction, signed: Signedness::Unsigned })
    }

    /// `self · 2^fraction`, truncated to a signed number of `width` bits, saturated; NaN becomes 0.
    #[must_use]
    pub fn to_signed(self, width: u32, fraction: u32) -> i64 {
        let bits = float::to_fixed(self.format, self.bits, Fixed { width, fraction, signed: Signedness::Signed });
        let unused = 64 - width;
        (bits << unused) as i64 >> unused
    }

    /// The value in another format.
    #[must_use]
    pub fn convert(self, format: Format) -> Self {
        Self { format, bits: float::convert(self.format, format, self.bits) }
    }

    /// `1/self`.
    #[must_use]
    pub fn recip(self) -> Self {
        Self { bits: float::recip(self.format, self.bits), ..self }
    }

    /// About `1/self`, from a table and Newton steps.
    #[must_use]
    pub fn recip_newton(self) -> Self {
        Self { bits: float::recip_newton(self.format, self.bits), ..self }
    }

    /// About the square root, by the reciprocal one from a table and Newton steps; a zero's and positive infinity's are
    /// themselves.
    #[must_use]
    pub fn sqrt_newton(self) -> Self {
        if self.abs().bits == 0 || self.bits == self.format.infinity() {
            return self;
        }
        self * Self { bits: float::rsqrt_newton(self.format, self.bits), ..self }
    }

    /// The square root.
    #[must_use]
    pub fn sqrt(self) -> Self {
        Self { bits: float::sqrt(self.format, self.bits), ..self }
    }

    /// `1/√self`.
    #[must_use]
    pub fn rsqrt(self) -> Self {
        Self { bits: float::rsqrt(self.format, self.bits), ..self }
    }

    /// About `1/√self`, from a table and Newton steps.
    #[must_use]
    pub fn rsqrt_newton(self) -> Self {
        Self { bits: float::rsqrt_newton(self.format, self.bits), ..self }
    }

    /// The magnitude.
    #[must_use]
    pub const fn abs(self) -> Self {
        Self { bits: self.bits & !self.format.sign_mask(), ..self }
    }

    /// The exponent as it is encoded, biased.
    #[must_use]
    pub const fn exponent_field(self) -> u64 {
        self.bits >> self.format.mantissa & self.format.exponent_max()
    }

    /// The exponent of a number's power of two, as its significand is an integer.
    #[must_use]
    pub const fn scale(self) -> i32 {
        self.exponent_field() as i32 - self.format.bias() - self.format.mantissa as i32
    }

    /// A normal number's significand, the implied bit included; 0 of a subnormal one.
    #[must_use]
    pub const fn significand(self) -> u64 {
        if self.exponent_field() == 0 {
            0
        } else {
            self.bits & ((1 << self.format.mantissa) - 1) | (1 << self.format.mantissa)
        }
    }

    /// `self · 2^places` by the exponent alone: zero where that falls below the least normal number's, and of a subnormal number; infinite
    /// above the largest one's. A NaN stays what it is.
    #[must_use]
    pub const fn raised(self, places: i64) -> Self {
        let exponent = self.exponent_field();
        if exponent == self.format.exponent_max() {
            return self;
        }
        let sign = self.bits & self.format.sign_mask();
        let raised = exponent as i64 + places;
        if exponent == 0 || raised <= 0 {
            return Self { bits: sign, ..self };
        }
        if raised as u64 >= self.format.exponent_max() {
            return Self { bits: sign | self.format.infinity(), ..self };
        }
        let fraction = self.bits & ((1 << self.format.mantissa) - 1);
        Self { bits: sign | (raised as u64) << self.format.mantissa | fraction, ..self }
    }

    /// With a magnitude so many units in the last place smaller, zero at least.
    #[must_use]
    pub const fn shrunk(self, units: u64) -> Self {
        Self { bits: self.bits & self.format.sign_mask() | self.abs().bits.saturating_sub(units), ..self }
    }

    /// The same with the other sign.
    #[must_use]
    pub const fn negated(self) -> Self {
        Self { bits: self.bits ^ self.format.sign_mask(), ..self }
    }

    /// Whether it is no number.
    #[must_use]
    pub const fn is_nan(self) -> bool {
        self.abs().bits > self.format.infinity()
    }

    /// Itself, or the largest number of its sign where it is infinite or NaN.
    #[must_use]
    pub const fn saturated(self) -> Self {
        let is_finite = self.exponent_field() < self.format.exponent_max();
        let largest = self.bits & self.format.sign_mask() | (self.format.infinity() - 1);
        Self { bits: if is_finite { self.bits } else { largest }, ..self }
    }

    /// The sign bit.
    #[must_use]
    pub const fn is_negative(self) -> bool {
        self.bits & self.format.sign_mask() != 0
    }

    /// The smaller one; prefers the operand that is not NaN.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        Self { bits: float::min(self.format, self.bits, other.bits), ..self }
    }

    /// The larger one; prefers the operand that is not NaN.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self { bits: float::max(self.format, self.bits, other.bits), ..self }
    }

    /// `self < other`; false with a NaN.
    #[must_use]
    pub fn is_below(self, other: Self) -> bool {
        float::lt(self.format, self.bits, other.bits)
    }

    /// `self ≤ other`; false with a NaN.
    #[must_use]
    pub fn is_at_most(self, other: Self) -> bool {
        float::le(self.format, self.bits, other.bits)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $model:path),*) => {
        $(impl $operator for Number {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                debug_assert_eq!(self.format, other.format);
                Self { bits: $model(self.format, self.bits, other.bits), ..self }
            }
        })*
    };
}

operators!(Add add float::add, Sub sub float::sub, Mul mul float::mul, Div div float::div);
