//! Sums, and products that they alone take, become one [`Compound`], as far as that takes no more operators than they do alone. Where
//! operators are shared, a value between them costs a register that holds it, an operand a choice, and both are wires.

use super::compound::Compound;
use super::graph::{Graph, Node, ValueId};
use super::operation::Operation;
use super::optimize::without_dead_values;
use super::types::Type;
use std::collections::HashMap;

/// The same graph with compounds.
pub(super) fn combine(graph: Graph, initiation_interval: u32) -> Graph {
    if initiation_interval == 1 {
        return graph;
    }
    Compound::ALL.into_iter().fold(graph, |graph, compound| {
        let sums = sums(&graph, compound);
        let mut wanted: HashMap<Type, u32> = HashMap::new();
        for sum in &sums {
            *wanted.entry(graph.node(sum.value).ty).or_default() += 1;
        }
        for (ty, count) in &mut wanted {
            *count = most(&graph, compound, *ty, *count, initiation_interval);
        }
        let is_wanted = |sum: &Sum| {
            let left = wanted.get_mut(&graph.node(sum.value).ty).expect("it was counted");
            let is_wanted = *left > 0;
            *left -= u32::from(is_wanted);
            is_wanted
        };
        let chosen: Vec<Sum> = sums.into_iter().filter(is_wanted).collect();
        replace(&graph, compound, &chosen)
    })
}

/// A sum that may become a compound.
struct Sum {
    value: ValueId,
    operands: Vec<Operand>,
}

/// An operand, negated or not.
#[derive(Clone, Copy)]
struct Operand {
    value: ValueId,
    negated: bool,
}

/// How many of so many sums of a type leave as few multipliers and adders as there are without, and the compound's operators busy in
/// three of four phases: one that is seldom busy has as many choices for less.
fn most(graph: &Graph, compound: Compound, ty: Type, sums: u32, initiation_interval: u32) -> u32 {
    let alone = |operation: &Operation| {
        let is_same = |node: &&Node| node.operation == *operation && node.ty == ty;
        graph.nodes().iter().filter(is_same).count() as u32
    };
    let parts = [(alone(&Operation::Multiply), compound.products() as u32), (alone(&Operation::Add), 1)];
    let is_free = |combined: u32| {
        let operators = combined.div_ceil(initiation_interval);
        let is_busy = 4 * combined >= 3 * operators * initiation_interval;
        let free = |(alone, parts): (u32, u32)| {
            (alone - parts * combined).div_ceil(initiation_interval) + parts * operators
                <= alone.div_ceil(initiation_interval)
        };
        is_busy && parts.into_iter().all(free)
    };
    (1..=sums).rev().find(|&combined| is_free(combined)).unwrap_or(0)
}

/// Sums with as many products as the compound has, which nothing else takes.
fn sums(graph: &Graph, compound: Compound) -> Vec<Sum> {
    let mut uses = vec![0; graph.nodes().len()];
    let operands = graph.nodes().iter().flat_map(|node| &node.operands);
    let results = graph.outputs().iter().map(|(_, id)| id);
    operands.chain(results).copied().chain(graph.keep()).for_each(|id| uses[id.0] += 1);
    let is_sum = |id: &ValueId| graph.node(*id).operation == Operation::Add && graph.node(*id).ty.is_float();
    let sum = |value: ValueId| {
        let terms = &graph.node(value).operands;
        let (mut operands, mut addends, mut products) = (Vec::new(), Vec::new(), 0);
        for &term in terms {
            match product(graph, &uses, term).filter(|_| products < compound.products()) {
                Some(factors) => {
                    products += 1;
                    operands.extend(factors);
                }
                None => addends.push(Operand { value: term, negated: false }),
            }
        }
        operands.extend(addends);
        (products == compound.products()).then_some(Sum { value, operands })
    };
    graph.ids().filter(is_sum).filter_map(sum).collect()
}

/// The factors of a term that is a product, or the negative of one, which is that with one factor negated.
fn product(graph: &Graph, uses: &[u32], term: ValueId) -> Option<[Operand; 2]> {
    let (mut value, mut negated) = (term, false);
    while uses[value.0] == 1 {
        let node = graph.node(value);
        match node.operation {
            Operation::Negate => (value, negated) = (node.operands[0], !negated),
            Operation::Multiply => {
                let [left, right] = [0, 1].map(|place| node.operands[place]);
                return Some([Operand { value: left, negated }, Operand { value: right, negated: false }]);
            }
            _ => return None,
        }
    }
    None
}

/// The graph with compounds in the place of sums.
fn replace(graph: &Graph, compound: Compound, sums: &[Sum]) -> Graph {
    let sums: HashMap<ValueId, &Sum> = sums.iter().map(|sum| (sum.value, sum)).collect();
    let mut nodes: Vec<Node> = Vec::new();
    let mut renamed: Vec<ValueId> = Vec::new();
    for (id, node) in graph.ids().zip(graph.nodes()) {
        let node = match sums.get(&id) {
            Some(sum) => {
                let operands = sum.operands.iter().map(|operand| signed(&mut nodes, *operand, &renamed)).collect();
                Node { operation: Operation::Compound(compound), operands, ..node.clone() }
            }
            None => Node { operands: node.operands.iter().map(|operand| renamed[operand.0]).collect(), ..node.clone() },
        };
        nodes.push(node);
        renamed.push(ValueId(nodes.len() - 1));
    }
    without_dead_values(&graph.with_nodes(nodes, |id| renamed[id.0]))
}

/// An operand among the new nodes.
fn signed(nodes: &mut Vec<Node>, Operand { value, negated }: Operand, renamed: &[ValueId]) -> ValueId {
    let value = renamed[value.0];
    let Node { operation, operands, ty, .. } = &nodes[value.0];
    match operation {
        _ if !negated => value,
        Operation::Negate => operands[0],
        _ => {
            let node = Node { operation: Operation::Negate, operands: vec![value], ty: *ty, name: None };
            nodes.push(node);
            ValueId(nodes.len() - 1)
        }
    }
}
