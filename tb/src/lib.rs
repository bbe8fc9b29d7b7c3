//! Co-simulation of the generated hardware with its models, and the `pointcore` command.

pub mod float_check;
pub mod lockstep;
pub mod toolchain;
pub mod vectors;
pub mod verilated;
