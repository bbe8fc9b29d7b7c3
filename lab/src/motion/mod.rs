//! Splats that move while the shutter is open: what hardware makes of a sample, beside f64 with a bound, beside quadrature, and cycle by cycle.

pub mod bound;
pub mod check;
pub mod setup;

#[cfg(test)]
mod tests;
