//! Every format against `rustc_apfloat`, an independent implementation of IEEE 754.
//!
//! It knows no flushing. There, the expected result follows from the rule itself: operands flushed, computed with an
//! exponent too wide to underflow or overflow, flushed by the rounded magnitude, then narrowed.

use crate::support::{Tally, canonical, formats_and_limits, operand_tuples};
use pointcore_contract::{Format, Subnormals};
use pointcore_golden::float;
use rustc_apfloat::ieee::{IeeeFloat, Semantics};
use rustc_apfloat::{Float, FloatConvert};

/// A binary interchange format of any field widths.
pub struct Encoded<const EXPONENT: usize, const MANTISSA: usize>;

impl<const EXPONENT: usize, const MANTISSA: usize> Semantics for Encoded<EXPONENT, MANTISSA> {
    const BITS: usize = 1 + EXPONENT + MANTISSA;
    const EXP_BITS: usize = EXPONENT;
}

type Number<const EXPONENT: usize, const MANTISSA: usize> = IeeeFloat<Encoded<EXPONENT, MANTISSA>>;

/// Exponent bits that no result of three operands leaves.
const WIDE_EXPONENT: usize = 15;

/// Holds every operand and every 64-bit integer exactly.
pub type Exact = Number<15, 64>;

#[derive(Clone, Copy, PartialEq)]
enum Operator {
    Add,
    Sub,
    Mul,
    Div,
    Fma,
}

fn compute<T: Float>(operator: Operator, [a, b, c]: [T; 3]) -> T {
    match operator {
        Operator::Add => a + b,
        Operator::Sub => a - b,
        Operator::Mul => a * b,
        Operator::Div => a / b,
        Operator::Fma => return a.mul_add(b, c).value,
    }
    .value
}

fn resize<From: FloatConvert<To>, To: Float>(number: From) -> To {
    number.convert(&mut false).value
}

fn flush_operand(f: Format, bits: u64) -> u64 {
    let is_subnormal = bits & f.infinity() == 0;
    if f.subnormals == Subnormals::Flush && is_subnormal { bits & f.sign_mask() } else { bits }
}

/// A result rounded to the format's precision only, brought into the format.
fn flush_result<const E: usize, const M: usize>(f: Format, rounded: Number<WIDE_EXPONENT, M>) -> u64 {
    let smallest_normal = Number::<WIDE_EXPONENT, M>::from_u128(1).value.scalbn(1 - f.bias());
    if rounded.is_finite() && rounded.abs() < smallest_normal {
        return if rounded.is_negative() { f.sign_mask() } else { 0 };
    }
    resize::<_, Number<E, M>>(rounded).to_bits() as u64
}

fn expected<const E: usize, const M: usize>(f: Format, operator: Operator, operands: [u64; 3]) -> u64 {
    let numbers = operands.map(|bits| Number::<E, M>::from_bits(flush_operand(f, bits).into()));
    let bits = match f.subnormals {
        Subnormals::Keep => compute(operator, numbers).to_bits() as u64,
        Subnormals::Flush => flush_result::<E, M>(f, compute(operator, numbers.map(resize))),
    };
    canonical(f, bits)
}

/// `number` rounded to `f`.
fn encode_as<const E: usize, const M: usize>(f: Format, number: Exact) -> u64 {
    let bits = match f.subnormals {
        Subnormals::Keep => resize::<_, Number<E, M>>(number).to_bits() as u64,
        Subnormals::Flush => flush_result::<E, M>(f, resize(number)),
    };
    canonical(f, bits)
}

fn decode_as<const E: usize, const M: usize>(f: Format, bits: u64) -> Exact {
    resize(Number::<E, M>::from_bits(flush_operand(f, bits).into()))
}

/// The same function for each format's field widths, chosen at run time.
macro_rules! by_widths {
    ($f:expr, $function:ident($($argument:expr),*)) => {
        match ($f.exponent, $f.mantissa) {
            (8, 23) => $function::<8, 23>($f, $($argument),*),
            (8, 15) => $function::<8, 15>($f, $($argument),*),
            (5, 10) => $function::<5, 10>($f, $($argument),*),
            (8, 7) => $function::<8, 7>($f, $($argument),*),
            (5, 2) => $function::<5, 2>($f, $($argument),*),
            (11, 28) => $function::<11, 28>($f, $($argument),*),
            _ => unreachable!("{} is not a format under test", $f),
        }
    };
}

/// `number` rounded to a format under test.
pub fn encode(f: Format, number: Exact) -> u64 {
    by_widths!(f, encode_as(number))
}

fn decode(f: Format, bits: u64) -> Exact {
    by_widths!(f, decode_as(bits))
}

fn binary(name: &str, operator: Operator, model: impl Fn(Format, u64, u64) -> u64) {
    for f in formats_and_limits() {
        let mut tally = Tally::new(name, f);
        for [a, b] in operand_tuples(f) {
            tally.check(&[a, b], model(f, a, b), by_widths!(f, expected(operator, [a, b, 0])));
        }
        tally.finish();
    }
}

#[test]
fn apfloat_sum_and_difference() {
    binary("add", Operator::Add, float::add);
    binary("sub", Operator::Sub, float::sub);
}

#[test]
fn apfloat_product() {
    binary("mul", Operator::Mul, float::mul);
}

#[test]
fn apfloat_quotient() {
    binary("div", Operator::Div, float::div);
}

#[test]
fn apfloat_fused_multiply_add() {
    for f in formats_and_limits() {
        let mut tally = Tally::new("fma", f);
        for [a, b, c] in operand_tuples(f) {
            tally.check(&[a, b, c], float::fma(f, a, b, c), by_widths!(f, expected(Operator::Fma, [a, b, c])));
        }
        tally.finish();
    }
}

#[test]
fn apfloat_reciprocal() {
    for f in formats_and_limits() {
        let mut tally = Tally::new("recip", f);
        for [a] in operand_tuples(f) {
            tally.check(&[a], float::recip(f, a), by_widths!(f, expected(Operator::Div, [f.one(), a, 0])));
        }
        tally.finish();
    }
}

#[test]
fn apfloat_conversions() {
    for from in formats_and_limits() {
        for to in formats_and_limits() {
            let mut tally = Tally::new(&format!("convert.{from}"), to);
            for [a] in operand_tuples(from) {
                tally.check(&[a], float::convert(from, to, a), encode(to, decode(from, a)));
            }
            tally.finish();
        }
    }
}
