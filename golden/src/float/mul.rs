//! Product. Zero times infinity is NaN.

use super::encoding::{Finite, Value, decode};
use pointcore_contract::Format;

/// `a · b`.
#[must_use]
pub fn mul(f: Format, a: u64, b: u64) -> u64 {
    product(decode(f, a), decode(f, b)).encode(f)
}

/// The exact product, up to 58 bits long.
#[inline]
pub(super) fn product(a: Value, b: Value) -> Value {
    use Value::{Infinity, Nan, Zero};
    match (a, b) {
        (Nan, _) | (_, Nan) | (Infinity { .. }, Zero { .. }) | (Zero { .. }, Infinity { .. }) => Nan,
        (Infinity { negative }, other) | (other, Infinity { negative }) => {
            Infinity { negative: negative != other.is_negative() }
        }
        (Zero { negative }, other) | (other, Zero { negative }) => Zero { negative: negative != other.is_negative() },
        (Value::Finite(a), Value::Finite(b)) => Value::Finite(Finite {
            negative: a.negative != b.negative,
            exponent: a.exponent + b.exponent,
            significand: a.significand * b.significand,
        }),
    }
}
