//! The processing module (thesis 6.5.4): programs carried out bit by bit.

pub mod block;
pub mod gatherer;
pub mod interpreter;
pub mod kernel;

pub use block::Blocks;
pub use gatherer::Gatherer;
pub use interpreter::{Interpreter, Neighborhood, Outcome};
pub use kernel::Kernel;

/// Stages of the compiled pipelines, and cycles between their tokens, from the manifests that the generator writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pipeline {
    /// Stages.
    pub latency: u32,
    /// Cycles from one token to the next.
    pub interval: u32,
}

/// The pipelines of a core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latencies {
    /// Of the block `kernel`.
    pub kernel: Pipeline,
    /// Of the sums' adders.
    pub sums: Pipeline,
}
