//! Conversion to fixed point, truncating toward zero.
//!
//! What the fixed-point format cannot hold saturates, infinities included; NaN becomes zero. Only a truncated value
//! counts: −0.5 is representable, as 0, in an unsigned format without fraction bits.

use super::encoding::{Finite, Value, decode};
use pointcore_contract::{Fixed, Format, Signedness};

/// `a · 2^fraction` toward zero, saturated, in the low `fixed.width` bits.
#[must_use]
pub fn to_fixed(f: Format, a: u64, fixed: Fixed) -> u64 {
    to_fixed_checked(f, a, fixed).unwrap_or_else(|| match decode(f, a) {
        Value::Nan => 0,
        out_of_range => {
            let negative = out_of_range.is_negative();
            encode(fixed, negative, largest_magnitude(fixed, negative))
        }
    })
}

/// [`to_fixed`] where the result is a number of the format, `None` where IEEE 754 signals an invalid operation: for NaN
/// and out of range.
#[must_use]
pub fn to_fixed_checked(f: Format, a: u64, fixed: Fixed) -> Option<u64> {
    match decode(f, a) {
        Value::Nan | Value::Infinity { .. } => None,
        Value::Zero { .. } => Some(0),
        Value::Finite(finite) => {
            let magnitude = truncate(finite, fixed.fraction);
            (magnitude <= u128::from(largest_magnitude(fixed, finite.negative)))
                .then(|| encode(fixed, finite.negative, magnitude as u64))
        }
    }
}

/// `⌊significand · 2^(exponent + fraction)⌋`; from 2^64 on, which no format holds, only the fact of overflow is kept.
#[inline]
fn truncate(finite: Finite, fraction: u32) -> u128 {
    let significand = u128::from(finite.significand);
    let shift = finite.exponent + fraction as i32;
    if shift < 0 { significand >> (-shift).min(64) } else { significand << shift.min(64) }
}

#[inline]
fn largest_magnitude(fixed: Fixed, negative: bool) -> u64 {
    match (fixed.signed, negative) {
        (Signedness::Signed, true) => 1 << (fixed.width - 1),
        (Signedness::Signed, false) => mask(fixed.width) >> 1,
        (Signedness::Unsigned, true) => 0,
        (Signedness::Unsigned, false) => mask(fixed.width),
    }
}

#[inline]
fn encode(fixed: Fixed, negative: bool, magnitude: u64) -> u64 {
    let bits = if negative { magnitude.wrapping_neg() } else { magnitude };
    bits & mask(fixed.width)
}

#[inline]
fn mask(width: u32) -> u64 {
    u64::MAX >> (64 - width)
}
