//! `f32` against the host's arithmetic.

use crate::support::{Tally, canonical, operand_tuples};
use pointcore_contract::Format;
use pointcore_golden::float;

const F: Format = Format::F32;

fn number(bits: u64) -> f32 {
    f32::from_bits(bits as u32)
}

fn bits(number: f32) -> u64 {
    canonical(F, u64::from(number.to_bits()))
}

fn unary(name: &str, model: impl Fn(u64) -> u64, host: impl Fn(f32) -> f32) {
    let mut tally = Tally::new(name, F);
    for [a] in operand_tuples(F) {
        tally.check(&[a], model(a), bits(host(number(a))));
    }
    tally.finish();
}

fn binary(name: &str, model: impl Fn(u64, u64) -> u64, host: impl Fn(f32, f32) -> u64) {
    let mut tally = Tally::new(name, F);
    for [a, b] in operand_tuples(F) {
        tally.check(&[a, b], model(a, b), host(number(a), number(b)));
    }
    tally.finish();
}

#[test]
fn host_arithmetic() {
    binary("add", |a, b| float::add(F, a, b), |a, b| bits(a + b));
    binary("sub", |a, b| float::sub(F, a, b), |a, b| bits(a - b));
    binary("mul", |a, b| float::mul(F, a, b), |a, b| bits(a * b));
    binary("div", |a, b| float::div(F, a, b), |a, b| bits(a / b));
    unary("recip", |a| float::recip(F, a), |a| 1.0 / a);
    unary("sqrt", |a| float::sqrt(F, a), f32::sqrt);
}

#[test]
fn host_fused_multiply_add() {
    let mut tally = Tally::new("fma", F);
    for [a, b, c] in operand_tuples(F) {
        tally.check(&[a, b, c], float::fma(F, a, b, c), bits(number(a).mul_add(number(b), number(c))));
    }
    tally.finish();
}

#[test]
fn host_comparisons() {
    binary("lt", |a, b| float::lt(F, a, b).into(), |a, b| (a < b).into());
    binary("le", |a, b| float::le(F, a, b).into(), |a, b| (a <= b).into());
    binary("eq", |a, b| float::eq(F, a, b).into(), |a, b| (a == b).into());
}

/// The host leaves open which zero wins; the models order them.
#[test]
fn host_minimum_and_maximum() {
    let with_ordered_zeros = |pick: fn(f32, f32) -> f32, zero: fn(bool, bool) -> bool| {
        move |a: f32, b: f32| match (a == 0.0, b == 0.0) {
            (true, true) => bits(if zero(a.is_sign_negative(), b.is_sign_negative()) { -0.0 } else { 0.0 }),
            _ => bits(pick(a, b)),
        }
    };
    binary("min", |a, b| float::min(F, a, b), with_ordered_zeros(f32::min, |a, b| a || b));
    binary("max", |a, b| float::max(F, a, b), with_ordered_zeros(f32::max, |a, b| a && b));
}

/// A narrow format's comparison is that of the numbers it encodes, flushed ones compare as zeros.
#[test]
fn narrow_formats_compare_as_their_numbers() {
    for f in crate::support::formats() {
        let mut tally = Tally::new("compare", f);
        for [a, b] in operand_tuples(f) {
            let [x, y] = [a, b].map(|operand| number(float::convert(f, F, operand)));
            let models = [float::lt(f, a, b), float::le(f, a, b), float::eq(f, a, b)];
            for (model, host) in models.into_iter().zip([x < y, x <= y, x == y]) {
                tally.check(&[a, b], model.into(), host.into());
            }
            let extremes = [float::min(f, a, b), float::max(f, a, b)].map(|extreme| float::convert(f, F, extreme));
            tally.check(&[a, b], extremes[0], float::min(F, bits(x), bits(y)));
            tally.check(&[a, b], extremes[1], float::max(F, bits(x), bits(y)));
        }
        tally.finish();
    }
}
