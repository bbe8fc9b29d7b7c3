//! Minimum and maximum.
//!
//! Of a number and a NaN the number is returned, of two NaNs the canonical one. −0 is less than +0. The result is one of
//! the operands, a subnormal one flushed if the format says so.

use super::encoding::operand;
use pointcore_contract::Format;

/// The lesser of `a` and `b`.
#[must_use]
pub fn min(f: Format, a: u64, b: u64) -> u64 {
    choose(f, a, b, |a, b| a <= b)
}

/// The greater of `a` and `b`.
#[must_use]
pub fn max(f: Format, a: u64, b: u64) -> u64 {
    choose(f, a, b, |a, b| a >= b)
}

#[inline]
fn choose(f: Format, a: u64, b: u64, first_wins: impl Fn(i64, i64) -> bool) -> u64 {
    match (operand(f, a), operand(f, b)) {
        (Some(a), Some(b)) => {
            if first_wins(rank(f, a), rank(f, b)) {
                a
            } else {
                b
            }
        }
        (Some(number), None) | (None, Some(number)) => number,
        (None, None) => f.quiet_nan(),
    }
}

/// An integer in the order of the numbers, −0 right below +0.
#[inline]
fn rank(f: Format, bits: u64) -> i64 {
    let magnitude = (bits & !f.sign_mask()) as i64;
    if bits & f.sign_mask() != 0 { !magnitude } else { magnitude }
}
