//! Which operations take an operator with registers inside, and which operator that is.

use super::multiply;
use super::operation::Operation;
use super::types::Type;
use crate::float::{
    self, Operator, add, compare, convert, div, fma, from_fixed, minmax, mul, recip_newton, rsqrt, rsqrt_newton, sqrt,
    to_fixed,
};
use pointcore_contract::{Fixed, Signedness};
use std::collections::BTreeMap;

/// Pipeline stages of operators where they should differ from the operators' own defaults.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OperatorStages {
    by_class: BTreeMap<String, u32>,
}

impl OperatorStages {
    /// Asks for `stages` in all operators of a class, named as in the manifest, such as `add.f32`; an operator takes as
    /// many as it can, at least one.
    #[must_use]
    pub fn with(mut self, class: &str, stages: u32) -> Self {
        self.by_class.insert(class.to_owned(), stages.max(1));
        self
    }

    pub(super) fn of(&self, class: &str) -> Option<u32> {
        self.by_class.get(class).copied()
    }
}

/// Ports of an operator, in the order of an operation's operands.
pub(super) const OPERAND_PORTS: [&str; 4] = ["a", "b", "c", "d"];

/// Whether the operation has registers inside, given the type of its first operand.
pub(super) const fn is_pipelined(operation: &Operation, operand: Type) -> bool {
    match operation {
        Operation::Add
        | Operation::Subtract
        | Operation::Minimum
        | Operation::Maximum
        | Operation::Less
        | Operation::LessOrEqual
        | Operation::Equal => operand.is_float(),
        Operation::Multiply
        | Operation::MultiplyAdd
        | Operation::Compound(_)
        | Operation::Divide
        | Operation::SquareRoot
        | Operation::Reciprocal
        | Operation::ReciprocalSquareRoot
        | Operation::ReciprocalNewton
        | Operation::ReciprocalSquareRootNewton
        | Operation::Convert(_)
        | Operation::ToFixed(_)
        | Operation::ToFloat { .. }
        | Operation::Interpolate(_) => true,
        _ => false,
    }
}

/// Whether an operator takes more than the choices of operands in front of it: a comparison, which keeps a bit, does not.
pub(super) const fn is_worth_sharing(operation: &Operation) -> bool {
    !matches!(operation, Operation::Less | Operation::LessOrEqual | Operation::Equal)
}

/// Kind and formats of the operator that carries out an operation.
pub(super) fn class_name(operation: &Operation, operands: &[Type]) -> String {
    let mnemonic = operation.mnemonic();
    match operation {
        Operation::Convert(format) => format!("{mnemonic}.{}.{format}", operands[0]),
        Operation::ToFixed(fixed) => {
            format!("{mnemonic}.{}.{}q{}", operands[0], Type::of_fixed(*fixed), fixed.fraction)
        }
        Operation::ToFloat { format, fraction } => format!("{mnemonic}.{}q{fraction}.{format}", operands[0]),
        Operation::Multiply if !operands[0].is_float() => format!("{mnemonic}.{}.{}", operands[0], operands[1]),
        Operation::Interpolate(table) => {
            let shape = table.shape();
            format!("{mnemonic}.{}_{}_{}", shape.index_bits, shape.fraction_bits, shape.value_bits)
        }
        _ => format!("{mnemonic}.{}", operands[0]),
    }
}

/// The operator of an operation on operands of these types, with its own number of stages unless told.
pub(super) fn operator(operation: &Operation, operands: &[Type], stages: &OperatorStages) -> Operator {
    let wanted = stages.of(&class_name(operation, operands));
    let Type::Float(format) = operands[0] else { return integer_operator(operation, operands, wanted) };
    if let Operation::Compound(compound) = operation {
        let part = |operation: &Operation| operator(operation, &operands[..2], stages);
        return compound.operator(format, &part(&Operation::Multiply), &part(&Operation::Add));
    }
    let or = |default: u32| wanted.unwrap_or(default);
    match operation {
        Operation::Add => add::module(format, or(add::stages(format))),
        Operation::Multiply => mul::module(format, or(mul::stages(format))),
        Operation::MultiplyAdd => fma::module(format, or(fma::stages(format))),
        Operation::Divide => div::module(format, or(div::stages(format))),
        Operation::Reciprocal => div::recip(format, or(div::stages(format))),
        Operation::SquareRoot => sqrt::module(format, or(sqrt::stages(format))),
        Operation::ReciprocalSquareRoot => rsqrt::module(format, or(rsqrt::stages(format))),
        Operation::ReciprocalNewton => recip_newton::module(format, or(recip_newton::stages(format))),
        Operation::ReciprocalSquareRootNewton => rsqrt_newton::module(format, or(rsqrt_newton::stages(format))),
        Operation::Minimum => minmax::min(format, or(minmax::stages(format))),
        Operation::Maximum => minmax::max(format, or(minmax::stages(format))),
        Operation::Less => compare::lt(format, or(compare::stages(format))),
        Operation::LessOrEqual => compare::le(format, or(compare::stages(format))),
        Operation::Equal => compare::eq(format, or(compare::stages(format))),
        Operation::Convert(to) => convert::module(format, *to, or(convert::stages(format, *to))),
        Operation::ToFixed(fixed) => to_fixed::module(format, *fixed, or(to_fixed::stages(format, *fixed))),
        other => unreachable!("{} on floats is not pipelined, or `optimize` replaced it", other.mnemonic()),
    }
}

fn integer_operator(operation: &Operation, operands: &[Type], stages: Option<u32>) -> Operator {
    let or = |default: u32| stages.unwrap_or(default);
    let a = operands[0];
    match operation {
        Operation::Multiply => multiply::module(a, operands[1], or(multiply::stages(a, operands[1]))),
        Operation::ToFloat { format, fraction } => {
            let signed = if matches!(a, Type::Signed(_)) { Signedness::Signed } else { Signedness::Unsigned };
            let fixed = Fixed { width: a.width(), fraction: *fraction, signed };
            from_fixed::module(*format, fixed, or(from_fixed::stages(*format, fixed)))
        }
        Operation::Interpolate(table) => {
            float::table::module(table.shape(), table.values(), or(float::table::stages(table.shape())))
        }
        other => unreachable!("{} on integers is not pipelined", other.mnemonic()),
    }
}
