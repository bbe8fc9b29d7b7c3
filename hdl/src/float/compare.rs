//! Comparisons; the result is one bit, 0 if an operand is NaN.

use super::parts::delay;
use super::parts::operand::{flushed, is_nan, order, order_delay, width};
use super::parts::pipe::{self, Operator, Pipe};
use pointcore_contract::Format;

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(&delays(format))
}

fn delays(format: Format) -> Vec<u32> {
    vec![order_delay(format) + delay::adder(format.width()) + delay::LEVEL, delay::LEVEL]
}

/// Module `float_lt`: `a < b`.
#[must_use]
pub fn lt(format: Format, stages: u32) -> Operator {
    module(Relation::Less, format, stages)
}

/// Module `float_le`: `a ≤ b`.
#[must_use]
pub fn le(format: Format, stages: u32) -> Operator {
    module(Relation::LessOrEqual, format, stages)
}

/// Module `float_eq`: `a = b`.
#[must_use]
pub fn eq(format: Format, stages: u32) -> Operator {
    module(Relation::Equal, format, stages)
}

#[derive(Clone, Copy)]
enum Relation {
    Less,
    LessOrEqual,
    Equal,
}

fn module(relation: Relation, format: Format, stages: u32) -> Operator {
    let (unit, summary) = match relation {
        Relation::Less => ("float_lt", "Whether one floating-point number is less than another."),
        Relation::LessOrEqual => ("float_le", "Whether one floating-point number is less than another or equal."),
        Relation::Equal => ("float_eq", "Whether two floating-point numbers are equal."),
    };
    let mut pipe = Pipe::new(unit, summary, &delays(format), stages);
    pipe.module.variant("format", format);
    let [a, b] = ["a", "b"].map(|name| {
        let encoded = pipe.module.input(name, width(format));
        flushed(format, encoded)
    });
    let magnitude_bits = width(format) - 1;
    let unordered = is_nan(format, a) | is_nan(format, b);
    let both_zero = (a.trunc(magnitude_bits) | b.trunc(magnitude_bits)).is_zero();
    let compared = match relation {
        Relation::Less => order(a).lt(order(b)),
        Relation::LessOrEqual => order(a).le(order(b)),
        Relation::Equal => a.eq(b),
    };
    let [unordered, both_zero, compared] =
        pipe.cut([("unordered", unordered), ("both_zero", both_zero), ("compared", compared)]);
    let holds = match relation {
        Relation::Less => compared & !both_zero,
        Relation::LessOrEqual | Relation::Equal => compared | both_zero,
    };
    pipe.finish(holds & !unordered)
}
