//! Conversion between formats.

use super::parts::delay;
use super::parts::operand::{Operand, exponent_width, normalize, precision, signed, signed_width};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::round::{Raw, Special, Underflow, round};
use super::parts::shift::keep_sticky;
use pointcore_contract::{Format, Subnormals};
use rtl::Expr;

/// Pipeline registers by default.
#[must_use]
pub fn stages(from: Format, to: Format) -> u32 {
    pipe::stages_for(|pipe| conversion(pipe, from, to))
}

/// Whether the smallest operand lies below the result's normal numbers.
fn underflow(from: Format, to: Format) -> Underflow {
    let subnormal_bits = match from.subnormals {
        Subnormals::Keep => from.mantissa as i32,
        Subnormals::Flush => 0,
    };
    if 1 - from.bias() - subnormal_bits < 1 - to.bias() { Underflow::Possible } else { Underflow::Impossible }
}

/// Module `float_convert`.
#[must_use]
pub fn module(from: Format, to: Format, stages: u32) -> Operator {
    pipe::operator("float_convert", "Floating-point format conversion.", stages, |pipe| conversion(pipe, from, to))
}

fn conversion(pipe: &mut Pipe, from: Format, to: Format) -> Expr {
    pipe.module.variant("from", from);
    pipe.module.variant("to", to);
    let a = Operand::input(pipe, from, "a");
    let special = Special { sign: a.sign, nan: a.nan, infinite: a.infinite, zero: a.zero };
    let special = special.carry(pipe);
    let [a] = normalize(pipe, from, [&a]);

    pipe.takes(delay::adder(from.exponent) + delay::reduction(from.mantissa));
    let offset = to.bias() - from.bias();
    let bits = signed_width(from.exponent_max() as u32 + from.mantissa + offset.unsigned_abs())
        .max(exponent_width(from))
        .max(exponent_width(to));
    let exponent = a.exponent.sext(bits) + signed(bits, offset);
    let significand = keep_sticky(a.significand, precision(to) + 2);
    round(pipe, to, underflow(from, to), Raw { special, exponent, significand })
}
