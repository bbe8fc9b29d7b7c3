//! Square root and its reciprocal against the definition of correct rounding, in exact integers.
//!
//! A result `r` is right if the root lies between the midpoints to `r`'s neighbours, on a midpoint only for even `r`.

use crate::support::{formats_and_limits, operand_tuples, reproduce};
use num_bigint::BigUint;
use pointcore_contract::{Format, Subnormals};
use pointcore_golden::float;
use std::cmp::Ordering;

/// `integer · 2^exponent`.
#[derive(Clone)]
struct Dyadic {
    integer: BigUint,
    exponent: i64,
}

impl Dyadic {
    fn new(integer: u64, exponent: i64) -> Self {
        Self { integer: integer.into(), exponent }
    }

    /// The magnitude that the encoding stands for.
    fn decode(f: Format, bits: u64) -> Self {
        let fraction = bits & ((1 << f.mantissa) - 1);
        let last_place = |biased: i64| biased - i64::from(f.bias()) - i64::from(f.mantissa);
        match (bits >> f.mantissa) & f.exponent_max() {
            0 => Self::new(fraction, last_place(1)),
            biased => Self::new(fraction | 1 << f.mantissa, last_place(biased as i64)),
        }
    }

    /// Halfway between two neighbouring encodings of the same sign.
    fn midpoint(f: Format, lower: u64) -> Self {
        let (a, b) = (Self::decode(f, lower), Self::decode(f, lower + 1));
        let exponent = a.exponent.min(b.exponent);
        let [a, b] = [a, b].map(|value| value.integer << (value.exponent - exponent) as usize);
        Self { integer: a + b, exponent: exponent - 1 }
    }

    fn times(&self, other: &Self) -> Self {
        Self { integer: &self.integer * &other.integer, exponent: self.exponent + other.exponent }
    }

    fn compare(&self, other: &Self) -> Ordering {
        let exponent = self.exponent.min(other.exponent);
        let [a, b] = [self, other].map(|value| &value.integer << (value.exponent - exponent) as usize);
        a.cmp(&b)
    }
}

/// Operands whose root is a positive number.
fn operands(f: Format) -> impl Iterator<Item = u64> {
    let smallest = match f.subnormals {
        Subnormals::Keep => 1,
        Subnormals::Flush => 1 << f.mantissa,
    };
    let magnitudes = operand_tuples(f).map(move |[a]| a & !f.sign_mask());
    magnitudes.filter(move |bits| (smallest..f.infinity()).contains(bits))
}

/// Checks `model` where `order(root, x)` says how `root` compares with the exact result.
fn correctly_rounded(name: &str, model: fn(Format, u64) -> u64, order: fn(&Dyadic, &Dyadic) -> Ordering) {
    for f in formats_and_limits() {
        let mut cases = 0_u64;
        for a in operands(f) {
            let root = model(f, a);
            let x = Dyadic::decode(f, a);
            let below = order(&Dyadic::midpoint(f, root - 1), &x);
            let above = order(&Dyadic::midpoint(f, root), &x);
            let tie_allowed = root & 1 == 0;
            assert!(
                below == Ordering::Less || tie_allowed && below == Ordering::Equal,
                "{name}({a:x}) = {root:x} in {f} is too large\n{}",
                reproduce()
            );
            assert!(
                above == Ordering::Greater || tie_allowed && above == Ordering::Equal,
                "{name}({a:x}) = {root:x} in {f} is too small\n{}",
                reproduce()
            );
            cases += 1;
        }
        println!("fp.{name}.{f}.cases {cases}\nfp.{name}.{f}.mismatches 0");
        assert!(cases > 0, "no case was checked");
    }
}

#[test]
fn square_root_is_correctly_rounded() {
    correctly_rounded("sqrt", float::sqrt, |root, x| root.times(root).compare(x));
}

#[test]
fn reciprocal_square_root_is_correctly_rounded() {
    let one = |root: &Dyadic, x: &Dyadic| root.times(root).times(x).compare(&Dyadic::new(1, 0));
    correctly_rounded("rsqrt", float::rsqrt, one);
}

#[test]
fn roots_of_special_operands() {
    for f in formats_and_limits() {
        let (infinity, nan, sign) = (f.infinity(), f.quiet_nan(), f.sign_mask());
        for (operand, sqrt, rsqrt) in [
            (0, 0, infinity),
            (sign, sign, infinity | sign),
            (infinity, infinity, 0),
            (infinity | sign, nan, nan),
            (f.one() | sign, nan, nan),
            (infinity + 1, nan, nan),
            (f.one(), f.one(), f.one()),
        ] {
            assert_eq!(float::sqrt(f, operand), sqrt, "sqrt({operand:x}) in {f}");
            assert_eq!(float::rsqrt(f, operand), rsqrt, "rsqrt({operand:x}) in {f}");
        }
        let subnormal = 1;
        let flushes = f.subnormals == Subnormals::Flush;
        assert_eq!(float::sqrt(f, subnormal) == 0, flushes, "{f}");
        assert_eq!(float::sqrt(f, subnormal | sign), if flushes { sign } else { nan }, "{f}");
        assert_eq!(float::rsqrt(f, subnormal) == infinity, flushes, "{f}");
        assert_eq!(float::rsqrt(f, subnormal | sign), if flushes { infinity | sign } else { nan }, "{f}");
    }
}
