//! Continuous attributes on their way through the units: made finite, weighted (eq. 5.10), summed (eq. 5.11), normalized (eq. 5.13).
//!
//! - Floating point: every step rounds to the attribute format; a sum that would overflow stops at the largest number.
//! - Fixed point: an attribute is a fraction in `[−1, 1)`, its product with a weight and every sum of products are exact, so sums do not
//!   depend on their order. Sums fit as long as those of weights do; of bits that no sum leads to they are modulo their width.
//!   Normalization computes in the geometry format and rounds to nearest, ties away from zero, once more to the fraction, so that it is off
//!   by half a unit in the last place and four roundings of the geometry format. What rounds to one becomes the largest fraction.

use crate::number::Number;
use pointcore_contract::splat::config::WEIGHT_BITS;
use pointcore_contract::splat::{AttributeFormat, Fraction};
use pointcore_contract::{Fixed, Format};

/// Arithmetic in an attribute format.
#[derive(Clone, Copy, Debug)]
pub struct Arithmetic(pub AttributeFormat);

/// The number in two's complement in the low bits.
const fn signed(fixed: Fixed, bits: u64) -> i64 {
    let unused = 64 - fixed.width;
    (bits << unused) as i64 >> unused
}

/// Its low bits.
const fn encoded(fixed: Fixed, number: i64) -> u64 {
    number as u64 & (u64::MAX >> (64 - fixed.width))
}

/// A fixed-point sum times the reciprocal of its weight, as the nearest fraction.
fn divided(fraction: Fraction, sum: i64, r: Number, geometry: Format) -> i64 {
    let quotient = Number::from_signed(geometry, sum, fraction.sum().fraction) * r;
    let Fixed { width, fraction: places, .. } = fraction.number();
    let halves = quotient.to_signed(width + 1, places + 1);
    let nearest = halves.signum() * ((halves.abs() + 1) / 2);
    nearest.min((1 << places) - 1)
}

impl Arithmetic {
    /// The attribute itself where it is a number; an infinity becomes the largest number of its sign, a NaN zero.
    #[must_use]
    pub fn finite(self, bits: u32) -> u32 {
        match self.0 {
            AttributeFormat::Float(format) => {
                let attribute = Number::new(format, bits);
                if attribute.is_nan() { 0 } else { attribute.saturated().bits() }
            }
            AttributeFormat::Fixed(_) => bits,
        }
    }

    /// Weight times attribute.
    #[must_use]
    pub fn weigh(self, weight: u16, bits: u32) -> u64 {
        match self.0 {
            AttributeFormat::Float(format) => {
                let weight = Number::from_fixed(format, weight.into(), WEIGHT_BITS, WEIGHT_BITS);
                (weight * Number::new(format, bits)).bits().into()
            }
            AttributeFormat::Fixed(fraction) => {
                let product = i64::from(weight) * signed(fraction.number(), bits.into());
                encoded(fraction.contribution(), product)
            }
        }
    }

    /// The sum of a weighted attribute alone.
    #[must_use]
    pub fn alone(self, contribution: u64) -> u64 {
        match self.0 {
            AttributeFormat::Float(_) => contribution,
            AttributeFormat::Fixed(fraction) => encoded(fraction.sum(), signed(fraction.contribution(), contribution)),
        }
    }

    /// The sum of two sums.
    #[must_use]
    pub fn add(self, sum: u64, other: u64) -> u64 {
        match self.0 {
            AttributeFormat::Float(format) => {
                let [sum, other] = [sum, other].map(|bits| Number::new(format, bits as u32));
                (sum + other).saturated().bits().into()
            }
            AttributeFormat::Fixed(fraction) => {
                let [sum, other] = [sum, other].map(|bits| signed(fraction.sum(), bits));
                encoded(fraction.sum(), sum + other)
            }
        }
    }

    /// A sum times the reciprocal of its weight, which is a number of the geometry format.
    #[must_use]
    pub fn normalize(self, sum: u64, r: Number, geometry: Format) -> u32 {
        match self.0 {
            AttributeFormat::Float(format) => {
                (Number::new(format, sum as u32).convert(geometry) * r).convert(format).bits()
            }
            AttributeFormat::Fixed(fraction) => {
                let quotient = divided(fraction, signed(fraction.sum(), sum), r, geometry);
                encoded(fraction.number(), quotient) as u32
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fastrand::Rng;

    const FULL: u16 = u16::MAX;

    fn formats() -> [(Arithmetic, Fraction); 3] {
        Fraction::NAMED.map(|(_, fraction)| (Arithmetic(AttributeFormat::Fixed(fraction)), fraction))
    }

    /// `1/weight` of a sum of weights.
    fn recip(geometry: Format, weight: u64) -> Number {
        Number::from_fixed(geometry, weight, 28, WEIGHT_BITS).recip()
    }

    #[test]
    fn products_are_exact() {
        let eight = Arithmetic(AttributeFormat::Fixed(Fraction::Eight));
        for (attribute, weight) in [(-128, FULL), (127, FULL), (-1, 1), (-1, 0), (77, 12_345)] {
            let product = eight.weigh(weight, encoded(Fraction::Eight.number(), attribute) as u32);
            assert_eq!(signed(Fraction::Eight.contribution(), product), attribute * i64::from(weight));
            let alone = eight.alone(product);
            assert_eq!(signed(Fraction::Eight.sum(), alone), attribute * i64::from(weight));
        }
    }

    #[test]
    fn sums_of_the_largest_do_not_overflow() {
        for (arithmetic, fraction) in formats() {
            let lowest = 1 << (fraction.width() - 1);
            for attribute in [lowest, lowest - 1] {
                let contribution = arithmetic.weigh(FULL, attribute);
                let sum = (0..4096).fold(0, |sum, _| arithmetic.add(sum, contribution));
                let value = signed(fraction.number(), attribute.into());
                assert_eq!(signed(fraction.sum(), sum), 4096 * i64::from(FULL) * value);
                let r = recip(Format::F32, 4096 * u64::from(FULL));
                assert_eq!(arithmetic.normalize(sum, r, Format::F32), attribute, "{fraction:?}");
            }
        }
    }

    #[test]
    fn sums_do_not_depend_on_their_order() {
        let mut random = Rng::with_seed(1);
        for (arithmetic, fraction) in formats() {
            let mut samples: Vec<u64> =
                (0..100).map(|_| arithmetic.weigh(random.u16(..), random.u32(..) >> (32 - fraction.width()))).collect();
            let sum = |samples: &[u64]| samples.iter().fold(0, |sum, sample| arithmetic.add(sum, *sample));
            let expected = sum(&samples);
            random.shuffle(&mut samples);
            assert_eq!(sum(&samples), expected);
        }
    }

    /// The bound of the module's documentation: the geometry format's roundings are of the sum, of the reciprocal with that of the
    /// weight, and of their product.
    #[test]
    fn normalized_attributes_are_near_the_quotient() {
        let mut random = Rng::with_seed(2);
        for geometry in [Format::F32, Format::F24.flushed()] {
            let rounding = 4.0 * 0.5_f64.powi(geometry.mantissa as i32 + 1);
            for (arithmetic, fraction) in formats() {
                let scale = f64::from(1 << (fraction.width() - 1));
                for _ in 0..1000 {
                    let weight = random.u64(1..1 << 28) >> random.u32(0..20);
                    let weight = weight.max(1);
                    let value = (2.0 * random.f64() - 1.0) * scale;
                    let sum = (value * weight as f64) as i64;
                    let bits = arithmetic.normalize(encoded(fraction.sum(), sum), recip(geometry, weight), geometry);
                    let quotient = (sum as f64 / weight as f64).min(scale - 1.0);
                    let error = (signed(fraction.number(), bits.into()) as f64 - quotient).abs();
                    assert!(
                        error <= 0.5 + rounding * scale,
                        "{fraction:?}, {geometry}: {sum}/{weight} is off by {error}"
                    );
                }
            }
        }
    }

    #[test]
    fn halves_are_rounded_away_from_zero_and_ones_saturate() {
        let arithmetic = Arithmetic(AttributeFormat::Fixed(Fraction::Eight));
        let one = recip(Format::F32, 1 << WEIGHT_BITS);
        let normalized = |halves: i64| {
            let sum = encoded(Fraction::Eight.sum(), halves << (WEIGHT_BITS - 1));
            signed(Fraction::Eight.number(), arithmetic.normalize(sum, one, Format::F32).into())
        };
        let halves = [0, 1, 2, 3, -1, -2, -3, 253, 254, 255, 256, 9999, -255, -256, -257, -9999];
        let numbers = [0, 1, 1, 2, -1, -1, -2, 127, 127, 127, 127, 127, -128, -128, -128, -128];
        assert_eq!(halves.map(normalized), numbers);
        // Nothing that a pixel holds, but hardware may meet it: a weight of zero.
        let infinite = recip(Format::F32, 0);
        let sums = [-1, 0, 1].map(|sum| encoded(Fraction::Eight.sum(), sum));
        let numbers = sums.map(|sum| arithmetic.normalize(sum, infinite, Format::F32));
        assert_eq!(numbers, [0x80, 0, 0x7f]);
    }
}
