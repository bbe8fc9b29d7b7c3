//! The renderer from scene to picture: generation, the host around it, runs on hardware and model.

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
pub use frame::assemble;
pub use generate::Core;
pub use host::{Counters, Host};
pub use recorded::record;
pub use report::{DEPTH_ROUNDING, EDGE_ROUNDING, Measured, ROUNDING_LIMIT, Report, rounding_limit};
pub use run::{Outcome, Runner};
