//! What a core holds, counted before synthesis, as it is kept of every point.

use super::count::total;
use rtl::Design;
use serde::{Deserialize, Serialize};

/// Totals over a design, as `pointcore plan` shows them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Proxy {
    /// Bits of registers.
    pub register_bits: u64,
    /// Bits of memories and tables.
    pub memory_bits: u64,
    /// Multipliers.
    pub multipliers: u64,
    /// Bits of their products.
    pub product_bits: u64,
    /// Bits of sums, differences and ordered comparisons.
    pub adder_bits: u64,
    /// Bits of two-way choices.
    pub mux_bits: u64,
}

impl Proxy {
    /// Two designs together.
    #[must_use]
    pub const fn sum(self, other: Self) -> Self {
        Self {
            register_bits: self.register_bits + other.register_bits,
            memory_bits: self.memory_bits + other.memory_bits,
            multipliers: self.multipliers + other.multipliers,
            product_bits: self.product_bits + other.product_bits,
            adder_bits: self.adder_bits + other.adder_bits,
            mux_bits: self.mux_bits + other.mux_bits,
        }
    }

    /// Counts a design.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        let area = total(design);
        Self {
            register_bits: area.register_bits,
            memory_bits: area.memory_bits,
            multipliers: area.multipliers,
            product_bits: area.multiplier_bits,
            adder_bits: area.adder_bits,
            mux_bits: area.mux_bits,
        }
    }

    /// What look-up tables may be spent on.
    #[must_use]
    pub const fn logic(&self) -> [f64; 4] {
        [self.adder_bits as f64, self.mux_bits as f64, self.product_bits as f64, self.register_bits as f64]
    }
}
