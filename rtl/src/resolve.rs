//! Expressions without detours: constants are folded through wires and registers, and what only renames a signal is that signal.

use std::collections::HashMap;

use super::expression::{Expr, Primitive, lit};
use super::module::{Module, Source};

/// The expressions of one module, resolved.
pub(super) struct Resolver<'a> {
    module: &'a Module,
    /// Registers that never change, by signal.
    constants: HashMap<usize, u128>,
    resolved: HashMap<u64, Expr>,
}

impl<'a> Resolver<'a> {
    pub fn new(module: &'a Module) -> Self {
        let mut resolver = Self { module, constants: HashMap::new(), resolved: HashMap::new() };
        while resolver.find_constants() {
            resolver.resolved.clear();
        }
        resolver
    }

    /// Registers that take nothing but what they hold; says whether there are more of them than were known.
    fn find_constants(&mut self) -> bool {
        let before = self.constants.len();
        for (index, signal) in self.module.signals.iter().enumerate() {
            let Source::Register { reset, next: Some(next) } = &signal.source else { continue };
            let data = self.resolve(next.data);
            let enable = next.enable.and_then(|enable| self.resolve(enable).literal_value());
            let constant = match reset {
                Some(value) if enable == Some(0) || is_signal(data, index) => Some(*value),
                Some(value) => data.literal_value().filter(|data| data == value),
                None => data.literal_value().filter(|_| next.enable.is_none() || enable == Some(1)),
            };
            self.constants.extend(constant.map(|value| (index, value)));
        }
        self.constants.len() > before
    }

    /// The expression without detours.
    pub fn resolve(&mut self, expr: Expr) -> Expr {
        if let Some(&known) = self.resolved.get(&expr.number()) {
            return known;
        }
        let node = expr.node();
        let result = match &node.operation {
            Primitive::Signal(signal) => self.signal(expr, signal.index),
            operation => {
                let mut operands: Vec<Expr> = node.operands.iter().map(|&operand| self.resolve(operand)).collect();
                if *operation == Primitive::Cat {
                    operands = self.joined(&operands);
                }
                let same = operands.len() == node.operands.len()
                    && operands.iter().zip(&node.operands).all(|(a, b)| a.number() == b.number());
                if same { expr } else { Expr::build(operation.clone(), node.width, operands) }
            }
        };
        self.resolved.insert(expr.number(), result);
        result
    }

    fn signal(&mut self, expr: Expr, index: usize) -> Expr {
        if let Some(&value) = self.constants.get(&index) {
            return lit(expr.width(), value);
        }
        match self.driver(index) {
            Some(driver) if matches!(driver.node().operation, Primitive::Literal(_) | Primitive::Signal(_)) => driver,
            _ => expr,
        }
    }

    /// What drives a wire.
    fn driver(&mut self, index: usize) -> Option<Expr> {
        match &self.module.signals[index].source {
            Source::Wire(Some(driver)) => Some(self.resolve(*driver)),
            _ => None,
        }
    }

    /// As [`Resolver::resolve`], where no name is of use: a wire that names bits of a signal is those bits.
    pub fn bits(&mut self, expr: Expr) -> Expr {
        let resolved = self.resolve(expr);
        let Primitive::Signal(signal) = &resolved.node().operation else { return resolved };
        match self.driver(signal.index) {
            Some(driver) if matches!(driver.node().operation, Primitive::Slice(_)) => driver,
            _ => resolved,
        }
    }

    /// Parts of a concatenation, with named neighbors of one signal as the bits that they are together.
    fn joined(&mut self, parts: &[Expr]) -> Vec<Expr> {
        let mut joined: Vec<Expr> = Vec::with_capacity(parts.len());
        for &part in parts {
            let both = joined.last().map(|&last| (self.bits(last), self.bits(part)));
            match both.and_then(|(high, low)| high.adjoining(low)) {
                Some(both) => *joined.last_mut().expect("a part was joined to the last one") = both,
                None => joined.push(part),
            }
        }
        joined
    }
}

fn is_signal(expr: Expr, index: usize) -> bool {
    matches!(&expr.node().operation, Primitive::Signal(signal) if signal.index == index)
}
