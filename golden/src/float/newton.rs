//! What the Newton variants of reciprocal and reciprocal square root have in common.
//!
//! Both work on unsigned fixed point: the operand's significand, a seed `y` from a table of 128 entries, and iterates.

use pointcore_contract::Format;

/// Entries of a seed table.
pub(super) const SEEDS: usize = 128;

/// Fraction bits of a seed. The seeds lie in (1/2, 1], so they take one bit more.
pub(super) const SEED_FRACTION_BITS: u32 = 16;

/// Fraction bits `F = p + 4` of every iterate and intermediate result.
pub(super) fn iterate_fraction_bits(f: Format) -> u32 {
    f.mantissa + 5
}

/// Steps that bring a seed of 8 good bits to precision `p = mantissa + 1`: one up to p = 12, two up to p = 26.
pub(super) fn steps(f: Format) -> u32 {
    debug_assert!(f.mantissa <= 25, "{f} needs more than two Newton steps");
    if f.mantissa < 12 { 1 } else { 2 }
}

/// The first `count` fraction bits of a significand, zeros appended where it has fewer.
#[inline]
pub(super) fn leading_fraction(f: Format, significand: u64, count: u32) -> usize {
    let fraction = significand & ((1 << f.mantissa) - 1);
    ((fraction << count) >> f.mantissa) as usize
}
