//! Addition `a + b`; a difference is the sum with the sign of `b` flipped.
//!
//! Single path: the operand of smaller magnitude is aligned to the larger one with guard, round and sticky bit, the sum's
//! leading one brought to the top.

use super::parts::delay;
use super::parts::operand::{Operand, exponent_width, precision};
use super::parts::pipe::{self, Carried, Operator, Pipe};
use super::parts::round::{Raw, Special, Underflow, round};
use super::parts::shift::{add_or_subtract, keep_sticky, shift_out_zeros, shift_right_sticky};
use pointcore_contract::{Format, Subnormals};
use rtl::{Expr, cat, lit};

/// Guard, round and sticky bit.
const EXTRA: u32 = 3;

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| sum(pipe, format))
}

/// Width of a sum, carry included.
fn sum_width(format: Format) -> u32 {
    precision(format) + EXTRA + 1
}

/// Module `float_add`.
#[must_use]
pub fn module(format: Format, stages: u32) -> Operator {
    pipe::operator("float_add", "Floating-point sum.", stages, |pipe| sum(pipe, format))
}

fn sum(pipe: &mut Pipe, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let (a, b) = (Operand::input(pipe, format, "a"), Operand::input(pipe, format, "b"));

    pipe.takes(delay::adder(format.width()) + 2 * delay::LEVEL);
    let swap = pipe.module.wire("swap", a.magnitude.lt(b.magnitude));
    let sign = pipe.carry("sign", swap.mux(b.sign, a.sign));
    let nan = a.nan | b.nan | (a.infinite & b.infinite & (a.sign ^ b.sign));
    let nan = pipe.carry("nan", nan);
    let infinite = pipe.carry("infinite", a.infinite | b.infinite);
    let mut subtract = pipe.carry("subtract", a.sign ^ b.sign);
    let mut limit = pipe.carry("limit", swap.mux(b.exponent, a.exponent));
    let [large, small] = by_magnitude(format, swap, &a, &b);
    let [distance, large, small] = pipe.cut([
        ("distance", swap.mux(b.exponent - a.exponent, a.exponent - b.exponent)),
        ("large", large),
        ("small", small),
    ]);

    let room = lit(EXTRA, 0);
    let stop = stop(pipe, format, &mut limit, sum_width(format));
    pipe.takes(delay::shifter(sum_width(format)));
    let aligned = shift_right_sticky(cat([small, room]), distance.trunc(format.exponent));
    let [large, aligned] = pipe.cut([("large", large), ("aligned", aligned)]);

    pipe.takes(delay::adder(sum_width(format)));
    let (large, aligned) = (cat([large, room]).zext(sum_width(format)), aligned.zext(sum_width(format)));
    let sum = add_or_subtract(large, aligned, pipe.arrive(&mut subtract));
    normalize_sum(pipe, format, Sum { sign, nan, infinite, subtract, limit, stop, sum })
}

/// The significands of the larger operand and of the other; `b` is larger where `swap` is set.
fn by_magnitude(format: Format, swap: Expr, a: &Operand, b: &Operand) -> [Expr; 2] {
    if format.subnormals == Subnormals::Keep {
        return [swap.mux(b.significand, a.significand), swap.mux(a.significand, b.significand)];
    }
    // The larger one is flushed where both are, the other where either is: that is known before `swap`.
    let [a_fraction, b_fraction] = [a, b].map(|operand| operand.magnitude.trunc(format.mantissa));
    let flushed = |normal: Expr, fraction: Expr| cat([normal, fraction & normal.repeat(format.mantissa)]);
    let [large, small] = [swap.mux(b_fraction, a_fraction), swap.mux(a_fraction, b_fraction)];
    [flushed(!(a.zero & b.zero), large), flushed(!(a.zero | b.zero), small)]
}

/// A sum before its leading one is found.
pub(super) struct Sum {
    /// Set if negative, unless the operands cancel.
    pub sign: Carried,
    /// The result is NaN.
    pub nan: Carried,
    /// The result is infinite.
    pub infinite: Carried,
    /// The operands' signs differ.
    pub subtract: Carried,
    /// Places by which the sum can be shifted left until its exponent is 1.
    pub limit: Carried,
    /// From [`stop`].
    pub stop: Option<Carried>,
    /// The sum in the current segment, its lowest bit sticky.
    pub sum: Expr,
}

/// A one at the place in a sum's width that may become the top one: counted among its leading zeros, it leaves a
/// subnormal result in place, at exponent 1. Nothing if the format flushes those.
pub(super) fn stop(pipe: &mut Pipe, format: Format, limit: &mut Carried, width: u32) -> Option<Carried> {
    if format.subnormals == Subnormals::Flush {
        return None;
    }
    let top = lit(width, 1 << (width - 1));
    let stop = top.shr_by(pipe.arrive(limit));
    Some(pipe.carry("stop", stop))
}

/// Takes the sum through a cut, shifts leading zeros out, with the cuts that takes, and rounds.
pub(super) fn normalize_sum(pipe: &mut Pipe, format: Format, raw: Sum) -> Expr {
    let Sum { mut sign, mut nan, mut infinite, mut subtract, mut limit, stop, sum } = raw;
    let [sum] = pipe.cut([("sum", sum)]);

    let marked = match stop {
        Some(mut stop) => sum | pipe.arrive(&mut stop),
        None => sum,
    };
    let cancelled = sum.is_zero();
    let [sign, nan, infinite, subtract] =
        [&mut sign, &mut nan, &mut infinite, &mut subtract].map(|flag| pipe.arrive(flag));
    let special = Special { sign: sign & !(cancelled & subtract), nan, zero: cancelled & !infinite, infinite };
    let special = special.carry(pipe);
    let (sum, shift) = shift_out_zeros(pipe, sum, marked);
    pipe.takes(delay::LEVEL);
    let significand = keep_sticky(sum, precision(format) + 2);
    let exponent = pipe.arrive(&mut limit).add_lit(1) - shift.zext(exponent_width(format));
    round(pipe, format, Underflow::Impossible, Raw { special, exponent, significand })
}
