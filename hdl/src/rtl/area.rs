//! A proxy for area, counted before synthesis.

/// What one module holds, without its children.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Area {
    /// Bits of registers, read ports of memories included.
    pub register_bits: usize,
    /// Bits of memories and tables.
    pub memory_bits: usize,
    /// Multipliers.
    pub multipliers: usize,
    /// Bits of their products.
    pub multiplier_bits: usize,
    /// Bits of sums, differences and ordered comparisons.
    pub adder_bits: usize,
    /// Bits of two-way choices.
    pub mux_bits: usize,
}
