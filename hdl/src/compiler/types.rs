//! Types of values in a datapath.

use pointcore_contract::{Fixed, Format, Signedness};
use std::fmt;

/// The widest value a datapath carries: what fits a port of a unit.
pub const WIDTH_MAX: u32 = 64;

/// Type of a value. A truth value is one unsigned bit, [`Type::BOOL`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Type {
    /// Floating point.
    Float(Format),
    /// Unsigned integer of so many bits.
    Unsigned(u32),
    /// Two's complement integer of so many bits.
    Signed(u32),
}

impl Type {
    /// A truth value.
    pub const BOOL: Self = Self::Unsigned(1);

    /// The integer type that holds a fixed-point number's bits.
    #[must_use]
    pub const fn of_fixed(fixed: Fixed) -> Self {
        match fixed.signed {
            Signedness::Signed => Self::Signed(fixed.width),
            Signedness::Unsigned => Self::Unsigned(fixed.width),
        }
    }

    /// Width in bits.
    #[must_use]
    pub const fn width(self) -> u32 {
        match self {
            Self::Float(format) => format.width(),
            Self::Unsigned(width) | Self::Signed(width) => width,
        }
    }

    /// The bits a value of this type may have set.
    #[must_use]
    pub const fn mask(self) -> u64 {
        u64::MAX >> (64 - self.width())
    }

    /// The same signedness at another width.
    pub(super) const fn resized(self, width: u32) -> Self {
        match self {
            Self::Signed(_) => Self::Signed(width),
            Self::Unsigned(_) | Self::Float(_) => Self::Unsigned(width),
        }
    }

    pub(super) const fn is_float(self) -> bool {
        matches!(self, Self::Float(_))
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Float(format) => write!(f, "{format}"),
            Self::Unsigned(width) => write!(f, "u{width}"),
            Self::Signed(width) => write!(f, "s{width}"),
        }
    }
}
