//! How much of a clock cycle an operation takes that has no registers inside, and what it takes to hold a value.
//!
//! One level is half a 4-input look-up table with its wiring: a coarse measure, which only has to keep chains short.

use super::graph::Node;
use super::operation::Operation;
use super::types::Type;

/// Levels that may follow each other between two registers: three gates, or an adder and a gate.
pub(super) const CYCLE_LEVELS: u32 = 6;
/// Levels that are as late as what block memory shows.
pub const BLOCK_MEMORY_LEVELS: u32 = 4;
/// Levels allowed in front of an operator, whose first stage comes in the same cycle: one gate.
pub(super) const OPERATOR_INPUT_LEVELS: u32 = 2;
/// A gate or a choice of two.
const GATE_LEVELS: u32 = 2;
/// Entry into and exit from a carry chain.
const CARRY_BASE_LEVELS: u32 = 3;
/// Bits of a carry chain that take one level.
const CARRY_BITS_PER_LEVEL: u32 = 16;
/// Ratio of inputs in a tree of gates, as a power of two.
const TREE_RADIX_LOG2: u32 = 2;

/// Shortest chain that becomes a memory. A bit of one costs an FPGA about 1½ look-up tables (ECP5: 16 words of 4 bits take
/// 6) and the registered read, so below this length there is little left to save.
pub(super) const MEMORY_STAGES: u32 = 5;

/// Levels of a combinational operation, whose operands have type `operand`. Wiring and sign bits cost nothing.
pub(super) fn levels(node: &Node, operand: Type) -> u32 {
    let carry = CARRY_BASE_LEVELS + operand.width() / CARRY_BITS_PER_LEVEL;
    let levels = match node.operation {
        Operation::Add | Operation::Subtract | Operation::Less | Operation::LessOrEqual => carry,
        Operation::Negate if !operand.is_float() => carry,
        Operation::Minimum | Operation::Maximum => carry + GATE_LEVELS,
        Operation::Equal => GATE_LEVELS * (1 + operand.width().ilog2() / TREE_RADIX_LOG2),
        Operation::Not | Operation::And | Operation::Or | Operation::Xor | Operation::Mux => GATE_LEVELS,
        _ => 0,
    };
    levels.min(CYCLE_LEVELS)
}

/// Levels of a choice among so many.
pub(super) const fn choice_levels(ways: u32) -> u32 {
    GATE_LEVELS * ways.next_power_of_two().ilog2()
}

/// Registers that hold a value for so many cycles.
pub(super) const fn stages(cycles: u32, initiation_interval: u32) -> u32 {
    cycles.div_ceil(initiation_interval)
}
