//! Integer multiplication with registers on both sides of the product, as the multipliers of FPGAs want it, and between the
//! parts and the sum of a product that takes several of them.

use super::types::Type;
use crate::float::parts::delay;
use crate::float::parts::pipe::{self, Operator, Pipe};
use crate::float::parts::product::{is_pieced, product};
use rtl::Expr;

/// Whether a signed product takes several multipliers: it is that of unsigned numbers, less what signs add to it.
fn is_corrected(a: Type, b: Type) -> bool {
    matches!(a, Type::Signed(_)) && is_pieced(a.width(), b.width())
}

/// A register stage for the operands, one for each step of the product.
pub(super) fn stages(a: Type, b: Type) -> u32 {
    pipe::cuts(|pipe| integer_product(pipe, a, b))
}

/// Module `integer_mul`: ports `enable`, `a`, `b`, and `y` as wide as both.
pub(super) fn module(a: Type, b: Type, stages: u32) -> Operator {
    pipe::operator("integer_mul", "Integer product, pipelined.", stages, |pipe| integer_product(pipe, a, b))
}

fn integer_product(pipe: &mut Pipe, a: Type, b: Type) -> Expr {
    pipe.module.variant("a", a);
    pipe.module.variant("b", b);
    let [left, right] = [("a", a), ("b", b)].map(|(name, ty)| pipe.module.input(name, ty.width()));
    let [left, right] = pipe.cut([("a", left), ("b", right)]);
    match a {
        Type::Signed(_) if is_corrected(a, b) => signed_product(pipe, left, right),
        Type::Signed(_) => {
            pipe.takes(delay::MULTIPLIER);
            left.mul_signed(right)
        }
        _ => product(pipe, left, right),
    }
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
    pipe.takes(2 * delay::adder(width));
    unsigned - left - right
}
