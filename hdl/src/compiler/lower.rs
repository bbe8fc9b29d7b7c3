//! Operations without registers as expressions.

use super::operation::Operation;
use super::types::Type;
use rtl::{Expr, bit, cat, lit};

/// The expression of a combinational operation.
pub(super) fn combinational(operation: &Operation, operands: &[Expr], types: &[Type], result: Type) -> Expr {
    let width = result.width();
    let a = operands[0];
    let is_signed = matches!(types[0], Type::Signed(_));
    let b = || operands[1];
    let less = |left: Expr, right: Expr| if is_signed { left.lt_signed(right) } else { left.lt(right) };
    match operation {
        Operation::Add => a + b(),
        Operation::Subtract => a - b(),
        Operation::Negate if types[0].is_float() => with_sign(!a.msb(), a),
        Operation::Negate => lit(width, 0) - a,
        Operation::Absolute => with_sign(bit(false), a),
        Operation::Minimum => less(b(), a).mux(b(), a),
        Operation::Maximum => less(a, b()).mux(b(), a),
        Operation::Less => less(a, b()),
        Operation::LessOrEqual => !less(b(), a),
        Operation::Equal => a.eq(b()),
        Operation::Not => !a,
        Operation::And => a & b(),
        Operation::Or => a | b(),
        Operation::Xor => a ^ b(),
        Operation::Mux => a.mux(b(), operands[2]),
        Operation::Bits { high, low } => a.bits(*high, *low),
        Operation::Cat => cat([a, b()]),
        Operation::ShiftLeft(by) => a << (*by),
        Operation::ShiftRight(by) if is_signed => a.sar(*by),
        Operation::ShiftRight(by) => a >> (*by),
        Operation::Resize(_) if is_signed && width > a.width() => a.sext(width),
        Operation::Resize(_) => a.resize(width),
        Operation::Reinterpret(_) => a,
        other => unreachable!("{} is a port, a constant or pipelined, as the plan says", other.mnemonic()),
    }
}

fn with_sign(sign: Expr, float: Expr) -> Expr {
    cat([sign, float.trunc(float.width() - 1)])
}
