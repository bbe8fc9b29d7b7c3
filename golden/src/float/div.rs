//! Quotient and reciprocal, correctly rounded.
//!
//! A non-zero number divided by zero is infinity; 0/0 and ∞/∞ are NaN.

use super::encoding::{Finite, Value, decode};
use pointcore_contract::Format;

/// `a / b`.
#[must_use]
pub fn div(f: Format, a: u64, b: u64) -> u64 {
    quotient(f, decode(f, a), decode(f, b)).encode(f)
}

/// `1 / a`.
#[must_use]
pub fn recip(f: Format, a: u64) -> u64 {
    div(f, f.one(), a)
}

#[inline]
fn quotient(f: Format, a: Value, b: Value) -> Value {
    use Value::{Infinity, Nan, Zero};
    match (a, b) {
        (Nan, _) | (_, Nan) | (Infinity { .. }, Infinity { .. }) | (Zero { .. }, Zero { .. }) => Nan,
        (Infinity { negative }, other) | (other, Zero { negative }) => {
            Infinity { negative: negative != other.is_negative() }
        }
        (Zero { negative }, other) | (other, Infinity { negative }) => {
            Zero { negative: negative != other.is_negative() }
        }
        (Value::Finite(a), Value::Finite(b)) => {
            // The dividend fills 64 bits, so the quotient has 64 − p or more: p + 2 and above for p ≤ 31.
            let scale = 63 - f.mantissa;
            let dividend = a.significand << scale;
            let (quotient, remainder) = (dividend / b.significand, dividend % b.significand);
            let sticky = u64::from(remainder != 0);
            Value::Finite(Finite {
                negative: a.negative != b.negative,
                exponent: a.exponent - b.exponent - scale as i32,
                significand: quotient | sticky,
            })
        }
    }
}
