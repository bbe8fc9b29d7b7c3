//! Sum and difference.
//!
//! An exact zero is +0 unless both operands are −0. Infinities of opposite sign sum to NaN.

use super::encoding::{Finite, Value, decode};
use pointcore_spec::Format;
use std::cmp::Ordering;

/// `a + b`.
#[must_use]
pub fn add(f: Format, a: u64, b: u64) -> u64 {
    sum(decode(f, a), decode(f, b)).encode(f)
}

/// `a − b`.
#[must_use]
pub fn sub(f: Format, a: u64, b: u64) -> u64 {
    sum(decode(f, a), decode(f, b).negate()).encode(f)
}

/// The raw sum of exact values.
#[inline]
pub(super) fn sum(a: Value, b: Value) -> Value {
    use Value::{Infinity, Nan, Zero};
    match (a, b) {
        (Nan, _) | (_, Nan) => Nan,
        (Infinity { negative }, Infinity { negative: other }) if negative != other => Nan,
        (Infinity { negative }, _) | (_, Infinity { negative }) => Infinity { negative },
        (Zero { negative }, Zero { negative: other }) => Zero { negative: negative && other },
        (Zero { .. }, value) | (value, Zero { .. }) => value,
        (Value::Finite(a), Value::Finite(b)) => sum_of_finite(a, b),
    }
}

/// Both significands move to the top of 126 bits, exactly; the smaller is then aligned, with what it loses in a sticky
/// bit. A loss needs a distance of more than 60 places, where the difference cannot lose more than one leading bit.
#[inline]
fn sum_of_finite(a: Finite, b: Finite) -> Value {
    let (exponent_a, wide_a) = widen(a);
    let (exponent_b, wide_b) = widen(b);
    let (large, small) = if exponent_a >= exponent_b { (wide_a, wide_b) } else { (wide_b, wide_a) };
    let small = shift_right_sticky(small, exponent_a.abs_diff(exponent_b));
    let large_is_negative = if exponent_a >= exponent_b { a.negative } else { b.negative };
    let exponent = exponent_a.max(exponent_b);
    if a.negative == b.negative {
        return narrow(a.negative, exponent, large + small);
    }
    match large.cmp(&small) {
        Ordering::Equal => Value::Zero { negative: false },
        Ordering::Greater => narrow(large_is_negative, exponent, large - small),
        Ordering::Less => narrow(!large_is_negative, exponent, small - large),
    }
}

/// Normalizes to a leading one at bit 125: two bits of headroom, 62 or more below any significand.
#[inline]
fn widen(value: Finite) -> (i32, u128) {
    let leading_zeros = value.significand.leading_zeros();
    let normalized = u128::from(value.significand << leading_zeros) << 62;
    (value.exponent - leading_zeros as i32 - 62, normalized)
}

/// Brings a sum back to 64 bits, the lowest one sticky.
#[inline]
fn narrow(negative: bool, exponent: i32, sum: u128) -> Value {
    let leading_zeros = sum.leading_zeros();
    let normalized = sum << leading_zeros;
    let sticky = u64::from(normalized as u64 != 0);
    let significand = (normalized >> 64) as u64 | sticky;
    Value::Finite(Finite { negative, exponent: exponent - leading_zeros as i32 + 64, significand })
}

#[inline]
fn shift_right_sticky(value: u128, distance: u32) -> u128 {
    if distance > 127 {
        return 1; // The value is not zero.
    }
    let lost = value & ((1 << distance) - 1) != 0;
    (value >> distance) | u128::from(lost)
}
