//! The renderer from scene to picture: generation, the host around it, runs on hardware and model.

pub mod area;
mod encode;
mod frame;
mod generate;
mod host;
pub mod mask;
mod memory;
mod recorded;
mod report;
mod run;

pub use encode::Frame as EncodedFrame;
pub use encode::{uniforms, word};
pub use frame::assemble;
pub use generate::Core;
pub use host::{Counters, Host, Progress};
pub use recorded::record;
pub use report::{DEPTH_ROUNDING, EDGE_ROUNDING, Measured, ROUNDING_LIMIT, Report, rounding_limit};
pub use run::{Outcome, Runner};
