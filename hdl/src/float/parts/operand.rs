//! Operands taken apart.

use super::delay;
use super::pipe::Pipe;
use super::shift::leading_zeros;
use pointcore_contract::{Format, Subnormals};
use rtl::{Expr, Module, cat, lit};

/// Bits of `format` as a width.
pub(crate) fn width(format: Format) -> u32 {
    format.width()
}

/// Precision `p`: the significand with its leading one.
pub(crate) fn precision(format: Format) -> u32 {
    format.mantissa + 1
}

/// Width of a signed biased exponent that holds those of sums, products, quotients and normalized subnormals.
pub(crate) fn exponent_width(format: Format) -> u32 {
    let largest = (3 << (format.exponent - 1)) + 2 * (format.mantissa + 1);
    (u32::BITS - largest.leading_zeros()) + 1
}

/// A number's fields. A zero has significand zero; so has a subnormal number that the format flushes.
pub(crate) struct Operand {
    /// Operand's port, for the names of registers.
    name: &'static str,
    /// Set if negative.
    pub sign: Expr,
    /// All bits but the sign, subnormal numbers as they are.
    pub magnitude: Expr,
    /// Signed biased exponent of the significand's top bit, `exponent_width` bits; 1 for subnormal numbers.
    pub exponent: Expr,
    /// `p` bits; the top one is set unless zero or subnormal.
    pub significand: Expr,
    /// Set for zero.
    pub zero: Expr,
    /// Set for an infinity.
    pub infinite: Expr,
    /// Set for NaN.
    pub nan: Expr,
}

impl Operand {
    /// The number in the input port `name`.
    pub fn input(pipe: &mut Pipe, format: Format, name: &'static str) -> Self {
        let encoded = pipe.module.input(name, width(format));
        Self::unpack(&mut pipe.module, format, name, encoded)
    }

    fn unpack(module: &mut Module, format: Format, name: &'static str, encoded: Expr) -> Self {
        let mantissa = format.mantissa;
        let field = module.wire(&format!("{name}_field"), encoded.bits(width(format) - 2, mantissa));
        let fraction = module.wire(&format!("{name}_fraction"), encoded.trunc(mantissa));
        let normal = field.any();
        // Of a full exponent field nothing is flushed.
        let (infinite, nan) = (field.all() & fraction.is_zero(), field.all() & fraction.any());
        let (zero, lowest, significant) = match format.subnormals {
            Subnormals::Keep => (!(normal | fraction.any()), field.bit(0) | !normal, fraction),
            Subnormals::Flush => (!normal, field.bit(0), fraction & normal.repeat(mantissa)),
        };
        let exponent = cat([field.bits(field.width() - 1, 1), lowest]);
        Self {
            name,
            sign: encoded.msb(),
            magnitude: encoded.trunc(width(format) - 1),
            exponent: exponent.zext(exponent_width(format)),
            significand: cat([normal, significant]),
            zero,
            infinite,
            nan,
        }
    }
}

/// A nonzero number's significand with its leading one on top.
pub(crate) struct Normalized {
    /// Signed biased exponent, below 1 for subnormal numbers.
    pub exponent: Expr,
    /// `p` bits.
    pub significand: Expr,
}

/// Normalizes operands. Takes one cut, none if the format flushes subnormal numbers.
pub(crate) fn normalize<const N: usize>(pipe: &mut Pipe, format: Format, operands: [&Operand; N]) -> [Normalized; N] {
    pipe.takes(delay::LEVEL);
    if format.subnormals == Subnormals::Flush {
        return operands.map(|operand| Normalized { exponent: operand.exponent, significand: operand.significand });
    }
    pipe.takes(delay::leading_zeros(precision(format)));
    let mut carried = operands.map(|operand| {
        let carry = |field: &str, value: Expr| pipe.carry(&format!("{}_{field}", operand.name), value);
        [
            carry("zeros", leading_zeros(operand.significand)),
            carry("exponent", operand.exponent),
            carry("significand", operand.significand),
        ]
    });
    pipe.cut([]);
    pipe.takes(delay::shifter(precision(format)));
    carried.each_mut().map(|values| {
        let [zeros, exponent, significand] = values.each_mut().map(|value| pipe.arrive(value));
        Normalized { exponent: exponent - zeros.zext(exponent.width()), significand: significand.shl_by(zeros) }
    })
}

/// The encoded numbers in the input ports `a` and `b` on their way to a comparison by [`order`], which does not wait for subnormal ones to be
/// [`flushed`]: two of them are told by [`is_zero`], and one lies on the same side of all others as zero.
pub(crate) fn ordered_inputs(pipe: &mut Pipe, format: Format) -> [Expr; 2] {
    // Datapaths share operators of formats that flush. The choice of operands in front of them takes as long as flushing would.
    pipe.takes(match format.subnormals {
        Subnormals::Keep => delay::LEVEL,
        Subnormals::Flush => delay::LEVEL + delay::reduction(format.exponent),
    });
    ["a", "b"].map(|name| pipe.module.input(name, width(format)))
}

/// Whether an encoded number is zero, or a subnormal one that the format flushes.
pub(crate) fn is_zero(format: Format, encoded: Expr) -> Expr {
    let lowest = match format.subnormals {
        Subnormals::Keep => 0,
        Subnormals::Flush => format.mantissa,
    };
    encoded.bits(width(format) - 2, lowest).is_zero()
}

/// An encoded number, subnormal ones as zero if the format flushes them.
pub(crate) fn flushed(format: Format, encoded: Expr) -> Expr {
    if format.subnormals == Subnormals::Keep {
        return encoded;
    }
    let mantissa = format.mantissa;
    let (field, fraction) = (encoded.bits(width(format) - 2, mantissa), encoded.trunc(mantissa));
    cat([encoded.msb(), field, (fraction & field.any().repeat(mantissa))])
}

/// Whether an encoded number is NaN.
pub(crate) fn is_nan(format: Format, encoded: Expr) -> Expr {
    let mantissa = format.mantissa;
    encoded.bits(width(format) - 2, mantissa).all() & encoded.trunc(mantissa).any()
}

/// An unsigned number in the order of the encoded ones, −0 right below +0.
pub(crate) fn order(encoded: Expr) -> Expr {
    let (sign, magnitude_bits) = (encoded.msb(), encoded.width() - 1);
    cat([!sign, (encoded.trunc(magnitude_bits) ^ sign.repeat(magnitude_bits))])
}

/// A constant in two's complement.
pub(crate) fn signed(bits: u32, value: i32) -> Expr {
    lit(bits, (i128::from(value) & ((1 << bits) - 1)) as u128)
}

/// Width of a two's complement number of at most that magnitude.
pub(crate) fn signed_width(magnitude: u32) -> u32 {
    (u32::BITS - magnitude.leading_zeros()) + 1
}
