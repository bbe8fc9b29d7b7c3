//! The shared rounder: to nearest, ties to even, with the format's rule for small results.

use super::delay;
use super::operand::{precision, width};
use super::pipe::{Carried, Pipe};
use super::shift::shift_right_sticky;
use pointcore_contract::{Format, Subnormals};
use rtl::{Expr, cat, lit};

/// The result's sign and whether it is one that no rounding leads to.
pub(crate) struct Special {
    /// Set if negative.
    pub sign: Expr,
    /// The result is NaN, whatever else is set.
    pub nan: Expr,
    /// The result is infinite.
    pub infinite: Expr,
    /// The result is zero.
    pub zero: Expr,
}

/// [`Special`] on its way to the rounder.
pub(crate) struct CarriedSpecial {
    sign: Carried,
    nan: Carried,
    infinite: Carried,
    zero: Carried,
}

impl Special {
    /// Sends it along to the rounder.
    pub fn carry(&self, pipe: &Pipe) -> CarriedSpecial {
        CarriedSpecial {
            sign: pipe.carry("sign", self.sign),
            nan: pipe.carry("nan", self.nan),
            infinite: pipe.carry("infinite", self.infinite),
            zero: pipe.carry("zero", self.zero),
        }
    }
}

/// Whether a raw result can lie below the normal numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Underflow {
    /// It can.
    Possible,
    /// It cannot.
    Impossible,
}

impl Underflow {
    /// Whether results are to be shifted into subnormal position.
    fn shifts(self, format: Format) -> bool {
        self == Self::Possible && format.subnormals == Subnormals::Keep
    }
}

/// A result before rounding.
pub(crate) struct Raw {
    /// Sign and special cases.
    pub special: CarriedSpecial,
    /// Signed biased exponent of the significand's top bit, of any width.
    pub exponent: Expr,
    /// `p + 2` bits: the significand with its leading one on top, the bit below, and whether anything lies below that.
    /// The leading one may be missing only at exponent 1.
    pub significand: Expr,
}

/// Rounds, and is the end of the description. Takes a cut right away, one more to shift a result into subnormal position, one before
/// the choice among number and special cases, and the output's.
pub(crate) fn round(pipe: &mut Pipe, format: Format, underflow: Underflow, raw: Raw) -> Expr {
    let Raw { special, exponent, significand } = raw;
    let (exponent, significand) = if underflow.shifts(format) {
        pipe.takes(delay::adder(format.exponent) + delay::LEVEL);
        let small = exponent.msb() | exponent.is_zero();
        let one = lit(exponent.width(), 1);
        let mut clamped = pipe.carry("exponent", small.mux(one, exponent));
        let distance = (one - exponent) & small.repeat(exponent.width());
        let [distance, significand] = pipe.cut([("distance", distance), ("significand", significand)]);
        pipe.takes(delay::shifter(format.mantissa + 3));
        let [significand] = pipe.cut([("significand", shift_right_sticky(significand, distance))]);
        (pipe.arrive(&mut clamped), significand)
    } else {
        let [exponent, significand] = pipe.cut([("exponent", exponent), ("significand", significand)]);
        (exponent, significand)
    };
    pack(pipe, format, special, exponent, significand)
}

/// Rounds the significand and encodes the number.
fn pack(pipe: &mut Pipe, format: Format, special: CarriedSpecial, exponent: Expr, significand: Expr) -> Expr {
    let CarriedSpecial { mut sign, mut nan, mut infinite, mut zero } = special;
    let [sign, nan, infinite, zero] = [&mut sign, &mut nan, &mut infinite, &mut zero].map(|flag| pipe.arrive(flag));
    let (p, mantissa, exponent_bits) = (precision(format), format.mantissa, format.exponent);
    let (leading, fraction) = (significand.bit(p + 1), significand.bits(p, 2));
    let (guard, sticky) = (significand.bit(1), significand.bit(0));
    let round_up = pipe.module.wire("round_up", guard & (sticky | fraction.bit(0)));
    let low = exponent.trunc(exponent_bits);
    let field = match format.subnormals {
        Subnormals::Keep => low & leading.repeat(exponent_bits),
        Subnormals::Flush => low,
    };
    pipe.takes(delay::adder(format.width()) + delay::LEVEL);
    // A carry out of the fraction increments the exponent, up to infinity.
    let rounded = pipe.module.wire("rounded", cat([field, fraction]) + round_up.zext(mantissa + exponent_bits));
    let negative = exponent.msb();
    let overflow = !negative & exponent.ge_lit(u128::from(format.exponent_max()));
    let zero = match format.subnormals {
        Subnormals::Keep => zero,
        Subnormals::Flush => {
            let carries = fraction.all() & guard;
            let underflow = negative | (exponent.is_zero() & !carries);
            zero | (underflow & !infinite)
        }
    };
    let infinity = lit(width(format) - 1, u128::from(format.infinity()));
    let infinite = infinite | overflow;
    let [sign, nan, infinite, zero, rounded] =
        pipe.cut([("sign", sign), ("nan", nan), ("infinite", infinite), ("zero", zero), ("rounded", rounded)]);
    pipe.takes(delay::LEVEL);
    let magnitude = zero.mux(lit(width(format) - 1, 0), infinite.mux(infinity, rounded));
    let quiet_nan = lit(width(format), u128::from(format.quiet_nan()));
    nan.mux(quiet_nan, cat([sign, magnitude]))
}
