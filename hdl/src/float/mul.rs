//! Multiplication `a · b`.
//!
//! Cuts lie on both sides of the raw product, so that it maps to hardware multipliers with registers around them.

use super::parts::delay;
use super::parts::operand::{Operand, exponent_width, normalize, precision};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::product::product;
use super::parts::round::{Raw, Special, Underflow, round};
use super::parts::shift::keep_sticky;
use pointcore_contract::Format;
use rtl::{Expr, lit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| product_of_floats(pipe, format))
}

/// Module `float_mul`.
#[must_use]
pub fn module(format: Format, stages: u32) -> Operator {
    pipe::operator("float_mul", "Floating-point product.", stages, |pipe| product_of_floats(pipe, format))
}

fn product_of_floats(pipe: &mut Pipe, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let [a, b] = ["a", "b"].map(|name| Operand::input(pipe, format, name));
    let special = Special {
        sign: a.sign ^ b.sign,
        nan: a.nan | b.nan | (a.infinite & b.zero) | (a.zero & b.infinite),
        infinite: a.infinite | b.infinite,
        zero: a.zero | b.zero,
    };
    let special = special.carry(pipe);

    let [a, b] = normalize(pipe, format, [&a, &b]);
    let [left, right, exponent] =
        pipe.cut([("left", a.significand), ("right", b.significand), ("exponent", (a.exponent + b.exponent))]);

    let bias = lit(exponent_width(format), format.bias() as u128);
    let mut exponent = pipe.carry("exponent", exponent - bias);
    let product = product(pipe, left, right);
    let [product] = pipe.cut([("product", product)]);

    pipe.takes(delay::LEVEL + delay::reduction(precision(format)));
    // Both factors lie in [1, 2), the product in [1, 4).
    let carry = product.msb();
    let normalized = carry.mux(product, product << 1);
    let exponent = pipe.arrive(&mut exponent) + carry.zext(exponent_width(format));
    let significand = keep_sticky(normalized, precision(format) + 2);
    round(pipe, format, Underflow::Possible, Raw { special, exponent, significand })
}
