//! A rough model of logic delay, in tenths of a nanosecond, that decides where pipeline registers go.
//!
//! The numbers are for a small FPGA (ECP5, speed grade 6), routing included. Only their proportions matter elsewhere.

/// One level of lookup tables.
pub const LEVEL: u32 = 9;
/// What a stage may take beside its register's own delay, for about 130 MHz.
pub const STAGE: u32 = 62;

/// Widest operand of one hardware multiplier.
const MULTIPLIER_WIDTH: u32 = 18;

/// Addition, subtraction or comparison: a carry chain.
#[must_use]
pub const fn adder(width: u32) -> u32 {
    13 + width * 2 / 5
}

/// Shift by a variable amount: two stages of the shifter fit one level.
#[must_use]
pub const fn shifter(width: u32) -> u32 {
    levels(width).div_ceil(2) * (LEVEL + 4)
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

/// Unsigned product: a stage of its own if narrow, more than that if pieced together.
#[must_use]
pub const fn multiplier(left: u32, right: u32) -> u32 {
    let narrow = left <= MULTIPLIER_WIDTH && right <= MULTIPLIER_WIDTH;
    if narrow { 55 } else { 55 + adder(left + right) / 2 }
}

/// `⌈log2(width)⌉`.
#[must_use]
pub const fn levels(width: u32) -> u32 {
    width.next_power_of_two().trailing_zeros()
}
