//! Numbers of the cores' formats.

use pointcore_contract::splat::{AttributeFormat, UniformFormat};
use pointcore_contract::{Fixed, Format, Signedness};
use pointcore_golden::float::convert;

/// The nearest number of a format, encoded.
#[must_use]
pub fn encode(format: Format, number: f32) -> u32 {
    convert(Format::F32, format, number.to_bits().into()) as u32
}

/// The value of an encoded number; every number of the cores' formats is one of `f32`.
#[must_use]
pub fn decode(format: Format, bits: u32) -> f32 {
    f32::from_bits(convert(format, Format::F32, bits.into()) as u32)
}

/// The nearest attribute, encoded; in fixed point saturated, and zero for a NaN.
#[must_use]
pub fn encode_attribute(format: AttributeFormat, number: f32) -> u32 {
    match format {
        AttributeFormat::Float(format) => encode(format, number),
        AttributeFormat::Fixed(fraction) => encode_fixed(fraction.number(), number),
    }
}

/// The nearest value of a uniform register, encoded; in fixed point as attributes.
#[must_use]
pub fn encode_uniform(format: UniformFormat, number: f32) -> u32 {
    match format {
        UniformFormat::Float(format) => encode(format, number),
        UniformFormat::Fixed(fixed) => encode_fixed(fixed, number),
    }
}

/// The nearest fixed-point number, saturated; zero for a NaN.
fn encode_fixed(Fixed { width, fraction, signed }: Fixed, number: f32) -> u32 {
    let range = match signed {
        Signedness::Signed => -(1_i64 << (width - 1))..=(1 << (width - 1)) - 1,
        Signedness::Unsigned => 0..=(1 << width) - 1,
    };
    let nearest = (f64::from(number) * f64::from(fraction).exp2()).round();
    // A cast saturates, and makes a NaN zero.
    let bits = (nearest as i64).clamp(*range.start(), *range.end()) as u32;
    bits & (u32::MAX >> (u32::BITS - width))
}

/// The value of an encoded attribute.
#[must_use]
pub fn decode_attribute(format: AttributeFormat, bits: u32) -> f32 {
    match format {
        AttributeFormat::Float(format) => decode(format, bits),
        AttributeFormat::Fixed(fraction) => {
            let Fixed { width, fraction, .. } = fraction.number();
            let unused = u32::BITS - width;
            let value = (bits << unused) as i32 >> unused;
            value as f32 / (1_i32 << fraction) as f32
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::{Coefficient, Fraction};

    #[test]
    fn fractions_are_the_nearest_and_saturate() {
        let eight = AttributeFormat::Fixed(Fraction::Eight);
        let numbers = [0.0, 0.5, -0.5, -1.0, 1.0, 7.0, -7.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.011, -0.001];
        let encoded = [0, 0x40, 0xc0, 0x80, 0x7f, 0x7f, 0x80, 0, 0x7f, 0x80, 1, 0];
        assert_eq!(numbers.map(|number| encode_attribute(eight, number)), encoded);
    }

    #[test]
    fn scales_of_filters_are_the_nearest_and_saturate() {
        let format = UniformFormat::Fixed(Coefficient::FILTER_SCALE);
        let numbers = [1.0, 0.25, 15.99, 16.0, 1e9, f32::INFINITY, f32::NAN, -1.0, 1.0 / 8192.0, 1.0 / 8193.0];
        let encoded = [0x1000, 0x400, 0xffd7, 0xffff, 0xffff, 0xffff, 0, 0, 1, 0];
        assert_eq!(numbers.map(|number| encode_uniform(format, number)), encoded);
        assert_eq!(encode_uniform(UniformFormat::Float(Format::F32), 1.5), 1.5_f32.to_bits());
    }

    #[test]
    fn every_fraction_is_encoded_as_it_was_decoded() {
        for (_, fraction) in Fraction::NAMED {
            let format = AttributeFormat::Fixed(fraction);
            for bits in 0..1 << fraction.width() {
                let value = decode_attribute(format, bits);
                assert!((-1.0..1.0).contains(&value));
                assert_eq!(encode_attribute(format, value), bits);
            }
        }
    }
}
