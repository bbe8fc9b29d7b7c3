//! Blocks of a program: straight-line arithmetic in a number format, each node rounded once.
//!
//! A word is the encoding of a float, the bits of an integer, or 0 or 1 of a truth value. A sum is that of its partial
//! sums, `((p0 + p1) + (p2 + p3)) + ((p4 + p5) + (p6 + p7))`; neighbor `i` of a query, counted from 0 in the order in
//! which neighbors come, was added to `p(i mod 8)`, which begins as +0.

use crate::float::{self, Table, kernel_table};
use pointcore_contract::process::{
    Block, EXP_NEGATIVE_END, EXP_NEGATIVE_TABLE, Literal, NodeId, Operation, PARTIAL_SUMS, Program, Scalar, Section,
    Source,
};
use pointcore_contract::{Fixed, Format, Signedness};

/// Bits of an integer in a float's terms.
const INT: Fixed = Fixed { width: i32::BITS, fraction: 0, signed: Signedness::Signed };

/// Operands of an operation at most.
const OPERANDS_MAX: usize = 3;

/// The blocks of a program in a number format.
#[derive(Clone, Debug)]
pub struct Blocks {
    program: Program,
    format: Format,
    exp_negative: Table,
}

impl Blocks {
    /// The blocks of `program` with floats of `format`.
    #[must_use]
    pub fn new(program: Program, format: Format) -> Self {
        Self { program, format, exp_negative: kernel_table(f64::from(EXP_NEGATIVE_END), EXP_NEGATIVE_TABLE) }
    }

    /// The program.
    #[must_use]
    pub const fn program(&self) -> &Program {
        &self.program
    }

    /// What leaves a block's data path, in the order of [`Program::results`], for what enters in the order of
    /// [`Program::inputs`].
    ///
    /// # Panics
    /// If there are fewer words than inputs.
    #[must_use]
    pub fn step(&self, section: Section, inputs: &[u32]) -> Vec<u32> {
        let ports = self.program.inputs(section);
        let values = self.evaluate(section, |source, partial| {
            let at = ports.iter().position(|port| port.source == source && port.partial == partial);
            inputs[at.expect("the ports are those of what the block reads")]
        });
        let results = self.program.results(section).into_iter();
        results.map(|outgoing| outgoing.value.map_or(1, |id| values[id.index()])).collect()
    }

    /// The value of every node of a block. `read` answers what it reads, and the given partial sum of a sum.
    pub(super) fn evaluate(&self, section: Section, read: impl Fn(Source, usize) -> u32) -> Vec<u32> {
        let block = self.program.block(section);
        let mut values: Vec<u32> = Vec::with_capacity(block.nodes().len());
        for node in block.nodes() {
            let mut operands = [0; OPERANDS_MAX];
            operands.iter_mut().zip(&node.operands).for_each(|(operand, id)| *operand = values[id.index()]);
            values.push(match node.operation {
                Operation::Input(Source::Sum(word)) => {
                    self.sum(node.ty, std::array::from_fn(|partial| read(Source::Sum(word), partial)))
                }
                Operation::Input(source) => read(source, 0),
                Operation::Literal(literal) => self.literal(literal),
                operation => match operand_type(block, &node.operands) {
                    Scalar::Float => self.on_floats(operation, &operands),
                    Scalar::Int => self.on_integers(operation, &operands),
                    Scalar::Bool => on_truth_values(operation, &operands),
                },
            });
        }
        values
    }

    /// A partial sum and an addend.
    #[must_use]
    pub fn add(&self, ty: Scalar, a: u32, b: u32) -> u32 {
        match ty {
            Scalar::Float => float::add(self.format, a.into(), b.into()) as u32,
            Scalar::Int | Scalar::Bool => a.wrapping_add(b),
        }
    }

    fn sum(&self, ty: Scalar, partial: [u32; PARTIAL_SUMS]) -> u32 {
        let mut level = partial.to_vec();
        while level.len() > 1 {
            level = level.chunks(2).map(|pair| self.add(ty, pair[0], pair[1])).collect();
        }
        level[0]
    }

    fn literal(&self, literal: Literal) -> u32 {
        match literal {
            Literal::Int(value) => value as u32,
            Literal::Bool(value) => value.into(),
            Literal::Float(bits) => {
                let bits = float::convert(Format::F32, self.format, bits.into());
                let is_normal = bits >> self.format.mantissa & self.format.exponent_max() != 0;
                let kept = if is_normal { u64::MAX } else { self.format.sign_mask() };
                (bits & kept) as u32
            }
        }
    }

    fn on_floats(&self, operation: Operation, operands: &[u32]) -> u32 {
        let f = self.format;
        let operand = |index: usize| u64::from(operands[index]);
        let a = operand(0);
        let result = match operation {
            Operation::Add => float::add(f, a, operand(1)),
            Operation::Subtract => float::sub(f, a, operand(1)),
            Operation::Multiply => float::mul(f, a, operand(1)),
            Operation::MultiplyAdd => float::fma(f, a, operand(1), operand(2)),
            Operation::Divide => float::div(f, a, operand(1)),
            Operation::Reciprocal => float::recip(f, a),
            Operation::SquareRoot => float::sqrt(f, a),
            Operation::ReciprocalSquareRoot => float::rsqrt(f, a),
            Operation::ExpNegative => self.exp_negative(a),
            Operation::Minimum => float::min(f, a, operand(1)),
            Operation::Maximum => float::max(f, a, operand(1)),
            Operation::Absolute => a & !f.sign_mask(),
            Operation::Negate => a ^ f.sign_mask(),
            Operation::Less => float::lt(f, a, operand(1)).into(),
            Operation::LessOrEqual => float::le(f, a, operand(1)).into(),
            Operation::Equal => float::eq(f, a, operand(1)).into(),
            Operation::ToInt => float::to_fixed(f, a, INT),
            other => unreachable!("the parser gives {other:?} no floats"),
        };
        result as u32
    }

    fn exp_negative(&self, a: u64) -> u64 {
        let f = self.format;
        if !float::eq(f, a, a) {
            return f.quiet_nan();
        }
        let width = EXP_NEGATIVE_TABLE.index_bits + EXP_NEGATIVE_TABLE.fraction_bits;
        let argument = Fixed { width, fraction: width - EXP_NEGATIVE_END.ilog2(), signed: Signedness::Unsigned };
        let value = self.exp_negative.interpolate(float::to_fixed(f, a, argument));
        let value_bits = EXP_NEGATIVE_TABLE.value_bits;
        float::from_fixed(f, value, Fixed { width: value_bits, fraction: value_bits, signed: Signedness::Unsigned })
    }

    fn on_integers(&self, operation: Operation, operands: &[u32]) -> u32 {
        let operand = |index: usize| operands[index] as i32;
        let a = operand(0);
        let result = match operation {
            Operation::Add => a.wrapping_add(operand(1)),
            Operation::Subtract => a.wrapping_sub(operand(1)),
            Operation::Multiply => a.wrapping_mul(operand(1)),
            Operation::Minimum => a.min(operand(1)),
            Operation::Maximum => a.max(operand(1)),
            Operation::Negate => a.wrapping_neg(),
            Operation::Less => (a < operand(1)).into(),
            Operation::LessOrEqual => (a <= operand(1)).into(),
            Operation::Equal => (a == operand(1)).into(),
            Operation::And => a & operand(1),
            Operation::Or => a | operand(1),
            Operation::Xor => a ^ operand(1),
            Operation::Not => !a,
            Operation::ToFloat => return float::from_fixed(self.format, operands[0].into(), INT) as u32,
            other => unreachable!("the parser gives {other:?} no integers"),
        };
        result as u32
    }
}

fn on_truth_values(operation: Operation, operands: &[u32]) -> u32 {
    match operation {
        Operation::And => operands[0] & operands[1],
        Operation::Or => operands[0] | operands[1],
        Operation::Xor => operands[0] ^ operands[1],
        Operation::Not => operands[0] ^ 1,
        Operation::Select => operands[if operands[0] == 1 { 1 } else { 2 }],
        other => unreachable!("the parser gives {other:?} no truth values"),
    }
}

/// Type of the first operand, by which an operation is chosen.
fn operand_type(block: &Block, operands: &[NodeId]) -> Scalar {
    block.node(*operands.first().expect("operations have operands")).ty
}
