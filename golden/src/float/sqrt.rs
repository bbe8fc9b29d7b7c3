//! Square root, correctly rounded. √−0 = −0; any other negative operand gives NaN.

use super::encoding::{Finite, Value, decode};
use pointcore_contract::Format;

/// `√a`.
#[must_use]
pub fn sqrt(f: Format, a: u64) -> u64 {
    match decode(f, a) {
        Value::Finite(Finite { negative: false, exponent, significand }) => root(exponent, significand),
        Value::Finite(_) | Value::Nan | Value::Infinity { negative: true } => Value::Nan,
        special @ (Value::Zero { .. } | Value::Infinity { negative: false }) => special,
    }
    .encode(f)
}

/// The radicand, scaled to an even exponent and 63 or 64 bits, has a root of 32: two more than the widest precision.
#[inline]
fn root(exponent: i32, significand: u64) -> Value {
    let headroom = significand.leading_zeros() as i32;
    let scale = headroom - (exponent - headroom).rem_euclid(2);
    let radicand = significand << scale;
    let root = radicand.isqrt();
    let sticky = u64::from(root * root != radicand);
    Value::Finite(Finite { negative: false, exponent: (exponent - scale) / 2, significand: root | sticky })
}
