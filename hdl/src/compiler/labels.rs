//! What values are called in the Verilog: as their author does, or else by what they are made of, `x_times_ay`, or where that grows
//! long by what they are for, `distance_sum`.

use super::graph::{Graph, Node};
use super::operation::Operation;
use super::types::Type;

/// A name made of operands' names is no longer than this.
const COMPOSED_CHARACTERS: usize = 30;

/// A label for each value; several may have the same.
pub(super) fn labels(graph: &Graph) -> Vec<String> {
    let purposes = purposes(graph);
    let mut labels: Vec<String> = Vec::with_capacity(graph.nodes().len());
    for (index, node) in graph.nodes().iter().enumerate() {
        let label = given(graph, index)
            .or_else(|| composed(graph, &labels, node))
            .unwrap_or_else(|| format!("{}_{}", purposes[index], noun(&node.operation)));
        labels.push(label);
    }
    labels
}

/// The author's name for a value, or one from that of the output it leaves by.
fn given(graph: &Graph, index: usize) -> Option<String> {
    let output = || graph.outputs().iter().find(|(_, id)| id.0 == index).map(|(name, _)| format!("{name}_out"));
    graph.nodes()[index].name.clone().or_else(output)
}

/// By value: the name of the first one behind it that has one.
fn purposes(graph: &Graph) -> Vec<String> {
    let mut purposes = vec![graph.unit().to_owned(); graph.nodes().len()];
    if let Some(keep) = graph.keep() {
        purposes[keep.0] = "kept".into();
    }
    for (index, node) in graph.nodes().iter().enumerate().rev() {
        if let Some(name) = given(graph, index) {
            purposes[index] = name;
        }
        for operand in &node.operands {
            purposes[operand.0] = purposes[index].clone();
        }
    }
    purposes
}

/// A short name from those of the operands.
fn composed(graph: &Graph, labels: &[String], node: &Node) -> Option<String> {
    let operand = |position: usize| {
        let id = *node.operands.get(position)?;
        match graph.node(id).operation {
            Operation::Constant(value) => constant(value, graph.node(id).ty),
            _ => Some(labels[id.0].clone()),
        }
    };
    // What a negated operand negates.
    let negated = |position: usize| {
        let of = graph.node(*node.operands.get(position)?);
        (of.operation == Operation::Negate).then(|| labels[of.operands[0].0].clone())
    };
    let left = operand(0)?;
    let between = |word: &str| {
        let right = operand(1)?;
        let number_first = node.operation.is_commutative() && left.starts_with(|first: char| first.is_ascii_digit());
        let (left, right) = if number_first { (&right, &left) } else { (&left, &right) };
        Some(format!("{left}_{word}_{right}"))
    };
    let name = match &node.operation {
        Operation::Add => match (negated(0), negated(1)) {
            (None, Some(right)) => format!("{left}_minus_{right}"),
            (Some(right), None) => format!("{}_minus_{right}", operand(1)?),
            _ => between("plus")?,
        },
        Operation::Subtract => between("minus")?,
        Operation::Multiply if node.operands[0] == node.operands[1] => format!("{left}_squared"),
        Operation::Multiply => between("times")?,
        Operation::Divide => between("over")?,
        Operation::Less => between("below")?,
        Operation::LessOrEqual => between("up_to")?,
        Operation::Equal => between("is")?,
        Operation::And => between("and")?,
        Operation::Or => between("or")?,
        Operation::SquareRoot => format!("root_of_{left}"),
        Operation::Reciprocal | Operation::ReciprocalNewton => format!("one_over_{left}"),
        Operation::Negate => format!("minus_{left}"),
        Operation::Absolute => format!("abs_{left}"),
        Operation::Not => format!("not_{left}"),
        Operation::ToFixed(_) => format!("{left}_fixed"),
        Operation::ToFloat { .. } => format!("{left}_float"),
        Operation::Convert(_) => format!("{left}_rounded"),
        // The same number in other bits.
        Operation::Resize(_) | Operation::Reinterpret(_) => return Some(left),
        Operation::Bits { high, low } if high == low && high + 1 == graph.node(node.operands[0]).ty.width() => {
            format!("{left}_sign")
        }
        Operation::Bits { .. } => format!("{left}_bits"),
        _ => return None,
    };
    let is_name = name.starts_with(|first: char| first.is_ascii_alphabetic());
    (is_name && name.len() <= COMPOSED_CHARACTERS).then_some(name)
}

/// A constant that a name can hold.
fn constant(value: u64, ty: Type) -> Option<String> {
    match ty {
        _ if value == 0 => Some("zero".into()),
        Type::Float(format) if value == format.one() => Some("one".into()),
        Type::Unsigned(_) if value < 1000 => Some(value.to_string()),
        _ => None,
    }
}

/// What an operation makes, as a noun.
const fn noun(operation: &Operation) -> &'static str {
    match operation {
        Operation::Add => "sum",
        Operation::Subtract => "difference",
        Operation::Multiply => "product",
        Operation::MultiplyAdd => "product_sum",
        Operation::Compound(_) => "sum",
        Operation::Divide => "quotient",
        Operation::SquareRoot => "root",
        Operation::Reciprocal | Operation::ReciprocalNewton => "reciprocal",
        Operation::ReciprocalSquareRoot | Operation::ReciprocalSquareRootNewton => "reciprocal_root",
        Operation::Minimum => "lesser",
        Operation::Maximum => "greater",
        Operation::Less | Operation::LessOrEqual => "in_order",
        Operation::Equal => "same",
        Operation::Negate => "negated",
        Operation::Absolute => "magnitude",
        Operation::Convert(_) => "rounded",
        Operation::ToFixed(_) => "fixed",
        Operation::ToFloat { .. } => "float",
        Operation::Interpolate(_) => "interpolated",
        Operation::Not => "inverted",
        Operation::And => "both",
        Operation::Or => "either",
        Operation::Xor => "unequal",
        Operation::Mux => "chosen",
        Operation::Cat => "joined",
        Operation::ShiftLeft(_) | Operation::ShiftRight(_) => "shifted",
        Operation::Bits { .. } => "bits",
        Operation::Input | Operation::Uniform | Operation::Constant(_) => "constant",
        Operation::Resize(_) | Operation::Reinterpret(_) => "number",
    }
}

#[cfg(test)]
mod tests {
    use super::super::optimize::optimize;
    use super::super::program::Program;
    use super::*;
    use pointcore_contract::Format;

    #[test]
    fn values_are_called_as_named_by_their_operands_or_by_their_purpose() {
        let p = Program::new("test", "");
        let [a, b] = ["a", "b"].map(|name| p.input(name, Type::Float(Format::F16)));
        let alpha = (a * b).named("alpha");
        let rest = (alpha - b) * (alpha + a) * (alpha + b) * alpha;
        p.output("sum", rest + p.float(Format::F16, 1.0));
        let graph = optimize(&p.graph().expect("the test's program is well typed"));
        let expected = [
            "a",
            "b",
            "alpha",
            "minus_b",
            "alpha_minus_b",
            "a_plus_alpha",
            "sum_out_product",
            "b_plus_alpha",
            "sum_out_product",
            "alpha_times_sum_out_product",
            "sum_out_constant",
            "sum_out",
        ];
        assert_eq!(labels(&graph), expected);
    }
}
