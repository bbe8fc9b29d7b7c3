//! The language of the processing module (thesis 6.5.4): an operator on neighborhoods as a short text, and what the
//! text means.
//!
//! [`Program::parse`] checks a text and makes three blocks of it, each a list of typed nodes without loops or vectors.
//! The golden interpreter carries them out, the compiler makes pipelines of them; neither sees the other. The page for
//! authors is docs/programs.md.
//!
//! A query goes through its blocks in iterations: `init` once, `kernel` once a neighbor, `final` once; then it is done,
//! or the next iteration begins, with the same neighbors or with those of the position it was moved to.

mod block;
mod builder;
pub mod config;
mod declaration;
mod error;
mod instruction;
mod layout;
mod lexer;
pub mod library;
mod operation;
mod parser;
mod ports;
mod program;
pub mod queries;
pub mod records;
pub mod stages;
mod statement;
#[cfg(test)]
mod tests;
pub mod units;

pub use block::{Block, Node, NodeId, Results, Store};
pub use config::{Config, ConfigError};
pub use error::{Fault, ProgramError};
pub use layout::{Field, Layout, Place, Scalar, Type, Word};
pub use operation::{EXP_NEGATIVE_END, EXP_NEGATIVE_TABLE, Literal, Operation, Source};
pub use ports::{Outgoing, Port};
pub use program::{Program, Section};

/// Partial sums of a sum: neighbor `i` of a query, counted from 0, is added to partial sum `i` modulo this.
pub const PARTIAL_SUMS: usize = 8;

/// Words of state that a query has at most.
pub const STATE_WORDS_MAX: usize = 16;
