//! Operators that carry out some operations one behind the other: what is between them needs no register outside, and no choice.

use super::operation::Operation;
use super::operators::OPERAND_PORTS;
use crate::float::Operator;
use pointcore_contract::Format;
use rtl::{Expr, Module};
use std::rc::Rc;

/// A sum with products that nothing else takes, of floats of one format; each operation rounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Compound {
    /// `a·b + c·d`.
    SumOfProducts,
    /// `a·b + c`.
    ProductPlus,
}

impl Compound {
    /// All, the largest first.
    pub(super) const ALL: [Self; 2] = [Self::SumOfProducts, Self::ProductPlus];

    /// Its name in messages and generated names.
    pub(super) const fn mnemonic(self) -> &'static str {
        match self {
            Self::SumOfProducts => "mul_mul_add",
            Self::ProductPlus => "mul_add",
        }
    }

    /// How many products it has.
    pub(super) const fn products(self) -> usize {
        match self {
            Self::SumOfProducts => 2,
            Self::ProductPlus => 1,
        }
    }

    /// How many operands it has.
    pub(super) const fn operands(self) -> usize {
        2 + self.products()
    }

    /// Its operations.
    pub(super) fn operations(self) -> impl Iterator<Item = Operation> {
        std::iter::repeat_n(Operation::Multiply, self.products()).chain([Operation::Add])
    }

    /// The operator, made of a multiplier and an adder of the format. It takes an addend when it has the product.
    pub(super) fn operator(self, format: Format, multiplier: &Operator, adder: &Operator) -> Operator {
        let mut module = Module::new(self.mnemonic(), "Floating-point sum with products, each of them rounded.");
        module.variant("product_stages", multiplier.latency);
        module.variant("sum_stages", adder.latency);
        module.variant("format", format);
        let enable = module.input("enable", 1);
        let ports = OPERAND_PORTS[..self.operands()].iter();
        let operands: Vec<Expr> = ports.map(|port| module.input(port, format.width())).collect();
        let (factors, addends) = operands.split_at(2 * self.products());
        let mut terms = Vec::new();
        for (name, factors) in ["product", "second_product"].into_iter().zip(factors.chunks(2)) {
            terms.push(result(&mut module, enable, (name, multiplier), factors));
        }
        terms.extend(addends);
        let y = result(&mut module, enable, ("sum", adder), &terms);
        module.output("y", y);
        Operator { module: Rc::new(module), latency: multiplier.latency + adder.latency }
    }
}

/// What an operator makes of two operands.
fn result(module: &mut Module, enable: Expr, (name, operator): (&str, &Operator), operands: &[Expr]) -> Expr {
    let instance = module.instance(name, operator.module.clone());
    module.connect(instance, "enable", enable);
    OPERAND_PORTS.iter().zip(operands).for_each(|(port, &operand)| module.connect(instance, port, operand));
    module.out(instance, "y")
}
