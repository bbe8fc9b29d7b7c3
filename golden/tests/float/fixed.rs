//! Conversions to and from fixed point against the host's integer casts, which saturate, and exact arithmetic.

use crate::apfloat::{Exact, encode};
use crate::support::{RANDOM_CASES, Tally, formats, operand_tuples, seed};
use fastrand::Rng;
use pointcore_contract::{Fixed, Format, Signedness};
use pointcore_golden::float;
use rustc_apfloat::Float;

const SHAPES: [(u32, u32); 9] = [(1, 0), (8, 0), (16, 4), (16, 16), (12, 20), (24, 8), (32, 0), (63, 40), (64, 32)];

fn fixed_formats() -> impl Iterator<Item = Fixed> {
    SHAPES.into_iter().flat_map(|(width, fraction)| {
        [Signedness::Signed, Signedness::Unsigned].map(|signed| Fixed { width, fraction, signed })
    })
}

fn range(fixed: Fixed) -> std::ops::RangeInclusive<i128> {
    match fixed.signed {
        Signedness::Signed => -(1 << (fixed.width - 1))..=(1 << (fixed.width - 1)) - 1,
        Signedness::Unsigned => 0..=(1 << fixed.width) - 1,
    }
}

fn low_bits(value: i128, width: u32) -> u64 {
    (value & ((1 << width) - 1)) as u64
}

/// Every number of a named format, and its product with a power of two, is exact in f64; casts truncate and saturate.
#[test]
fn to_fixed_truncates_and_saturates() {
    for f in formats() {
        let mut tally = Tally::new("to_fixed", f);
        for fixed in fixed_formats() {
            let range = range(fixed);
            for [a] in operand_tuples(f) {
                let number = f64::from(f32::from_bits(float::convert(f, Format::F32, a) as u32));
                let truncated = (number * f64::from(fixed.fraction).exp2()) as i128;
                let saturated = truncated.clamp(*range.start(), *range.end());
                tally.check(&[a], float::to_fixed(f, a, fixed), low_bits(saturated, fixed.width));
                let valid = number.is_finite() && saturated == truncated;
                tally.check(&[a], float::to_fixed_checked(f, a, fixed).is_some().into(), valid.into());
            }
        }
        tally.finish();
    }
}

#[test]
fn from_fixed_rounds_once() {
    let mut rng = Rng::with_seed(seed());
    for f in formats() {
        let mut tally = Tally::new("from_fixed", f);
        for fixed in fixed_formats() {
            let range = range(fixed);
            for case in 0..RANDOM_CASES / 10 {
                let bits = match case {
                    0..=32 => low_bits(case as i128 - 16, fixed.width),
                    _ => low_bits(i128::from(rng.i64(..) >> rng.u32(..64)), fixed.width),
                };
                let value = i128::from(bits);
                let value = if value > *range.end() { value - (1 << fixed.width) } else { value };
                let exact = Exact::from_i128(value).value.scalbn(-(fixed.fraction as i32));
                tally.check(&[bits], float::from_fixed(f, bits, fixed), encode(f, exact));
            }
        }
        tally.finish();
    }
}

#[test]
fn from_fixed_agrees_with_host_casts() {
    let mut rng = Rng::with_seed(seed());
    let mut tally = Tally::new("from_i64", Format::F32);
    let fixed = Fixed { width: 64, fraction: 0, signed: Signedness::Signed };
    for _ in 0..RANDOM_CASES {
        let value = rng.i64(..) >> rng.u32(..64);
        tally.check(
            &[value as u64],
            float::from_fixed(Format::F32, value as u64, fixed),
            (value as f32).to_bits().into(),
        );
    }
    tally.finish();
}
