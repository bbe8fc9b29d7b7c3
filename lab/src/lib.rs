//! What measures the project: accuracy, stability, operators, and the charts of all of them.

pub mod accuracy;
pub mod float_check;
pub mod operands;
pub mod plot;
pub mod stability;
pub mod synthesis;
