//! What each node needs from the schedule: nothing, part of a cycle, or an operator of some class.

use super::cost::{CYCLE_LEVELS, OPERATOR_INPUT_LEVELS, choice_levels, levels};
use super::graph::{Graph, ValueId};
use super::operation::Operation;
use super::operators::{OperatorStages, class_name, is_pipelined, is_worth_sharing, operator};
use super::types::Type;
use crate::float::Operator;
use std::collections::HashMap;

/// How a node relates to time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Timing {
    /// The same for every token under way: usable at any time, without registers.
    Static {
        /// Gates behind the port.
        levels: u32,
    },
    /// There when the token is accepted.
    Input,
    /// Within a cycle.
    Combinational {
        /// Part of the cycle it takes.
        levels: u32,
    },
    /// Computed by an operator.
    Pipelined {
        /// Index into [`Plan::classes`].
        class: usize,
    },
}

/// Interchangeable operators and the operations that share them.
pub(super) struct Class {
    /// Kind and formats, such as `add.f32`.
    pub name: String,
    pub operator: Operator,
    pub operations: u32,
    /// The classes of its operations: its own, or those of a compound's.
    pub parts: Vec<String>,
    pub instances: u32,
    /// Whether operations share an instance where the interval allows it.
    is_shared: bool,
    /// Whether the operands are chosen in a cycle of their own, because operations share an instance.
    pub operand_registers: bool,
    /// Operations that share one instance at most.
    ways: u32,
    /// From which operand on they are taken how many cycles later.
    late: (usize, u32),
}

impl Class {
    fn new(operation: &Operation, operands: &[Type], stages: &OperatorStages) -> Self {
        let name = class_name(operation, operands);
        let parts = match operation {
            Operation::Compound(compound) => compound.operations().map(|part| class_name(&part, operands)).collect(),
            _ => vec![name.clone()],
        };
        let late = match operation {
            Operation::Compound(compound) => {
                (2 * compound.products(), operator(&Operation::Multiply, &operands[..2], stages).latency)
            }
            _ => (operands.len(), 0),
        };
        let operator = operator(operation, operands, stages);
        let is_shared = is_worth_sharing(operation);
        Self { name, operator, parts, operations: 0, instances: 0, is_shared, operand_registers: false, ways: 1, late }
    }

    /// Cycles from the operands to the result.
    pub const fn latency(&self) -> u32 {
        self.operator.latency + if self.operand_registers { 1 } else { 0 }
    }

    /// Cycles after the first operands in which one is taken.
    pub const fn offset(&self, position: usize) -> u32 {
        if position < self.late.0 { 0 } else { self.late.1 }
    }

    /// Levels left for the operands' own gates in the cycle in which the operator takes them.
    pub const fn input_levels(&self) -> u32 {
        let budget = if self.operand_registers { CYCLE_LEVELS } else { OPERATOR_INPUT_LEVELS };
        budget.saturating_sub(choice_levels(self.ways))
    }
}

/// Requirements of all nodes of a graph.
pub(super) struct Plan {
    /// Levels of logic that are as late as inputs are.
    pub input_levels: u32,
    pub timing: Vec<Timing>,
    pub classes: Vec<Class>,
}

impl Plan {
    pub fn new(graph: &Graph, initiation_interval: u32, stages: &OperatorStages) -> Self {
        let mut plan = Self { input_levels: 0, timing: Vec::new(), classes: Vec::new() };
        let mut known: HashMap<(Operation, Vec<Type>), usize> = HashMap::new();
        for node in graph.nodes() {
            let operands: Vec<Type> = node.operands.iter().map(|&id| graph.node(id).ty).collect();
            let timing = match node.operation {
                Operation::Input => Timing::Input,
                Operation::Uniform | Operation::Constant(_) => Timing::Static { levels: 0 },
                _ if is_pipelined(&node.operation, operands[0]) => {
                    let key = (node.operation.clone(), operands);
                    let class = *known.entry(key).or_insert_with_key(|(operation, operands)| {
                        plan.classes.push(Class::new(operation, operands, stages));
                        plan.classes.len() - 1
                    });
                    plan.classes[class].operations += 1;
                    Timing::Pipelined { class }
                }
                // The last operand of a choice is as wide as its result; the first is only a bit.
                _ => plan.combinational(&node.operands, levels(node, operands[operands.len() - 1])),
            };
            plan.timing.push(timing);
        }
        for class in &mut plan.classes {
            let operations_each = if class.is_shared { initiation_interval } else { 1 };
            class.instances = class.operations.div_ceil(operations_each);
            class.ways = class.operations.div_ceil(class.instances);
            class.operand_registers = class.ways > 1;
        }
        plan
    }

    pub fn of(&self, value: ValueId) -> Timing {
        self.timing[value.0]
    }

    pub fn is_static(&self, value: ValueId) -> bool {
        matches!(self.of(value), Timing::Static { .. })
    }

    /// Cycles from operands to result.
    pub fn latency(&self, index: usize) -> u32 {
        match self.timing[index] {
            Timing::Pipelined { class } => self.classes[class].latency(),
            Timing::Static { .. } | Timing::Input | Timing::Combinational { .. } => 0,
        }
    }

    /// Cycles from a node's start in which it takes an operand.
    pub fn offset(&self, index: usize, position: usize) -> u32 {
        match self.timing[index] {
            Timing::Pipelined { class } => self.classes[class].offset(position),
            Timing::Static { .. } | Timing::Input | Timing::Combinational { .. } => 0,
        }
    }

    fn combinational(&self, operands: &[ValueId], own: u32) -> Timing {
        let mut chain = 0;
        for &operand in operands {
            match self.of(operand) {
                Timing::Static { levels } => chain = levels.max(chain),
                _ => return Timing::Combinational { levels: own },
            }
        }
        let levels = chain + own;
        if levels <= OPERATOR_INPUT_LEVELS { Timing::Static { levels } } else { Timing::Combinational { levels: own } }
    }
}
