//! Conversion from fixed point, correctly rounded.

use super::parts::delay;
use super::parts::operand::{precision, signed, signed_width};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::round::{Raw, Special, Underflow, round};
use super::parts::shift::{keep_sticky, leading_zeros};
use pointcore_contract::{Fixed, Format, Signedness};
use rtl::{Expr, bit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format, fixed: Fixed) -> u32 {
    pipe::stages_for(|pipe| conversion(pipe, format, fixed))
}

/// Whether the last place lies below the normal numbers.
fn underflow(format: Format, fixed: Fixed) -> Underflow {
    if -(fixed.fraction as i32) < 1 - format.bias() { Underflow::Possible } else { Underflow::Impossible }
}

/// Module `float_from_fixed`.
#[must_use]
pub fn module(format: Format, fixed: Fixed, stages: u32) -> Operator {
    pipe::operator("float_from_fixed", "Fixed to floating point.", stages, |pipe| conversion(pipe, format, fixed))
}

fn conversion(pipe: &mut Pipe, format: Format, fixed: Fixed) -> Expr {
    fixed_parameters(pipe, format, fixed);
    let width = fixed.width;
    let a = pipe.module.input("a", width);
    let (sign, magnitude) = match fixed.signed {
        Signedness::Signed => {
            pipe.takes(delay::adder(width) + delay::LEVEL);
            (a.msb(), a.msb().mux((!a).add_lit(1), a))
        }
        Signedness::Unsigned => (bit(false), a),
    };
    let special = Special { sign, nan: bit(false), infinite: bit(false), zero: magnitude.is_zero() }.carry(pipe);
    let [magnitude] = pipe.cut([("magnitude", magnitude)]);
    pipe.takes(delay::leading_zeros(width));
    let [magnitude, zeros] = pipe.cut([("magnitude", magnitude), ("zeros", leading_zeros(magnitude))]);

    pipe.takes(delay::shifter(width));
    let [shifted, zeros] = pipe.cut([("shifted", magnitude.shl_by(zeros)), ("zeros", zeros)]);

    pipe.takes(delay::reduction(width));
    let top = format.bias() + fixed.width as i32 - 1 - fixed.fraction as i32;
    let bits = signed_width(top.unsigned_abs() + fixed.width).max(format.exponent + 1);
    let exponent = signed(bits, top) - zeros.zext(bits);
    let significand = keep_sticky(shifted, precision(format) + 2);
    round(pipe, format, underflow(format, fixed), Raw { special, exponent, significand })
}

/// Records format and fixed-point format as parameters.
pub(super) fn fixed_parameters(pipe: &mut Pipe, format: Format, fixed: Fixed) {
    pipe.module.variant("format", format);
    pipe.module.variant("width", fixed.width);
    pipe.module.variant("fraction", fixed.fraction);
    let signed = match fixed.signed {
        Signedness::Signed => "signed",
        Signedness::Unsigned => "unsigned",
    };
    pipe.module.variant("integer", signed);
}
