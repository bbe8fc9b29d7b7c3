//! Programs carried out one operation after the other, with the golden operators and plain integers.

use pointcore_contract::{Fixed, Format, Signedness};
use pointcore_golden::float;
use pointcore_hdl::compiler::{Graph, Node, Operation, Type};

/// The results of a token, or nothing when the program drops it. `inputs` and `uniforms` are in order of declaration.
pub fn interpret(graph: &Graph, tables: &[float::Table], inputs: &[u64], uniforms: &[u64]) -> Option<Vec<u64>> {
    let (mut inputs, mut uniforms) = (inputs.iter(), uniforms.iter());
    let mut values: Vec<u64> = Vec::new();
    for node in graph.nodes() {
        let value = match node.operation {
            Operation::Input => *inputs.next().expect("a value for every input"),
            Operation::Uniform => *uniforms.next().expect("a value for every uniform"),
            Operation::Constant(value) => value,
            _ => {
                let operand =
                    |id: &pointcore_hdl::compiler::ValueId| (graph.nodes()[id.index()].ty, values[id.index()]);
                let operands: Vec<(Type, u64)> = node.operands.iter().map(operand).collect();
                apply(node, tables, &operands)
            }
        };
        assert_eq!(value & !node.ty.mask(), 0, "the interpreter keeps to the type of {node:?}");
        values.push(value);
    }
    if graph.keep().is_some_and(|keep| values[keep.index()] == 0) {
        return None;
    }
    Some(graph.outputs().iter().map(|(_, id)| values[id.index()]).collect())
}

fn apply(node: &Node, tables: &[float::Table], operands: &[(Type, u64)]) -> u64 {
    match operands[0].0 {
        Type::Float(format) => match on_float(&node.operation, format, operands) {
            Some(value) => value,
            None => on_bits(node, operands),
        },
        _ => match &node.operation {
            Operation::ToFloat { format, fraction } => {
                let signed = matches!(operands[0].0, Type::Signed(_));
                let signed = if signed { Signedness::Signed } else { Signedness::Unsigned };
                let fixed = Fixed { width: operands[0].0.width(), fraction: *fraction, signed };
                float::from_fixed(*format, operands[0].1, fixed)
            }
            Operation::Interpolate(table) => {
                let samples = |golden: &&float::Table| {
                    golden.values().iter().map(|&v| v as u64).eq(table.values().iter().copied())
                };
                tables.iter().find(samples).expect("programs use known tables").interpolate(operands[0].1)
            }
            _ => on_bits(node, operands),
        },
    }
}

fn on_float(operation: &Operation, format: Format, operands: &[(Type, u64)]) -> Option<u64> {
    let value = |index: usize| operands[index].1;
    let a = value(0);
    Some(match operation {
        Operation::Add => float::add(format, a, value(1)),
        Operation::Subtract => float::sub(format, a, value(1)),
        Operation::Multiply => float::mul(format, a, value(1)),
        Operation::MultiplyAdd => float::fma(format, a, value(1), value(2)),
        Operation::Divide => float::div(format, a, value(1)),
        Operation::SquareRoot => float::sqrt(format, a),
        Operation::Reciprocal => float::recip(format, a),
        Operation::ReciprocalSquareRoot => float::rsqrt(format, a),
        Operation::ReciprocalNewton => float::recip_newton(format, a),
        Operation::ReciprocalSquareRootNewton => float::rsqrt_newton(format, a),
        Operation::Minimum => float::min(format, a, value(1)),
        Operation::Maximum => float::max(format, a, value(1)),
        Operation::Less => float::lt(format, a, value(1)).into(),
        Operation::LessOrEqual => float::le(format, a, value(1)).into(),
        Operation::Equal => float::eq(format, a, value(1)).into(),
        Operation::Negate => a ^ format.sign_mask(),
        Operation::Absolute => a & !format.sign_mask(),
        Operation::Convert(to) => float::convert(format, *to, a),
        Operation::ToFixed(fixed) => float::to_fixed(format, a, *fixed),
        _ => return None,
    })
}

/// Everything that is the same for all types, or only for integers.
fn on_bits(node: &Node, operands: &[(Type, u64)]) -> u64 {
    let value = |index: usize| operands[index].1;
    let number = |index: usize| match operands[index] {
        (Type::Signed(width), bits) => i128::from((bits << (64 - width)) as i64 >> (64 - width)),
        (_, bits) => i128::from(bits),
    };
    let (a, b) = (number(0), || number(1));
    let result = match node.operation {
        Operation::Add => a + b(),
        Operation::Subtract => a - b(),
        Operation::Multiply => a * b(),
        Operation::Minimum => a.min(b()),
        Operation::Maximum => a.max(b()),
        Operation::Less => i128::from(a < b()),
        Operation::LessOrEqual => i128::from(a <= b()),
        Operation::Equal => i128::from(a == b()),
        Operation::Negate => -a,
        Operation::Not => !a,
        Operation::And => a & b(),
        Operation::Or => a | b(),
        Operation::Xor => a ^ b(),
        Operation::Mux => i128::from(value(if value(0) == 1 { 1 } else { 2 })),
        Operation::Bits { low, .. } => i128::from(value(0) >> low),
        Operation::Cat => i128::from(value(0)) << operands[1].0.width() | i128::from(value(1)),
        Operation::ShiftLeft(by) => a << by,
        Operation::ShiftRight(by) => a >> by,
        Operation::Resize(_) => a,
        Operation::Reinterpret(_) => i128::from(value(0)),
        ref other => panic!("{} is no operation on bits", other.mnemonic()),
    };
    result as u64 & node.ty.mask()
}
