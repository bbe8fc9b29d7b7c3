//! Integer multiplication with registers on both sides of the product, as the multipliers of FPGAs want it.

use super::types::Type;
use crate::float::Operator;
use crate::rtl::{Expr, Module};
use std::rc::Rc;

/// One register stage for the operands, one for the product.
pub(super) const STAGES: u32 = 2;

/// Module `integer_mul`: ports `enable`, `a`, `b`, and `y` as wide as both. Stages past the second follow the product;
/// with a single one, only the product has a register.
pub(super) fn module(a: Type, b: Type, stages: u32) -> Operator {
    let mut module = Module::new("integer_mul", "Integer product, pipelined.");
    module.parameter("a", a);
    module.parameter("b", b);
    module.parameter("stages", stages);
    let enable = module.input("enable", 1);
    let operands = [("a", a), ("b", b)].map(|(name, ty)| {
        let port = module.input(name, ty.width() as usize);
        if stages == 1 { port } else { register(&mut module, &enable, &format!("{name}_s1"), &port) }
    });
    let [left, right] = &operands;
    let mut product = if matches!(a, Type::Signed(_)) { left.mul_signed(right) } else { left * right };
    for stage in stages.min(2)..=stages {
        product = register(&mut module, &enable, &format!("product_s{stage}"), &product);
    }
    module.output("y", &product);
    Operator { module: Rc::new(module), latency: stages }
}

fn register(module: &mut Module, enable: &Expr, name: &str, value: &Expr) -> Expr {
    let register = module.reg(name, value.width());
    module.next_if(&register, enable, value);
    register.expr()
}
