//! Hardware descriptions: from a configuration to Verilog.

pub mod rtl;
