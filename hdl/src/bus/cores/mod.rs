//! The cores behind their buses, and what only they need.

pub mod buffer;
mod memory;
mod payloads;
pub mod points;
pub mod search;
pub mod splat;
mod wiring;
