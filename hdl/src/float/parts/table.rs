//! A sampled function, interpolated linearly where the argument has fraction bits.
//!
//! For the argument `a = index · fraction`: `v[index] + ⌊(v[index+1] − v[index]) · fraction / 2^fraction_bits⌋`. The table
//! holds samples and slopes, so that one read gives both. Without fraction bits it is a memory of samples, `v[index]`, and
//! no multiplier.

use super::delay;
use super::pipe::{self, Operator, Pipe};
use pointcore_contract::TableShape;
use rtl::Expr;

/// Pipeline registers by default.
#[must_use]
pub fn stages(shape: TableShape) -> u32 {
    pipe::stages_for(|pipe| interpolation(pipe, shape, &vec![0; shape.samples()]))
}

/// Module `float_table`: interpolates those samples of `value_bits` bits, or looks them up.
#[must_use]
pub fn module(shape: TableShape, samples: &[u64], stages: u32) -> Operator {
    let summary = "Sampled function, interpolated linearly.";
    pipe::operator("float_table", summary, stages, |pipe| interpolation(pipe, shape, samples))
}

fn interpolation(pipe: &mut Pipe, shape: TableShape, samples: &[u64]) -> Expr {
    pipe.module.variant("index_bits", shape.index_bits);
    pipe.module.variant("fraction_bits", shape.fraction_bits);
    let (value_bits, fraction_bits) = (shape.value_bits, shape.fraction_bits);
    pipe.takes(shape.index_bits.div_ceil(2) * delay::LEVEL);
    let argument = pipe.module.input("a", fraction_bits + shape.index_bits);
    if fraction_bits == 0 {
        let samples: Vec<u128> = samples.iter().map(|&sample| sample.into()).collect();
        let entry = pipe.module.lookup("samples", &samples, value_bits, argument);
        let [entry] = pipe.cut([("entry", entry)]);
        pipe.takes(delay::BLOCK_RAM);
        return entry;
    }
    let slope_mask = (1 << (value_bits + 1)) - 1;
    let entries: Vec<u128> = samples
        .windows(2)
        .map(|ends| {
            let (start, end) = (u128::from(ends[0]), u128::from(ends[1]));
            start << (value_bits + 1) | (end.wrapping_sub(start) & slope_mask)
        })
        .collect();

    let index = argument.bits(argument.width() - 1, fraction_bits);
    let entry = pipe.module.lookup("samples", &entries, 2 * value_bits + 1, index);
    let [entry, fraction] = pipe.cut([("entry", entry), ("fraction", argument.trunc(fraction_bits))]);
    pipe.takes(delay::BLOCK_RAM);
    let mut start = pipe.carry("start", entry.bits(2 * value_bits, value_bits + 1));
    let [slope, fraction] = pipe.cut([("slope", entry.trunc(value_bits + 1)), ("fraction", fraction)]);
    pipe.takes(delay::MULTIPLIER);
    let product = slope.mul_signed(fraction.zext(fraction_bits + 1));
    let rise = product.bits(value_bits + fraction_bits - 1, fraction_bits);
    let [rise] = pipe.cut([("rise", rise)]);
    pipe.takes(delay::adder(value_bits + 1));
    pipe.arrive(&mut start) + rise
}

/// Samples at equal distances of a function from [0, 1] to [0, 1]: of the ends of intervals, or without interpolation of their
/// middles.
pub(crate) fn sample(shape: TableShape, function: impl Fn(f64) -> f64) -> Vec<u64> {
    let (intervals, one) = ((1_u64 << shape.index_bits) as f64, ((1_u64 << shape.value_bits) - 1) as f64);
    let offset = if shape.fraction_bits == 0 { 0.5 } else { 0.0 };
    let sample = |index| (function((index as f64 + offset) / intervals) * one).round() as u64;
    (0..shape.samples()).map(sample).collect()
}
