//! Reciprocal by table and Newton steps: no divider, and not always correctly rounded.
//!
//! Special operands and results are those of [`recip`]. For any other operand `±m · 2^E`, `m` in [1, 2) with `p − 1`
//! fraction bits and `F = p + 4`:
//!
//! 1. seed: `y = ⌊2^16 / (1 + (2i + 1)/256) + 1/2⌋ · 2^−16`, with `i` the first 7 fraction bits of `m` (zeros appended
//!    where it has fewer);
//! 2. one step for p ≤ 12, two for p ≤ 26: `e = 2 − ⌊m·y⌋`, `y ← ⌊y·e⌋`, where `⌊·⌋` truncates to `F` fraction bits;
//!    the first step uses all 16 fraction bits of the seed, the second the `F` bits of the iterate;
//! 3. `±y · 2^−E` is normalized and rounded by the format's rule; the bits of `y` below the result's last place decide,
//!    those that truncation dropped do not.
//!
//! The error is at most 0.565 ulp (tests/float/newton.rs, every significand of the named formats).

use super::div::recip;
use super::encoding::{Finite, Value, decode};
use super::newton::{SEED_FRACTION_BITS, SEEDS, iterate_fraction_bits, leading_fraction, steps};
use pointcore_contract::Format;

/// About `1 / a`.
#[must_use]
pub fn recip_newton(f: Format, a: u64) -> u64 {
    match decode(f, a) {
        Value::Finite(Finite { negative, exponent, significand }) => {
            let exponent_of_leading_one = exponent + f.mantissa as i32;
            let exponent = -exponent_of_leading_one - iterate_fraction_bits(f) as i32;
            Finite { negative, exponent, significand: iterate(f, significand) }.round(f)
        }
        _ => recip(f, a),
    }
}

/// `1/m` with `F` fraction bits.
#[inline]
fn iterate(f: Format, significand: u64) -> u64 {
    static TABLE: [u64; SEEDS] = seeds();
    let fraction_bits = iterate_fraction_bits(f);
    let mut y = TABLE[leading_fraction(f, significand, SEEDS.ilog2())];
    let mut y_fraction_bits = SEED_FRACTION_BITS;
    for _ in 0..steps(f) {
        let product = (significand * y) >> (f.mantissa + y_fraction_bits - fraction_bits);
        let correction = (2 << fraction_bits) - product;
        y = (y * correction) >> y_fraction_bits;
        y_fraction_bits = fraction_bits;
    }
    y
}

/// Exact: `⌊x + 1/2⌋ = ⌊(⌊2x⌋ + 1)/2⌋`, and `2x = 2^17 · 256 / (256 + 2i + 1)`.
const fn seeds() -> [u64; SEEDS] {
    let mut table = [0; SEEDS];
    let mut i = 0;
    while i < SEEDS {
        let twice = (256 << (SEED_FRACTION_BITS + 1)) / (257 + 2 * i as u64);
        table[i] = twice.div_ceil(2);
        i += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_are_those_of_the_formula() {
        for (i, seed) in seeds().into_iter().enumerate() {
            assert_eq!(seed as f64, (65536.0 / (1.0 + (2.0 * i as f64 + 1.0) / 256.0) + 0.5).floor(), "entry {i}");
        }
    }
}
