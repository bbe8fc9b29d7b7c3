//! Reciprocal square root by table and Newton steps: no divider, and not always correctly rounded.
//!
//! Special operands and results are those of [`rsqrt`](super::rsqrt()). For any other operand `m · 4^k`, `m` in [1, 4)
//! with `p − 1` fraction bits and `F = p + 4`:
//!
//! 1. seed: `y = ⌊2^16 / √c + 1/2⌋ · 2^−16`, with `c` the middle of the interval of `m`: `(1 + (2j + 1)/128) · 2^b`,
//!    where `b = 1` if `m ≥ 2`, and `j` is the first 6 fraction bits of the significand `m / 2^b` (zeros appended where
//!    it has fewer). The table's index is `b · j`, `b` on top;
//! 2. one step for p ≤ 12, two for p ≤ 26: `t = ⌊y·y⌋`, `s = ⌊m·t⌋`, `y ← ⌊y·(3 − s)/2⌋`, where `⌊·⌋` truncates to `F`
//!    fraction bits; the first step uses all 16 fraction bits of the seed, the second the `F` bits of the iterate;
//! 3. `y · 2^−k` is normalized and rounded by the format's rule; the bits of `y` below the result's last place decide,
//!    those that truncation dropped do not.
//!
//! The error is at most 0.576 ulp (tests/float/newton.rs, every significand of the named formats).

use super::encoding::{Finite, decode};
use super::newton::{SEED_FRACTION_BITS, SEEDS, iterate_fraction_bits, leading_fraction, steps};
use super::rsqrt::reciprocal_root;
use pointcore_contract::Format;

/// About `1/√a`.
#[must_use]
pub fn rsqrt_newton(f: Format, a: u64) -> u64 {
    reciprocal_root(f, decode(f, a), newton).encode(f)
}

fn newton(f: Format, exponent: i32, significand: u64) -> Finite {
    let exponent_of_leading_one = exponent + f.mantissa as i32;
    let parity = exponent_of_leading_one.rem_euclid(2);
    let k = (exponent_of_leading_one - parity) / 2;
    Finite {
        negative: false,
        exponent: -k - iterate_fraction_bits(f) as i32,
        significand: iterate(f, parity as u32, significand),
    }
}

/// `1/√m` with `F` fraction bits, `m` the significand times `2^parity`.
#[inline]
fn iterate(f: Format, parity: u32, significand: u64) -> u64 {
    static TABLE: [u64; SEEDS] = seeds();
    let fraction_bits = iterate_fraction_bits(f);
    let half_table = SEEDS / 2;
    let mut y = TABLE[parity as usize * half_table + leading_fraction(f, significand, half_table.ilog2())];
    let mut y_fraction_bits = SEED_FRACTION_BITS;
    for _ in 0..steps(f) {
        let square = (y * y) >> (2 * y_fraction_bits - fraction_bits);
        let product = ((significand << parity) * square) >> f.mantissa;
        y = (y * ((3 << fraction_bits) - product)) >> (y_fraction_bits + 1);
        y_fraction_bits = fraction_bits;
    }
    y
}

/// Exact: `⌊x + 1/2⌋ = ⌊(⌊2x⌋ + 1)/2⌋`, `2x = √(2^34 · 128 / 128c)`, and a floor under the root does not change the
/// root's floor.
const fn seeds() -> [u64; SEEDS] {
    let mut table = [0; SEEDS];
    let mut i = 0;
    while i < SEEDS {
        let (parity, j) = (i / (SEEDS / 2), (i % (SEEDS / 2)) as u64);
        let middle_times_128 = (129 + 2 * j) << parity;
        let twice = ((128 << (2 * SEED_FRACTION_BITS + 2)) / middle_times_128).isqrt();
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
            let (parity, j) = ((i / 64) as i32, (i % 64) as f64);
            let middle = (1.0 + (2.0 * j + 1.0) / 128.0) * f64::from(parity).exp2();
            assert_eq!(seed as f64, (65536.0 / middle.sqrt() + 0.5).floor(), "entry {i}");
        }
    }
}
