//! A rough model of logic delay, in tenths of a nanosecond, that decides where pipeline registers go.
//!
//! The numbers are for a small FPGA (ECP5, speed grade 6), routing included. Only their proportions matter elsewhere.

/// One level of lookup tables.
pub const LEVEL: u32 = 12;
/// What a stage may take beside its register's own delay, for about 130 MHz.
pub const STAGE: u32 = 68;

/// A hardware multiplier: a stage of its own.
pub const MULTIPLIER: u32 = 60;
/// From the clock to the output of a block RAM, which takes the register behind a large table into itself.
pub const BLOCK_RAM: u32 = 50;

/// Addition, subtraction or comparison: a carry chain.
#[must_use]
pub const fn adder(width: u32) -> u32 {
    19 + width * 7 / 20
}

/// Shift by a variable amount.
#[must_use]
pub const fn shifter(width: u32) -> u32 {
    levels(width) * (LEVEL - 2)
}

/// Count of leading zeros.
#[must_use]
pub const fn leading_zeros(width: u32) -> u32 {
    levels(width) * LEVEL
}

/// AND or OR of all bits.
#[must_use]
pub const fn reduction(width: u32) -> u32 {
    levels(width).div_ceil(2) * LEVEL
}

/// `⌈log2(width)⌉`.
#[must_use]
pub const fn levels(width: u32) -> u32 {
    width.next_power_of_two().trailing_zeros()
}
