//! The cores behind their buses, and what only they need.

pub mod buffer;
pub mod search;
pub mod splat;
mod wiring;
