//! Hardware descriptions: from a configuration to Verilog.

pub mod bus;
pub mod compiler;
pub mod float;
pub mod points;
pub mod process;
pub mod search;
pub mod splat;
pub mod stream;

mod units;
