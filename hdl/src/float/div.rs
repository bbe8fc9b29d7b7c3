//! Division `a / b` and reciprocal `1 / a`, correctly rounded by digit recurrence.
//!
//! Restoring, radix 2: the remainder stays below the divisor and a digit is whether twice the remainder reaches it. The
//! quotient of two significands lies in (1/2, 2): `p + 2` digits hold the result, the bit below it, and one more that
//! the last remainder joins in the sticky bit.

use super::parts::delay;
use super::parts::operand::{Normalized, Operand, exponent_width, normalize, precision};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::round::{CarriedSpecial, Raw, Special, Underflow, round};
use super::parts::shift::keep_sticky;
use pointcore_contract::Format;
use rtl::{Expr, bit, cat, lit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| division(pipe, format))
}

/// Module `float_div`: `a / b`.
#[must_use]
pub fn module(format: Format, stages: u32) -> Operator {
    pipe::operator("float_div", "Floating-point quotient, correctly rounded.", stages, |pipe| division(pipe, format))
}

fn division(pipe: &mut Pipe, format: Format) -> Expr {
    let [a, b] = ["a", "b"].map(|name| Operand::input(pipe, format, name));
    let special = Special {
        sign: a.sign ^ b.sign,
        nan: a.nan | b.nan | (a.zero & b.zero) | (a.infinite & b.infinite),
        infinite: a.infinite | b.zero,
        zero: a.zero | b.infinite,
    };
    let special = special.carry(pipe);
    let [a, b] = normalize(pipe, format, [&a, &b]);
    quotient(pipe, format, special, &a, &b)
}

/// Module `float_recip`: `1 / a`.
#[must_use]
pub fn recip(format: Format, stages: u32) -> Operator {
    let summary = "Floating-point reciprocal, correctly rounded.";
    pipe::operator("float_recip", summary, stages, |pipe| reciprocal(pipe, format))
}

fn reciprocal(pipe: &mut Pipe, format: Format) -> Expr {
    let a = Operand::input(pipe, format, "a");
    let special = recip_special(&a).carry(pipe);
    let [a] = normalize(pipe, format, [&a]);
    let one = Normalized {
        exponent: lit(exponent_width(format), format.bias() as u128),
        significand: lit(precision(format), 1 << format.mantissa),
    };
    quotient(pipe, format, special, &one, &a)
}

/// Special results of a reciprocal.
pub(super) fn recip_special(a: &Operand) -> Special {
    Special { sign: a.sign, nan: a.nan, infinite: a.zero, zero: a.infinite }
}

/// `a / b` of normalized operands.
fn quotient(pipe: &mut Pipe, format: Format, special: CarriedSpecial, a: &Normalized, b: &Normalized) -> Expr {
    pipe.module.variant("format", format);
    let (p, exponent_bits) = (precision(format), exponent_width(format));
    let bias = lit(exponent_bits, format.bias() as u128);
    let mut exponent = pipe.carry("exponent", a.exponent - b.exponent + bias);
    let mut divisor = pipe.carry("divisor", b.significand);
    let [mut remainder] = pipe.cut([("remainder", a.significand.zext(p + 1))]);

    let mut quotient = None;
    for _ in 0..p + 2 {
        pipe.takes(delay::adder(p + 1) + delay::LEVEL);
        let difference = remainder.zext(p + 2) - pipe.arrive(&mut divisor).zext(p + 2);
        let digit = !difference.msb();
        let kept = digit.mux(difference.trunc(p), remainder.trunc(p));
        let digits = quotient.map_or(digit, |quotient| cat([quotient, digit]));
        let [next_remainder, next_quotient] = pipe.cut([("remainder", cat([kept, bit(false)])), ("quotient", digits)]);
        remainder = next_remainder;
        quotient = Some(next_quotient);
    }
    let quotient = quotient.expect("there are p + 2 digits");

    pipe.takes(delay::reduction(p) + delay::LEVEL);
    let below_one = !quotient.msb();
    let digits = cat([quotient, remainder.any()]);
    let exponent = pipe.arrive(&mut exponent) - below_one.zext(exponent_bits);
    let [exponent, significand] =
        pipe.cut([("exponent", exponent), ("significand", keep_sticky(below_one.mux(digits << 1, digits), p + 2))]);
    round(pipe, format, Underflow::Possible, Raw { special, exponent, significand })
}
