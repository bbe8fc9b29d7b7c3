//! The testbench: generated hardware compiled by Verilator and loaded into the process, in lockstep with a model.

pub mod cache;
pub mod lockstep;
pub mod skipped;
pub mod toolchain;
pub mod verilated;
