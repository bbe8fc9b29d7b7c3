//! Number formats, the only description of numbers both sides share: binary floating point (`Format`) and fixed
//! point (`Fixed`).
//!
//! A floating-point value is `sign · exponent · mantissa`, most significant bit first, as in IEEE 754: the exponent is
//! biased by `2^(exponent−1) − 1`, an exponent of all ones holds infinity and NaN. Every operator rounds to nearest,
//! ties to even, and returns the canonical quiet NaN ([`Format::quiet_nan`]) whenever its result is a NaN.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::str::FromStr;

/// What an operator does with subnormal numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Subnormals {
    /// Gradual underflow, as IEEE 754 has it.
    Keep,
    /// A subnormal operand reads as zero of its sign; a result whose magnitude, after rounding with unbounded
    /// exponent, lies below the smallest normal number becomes zero of its sign.
    Flush,
}

/// A binary floating-point format: field widths in bits and the treatment of subnormal numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Format {
    /// Width of the biased exponent field.
    pub exponent: u32,
    /// Width of the stored fraction; the leading one is implied.
    pub mantissa: u32,
    /// Treatment of subnormal numbers.
    pub subnormals: Subnormals,
}

/// Whether a fixed-point number has a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Signedness {
    /// Two's complement.
    Signed,
    /// Not negative.
    Unsigned,
}

/// A fixed-point format: the integer in its `width` bits, times `2^−fraction`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Fixed {
    /// Total width in bits, 1 to 64.
    pub width: u32,
    /// Fraction bits; more than `width` where the leading ones are known to be zero.
    pub fraction: u32,
    /// Whether the number has a sign.
    pub signed: Signedness,
}

/// A format's name is not one of those [`Format::from_str`] knows.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown number format `{0}`: expected f32, f24, f16 or bf16, with `-ftz` appended to flush subnormals")]
pub struct UnknownFormat(pub String);

impl Format {
    /// IEEE 754 binary32.
    pub const F32: Self = Self::new(8, 23);
    /// 24 bits with the exponent of `f32`: a product takes one 18×18 multiplier.
    pub const F24: Self = Self::new(8, 15);
    /// IEEE 754 binary16, the thesis' attribute format (5.6.2).
    pub const F16: Self = Self::new(5, 10);
    /// The upper half of `f32`.
    pub const BF16: Self = Self::new(8, 7);
    /// The named formats, without their flushing variants.
    pub const NAMED: [(&'static str, Self); 4] =
        [("f32", Self::F32), ("f24", Self::F24), ("f16", Self::F16), ("bf16", Self::BF16)];

    const fn new(exponent: u32, mantissa: u32) -> Self {
        Self { exponent, mantissa, subnormals: Subnormals::Keep }
    }

    /// The same field widths with subnormals flushed to zero.
    #[inline]
    #[must_use]
    pub const fn flushed(self) -> Self {
        Self { subnormals: Subnormals::Flush, ..self }
    }

    /// Total width in bits.
    #[inline]
    #[must_use]
    pub const fn width(self) -> u32 {
        1 + self.exponent + self.mantissa
    }

    /// Exponent bias.
    #[inline]
    #[must_use]
    pub const fn bias(self) -> i32 {
        (1 << (self.exponent - 1)) - 1
    }

    /// The biased exponent of infinity and NaN.
    #[inline]
    #[must_use]
    pub const fn exponent_max(self) -> u64 {
        (1 << self.exponent) - 1
    }

    /// Encoding of positive infinity.
    #[inline]
    #[must_use]
    pub const fn infinity(self) -> u64 {
        self.exponent_max() << self.mantissa
    }

    /// Encoding of the one NaN operators return: positive, quiet, no payload.
    #[inline]
    #[must_use]
    pub const fn quiet_nan(self) -> u64 {
        self.infinity() | 1 << (self.mantissa - 1)
    }

    /// Encoding of one.
    #[inline]
    #[must_use]
    pub const fn one(self) -> u64 {
        (self.bias() as u64) << self.mantissa
    }

    /// Mask of the sign bit; the words of numbers that are not negative are below.
    #[inline]
    #[must_use]
    pub const fn sign_mask(self) -> u64 {
        1 << (self.width() - 1)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let widths = Self { subnormals: Subnormals::Keep, ..*self };
        match Self::NAMED.iter().find(|(_, named)| *named == widths) {
            Some((name, _)) => f.write_str(name)?,
            None => write!(f, "e{}m{}", self.exponent, self.mantissa)?,
        }
        if self.subnormals == Subnormals::Flush { f.write_str("-ftz") } else { Ok(()) }
    }
}

impl FromStr for Format {
    type Err = UnknownFormat;

    fn from_str(text: &str) -> Result<Self, UnknownFormat> {
        let (name, flush) = match text.strip_suffix("-ftz") {
            Some(name) => (name, true),
            None => (text, false),
        };
        let named = Self::NAMED.iter().find(|(known, _)| *known == name);
        let (_, format) = named.ok_or_else(|| UnknownFormat(text.to_owned()))?;
        Ok(if flush { format.flushed() } else { *format })
    }
}

impl Serialize for Format {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Format {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip() {
        for (name, format) in Format::NAMED {
            assert_eq!(name.parse(), Ok(format));
            assert_eq!(format.flushed().to_string().parse(), Ok(format.flushed()));
        }
        assert_eq!("f8".parse::<Format>(), Err(UnknownFormat("f8".into())));
    }

    #[test]
    fn constants_match_the_host() {
        assert_eq!(Format::F32.one(), u64::from(1f32.to_bits()));
        assert_eq!(Format::F32.infinity(), u64::from(f32::INFINITY.to_bits()));
        assert_eq!(Format::F32.quiet_nan(), 0x7fc0_0000);
        assert_eq!(Format::F32.sign_mask(), u64::from((-0f32).to_bits()));
    }
}
