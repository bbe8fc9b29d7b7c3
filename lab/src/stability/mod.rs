//! Numerical stability of the renderer's geometry: hard cases, an exact truth, what must hold, and the methods the thesis measures itself against.
//!
//! docs/stability.md derives the bounds.

pub mod analysis;
pub mod campaign;
pub mod case;
pub mod check;
pub mod compare;
pub mod exact;
pub mod families;
pub mod family;
pub mod figures;
pub mod frames;
pub mod hardware;
pub mod hit;
pub mod lockstep;
pub mod methods;
pub mod page;
pub mod rounding;
pub mod search;
pub mod shrink;
pub mod truth;
