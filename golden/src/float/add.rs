//! Sum and difference.
//!
//! An exact zero is +0 unless both operands are −0. Infinities of opposite sign sum to NaN.

use super::encoding::{Finite, Value, decode, shift_right_sticky};
use pointcore_contract::Format;

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

/// Both significands move to the top of 62 bits, exactly, and are then aligned to the larger exponent with what they
/// lose in a sticky bit. The longest significand, a product's 58 bits, loses nothing to the first four places, and
/// beyond one place a difference keeps at least 61 bits, of which the rounder needs p + 2.
#[inline]
fn sum_of_finite(a: Finite, b: Finite) -> Value {
    let (exponent_a, magnitude_a) = normalize(a);
    let (exponent_b, magnitude_b) = normalize(b);
    let exponent = exponent_a.max(exponent_b);
    let aligned = |magnitude, distance, negative| {
        let magnitude = shift_right_sticky(magnitude, distance) as i64;
        if negative { -magnitude } else { magnitude }
    };
    let sum = aligned(magnitude_a, exponent - exponent_a, a.negative)
        + aligned(magnitude_b, exponent - exponent_b, b.negative);
    if sum == 0 {
        return Value::Zero { negative: false };
    }
    Value::Finite(Finite { negative: sum < 0, exponent, significand: sum.unsigned_abs() })
}

/// Moves the leading one to bit 61, which leaves room for a carry and the sign.
#[inline]
fn normalize(value: Finite) -> (i32, u64) {
    let shift = value.significand.leading_zeros() - 2;
    (value.exponent - shift as i32, value.significand << shift)
}
