//! Integer multiplication with registers on both sides of the product, as the multipliers of FPGAs want it, and between the
//! parts and the sum of a product that takes several of them.

use super::types::Type;
use crate::float::parts::delay;
use crate::float::parts::pipe::{Operator, Pipe};
use crate::float::parts::product::{product, product_delays};
use rtl::Expr;

/// Segments: the operands' way to their registers, then those of the product.
fn delays(a: Type, b: Type) -> Vec<u32> {
    let mut delays = vec![0];
    delays.extend(product_delays(a.width(), b.width()));
    if is_corrected(a, b) {
        delays.push(2 * delay::adder(a.width() + b.width()));
    }
    delays
}

/// Whether a signed product takes several multipliers: it is that of unsigned numbers, less what signs add to it.
fn is_corrected(a: Type, b: Type) -> bool {
    matches!(a, Type::Signed(_)) && product_delays(a.width(), b.width()).len() > 1
}

/// A register stage for the operands, one for each step of the product.
pub(super) fn stages(a: Type, b: Type) -> u32 {
    delays(a, b).len() as u32
}

/// Module `integer_mul`: ports `enable`, `a`, `b`, and `y` as wide as both.
pub(super) fn module(a: Type, b: Type, stages: u32) -> Operator {
    let mut pipe = Pipe::new("integer_mul", "Integer product, pipelined.", &delays(a, b), stages);
    pipe.module.variant("a", a);
    pipe.module.variant("b", b);
    let [left, right] = [("a", a), ("b", b)].map(|(name, ty)| pipe.module.input(name, ty.width()));
    let [left, right] = pipe.cut([("a", left), ("b", right)]);
    let product = match a {
        Type::Signed(_) if is_corrected(a, b) => signed_product(&mut pipe, left, right),
        Type::Signed(_) => left.mul_signed(right),
        _ => product(&mut pipe, left, right),
    };
    pipe.finish(product)
}

/// A product of signed numbers: the top bit of one counts `2^width` less than an unsigned number's, times the other.
fn signed_product(pipe: &mut Pipe, left: Expr, right: Expr) -> Expr {
    let width = left.width() + right.width();
    let mut excess = [("left", left, right), ("right", right, left)].map(|(name, signed, other)| {
        let times_sign = signed.msb().repeat(other.width()) & other;
        (signed.width(), pipe.carry(&format!("excess_{name}"), times_sign))
    });
    let unsigned = product(pipe, left, right);
    let [unsigned] = pipe.cut([("unsigned", unsigned)]);
    let [left, right] = excess.each_mut().map(|(place, times)| pipe.arrive(times).zext(width) << *place);
    unsigned - left - right
}
