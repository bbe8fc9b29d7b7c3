//! Tables of the error function, and of the integral of a kernel by it.
//!
//! The argument is `t` in [0, 4) with `index_bits + fraction_bits − 2` fraction bits, the value a fraction of
//! `2^value_bits − 1`. Beyond 4, erf differs from 1 by less than 2^−25. The interpolated value is within
//! `2 · 4^−index_bits` (chord against curve: `h²/8 · max|erf″|`, `h = 4 · 2^−index_bits`, `max|erf″| = √(8/πe) < 1`) and
//! 3/2 units (rounding, truncation) of erf; without interpolation it is within `4/√π · 2^−index_bits` (half an interval) and
//! half a unit. The test is tests/float/tables.rs.

use super::table::Table;
use pointcore_contract::TableShape;

/// `erf(t)` for `t` in [0, 4]: sample `i` is `round(erf(4 · i/2^index_bits) · (2^value_bits − 1))`.
#[must_use]
pub fn erf_table(shape: TableShape) -> Table {
    const ARGUMENT_END: f64 = 4.0;
    // libm, so that every host computes the same table.
    Table::sample(shape, |t| libm::erf(ARGUMENT_END * t))
}

/// `∫₀ᵗ exp(−γy²) dy = √(π/4γ)·erf(√γ·t)` for `t` in [0, 1]: sample `i` is that of `i/2^index_bits`, times `2^value_bits − 1`, rounded.
///
/// The interpolated value is within `√(2γ/e)/8 · 4^−index_bits` (chord against curve, the largest slope of the kernel) and 3/2 units.
#[must_use]
pub fn kernel_integral_table(gamma: f64, shape: TableShape) -> Table {
    let scale = (std::f64::consts::PI / (4.0 * gamma)).sqrt();
    Table::sample(shape, |t| scale * libm::erf(gamma.sqrt() * t))
}
