//! `RasterFormat`: floating or fixed point behind setup, and the widths that footprints and places have in the latter.

use super::config::WEIGHT_BITS;
use crate::{Fixed, Format, Signedness};
use std::fmt;
use std::str::FromStr;

/// The format of footprints and of the rasterizer, down to ρ².
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RasterFormat {
    /// Floating point.
    Float(Format),
    /// Fixed point: the coefficients of a footprint are integers with one power of two in common, which ρ² does not depend on.
    Fixed(Coefficient),
}

/// Two's complement coefficients of footprints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Coefficient {
    /// Of 16 bits.
    Sixteen,
    /// Of 18 bits, as wide as many hardware multipliers.
    Eighteen,
}

/// A rasterizer format's name is not one of those [`RasterFormat::from_str`] knows.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "unknown rasterizer format `{0}`: expected f32, f24 or bf16, with `-ftz` appended to flush subnormals, or fixed18 or \
     fixed16"
)]
pub struct UnknownRasterFormat(pub String);

impl Coefficient {
    /// Every width, with the name of the format.
    pub const NAMED: [(&'static str, Self); 2] = [("fixed18", Self::Eighteen), ("fixed16", Self::Sixteen)];
    /// Integer bits of a projected centre, px, the sign included: from two of the largest images beside the image on.
    pub const CENTER_INTEGER_BITS: u32 = 14;
    /// Bits of the number of places by which a splat's offsets are shifted.
    pub const SHIFT_BITS: u32 = 4;
    /// Bits of `s` and `D` that are left when they are squared: as wide as a hardware multiplier.
    pub const SIGNIFICANT_BITS: u32 = 18;
    /// Format of the uniform `filter_scale`.
    pub const FILTER_SCALE: Fixed = Fixed { width: WEIGHT_BITS, fraction: 12, signed: Signedness::Unsigned };
    /// Squared distances below the radius of a screen filter, px²: the filter reaches no farther.
    pub const FILTER_SQUARE: Fixed = Fixed { width: 18, fraction: 14, signed: Signedness::Unsigned };
    /// Integer bits of an offset from the centre of a screen filter, px, the sign included.
    const FILTER_INTEGER_BITS: u32 = 4;

    const fn signed(integer: u32, fraction: u32) -> Fixed {
        Fixed { width: integer + fraction, fraction, signed: Signedness::Signed }
    }

    /// Total width in bits, the sign included.
    #[must_use]
    pub const fn width(self) -> u32 {
        match self {
            Self::Sixteen => 16,
            Self::Eighteen => 18,
        }
    }

    /// Fraction bits of a place, px: as many as let the offsets of splats of some pixels fill the width.
    #[must_use]
    pub const fn place_fraction(self) -> u32 {
        self.width() - 4
    }

    /// A projected centre, px.
    #[must_use]
    pub const fn center(self) -> Fixed {
        Self::signed(Self::CENTER_INTEGER_BITS, self.place_fraction())
    }

    /// From a centre to a sample, px: a bit more, since images are half as wide as the range of centres at most.
    #[must_use]
    pub const fn offset(self) -> Fixed {
        Self::signed(Self::CENTER_INTEGER_BITS + 1, self.place_fraction())
    }

    /// From the centre of a screen filter to a sample, px.
    #[must_use]
    pub const fn filter_offset(self) -> Fixed {
        let fraction = self.place_fraction();
        let fraction = if fraction < Self::FILTER_SQUARE.fraction { fraction } else { Self::FILTER_SQUARE.fraction };
        Self::signed(Self::FILTER_INTEGER_BITS, fraction)
    }

    /// Bits of `Δ`, which is an area where the others are lengths.
    #[must_use]
    pub const fn delta_width(self) -> u32 {
        2 * self.width() - self.place_fraction()
    }

    /// A `Δ` of a smaller magnitude is the rounding of offsets and coefficients.
    #[must_use]
    pub const fn delta_least(self) -> u32 {
        2 << (self.width() - self.place_fraction())
    }
}

impl RasterFormat {
    /// Bits of a projected centre's coordinate.
    #[must_use]
    pub const fn center_width(self) -> u32 {
        match self {
            Self::Float(format) => format.width(),
            Self::Fixed(coefficient) => coefficient.center().width,
        }
    }

    /// Bits of a coefficient.
    #[must_use]
    pub const fn coefficient_width(self) -> u32 {
        match self {
            Self::Float(format) => format.width(),
            Self::Fixed(coefficient) => coefficient.width(),
        }
    }

    /// Bits of `Δ`.
    #[must_use]
    pub const fn delta_width(self) -> u32 {
        match self {
            Self::Float(format) => format.width(),
            Self::Fixed(coefficient) => coefficient.delta_width(),
        }
    }

    /// Bits of a limit of `|D|`: in floating point a magnitude, in fixed point one in units of `Δ`.
    #[must_use]
    pub const fn limit_width(self) -> u32 {
        match self {
            Self::Float(format) => format.width() - 1,
            Self::Fixed(coefficient) => coefficient.delta_width(),
        }
    }

    /// The format of coefficients, in floating point.
    #[must_use]
    pub const fn floating(self) -> Option<Format> {
        match self {
            Self::Float(format) => Some(format),
            Self::Fixed(_) => None,
        }
    }

    /// The width of coefficients, in fixed point.
    #[must_use]
    pub const fn fixed(self) -> Option<Coefficient> {
        match self {
            Self::Float(_) => None,
            Self::Fixed(coefficient) => Some(coefficient),
        }
    }
}

impl From<Format> for RasterFormat {
    fn from(format: Format) -> Self {
        Self::Float(format)
    }
}

impl fmt::Display for RasterFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Float(format) => format.fmt(f),
            Self::Fixed(coefficient) => write!(f, "fixed{}", coefficient.width()),
        }
    }
}

impl FromStr for RasterFormat {
    type Err = UnknownRasterFormat;

    fn from_str(text: &str) -> Result<Self, UnknownRasterFormat> {
        let named = Coefficient::NAMED.iter().find(|(name, _)| *name == text);
        let fixed = named.map(|(_, coefficient)| Self::Fixed(*coefficient));
        let float = || text.parse().ok().map(Self::Float);
        fixed.or_else(float).ok_or_else(|| UnknownRasterFormat(text.to_owned()))
    }
}

/// The format of a uniform register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UniformFormat {
    /// Floating point.
    Float(Format),
    /// Fixed point.
    Fixed(Fixed),
}

impl UniformFormat {
    /// Width in bits.
    #[must_use]
    pub const fn width(self) -> u32 {
        match self {
            Self::Float(format) => format.width(),
            Self::Fixed(fixed) => fixed.width,
        }
    }
}

impl fmt::Display for UniformFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Float(format) => format.fmt(f),
            Self::Fixed(Fixed { width, fraction, signed }) => {
                let sign = match signed {
                    Signedness::Signed => "signed",
                    Signedness::Unsigned => "unsigned",
                };
                write!(f, "{sign} fixed point, {width} bits, {fraction} of them behind the point")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip() {
        for name in ["f32", "f24-ftz", "bf16", "fixed16", "fixed18"] {
            let format: RasterFormat = name.parse().expect("the name is known");
            assert_eq!(format.to_string(), name);
        }
        for name in ["fixed20", "fixed24", "fixed", "fixed18-ftz", "f8", ""] {
            let error = name.parse::<RasterFormat>().expect_err("there is no such format").to_string();
            assert!(
                error.contains(&format!("`{name}`")) && error.contains("f24") && error.contains("fixed18"),
                "{error}"
            );
        }
    }

    #[test]
    fn widths_hold_what_they_must() {
        for (_, coefficient) in Coefficient::NAMED {
            let (n, offset) = (coefficient.width(), coefficient.offset());
            assert!(
                offset.width - n < 1 << Coefficient::SHIFT_BITS,
                "every offset is shifted to a coefficient's width"
            );
            // |D| < 2^(delta − 1)·2^f + 2·2^(2n − 2) = 2^2n, which a datapath squares after it was made narrower.
            assert_eq!(coefficient.delta_width() - 1 + coefficient.place_fraction(), 2 * n - 1);
            assert!(
                2 * n < u64::BITS && coefficient.delta_width() <= u32::BITS && coefficient.center().width < u32::BITS
            );
            let filter = coefficient.filter_offset();
            assert!(filter.fraction <= offset.fraction && 2 * filter.fraction >= Coefficient::FILTER_SQUARE.fraction);
        }
    }
}
