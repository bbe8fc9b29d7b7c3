//! Core A from scene to picture: generation, the host around it, runs on hardware and model.

pub mod area;
mod encode;
mod frame;
mod generate;
mod host;
mod mask;
mod memory;
mod report;
mod run;

pub use encode::Frame as EncodedFrame;
pub use frame::assemble;
pub use generate::{Core, GenerateError};
pub use host::{Counters, Host, Progress};
pub use mask::end_records;
pub use report::{Measured, Report};
pub use run::{Outcome, Runner, verilate};
