//! Decoding of operands and the one rounder all operators share.

use pointcore_contract::{Format, Subnormals};

/// A decoded operand or a raw result that has not been rounded.
#[derive(Clone, Copy, Debug)]
pub(super) enum Value {
    Nan,
    Infinity { negative: bool },
    Zero { negative: bool },
    Finite(Finite),
}

/// A non-zero number, `±significand · 2^exponent`.
///
/// In a raw result the lowest bit of the significand may be sticky: set if anything non-zero was dropped below it. Such
/// a significand is at least two bits longer than the target's precision, so that the sticky bit lies below the round
/// bit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Finite {
    pub negative: bool,
    pub exponent: i32,
    pub significand: u64,
}

/// Decodes `bits`. A finite significand has exactly `mantissa + 1` bits, whether its encoding was normal or not.
#[inline]
pub(super) fn decode(f: Format, bits: u64) -> Value {
    debug_assert!(f.exponent <= 11 && (2..=28).contains(&f.mantissa), "{f} is outside the range of the models");
    debug_assert!(bits >> f.width() == 0, "{bits:#x} is wider than {f}");
    let negative = bits & f.sign_mask() != 0;
    let biased = (bits >> f.mantissa) & f.exponent_max();
    let fraction = bits & fraction_mask(f);
    let exponent_of_last_bit = 1 - f.bias() - f.mantissa as i32;
    if biased == f.exponent_max() {
        if fraction == 0 { Value::Infinity { negative } } else { Value::Nan }
    } else if biased != 0 {
        let significand = fraction | (1 << f.mantissa);
        Value::Finite(Finite { negative, exponent: exponent_of_last_bit + biased as i32 - 1, significand })
    } else if fraction == 0 || f.subnormals == Subnormals::Flush {
        Value::Zero { negative }
    } else {
        let shift = fraction.leading_zeros() - (63 - f.mantissa);
        let exponent = exponent_of_last_bit - shift as i32;
        Value::Finite(Finite { negative, exponent, significand: fraction << shift })
    }
}

/// An operand that an operator passes on unchanged: subnormals flushed if the format says so, `None` for a NaN.
#[inline]
pub(super) fn operand(f: Format, bits: u64) -> Option<u64> {
    match decode(f, bits) {
        Value::Nan => None,
        Value::Zero { negative } => Some(signed(f, negative, 0)),
        Value::Infinity { .. } | Value::Finite(_) => Some(bits),
    }
}

impl Value {
    /// Rounds and encodes.
    #[inline]
    pub(super) fn encode(self, f: Format) -> u64 {
        match self {
            Self::Nan => f.quiet_nan(),
            Self::Infinity { negative } => signed(f, negative, f.infinity()),
            Self::Zero { negative } => signed(f, negative, 0),
            Self::Finite(finite) => finite.round(f),
        }
    }

    /// The sign; a NaN has none and counts as positive.
    #[inline]
    pub(super) fn is_negative(self) -> bool {
        match self {
            Self::Nan => false,
            Self::Infinity { negative } | Self::Zero { negative } | Self::Finite(Finite { negative, .. }) => negative,
        }
    }

    /// The same value with the opposite sign.
    #[inline]
    pub(super) fn negate(self) -> Self {
        match self {
            Self::Nan => Self::Nan,
            Self::Infinity { negative } => Self::Infinity { negative: !negative },
            Self::Zero { negative } => Self::Zero { negative: !negative },
            Self::Finite(finite) => Self::Finite(Finite { negative: !finite.negative, ..finite }),
        }
    }
}

impl Finite {
    /// Rounds to nearest even, to infinity beyond the largest number and to zero as the format's subnormals demand.
    #[inline]
    pub(super) fn round(self, f: Format) -> u64 {
        let leading_zeros = self.significand.leading_zeros();
        let normalized = self.significand << leading_zeros;
        let biased = self.exponent + 63 - leading_zeros as i32 + f.bias();
        let below_normal = match f.subnormals {
            Subnormals::Keep => (1 - biased).max(0),
            Subnormals::Flush => 0,
        };
        let shifted = shift_right_sticky(normalized, below_normal);
        let (kept, rest) = (shifted >> (63 - f.mantissa), shifted << (f.mantissa + 1));
        const HALF: u64 = 1 << 63;
        let round_up = rest > HALF - (kept & 1);
        // The leading one adds to the exponent field, and so does a carry out of the significand.
        let magnitude = (i64::from(biased + below_normal - 1) << f.mantissa) + kept as i64 + i64::from(round_up);
        let smallest_normal = 1 << f.mantissa;
        if f.subnormals == Subnormals::Flush && magnitude < smallest_normal {
            return signed(f, self.negative, 0);
        }
        signed(f, self.negative, (magnitude as u64).min(f.infinity()))
    }
}

/// `value` without its last `distance` bits, its new last bit set if any of them was.
#[inline]
pub(super) fn shift_right_sticky(value: u64, distance: i32) -> u64 {
    let distance = distance.min(63); // One is left of any value, as a sticky bit.
    let shifted = value >> distance;
    shifted | u64::from(shifted << distance != value)
}

/// `magnitude` with a sign bit.
#[inline]
pub(super) fn signed(f: Format, negative: bool, magnitude: u64) -> u64 {
    if negative { f.sign_mask() | magnitude } else { magnitude }
}

/// Mask of the stored fraction.
#[inline]
pub(super) fn fraction_mask(f: Format) -> u64 {
    (1 << f.mantissa) - 1
}
