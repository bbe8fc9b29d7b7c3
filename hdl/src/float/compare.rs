//! Comparisons; the result is one bit, 0 if an operand is NaN.

use super::parts::delay;
use super::parts::operand::{is_nan, is_zero, order, ordered_inputs};
use super::parts::pipe::{self, Operator, Pipe};
use pointcore_contract::Format;
use rtl::Expr;

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| relation(pipe, Relation::Less, format))
}

/// Module `float_lt`: `a < b`.
#[must_use]
pub fn lt(format: Format, stages: u32) -> Operator {
    let summary = "Whether one floating-point number is less than another.";
    pipe::operator("float_lt", summary, stages, |pipe| relation(pipe, Relation::Less, format))
}

/// Module `float_le`: `a ≤ b`.
#[must_use]
pub fn le(format: Format, stages: u32) -> Operator {
    let summary = "Whether one floating-point number is less than another or equal.";
    pipe::operator("float_le", summary, stages, |pipe| relation(pipe, Relation::LessOrEqual, format))
}

/// Module `float_eq`: `a = b`.
#[must_use]
pub fn eq(format: Format, stages: u32) -> Operator {
    let summary = "Whether two floating-point numbers are equal.";
    pipe::operator("float_eq", summary, stages, |pipe| relation(pipe, Relation::Equal, format))
}

#[derive(Clone, Copy)]
enum Relation {
    Less,
    LessOrEqual,
    Equal,
}

fn relation(pipe: &mut Pipe, relation: Relation, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let [a, b] = ordered_inputs(pipe, format);
    pipe.takes(delay::adder(format.width()) + delay::LEVEL);
    let unordered = is_nan(format, a) | is_nan(format, b);
    let both_zero = is_zero(format, a) & is_zero(format, b);
    let compared = match relation {
        Relation::Less => order(a).lt(order(b)),
        Relation::LessOrEqual => order(a).le(order(b)),
        Relation::Equal => a.eq(b),
    };
    let [unordered, both_zero, compared] =
        pipe.cut([("unordered", unordered), ("both_zero", both_zero), ("compared", compared)]);
    pipe.takes(delay::LEVEL);
    let holds = match relation {
        Relation::Less => compared & !both_zero,
        Relation::LessOrEqual | Relation::Equal => compared | both_zero,
    };
    holds & !unordered
}
