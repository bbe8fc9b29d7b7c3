//! Operations on bits and integers whose operands are constants. Floating-point arithmetic is left to the operators.

use super::operation::Operation;
use super::types::Type;

/// The result of `operation` on encoded constants; `None` when only an operator of the hardware can tell.
pub(super) fn evaluate(operation: &Operation, operands: &[(Type, u64)], result: Type) -> Option<u64> {
    let (first_type, first) = *operands.first()?;
    let operand = |index: usize| operands[index].1;
    // 65 bits hold every operand with its sign; products of 64-bit results hold in 128.
    let number = |index: usize| integer(operands[index]);
    let value = match operation {
        Operation::Mux => operand(if first == 1 { 1 } else { 2 }),
        Operation::Bits { low, .. } => first >> low,
        Operation::Cat => first << operands[1].0.width() | operand(1),
        Operation::Reinterpret(_) => first,
        Operation::Negate if first_type.is_float() => first ^ sign_mask(first_type),
        Operation::Absolute => first & !sign_mask(first_type),
        _ if first_type.is_float() => return None,
        Operation::Not => !first,
        Operation::And => first & operand(1),
        Operation::Or => first | operand(1),
        Operation::Xor => first ^ operand(1),
        Operation::Add => first.wrapping_add(operand(1)),
        Operation::Subtract => first.wrapping_sub(operand(1)),
        Operation::Negate => first.wrapping_neg(),
        Operation::Multiply => (number(0) * number(1)) as u64,
        Operation::Minimum => number(0).min(number(1)) as u64,
        Operation::Maximum => number(0).max(number(1)) as u64,
        Operation::Less => (number(0) < number(1)).into(),
        Operation::LessOrEqual => (number(0) <= number(1)).into(),
        Operation::Equal => (first == operand(1)).into(),
        Operation::ShiftLeft(by) => first << by,
        Operation::ShiftRight(by) => (number(0) >> by) as u64,
        Operation::Resize(_) => number(0) as u64,
        _ => return None,
    };
    Some(value & result.mask())
}

/// The sign bit of a type.
pub(super) const fn sign_mask(ty: Type) -> u64 {
    1 << (ty.width() - 1)
}

fn integer((ty, bits): (Type, u64)) -> i128 {
    let negative = matches!(ty, Type::Signed(_)) && bits & sign_mask(ty) != 0;
    i128::from(bits) - if negative { 1 << ty.width() } else { 0 }
}
