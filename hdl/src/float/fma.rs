//! Fused multiply-add `a · b + c`, rounded once.
//!
//! The addend is aligned to the product while it is formed, in a field of `3p + 5` bits: the addend leads by at most
//! `p + 2` places (its `p` bits and two of room keep a lower product from the rounding position), then the product's `2p`
//! bits, then guard, round and sticky bit. Subnormal factors need no normalizing: the sum's leading one is found anyway.

use super::add::{Sum, normalize_sum, stop};
use super::parts::delay;
use super::parts::operand::{Operand, exponent_width, precision, signed};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::product::product;
use super::parts::shift::{add_or_subtract, shift_right_sticky};
use pointcore_contract::{Format, Subnormals};
use rtl::{Expr, cat, lit};

/// Guard, round and sticky bit.
const EXTRA: u32 = 3;
/// Places between addend and a product too small to reach it.
const ROOM: u32 = 2;

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| product_sum(pipe, format))
}

/// Width of the field in which the sum is formed.
fn field_width(format: Format) -> u32 {
    3 * precision(format) + ROOM + EXTRA
}

/// Module `float_fma`.
#[must_use]
pub fn module(format: Format, stages: u32) -> Operator {
    pipe::operator("float_fma", "Fused multiply-add, rounded once.", stages, |pipe| product_sum(pipe, format))
}

fn product_sum(pipe: &mut Pipe, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let (p, field) = (precision(format), field_width(format));
    let [a, b, c] = ["a", "b", "c"].map(|name| Operand::input(pipe, format, name));

    let exponents = delay::adder(format.exponent) + delay::LEVEL;
    let zeros = match format.subnormals {
        Subnormals::Keep => delay::reduction(p),
        Subnormals::Flush => 0,
    };
    pipe.takes_longest([exponents, zeros + 2 * delay::LEVEL]);
    let product_sign = a.sign ^ b.sign;
    let product_infinite = a.infinite | b.infinite;
    let product_zero = a.zero | b.zero;
    let opposed = product_sign ^ c.sign;
    let nan = a.nan
        | b.nan
        | c.nan
        | (a.infinite & b.zero)
        | (a.zero & b.infinite)
        | (product_infinite & c.infinite & opposed);
    let infinite = product_infinite | c.infinite;
    // An infinite result takes its sign here: the sum does not know which operand is infinite.
    let mut sign = pipe.carry("sign", c.infinite.mux(c.sign, product_sign));
    let mut subtract = pipe.carry("subtract", opposed & !infinite);
    let nan = pipe.carry("nan", nan);
    let infinite = pipe.carry("infinite", infinite);

    // The product's biased exponent at the field's top bit, where the addend stands unshifted, is `factors + lead`; less
    // one, it is the shift down to exponent 1.
    let bits = exponent_width(format) + 1;
    let lead = (p + EXTRA) as i32 - format.bias();
    let addend_exponent = c.exponent.zext(bits);
    let factors = a.exponent.zext(bits) + b.exponent.zext(bits);
    let below_lead = signed(bits, lead) - addend_exponent;
    let [factors, below_lead, addend_exponent, product_zero, left, right, addend] = pipe.cut([
        ("factors", factors),
        ("below_lead", below_lead),
        ("addend_exponent", addend_exponent),
        ("product_zero", product_zero),
        ("left", a.significand),
        ("right", b.significand),
        ("addend", c.significand),
    ]);
    pipe.takes(exponents + delay::LEVEL);
    let distance = factors + below_lead;
    let addend_leads = pipe.module.wire("addend_leads", product_zero | distance.msb());
    let limit = addend_leads.mux(addend_exponent.sub_lit(1), factors + signed(bits, lead - 1)).trunc(bits - 1);
    let mut limit = pipe.carry("limit", limit);
    let [distance, left, right, addend] = pipe.cut([
        ("distance", (distance & !addend_leads.repeat(bits)).trunc(bits - 1)),
        ("left", left),
        ("right", right),
        ("addend", addend),
    ]);

    // Only the multipliers count here; the shift beside them is left to the tools (docs/decisions/23-delays-are-stated.md).
    let stop = stop(pipe, format, &mut limit, field);
    let aligned = shift_right_sticky(cat([addend, lit(field - p, 0)]), distance);
    let mut aligned = pipe.carry("aligned", aligned);
    let product = product(pipe, left, right);
    let [product] = pipe.cut([("product", product)]);
    let aligned = pipe.arrive(&mut aligned);

    pipe.takes(delay::adder(field) + delay::LEVEL);
    let product = cat([product, lit(EXTRA, 0)]).zext(field);
    let forward = add_or_subtract(product.zext(field + 1), aligned.zext(field + 1), pipe.arrive(&mut subtract));
    let addend_larger = pipe.module.wire("addend_larger", forward.msb());
    let sum = addend_larger.mux(aligned - product, forward.trunc(field));
    let sign = pipe.arrive(&mut sign) ^ addend_larger;
    let sign = pipe.carry("sign", sign);
    normalize_sum(pipe, format, Sum { sign, nan, infinite, subtract, limit, stop, sum })
}
