//! Hardware descriptions: from a configuration to Verilog.

pub mod compiler;
pub mod float;
pub mod rtl;
pub mod stream;
