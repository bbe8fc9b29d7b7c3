//! Table of the Gaussian that weighs a splat's samples, over the squared radius in [0, 1].

use super::parts::table::sample;
use pointcore_contract::TableShape;

/// Samples of `exp(−γ·t)` for [`table::module`](super::parts::table::module).
#[must_use]
pub fn samples(gamma: f64, shape: TableShape) -> Vec<u64> {
    sample(shape, |t| (-gamma * t).exp())
}
