//! The type of an operation's result, or what is wrong with its operands.

use super::operation::Operation;
use super::types::{Type, WIDTH_MAX};
use pointcore_contract::{Fixed, Format};

const SAME_FLOAT: &str = "operands must be floats of one format";
const SAME_TYPE: &str = "operands must have one type";
const SAME_INTEGER: &str = "operands must be integers of one type";
const SAME_SIGNEDNESS: &str = "operands must be floats of one format or integers of one signedness";
const OPERAND_COUNT: &str = "wrong number of operands";
const FIXED: &str = "operand must be a float and the fixed-point format 1 to 64 bits wide";
const INTEGER: &str = "operand must be an integer";
const FLOAT: &str = "operand must be a float";

/// What `operation` makes of operands of these types; the error says what it wants. The result's width is not checked.
pub(super) fn result_type(operation: &Operation, operands: &[Type]) -> Result<Type, &'static str> {
    match *operands {
        [] => Err(OPERAND_COUNT),
        [a] => unary(operation, a),
        [a, b] => binary(operation, a, b),
        [a, b, c] => match operation {
            Operation::MultiplyAdd => all_same(&[a, b, c], Type::is_float, SAME_FLOAT),
            Operation::Mux if a == Type::BOOL => all_same(&[b, c], |_| true, "both choices must have one type"),
            Operation::Mux => Err("the condition must be u1"),
            _ => compound(operation, operands),
        },
        _ => compound(operation, operands),
    }
}

fn compound(operation: &Operation, operands: &[Type]) -> Result<Type, &'static str> {
    match operation {
        Operation::Compound(compound) if compound.operands() == operands.len() => {
            all_same(operands, Type::is_float, SAME_FLOAT)
        }
        _ => Err(OPERAND_COUNT),
    }
}

fn all_same(types: &[Type], accept: impl Fn(Type) -> bool, expected: &'static str) -> Result<Type, &'static str> {
    let first = types[0];
    if types.iter().all(|&ty| ty == first) && accept(first) { Ok(first) } else { Err(expected) }
}

fn unary(operation: &Operation, a: Type) -> Result<Type, &'static str> {
    let require = |holds: bool, ty: Type, expected| if holds { Ok(ty) } else { Err(expected) };
    match operation {
        Operation::SquareRoot
        | Operation::Reciprocal
        | Operation::ReciprocalSquareRoot
        | Operation::ReciprocalNewton
        | Operation::ReciprocalSquareRootNewton
        | Operation::Absolute => require(a.is_float(), a, FLOAT),
        Operation::Convert(format) => require(a.is_float(), Type::Float(*format), FLOAT),
        Operation::ToFixed(fixed) => to_fixed(a, *fixed),
        Operation::ToFloat { format, .. } => to_float(a, *format),
        Operation::Interpolate(table) => {
            let shape = table.shape();
            let matches = a == Type::Unsigned(shape.index_bits + shape.fraction_bits);
            require(
                matches,
                Type::Unsigned(shape.value_bits),
                "operand must be unsigned, as wide as the table's argument",
            )
        }
        Operation::Negate => require(!matches!(a, Type::Unsigned(_)), a, "operand must be a float or signed"),
        Operation::Not => require(!a.is_float(), a, INTEGER),
        Operation::Bits { high, low } => {
            let within = low <= high && *high < a.width();
            require(within, Type::Unsigned(high.saturating_sub(*low) + 1), "bits must lie within the operand")
        }
        Operation::ShiftLeft(by) | Operation::ShiftRight(by) => {
            require(!a.is_float() && *by < a.width(), a, "operand must be an integer wider than the shift")
        }
        Operation::Resize(width) => require(!a.is_float(), a.resized(*width), INTEGER),
        Operation::Reinterpret(ty) => require(ty.width() == a.width(), *ty, "both types must be equally wide"),
        _ => Err(OPERAND_COUNT),
    }
}

fn to_fixed(a: Type, fixed: Fixed) -> Result<Type, &'static str> {
    if a.is_float() && (1..=WIDTH_MAX).contains(&fixed.width) { Ok(Type::of_fixed(fixed)) } else { Err(FIXED) }
}

fn to_float(a: Type, format: Format) -> Result<Type, &'static str> {
    if a.is_float() { Err(INTEGER) } else { Ok(Type::Float(format)) }
}

fn binary(operation: &Operation, a: Type, b: Type) -> Result<Type, &'static str> {
    match operation {
        Operation::Add | Operation::Subtract | Operation::Minimum | Operation::Maximum => {
            all_same(&[a, b], |_| true, SAME_TYPE)
        }
        Operation::Divide => all_same(&[a, b], Type::is_float, SAME_FLOAT),
        Operation::Multiply => match (a, b) {
            (Type::Float(_), _) if a == b => Ok(a),
            (Type::Unsigned(left), Type::Unsigned(right)) => Ok(Type::Unsigned(left + right)),
            (Type::Signed(left), Type::Signed(right)) => Ok(Type::Signed(left + right)),
            _ => Err(SAME_SIGNEDNESS),
        },
        Operation::Less | Operation::LessOrEqual | Operation::Equal => {
            all_same(&[a, b], |_| true, SAME_TYPE).map(|_| Type::BOOL)
        }
        Operation::And | Operation::Or | Operation::Xor => all_same(&[a, b], |ty| !ty.is_float(), SAME_INTEGER),
        Operation::Cat => Ok(Type::Unsigned(a.width() + b.width())),
        _ => Err(OPERAND_COUNT),
    }
}
