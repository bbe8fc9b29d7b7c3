//! What a unit takes of a technology.

use serde::{Deserialize, Serialize};

/// What a unit takes of a technology.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeviceArea {
    /// Lookup tables for logic, of four inputs (six in 7-series).
    pub lut: u64,
    /// Carry cells: on ECP5 of two bits, each in the place of two lookup tables; on iCE40 of one bit; in 7-series of four.
    pub carry: u64,
    /// Flip-flops.
    pub flip_flop: u64,
    /// Lookup-table memories: on ECP5 16 words of 4 bits.
    pub distributed_ram: u64,
    /// Block RAMs: on ECP5 of 18 kbit, on iCE40 of 4 kbit, in 7-series of 18 kbit.
    pub block_ram: u64,
    /// Multipliers.
    pub dsp: u64,
    /// Gates, without those of flip-flops and memories.
    pub gate: u64,
    /// Bits of memories that have not been mapped to cells.
    pub memory_bits: u64,
}
