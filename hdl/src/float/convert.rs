//! Conversion between formats.

use super::parts::delay;
use super::parts::operand::{Operand, exponent_width, normalize, normalize_delays, precision, signed, signed_width};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::round::{Raw, Special, Underflow, round, round_delays};
use super::parts::shift::keep_sticky;
use pointcore_contract::{Format, Subnormals};

/// Pipeline registers by default.
#[must_use]
pub fn stages(from: Format, to: Format) -> u32 {
    pipe::stages_for(&delays(from, to))
}

fn delays(from: Format, to: Format) -> Vec<u32> {
    let mut delays = normalize_delays(from, delay::adder(from.exponent) + delay::reduction(from.mantissa));
    let preceding = delays.pop().unwrap_or(0);
    delays.extend(round_delays(to, underflow(from, to), preceding));
    delays
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
    let mut pipe = Pipe::new("float_convert", "Floating-point format conversion.", &delays(from, to), stages);
    pipe.module.variant("from", from);
    pipe.module.variant("to", to);
    let a = Operand::input(&mut pipe, from, "a");
    let special = Special { sign: a.sign, nan: a.nan, infinite: a.infinite, zero: a.zero };
    let special = special.carry(&pipe);
    let [a] = normalize(&mut pipe, from, [&a]);

    let offset = to.bias() - from.bias();
    let bits = signed_width(from.exponent_max() as u32 + from.mantissa + offset.unsigned_abs())
        .max(exponent_width(from))
        .max(exponent_width(to));
    let exponent = a.exponent.sext(bits) + signed(bits, offset);
    let significand = keep_sticky(a.significand, precision(to) + 2);
    round(pipe, to, underflow(from, to), Raw { special, exponent, significand })
}
