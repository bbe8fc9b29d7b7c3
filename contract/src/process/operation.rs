//! What a node of a block computes, and where it reads.

use crate::TableShape;

/// `exp_neg` is tabulated from 0 to here, a power of two; beyond, it is below half of the last place of the table, and
/// 0.
pub const EXP_NEGATIVE_END: u32 = 16;

/// Shape of the table of `exp_neg` over `[0, EXP_NEGATIVE_END)`: within 2⁻¹³ of the function, chord, rounding and
/// truncation together.
pub const EXP_NEGATIVE_TABLE: TableShape = TableShape { index_bits: 10, fraction_bits: 10, value_bits: 16 };

/// A value from outside a block, by its word in the layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Source {
    /// Of the query; the first three are its position.
    Query(usize),
    /// Of the neighbor; the first three are its position.
    Neighbor(usize),
    /// Of the farthest neighbor; zero of a query without neighbors.
    Farthest(usize),
    /// Of the state.
    State(usize),
    /// A sum.
    Sum(usize),
    /// Neighbors of the query.
    Neighbors,
    /// Iterations that are complete.
    Count,
    /// A setting of the run.
    Setting(usize),
}

/// A constant in the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Literal {
    /// Encoding of the `f32` nearest to the text. It is rounded to the program's format; below the format's smallest
    /// normal number it is zero.
    Float(u32),
    /// A whole number.
    Int(i32),
    /// A truth value.
    Bool(bool),
}

/// What a node computes from its operands.
///
/// Floats are rounded once an operation, to nearest, ties to even; an operation's result that is no number is the
/// format's canonical NaN. Integers wrap. Comparisons with a NaN are false; `min` and `max` prefer the operand that is
/// a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A value from outside.
    Input(Source),
    /// A constant.
    Literal(Literal),
    /// `a + b`.
    Add,
    /// `a − b`.
    Subtract,
    /// `a · b`; of integers the low 32 bits.
    Multiply,
    /// `a · b + c`, rounded once.
    MultiplyAdd,
    /// `a / b`.
    Divide,
    /// `1 / a`.
    Reciprocal,
    /// `√a`.
    SquareRoot,
    /// `1 / √a`.
    ReciprocalSquareRoot,
    /// `e^−a` for `a ≥ 0` from a table: `a` divided by [`EXP_NEGATIVE_END`], truncated to the argument of
    /// [`EXP_NEGATIVE_TABLE`] and saturated, is looked up; the result is the table's value, of as many fraction bits as
    /// it has bits. Negative arguments count as 0, a NaN's is NaN.
    ExpNegative,
    /// The smaller one.
    Minimum,
    /// The larger one.
    Maximum,
    /// `|a|`: without the sign bit.
    Absolute,
    /// `−a`: the other sign bit; of integers the difference from 0.
    Negate,
    /// `a < b`.
    Less,
    /// `a ≤ b`.
    LessOrEqual,
    /// `a = b`.
    Equal,
    /// Both; of integers bit by bit, as the following.
    And,
    /// Either.
    Or,
    /// Not the same.
    Xor,
    /// The opposite.
    Not,
    /// `b` where `a` holds, else `c`.
    Select,
    /// An integer as a float, rounded.
    ToFloat,
    /// A float as an integer, truncated and saturated; 0 of a NaN.
    ToInt,
}
