//! Table of the Gaussian that weighs the samples of a splat, over the squared radius.
//!
//! The argument is ρ² in [0, 1), the value a fraction of `2^value_bits − 1`. The interpolated weight is within
//! `γ²/8 · 4^−index_bits` (chord against curve) and 3/2 units (rounding, truncation) of `exp(−γρ²)`; without interpolation
//! it is within `γ/2 · 2^−index_bits` (half an interval) and half a unit. The test is tests/float/tables.rs.

use super::table::Table;
use pointcore_contract::TableShape;

/// `exp(−γ·t)` for `t` in [0, 1]: sample `i` is `round(exp(−γ · i/2^index_bits) · (2^value_bits − 1))`, of
/// `i + ½` without interpolation.
#[must_use]
pub fn kernel_table(gamma: f64, shape: TableShape) -> Table {
    // libm, so that every host computes the same table.
    Table::sample(shape, |t| libm::exp(-gamma * t))
}
