//! Conversion to fixed point: toward zero, saturating, NaN to zero.

use super::from_fixed::fixed_parameters;
use super::parts::delay;
use super::parts::operand::{Normalized, Operand, normalize, precision, signed, signed_width};
use super::parts::pipe::{self, Operator, Pipe};
use pointcore_contract::{Fixed, Format, Signedness, Subnormals};
use rtl::{Expr, lit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format, fixed: Fixed) -> u32 {
    pipe::stages_for(|pipe| conversion(pipe, format, fixed))
}

/// Width in which the significand is shifted.
fn shifted_width(format: Format, fixed: Fixed) -> u32 {
    fixed.width.max(format.mantissa + 1)
}

/// Whether subnormal numbers are so large in units of the last place that their leading one has to be found.
fn normalizes(format: Format, fixed: Fixed) -> bool {
    format.subnormals == Subnormals::Keep && integer_bits(format, fixed, 1) > 0
}

/// Integer bits of the result for a biased exponent: where the leading one comes to stand.
fn integer_bits(format: Format, fixed: Fixed, exponent: i32) -> i32 {
    exponent - format.bias() + fixed.fraction as i32 + 1
}

/// Module `float_to_fixed`.
#[must_use]
pub fn module(format: Format, fixed: Fixed, stages: u32) -> Operator {
    pipe::operator("float_to_fixed", "Floating to fixed point.", stages, |pipe| conversion(pipe, format, fixed))
}

fn conversion(pipe: &mut Pipe, format: Format, fixed: Fixed) -> Expr {
    fixed_parameters(pipe, format, fixed);
    let a = Operand::input(pipe, format, "a");
    let [mut sign, mut nan] = [pipe.carry("sign", a.sign), pipe.carry("nan", a.nan)];
    let mut flags = [pipe.carry("infinite", a.infinite), pipe.carry("zero", a.zero)];
    let a = if normalizes(format, fixed) {
        let [normalized] = normalize(pipe, format, [&a]);
        normalized
    } else {
        Normalized { exponent: a.exponent, significand: a.significand }
    };

    pipe.takes(delay::adder(format.exponent + 1) + 2 * delay::LEVEL);
    let width = fixed.width;
    let magnitude_bits = match fixed.signed {
        Signedness::Signed => width - 1,
        Signedness::Unsigned => width,
    };
    let wide = shifted_width(format, fixed);
    let offset = integer_bits(format, fixed, 0);
    let bits = signed_width(offset.unsigned_abs() + 2 * format.exponent_max() as u32 + wide);
    let [infinite, zero] = flags.each_mut().map(|flag| pipe.arrive(flag));
    let integer_bits = a.exponent.sext(bits) + signed(bits, offset);
    let fraction_only = integer_bits.msb() | integer_bits.is_zero();
    let too_large = !fraction_only & integer_bits.ge_lit(magnitude_bits as u128 + 1);
    let vanishes = pipe.carry("vanishes", (fraction_only & !infinite) | zero);
    let saturates = pipe.carry("saturates", (too_large & !zero) | infinite);
    let [distance, significand] = pipe.cut([
        ("distance", (signed(bits, wide as i32) - integer_bits).trunc(delay::levels(wide))),
        ("significand", a.significand),
    ]);

    pipe.takes(delay::shifter(wide));
    let padded = significand.zext(wide) << (wide - precision(format));
    let [magnitude] = pipe.cut([("magnitude", padded.shr_by(distance).trunc(width))]);

    let [mut vanishes, mut saturates] = [vanishes, saturates];
    let [sign, nan, vanishes, saturates] =
        [&mut sign, &mut nan, &mut vanishes, &mut saturates].map(|flag| pipe.arrive(flag));
    pipe.takes(delay::adder(width) + 2 * delay::LEVEL);
    let largest = (1 << magnitude_bits) - 1;
    let (value, limit, cleared) = match fixed.signed {
        Signedness::Signed => {
            let limit = sign.mux(lit(width, largest + 1), lit(width, largest));
            (sign.mux((!magnitude).add_lit(1), magnitude), limit, vanishes | nan)
        }
        Signedness::Unsigned => (magnitude, lit(width, largest), vanishes | nan | sign),
    };
    cleared.mux(lit(width, 0), saturates.mux(limit, value))
}
