//! What the Newton variants of reciprocal and reciprocal square root have in common.

use super::delay;
use super::operand::{exponent_width, precision};
use super::pipe::Pipe;
use super::round::{CarriedSpecial, Raw, Underflow, round};
use super::shift::keep_sticky;
use pointcore_contract::Format;
use rtl::{Expr, cat, lit};

/// Bits of a seed table's index.
pub(crate) const INDEX_BITS: u32 = 7;
/// Fraction bits of a seed, which lies in (1/2, 1].
pub(crate) const SEED_FRACTION: u32 = 16;

/// Fraction bits of the iterates.
pub(crate) fn fraction_bits(format: Format) -> u32 {
    precision(format) + 4
}

/// Steps until the seed's error is below the result's.
pub(crate) fn steps(format: Format) -> u32 {
    if precision(format) <= 12 { 1 } else { 2 }
}

/// Fraction bits of the iterate that enters a step.
pub(crate) fn iterate_fraction(format: Format, step: u32) -> u32 {
    if step == 0 { SEED_FRACTION } else { fraction_bits(format) }
}

/// The top `count` fraction bits of a significand, zeros behind the last.
pub(crate) fn top_fraction(significand: Expr, count: u32) -> Expr {
    let mantissa = significand.width() - 1;
    match count.checked_sub(mantissa) {
        None | Some(0) => significand.bits(mantissa - 1, mantissa - count),
        Some(missing) => cat([significand.trunc(mantissa), lit(missing, 0)]),
    }
}

/// `value` of `from` fraction bits truncated to `to` of them and cut to `width` bits.
pub(crate) fn floor(value: Expr, from: u32, to: u32, width: u32) -> Expr {
    value.bits(from - to + width - 1, from - to)
}

/// Normalizes an iterate in (1/2, 1] whose one has that biased exponent, and rounds it.
pub(crate) fn finish(
    pipe: &mut Pipe,
    format: Format,
    underflow: Underflow,
    special: CarriedSpecial,
    exponent: Expr,
    y: Expr,
) -> Expr {
    pipe.takes(delay::LEVEL);
    let below_one = !y.msb();
    let normalized = below_one.mux(y << 1, y);
    let raw = Raw {
        special,
        exponent: exponent - below_one.zext(exponent_width(format)),
        significand: keep_sticky(normalized, precision(format) + 2),
    };
    round(pipe, format, underflow, raw)
}
