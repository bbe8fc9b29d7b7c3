//! Co-simulation of the generated hardware with its models, and the `pointcore` command.

pub mod lockstep;
pub mod toolchain;
pub mod verilated;
