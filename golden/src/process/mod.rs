//! The processing module (thesis 6.5.4): programs carried out bit by bit.

pub mod block;
pub mod interpreter;

pub use block::Blocks;
pub use interpreter::{Interpreter, Neighborhood, Outcome};
