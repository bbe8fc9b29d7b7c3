//! Hardware descriptions: from a configuration to Verilog.

pub mod bus;
pub mod compiler;
pub mod core_a;
pub mod core_b;
pub mod float;
pub mod rtl;
pub mod stream;

mod units;
