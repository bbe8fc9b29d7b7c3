//! Minimum and maximum.

use super::parts::delay;
use super::parts::operand::{flushed, is_nan, order, order_delay, width};
use super::parts::pipe::{self, Operator, Pipe};
use pointcore_contract::Format;
use rtl::lit;

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(&delays(format))
}

fn delays(format: Format) -> Vec<u32> {
    vec![order_delay(format) + delay::adder(format.width()), 2 * delay::LEVEL]
}

/// Module `float_min`.
#[must_use]
pub fn min(format: Format, stages: u32) -> Operator {
    module(Extremum::Minimum, format, stages)
}

/// Module `float_max`.
#[must_use]
pub fn max(format: Format, stages: u32) -> Operator {
    module(Extremum::Maximum, format, stages)
}

#[derive(Clone, Copy)]
enum Extremum {
    Minimum,
    Maximum,
}

fn module(extremum: Extremum, format: Format, stages: u32) -> Operator {
    let (unit, summary) = match extremum {
        Extremum::Minimum => ("float_min", "Lesser of two floating-point numbers."),
        Extremum::Maximum => ("float_max", "Greater of two floating-point numbers."),
    };
    let mut pipe = Pipe::new(unit, summary, &delays(format), stages);
    pipe.module.variant("format", format);
    let [a, b] = ["a", "b"].map(|name| {
        let encoded = pipe.module.input(name, width(format));
        flushed(format, encoded)
    });
    let less = order(a).lt(order(b));
    let [a_nan, b_nan, less, a, b] =
        pipe.cut([("a_nan", is_nan(format, a)), ("b_nan", is_nan(format, b)), ("less", less), ("a", a), ("b", b)]);
    let first = match extremum {
        Extremum::Minimum => less,
        Extremum::Maximum => !less,
    };
    let take_a = b_nan | (!a_nan & first);
    let quiet_nan = lit(width(format), u128::from(format.quiet_nan()));
    let result = (a_nan & b_nan).mux(quiet_nan, take_a.mux(a, b));
    pipe.finish(result)
}
