//! A testbench for generated Verilog: compiled by Verilator, loaded into the process, and stepped in lockstep with a model in Rust.
//!
//! It knows neither splats nor searches, and can test the hardware of other projects. What it takes is a text with a top module and a
//! list of its ports, as [`rtl`] makes it or as anybody else writes it ([`verilated::VerilogSource`]), and a model: whatever has a
//! function from the words of all inputs to the words of all outputs ([`lockstep::Golden`]).
//!
//! - [`verilated`] runs `verilator --cc`, compiles a shim, loads the result, and steps it with one foreign call a cycle. Builds are kept by
//!   the hash of all they depend on.
//! - [`lockstep`] drives hardware and model with the same inputs and compares every output in every cycle. For units with streams it makes
//!   the inputs itself, with random stalls; for whole cores a [`lockstep::Stimulus`] plays what is around them. A failure names cycle,
//!   port, both values and the command that reproduces it, and replays the last cycles into a waveform. What went well can be
//!   [replayed](lockstep::Recorded) in four states, where what nothing has set is unknown.
//! - [`cache`] keeps what tools make, shared by threads and processes; [`toolchain`] finds them and knows their versions.
//! - [`scratch`] removes what is left of work that was interrupted.
//! - [`skipped`] has tests that cannot run say so.
//!
//! The tests of this crate are the unit tests of pointcore's cores. Only they depend on the cores and their models.

pub mod cache;
pub mod lockstep;
pub mod scratch;
pub mod skipped;
pub mod toolchain;
pub mod verilated;
