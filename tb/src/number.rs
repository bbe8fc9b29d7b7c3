//! Numbers of the cores' formats.

use pointcore_golden::float::convert;
use pointcore_spec::Format;

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
