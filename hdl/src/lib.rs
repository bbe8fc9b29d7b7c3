//! Hardware descriptions: from a configuration to Verilog.

pub mod rtl;
pub mod stream;
