//! `AttributeFormat`: floating or fixed point, and the widths that attributes have on their way through the renderer.

use super::config::{WEIGHT_BITS, WEIGHT_SUM_BITS};
use crate::{Fixed, Format, Signedness};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::str::FromStr;

/// The format of attributes and of what is made of them up to the fragment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AttributeFormat {
    /// Floating point: products and sums are rounded to the same format.
    Float(Format),
    /// Fixed point: products and sums are exact and as wide as that takes.
    Fixed(Fraction),
}

/// Two's complement fractions in `[−1, 1)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fraction {
    /// Of 8 bits.
    Eight,
    /// Of 12 bits.
    Twelve,
    /// Of 16 bits.
    Sixteen,
}

/// An attribute format's name is not one of those [`AttributeFormat::from_str`] knows.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "unknown attribute format `{0}`: expected f32, f24, f16 or bf16, with `-ftz` appended to flush subnormals, or fixed16, fixed12 or \
     fixed8"
)]
pub struct UnknownAttributeFormat(pub String);

impl Fraction {
    /// Every width, with the name of the format.
    pub const NAMED: [(&'static str, Self); 3] =
        [("fixed16", Self::Sixteen), ("fixed12", Self::Twelve), ("fixed8", Self::Eight)];

    const fn signed(width: u32, fraction: u32) -> Fixed {
        Fixed { width, fraction, signed: Signedness::Signed }
    }

    /// Total width in bits, the sign included.
    #[must_use]
    pub const fn width(self) -> u32 {
        match self {
            Self::Eight => 8,
            Self::Twelve => 12,
            Self::Sixteen => 16,
        }
    }

    /// An attribute of a splat or a fragment.
    #[must_use]
    pub const fn number(self) -> Fixed {
        Self::signed(self.width(), self.width() - 1)
    }

    /// A weighted attribute: the whole product.
    #[must_use]
    pub const fn contribution(self) -> Fixed {
        Self::signed(self.width() + WEIGHT_BITS, self.number().fraction + WEIGHT_BITS)
    }

    /// A sum of weighted attributes: it cannot overflow where the sum of weights does not, as no attribute is larger than one.
    #[must_use]
    pub const fn sum(self) -> Fixed {
        Self::signed(self.width() + WEIGHT_SUM_BITS, self.contribution().fraction)
    }
}

impl AttributeFormat {
    /// IEEE 754 binary16, the format of the thesis' FPGA (5.6.2).
    pub const F16: Self = Self::Float(Format::F16);

    /// Bits of an attribute of a splat or a fragment.
    #[must_use]
    pub const fn width(self) -> u32 {
        match self {
            Self::Float(format) => format.width(),
            Self::Fixed(fraction) => fraction.width(),
        }
    }

    /// Bits of a weighted attribute.
    #[must_use]
    pub const fn contribution_width(self) -> u32 {
        match self {
            Self::Float(format) => format.width(),
            Self::Fixed(fraction) => fraction.contribution().width,
        }
    }

    /// Bits of a sum of weighted attributes.
    #[must_use]
    pub const fn sum_width(self) -> u32 {
        match self {
            Self::Float(format) => format.width(),
            Self::Fixed(fraction) => fraction.sum().width,
        }
    }
}

impl From<Format> for AttributeFormat {
    fn from(format: Format) -> Self {
        Self::Float(format)
    }
}

impl fmt::Display for AttributeFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Float(format) => format.fmt(f),
            Self::Fixed(fraction) => write!(f, "fixed{}", fraction.width()),
        }
    }
}

impl FromStr for AttributeFormat {
    type Err = UnknownAttributeFormat;

    fn from_str(text: &str) -> Result<Self, UnknownAttributeFormat> {
        let fixed = Fraction::NAMED.iter().find(|(name, _)| *name == text).map(|(_, fraction)| Self::Fixed(*fraction));
        let float = || text.parse().ok().map(Self::Float);
        fixed.or_else(float).ok_or_else(|| UnknownAttributeFormat(text.to_owned()))
    }
}

impl Serialize for AttributeFormat {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for AttributeFormat {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip() {
        for name in ["f32", "f24-ftz", "f16", "bf16", "fixed16", "fixed12", "fixed8"] {
            let format: AttributeFormat = name.parse().expect("the name is known");
            assert_eq!(format.to_string(), name);
        }
        for name in ["fixed9", "fixed", "fixed8-ftz", "f8", ""] {
            let error = name.parse::<AttributeFormat>().expect_err("there is no such format").to_string();
            assert!(
                error.contains(&format!("`{name}`")) && error.contains("f16") && error.contains("fixed12"),
                "{error}"
            );
        }
    }

    #[test]
    fn the_largest_sum_fits_and_would_not_in_a_bit_less() {
        for (_, fraction) in Fraction::NAMED {
            let most_negative = -(1_i64 << (fraction.width() - 1)) * ((1 << WEIGHT_SUM_BITS) - 1);
            let smallest = |width: u32| -(1_i64 << (width - 1));
            assert!((smallest(fraction.sum().width)..smallest(fraction.sum().width - 1)).contains(&most_negative));
            let most_negative = -(1_i64 << (fraction.width() - 1)) * ((1 << WEIGHT_BITS) - 1);
            let width = fraction.contribution().width;
            assert!((smallest(width)..smallest(width - 1)).contains(&most_negative));
        }
    }

    #[test]
    fn floats_have_one_width() {
        let f16 = AttributeFormat::F16;
        assert_eq!([f16.width(), f16.contribution_width(), f16.sum_width()], [16; 3]);
        let fixed = AttributeFormat::Fixed(Fraction::Twelve);
        assert_eq!([fixed.width(), fixed.contribution_width(), fixed.sum_width()], [12, 28, 40]);
    }
}
