//! Minimum and maximum.

use super::parts::delay;
use super::parts::operand::{flushed, is_nan, order, ordered_inputs, width};
use super::parts::pipe::{self, Operator, Pipe};
use pointcore_contract::Format;
use rtl::{Expr, lit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| extremum(pipe, Extremum::Minimum, format))
}

/// Module `float_min`.
#[must_use]
pub fn min(format: Format, stages: u32) -> Operator {
    let summary = "Lesser of two floating-point numbers.";
    pipe::operator("float_min", summary, stages, |pipe| extremum(pipe, Extremum::Minimum, format))
}

/// Module `float_max`.
#[must_use]
pub fn max(format: Format, stages: u32) -> Operator {
    let summary = "Greater of two floating-point numbers.";
    pipe::operator("float_max", summary, stages, |pipe| extremum(pipe, Extremum::Maximum, format))
}

#[derive(Clone, Copy)]
enum Extremum {
    Minimum,
    Maximum,
}

fn extremum(pipe: &mut Pipe, extremum: Extremum, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let [a, b] = ordered_inputs(pipe, format);
    pipe.takes(delay::adder(format.width()));
    let less = order(a).lt(order(b));
    let [a_nan, b_nan, less, a, b] = pipe.cut([
        ("a_nan", is_nan(format, a)),
        ("b_nan", is_nan(format, b)),
        ("less", less),
        ("a", flushed(format, a)),
        ("b", flushed(format, b)),
    ]);
    pipe.takes(2 * delay::LEVEL);
    let first = match extremum {
        Extremum::Minimum => less,
        Extremum::Maximum => !less,
    };
    let take_a = b_nan | (!a_nan & first);
    let quiet_nan = lit(width(format), u128::from(format.quiet_nan()));
    (a_nan & b_nan).mux(quiet_nan, take_a.mux(a, b))
}
