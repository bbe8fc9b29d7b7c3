//! What a node of a program computes.

use super::compound::Compound;
use super::table::Table;
use super::types::Type;
use pointcore_contract::{Fixed, Format};
use std::rc::Rc;

/// What a node computes from its operands.
///
/// Arithmetic, comparison and sign operations take floating-point or integer operands, all of one type unless said
/// otherwise. Operations on the bits of a value take every type.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A field of the token.
    Input,
    /// A port that is constant while a token is under way.
    Uniform,
    /// An encoded constant.
    Constant(u64),
    /// `a + b`; integers wrap.
    Add,
    /// `a − b`; integers wrap.
    Subtract,
    /// `a · b`; integers of one signedness but any width, to the sum of the widths.
    Multiply,
    /// `a · b + c` rounded once, floating point.
    MultiplyAdd,
    /// Some operations one behind the other, each rounded; the compiler makes them where operators are shared.
    Compound(Compound),
    /// `a / b`, floating point.
    Divide,
    /// `√a`, floating point.
    SquareRoot,
    /// `1 / a`, floating point.
    Reciprocal,
    /// `1 / √a`, floating point.
    ReciprocalSquareRoot,
    /// `1 / a` from a table and Newton steps.
    ReciprocalNewton,
    /// `1 / √a` from a table and Newton steps.
    ReciprocalSquareRootNewton,
    /// The smaller operand.
    Minimum,
    /// The larger operand.
    Maximum,
    /// `a < b`.
    Less,
    /// `a ≤ b`.
    LessOrEqual,
    /// `a = b`.
    Equal,
    /// `−a`: the sign bit of a float (a NaN's too); integers wrap.
    Negate,
    /// `|a|`: clears the sign bit of a float.
    Absolute,
    /// To another floating-point format.
    Convert(Format),
    /// Float to fixed point, truncated and saturated.
    ToFixed(Fixed),
    /// Fixed point with so many fraction bits to float.
    ToFloat {
        /// Result format.
        format: Format,
        /// Fraction bits of the operand.
        fraction: u32,
    },
    /// Linear interpolation in a table, or the table alone.
    Interpolate(Rc<Table>),
    /// Every bit inverted.
    Not,
    /// Bitwise and.
    And,
    /// Bitwise or.
    Or,
    /// Bitwise exclusive or.
    Xor,
    /// The first operand chooses: the second when it is 1, the third when it is 0.
    Mux,
    /// Bits `high` down to `low`, unsigned.
    Bits {
        /// Highest bit taken.
        high: u32,
        /// Lowest bit taken.
        low: u32,
    },
    /// Both operands side by side, the first in the upper bits, unsigned.
    Cat,
    /// To the left, filled with zeros, at the same width.
    ShiftLeft(u32),
    /// To the right, filled with zeros or, for a signed operand, copies of the sign, at the same width.
    ShiftRight(u32),
    /// An integer at another width: truncated, or extended as its signedness says.
    Resize(u32),
    /// The same bits under another type.
    Reinterpret(Type),
}

impl Operation {
    /// The operation's name in messages, manifests and generated names.
    #[must_use]
    pub const fn mnemonic(&self) -> &'static str {
        match self {
            Self::Input => "input",
            Self::Uniform => "uniform",
            Self::Constant(_) => "constant",
            Self::Add => "add",
            Self::Subtract => "sub",
            Self::Multiply => "mul",
            Self::MultiplyAdd => "fma",
            Self::Compound(compound) => compound.mnemonic(),
            Self::Divide => "div",
            Self::SquareRoot => "sqrt",
            Self::Reciprocal => "recip",
            Self::ReciprocalSquareRoot => "rsqrt",
            Self::ReciprocalNewton => "recip_newton",
            Self::ReciprocalSquareRootNewton => "rsqrt_newton",
            Self::Minimum => "min",
            Self::Maximum => "max",
            Self::Less => "lt",
            Self::LessOrEqual => "le",
            Self::Equal => "equal",
            Self::Negate => "neg",
            Self::Absolute => "abs",
            Self::Convert(_) => "convert",
            Self::ToFixed(_) => "to_fixed",
            Self::ToFloat { .. } => "to_float",
            Self::Interpolate(_) => "interpolate",
            Self::Not => "not",
            Self::And => "and",
            Self::Or => "or",
            Self::Xor => "xor",
            Self::Mux => "select",
            Self::Bits { .. } => "bits",
            Self::Cat => "concat",
            Self::ShiftLeft(_) => "shl",
            Self::ShiftRight(_) => "shr",
            Self::Resize(_) => "resize",
            Self::Reinterpret(_) => "reinterpret",
        }
    }

    /// Whether the first two operands may be exchanged.
    pub(super) const fn is_commutative(&self) -> bool {
        matches!(
            self,
            Self::Add
                | Self::Multiply
                | Self::MultiplyAdd
                | Self::Minimum
                | Self::Maximum
                | Self::Equal
                | Self::And
                | Self::Or
                | Self::Xor
        )
    }
}
