//! Square root, correctly rounded by digit recurrence.
//!
//! Restoring, radix 2, of the significand in [1, 4) that an even exponent leaves. With `j` digits of the root known, the
//! remainder is at most twice the root; a digit is whether four times the remainder and the next two bits of the
//! radicand reach four times the root and one. The remainder left after `p + 1` digits is the sticky bit.

use super::parts::delay;
use super::parts::operand::{Normalized, Operand, normalize, precision};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::round::{Raw, Special, Underflow, round};
use pointcore_contract::Format;
use rtl::{Expr, bit, cat, lit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| root(pipe, format))
}

/// The parity-adjusted significand in [1, 4) of `p + 1` bits, and half the even exponent that goes with it, plus bias.
pub(super) fn even_exponent(format: Format, operand: &Normalized) -> (Expr, Expr) {
    // The bias is odd, so an even biased exponent is an odd one.
    let odd = !operand.exponent.bit(0);
    let significand = odd.mux(cat([operand.significand, bit(false)]), operand.significand.zext(precision(format) + 1));
    let half = operand.exponent.add_lit(format.bias() as u128).sar(1);
    (significand, half)
}

/// Module `float_sqrt`.
#[must_use]
pub fn module(format: Format, stages: u32) -> Operator {
    pipe::operator("float_sqrt", "Floating-point square root, correctly rounded.", stages, |pipe| root(pipe, format))
}

fn root(pipe: &mut Pipe, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let p = precision(format);
    let a = Operand::input(pipe, format, "a");
    let special = Special { nan: a.nan | (a.sign & !a.zero), sign: a.sign, infinite: a.infinite, zero: a.zero };
    let special = special.carry(pipe);
    let [a] = normalize(pipe, format, [&a]);

    pipe.takes(delay::LEVEL);
    let (radicand, exponent) = even_exponent(format, &a);
    let mut exponent = pipe.carry("exponent", exponent);
    let mut pending = pipe.carry("pending", radicand.trunc(p - 1));
    // The first digit is one.
    let [mut remainder] = pipe.cut([("remainder", radicand.bits(p, p - 1).sub_lit(1))]);

    let mut root = bit(true);
    for digits in 1..=p {
        // The digit chooses among all bits of the remainder, from one end of a carry chain.
        pipe.takes(delay::adder(digits + 3) + 2 * delay::LEVEL);
        let unread = pipe.arrive(&mut pending);
        let reach = cat([remainder, next_pair(unread)]);
        let trial = cat([root, lit(2, 1)]);
        let difference = reach.zext(digits + 4) - trial.zext(digits + 4);
        let digit = !difference.msb();
        let kept = digit.mux(difference.trunc(digits + 2), reach.trunc(digits + 2));
        let rest = if unread.width() > 2 { unread.trunc(unread.width() - 2) } else { bit(false) };
        pending = pipe.carry("pending", rest);
        [remainder, root] = pipe.cut([("remainder", kept), ("root", cat([root, digit]))]);
    }

    pipe.takes(delay::reduction(p));
    let significand = cat([root, remainder.any()]);
    let exponent = pipe.arrive(&mut exponent);
    round(pipe, format, Underflow::Impossible, Raw { special, exponent, significand })
}

/// The top two of the pending bits, zeros behind the last.
fn next_pair(pending: Expr) -> Expr {
    let width = pending.width();
    if width == 1 { cat([pending, bit(false)]) } else { pending.bits(width - 1, width - 2) }
}
