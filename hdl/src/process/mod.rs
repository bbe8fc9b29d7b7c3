//! The processing module (thesis 6.5.4): programs as data paths.

pub mod gatherer;
pub mod kernel;
pub mod program;
