//! Common subexpressions, constants and dead values; differences become sums, and
//! reciprocals quotients in a program that divides anyway.
//!
//! Only rewrites that keep every bit: floating-point arithmetic is commuted, never reassociated or evaluated here.

use super::evaluate::{evaluate, sign_mask};
use super::graph::{Graph, Node, ValueId};
use super::operation::Operation;
use super::types::Type;
use std::collections::HashMap;

/// A graph with the same ports and results, and no more nodes than it needs.
pub(super) fn optimize(graph: &Graph) -> Graph {
    let has_divider = graph.nodes().iter().any(|node| node.operation == Operation::Divide);
    let mut rewriter = Rewriter { nodes: Vec::new(), known: HashMap::new(), has_divider };
    let mut renamed: Vec<ValueId> = Vec::with_capacity(graph.nodes().len());
    for node in graph.nodes() {
        let operands: Vec<ValueId> = node.operands.iter().map(|operand| renamed[operand.0]).collect();
        let value = match node.operation {
            Operation::Input | Operation::Uniform => rewriter.append(node.clone()),
            _ => rewriter.rewrite(node.operation.clone(), operands, node.ty),
        };
        let name = &mut rewriter.nodes[value.0].name;
        *name = name.take().or_else(|| node.name.clone());
        renamed.push(value);
    }
    let all = graph.with_nodes(rewriter.nodes, |id| renamed[id.0]);
    without_dead_values(&all)
}

/// Drops nodes that no result depends on. Ports stay: they are the unit's contract.
pub(super) fn without_dead_values(graph: &Graph) -> Graph {
    let mut live = vec![false; graph.nodes().len()];
    for id in graph.outputs().iter().map(|(_, id)| *id).chain(graph.keep()) {
        live[id.0] = true;
    }
    for (index, node) in graph.nodes().iter().enumerate().rev() {
        live[index] |= matches!(node.operation, Operation::Input | Operation::Uniform);
        if live[index] {
            node.operands.iter().for_each(|operand| live[operand.0] = true);
        }
    }
    let mut renamed = vec![ValueId(0); graph.nodes().len()];
    let mut nodes: Vec<Node> = Vec::new();
    for (index, node) in graph.nodes().iter().enumerate().filter(|(index, _)| live[*index]) {
        renamed[index] = ValueId(nodes.len());
        let operands = node.operands.iter().map(|operand| renamed[operand.0]).collect();
        nodes.push(Node { operands, ..node.clone() });
    }
    graph.with_nodes(nodes, |id| renamed[id.0])
}

struct Rewriter {
    nodes: Vec<Node>,
    known: HashMap<(Operation, Vec<ValueId>, Type), ValueId>,
    /// The program divides: reciprocals can use the divider.
    has_divider: bool,
}

impl Rewriter {
    fn append(&mut self, node: Node) -> ValueId {
        self.nodes.push(node);
        ValueId(self.nodes.len() - 1)
    }

    fn constant(&mut self, ty: Type, value: u64) -> ValueId {
        self.rewrite(Operation::Constant(value), Vec::new(), ty)
    }

    /// The value of `operation`: an earlier one where there is one that is equal.
    fn rewrite(&mut self, operation: Operation, mut operands: Vec<ValueId>, ty: Type) -> ValueId {
        if operation.is_commutative() {
            operands[..2].sort_unstable();
        }
        let types: Vec<Type> = operands.iter().map(|id| self.nodes[id.0].ty).collect();
        let constants: Vec<Option<u64>> = operands.iter().map(|&id| self.constant_value(id)).collect();
        let known: Option<Vec<u64>> = constants.iter().copied().collect();
        if let Some(values) = known {
            let typed: Vec<(Type, u64)> = types.iter().copied().zip(values).collect();
            if let Some(value) = evaluate(&operation, &typed, ty) {
                return self.constant(ty, value);
            }
        }
        if let Some(value) = self.simplify(&operation, &operands, &types, &constants, ty) {
            return value;
        }
        let key = (operation, operands, ty);
        if let Some(&value) = self.known.get(&key) {
            return value;
        }
        let (operation, operands, ty) = key.clone();
        let value = self.append(Node { operation, operands, ty, name: None });
        self.known.insert(key, value);
        value
    }

    fn constant_value(&self, id: ValueId) -> Option<u64> {
        match self.nodes[id.0].operation {
            Operation::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// A value that equals the operation's result and costs less, if there is one.
    fn simplify(
        &mut self,
        operation: &Operation,
        operands: &[ValueId],
        types: &[Type],
        constants: &[Option<u64>],
        ty: Type,
    ) -> Option<ValueId> {
        let &first = operands.first()?;
        let is_float = types[0].is_float();
        // The other operand when one of two is the given constant.
        let beside = |value: u64| match constants {
            [Some(constant), _] if *constant == value => Some(operands[1]),
            [_, Some(constant)] if *constant == value => Some(first),
            _ => None,
        };
        match operation {
            Operation::Mux => match constants[0] {
                Some(condition) => Some(operands[if condition == 1 { 1 } else { 2 }]),
                None => (operands[1] == operands[2]).then_some(operands[1]),
            },
            Operation::Subtract if is_float => {
                let negated = self.rewrite(Operation::Negate, vec![operands[1]], ty);
                Some(self.rewrite(Operation::Add, vec![first, negated], ty))
            }
            Operation::Reciprocal if self.has_divider => {
                let Type::Float(format) = ty else { return None };
                let one = self.constant(ty, format.one());
                Some(self.rewrite(Operation::Divide, vec![one, first], ty))
            }
            Operation::Negate | Operation::Not => {
                let inner = &self.nodes[first.0];
                (inner.operation == *operation).then(|| inner.operands[0])
            }
            Operation::And if operands[0] == operands[1] => Some(first),
            Operation::And if beside(0).is_some() => Some(self.constant(ty, 0)),
            Operation::And => beside(ty.mask()),
            Operation::Or if operands[0] == operands[1] => Some(first),
            Operation::Or if beside(ty.mask()).is_some() => Some(self.constant(ty, ty.mask())),
            Operation::Or => beside(0),
            Operation::Xor if operands[0] == operands[1] => Some(self.constant(ty, 0)),
            Operation::Xor => beside(0),
            Operation::Add if !is_float => beside(0),
            Operation::Subtract if constants[1] == Some(0) => Some(first),
            Operation::Multiply if !is_float => self.multiply_by_constant(operands, types, constants, ty),
            Operation::ShiftLeft(0) | Operation::ShiftRight(0) => Some(first),
            Operation::Resize(_) | Operation::Reinterpret(_) if types[0] == ty => Some(first),
            Operation::Bits { high, low: 0 } if high + 1 == types[0].width() => {
                Some(self.rewrite(Operation::Reinterpret(ty), vec![first], ty))
            }
            _ => None,
        }
    }

    /// An integer product with zero or a power of two needs no multiplier.
    fn multiply_by_constant(
        &mut self,
        operands: &[ValueId],
        types: &[Type],
        constants: &[Option<u64>],
        ty: Type,
    ) -> Option<ValueId> {
        let constant_at = constants.iter().position(Option::is_some)?;
        let (factor, other) = (constants[constant_at]?, operands[1 - constant_at]);
        let negative = matches!(ty, Type::Signed(_)) && factor == sign_mask(types[constant_at]);
        match factor {
            0 => Some(self.constant(ty, 0)),
            _ if factor.is_power_of_two() && !negative => {
                let wide = self.rewrite(Operation::Resize(ty.width()), vec![other], ty);
                Some(self.rewrite(Operation::ShiftLeft(factor.trailing_zeros()), vec![wide], ty))
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::program::Program;
    use super::*;
    use pointcore_contract::Format;

    /// Mnemonics left after optimization, ports excluded.
    fn remaining(program: &Program) -> Vec<&'static str> {
        let graph = optimize(&program.graph().expect("the test's program is well typed"));
        let is_port = |node: &&Node| matches!(node.operation, Operation::Input | Operation::Uniform);
        graph.nodes().iter().filter(|node| !is_port(node)).map(|node| node.operation.mnemonic()).collect()
    }

    #[test]
    fn equal_values_are_computed_once() {
        let p = Program::new("test", "");
        let (a, b) = (p.input("a", Type::Float(Format::F16)), p.input("b", Type::Float(Format::F16)));
        p.output("x", a * b + a);
        p.output("y", a + b * a);
        assert_eq!(remaining(&p), ["mul", "add"]);
    }

    #[test]
    fn differences_share_the_adder_and_reciprocals_the_divider() {
        let p = Program::new("test", "");
        let (a, b) = (p.input("a", Type::Float(Format::F16)), p.input("b", Type::Float(Format::F16)));
        p.output("x", a - b);
        p.output("y", a.recip());
        assert_eq!(remaining(&p), ["neg", "add", "recip"]);
        p.output("z", b / a);
        assert_eq!(remaining(&p), ["neg", "add", "constant", "div", "div"]);
    }

    #[test]
    fn integer_constants_fold_and_float_arithmetic_does_not() {
        let p = Program::new("test", "");
        let n = p.input("n", Type::Unsigned(8));
        let two = p.lit(8, 1) + p.lit(8, 1);
        p.output("zero", n * (two - two));
        p.output("double", n * two);
        p.output("same", !(!(n & p.lit(8, 255))));
        let one = p.float(Format::F16, 1.0);
        p.output("float", one + one);
        assert_eq!(remaining(&p), ["constant", "resize", "shl", "constant", "add"]);
    }

    #[test]
    fn values_nobody_uses_vanish() {
        let p = Program::new("test", "");
        let a = p.input("a", Type::Float(Format::F16));
        let _unused = a * a;
        p.output("y", a);
        assert_eq!(remaining(&p), [""; 0]);
    }
}
