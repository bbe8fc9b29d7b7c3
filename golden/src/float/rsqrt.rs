//! Reciprocal square root, correctly rounded. 1/√±0 = ±∞, 1/√+∞ = +0; any other negative operand gives NaN.

use super::encoding::{Finite, Value, decode};
use pointcore_contract::Format;

/// `1/√a`, rounded once.
#[must_use]
pub fn rsqrt(f: Format, a: u64) -> u64 {
    reciprocal_root(f, decode(f, a), correctly_rounded).encode(f)
}

/// The special cases that all variants of the operator share; `finite` computes `1/√(significand · 2^exponent)`.
#[inline]
pub(super) fn reciprocal_root(f: Format, a: Value, finite: impl FnOnce(Format, i32, u64) -> Finite) -> Value {
    match a {
        Value::Finite(Finite { negative: false, exponent, significand }) => {
            Value::Finite(finite(f, exponent, significand))
        }
        Value::Zero { negative } => Value::Infinity { negative },
        Value::Infinity { negative: false } => Value::Zero { negative: false },
        Value::Finite(_) | Value::Nan | Value::Infinity { negative: true } => Value::Nan,
    }
}

/// With an even exponent, `r = ⌊2^k/√m⌋` for the `k` that gives `r` at least p + 2 bits. An estimate in f64 is off by
/// one at most and is set right by `r² · m ≤ 2^2k`, in integers (`r` has at most 32 bits for p ≤ 29).
fn correctly_rounded(f: Format, exponent: i32, significand: u64) -> Finite {
    let parity = exponent.rem_euclid(2);
    let radicand = significand << parity; // p or p + 1 bits
    let half_scale = f.mantissa + 3 + f.mantissa.div_ceil(2); // k = p + 1 + ⌈(p + 1)/2⌉
    let scale = 1_u128 << (2 * half_scale);
    let square_times_radicand = |root: u64| u128::from(root * root) * u128::from(radicand);
    let mut root = ((1_u64 << half_scale) as f64 / (radicand as f64).sqrt()) as u64;
    while square_times_radicand(root) > scale {
        root -= 1;
    }
    while square_times_radicand(root + 1) <= scale {
        root += 1;
    }
    let sticky = u64::from(square_times_radicand(root) != scale);
    Finite { negative: false, exponent: -(exponent - parity) / 2 - half_scale as i32, significand: root | sticky }
}
