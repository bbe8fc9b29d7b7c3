//! Integer multiplication with registers on both sides of the product, as the multipliers of FPGAs want it, and between the
//! parts and the sum of a product that takes several of them.

use super::types::Type;
use crate::float::pipe::{Operator, Pipe};
use crate::float::product::{product, product_delays};

/// Segments: the operands' way to their registers, then those of the product.
fn delays(a: Type, b: Type) -> Vec<u32> {
    let mut delays = vec![0];
    match a {
        Type::Signed(_) => delays.extend(product_delays(1, 1)),
        _ => delays.extend(product_delays(a.width(), b.width())),
    }
    delays
}

/// A register stage for the operands, one for each step of the product.
pub(super) fn stages(a: Type, b: Type) -> u32 {
    delays(a, b).len() as u32
}

/// Module `integer_mul`: ports `enable`, `a`, `b`, and `y` as wide as both.
pub(super) fn module(a: Type, b: Type, stages: u32) -> Operator {
    let mut pipe = Pipe::new("integer_mul", "Integer product, pipelined.", &delays(a, b), stages);
    pipe.module.parameter("a", a);
    pipe.module.parameter("b", b);
    let [left, right] = [("a", a), ("b", b)].map(|(name, ty)| pipe.module.input(name, ty.width() as usize));
    let [left, right] = pipe.cut([("a", &left), ("b", &right)]);
    let product = match a {
        Type::Signed(_) => left.mul_signed(&right),
        _ => product(&mut pipe, &left, &right),
    };
    pipe.finish(&product)
}
