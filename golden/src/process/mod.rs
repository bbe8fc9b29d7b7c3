//! The processing module (thesis 6.5.4): programs carried out bit by bit.

pub mod bank;
pub mod block;
pub mod control;
pub mod gatherer;
pub mod interpreter;
pub mod kernel;
pub mod output;
pub mod stage;
pub mod threads;
pub mod top;

pub use bank::Bank;
pub use block::Blocks;
pub use control::Control;
pub use gatherer::Gatherer;
pub use interpreter::{Interpreter, Neighborhood, Outcome};
pub use kernel::{Kernel, KernelPipelines, Pipeline};
pub use output::Output;
pub use stage::{Finish, Init};
pub use threads::Threads;
pub use top::Top;

/// Stages of the compiled blocks, from the manifests that the generator writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latencies {
    /// Of `init`, where there is one.
    pub init: Option<u32>,
    /// Of `final`.
    pub finish: u32,
}
