//! The contract between the golden models and the hardware descriptions: number formats, configurations and record
//! layouts. Nothing here computes a result of the hardware.

pub mod format;

pub use format::{Format, Subnormals};
