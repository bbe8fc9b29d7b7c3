//! The cores behind their buses, and what only they need.

pub mod buffer;
mod depths;
mod memory;
mod payloads;
pub mod points;
mod port;
pub mod search;
pub mod splat;
mod wiring;
