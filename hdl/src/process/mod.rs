//! The processing module (thesis 6.5.4): programs as data paths.

pub mod program;
