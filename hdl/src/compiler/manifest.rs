//! What the rest of the world must know about a compiled datapath, written beside its Verilog.

use super::output;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Timing and cost of a datapath.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Name of the unit.
    pub unit: String,
    /// Cycles from a token's acceptance to its entry into the output queue.
    pub latency: u32,
    /// Cycles from one token to the next.
    pub initiation_interval: u32,
    /// Pipelined operators by kind and format, such as `add.f32`; those within a compound are counted one by one.
    pub operators: BTreeMap<String, OperatorUse>,
    /// Flip-flops that the datapath adds to its operators', up to its end: delays, operand registers, phases and validity.
    pub register_bits: u64,
    /// Bits in memories that delay values.
    pub delay_memory_bits: u64,
}

impl Manifest {
    /// Tokens that may be under way at a time, from their acceptance until they are taken, where results wait in a queue.
    #[must_use]
    pub fn tokens(&self) -> u32 {
        output::places(self.latency, self.initiation_interval)
    }
}

/// How often a program needs an operator, and how often the hardware has it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperatorUse {
    /// Copies in hardware.
    pub instances: u32,
    /// Operations of the program, after common ones are merged.
    pub operations: u32,
}
