//! Blocks of a program as pipelines; golden twin: `pointcore_golden::process::block`.
//!
//! The ports are those of [`Program::inputs`](process::Program::inputs), settings as uniforms, and of
//! [`Program::results`](process::Program::results). The tree over a sum's partial sums is part of `final`.

use crate::compiler::{self, CompileError, Datapath, Graph, Options, Program, Table, Type, Value};
use crate::float::exp_neg;
use pointcore_contract::process::{
    self, EXP_NEGATIVE_END, EXP_NEGATIVE_TABLE, Literal, Node, Operation, PARTIAL_SUMS, Port, Scalar, Section, Source,
};
use pointcore_contract::{Fixed, Format, Signedness};
use std::collections::HashMap;
use std::rc::Rc;

/// An integer of a program.
const INT: Fixed = Fixed { width: i32::BITS, fraction: 0, signed: Signedness::Signed };

/// Neighbors that a query has at least where all blocks are busy all the time.
const NEIGHBORS_AT_FULL_SPEED: u32 = 8;

/// Cycles from one token of a block to the next, at `rate` cycles a neighbor.
#[must_use]
pub const fn interval(section: Section, rate: u32) -> u32 {
    match section {
        Section::Kernel => rate,
        Section::Init | Section::Final => rate.saturating_mul(NEIGHBORS_AT_FULL_SPEED),
    }
}

/// The data path of a block with floats of `format`, at `rate` cycles a neighbor. An `init` that stores nothing has
/// none.
///
/// # Errors
/// What the compiler rejects: a block that gives nothing, a rate of 0 or above 8.
pub fn datapath(
    program: &process::Program,
    section: Section,
    format: Format,
    rate: u32,
    options: &Options,
) -> Result<Datapath, CompileError> {
    let graph = graph(program, section, format)?;
    compiler::compile_graph(&graph, &options.with_interval(interval(section, rate)))
}

/// The block as the compiler takes it.
///
/// # Errors
/// What the compiler rejects.
pub fn graph(program: &process::Program, section: Section, format: Format) -> Result<Graph, CompileError> {
    let unit = format!("{}_{}", program.name(), section.name());
    let doc = format!("The block `{}` of the program `{}`.", section.name(), program.name());
    let target = Program::new(&unit, &doc);
    lower(&target, program, (section, &program.inputs(section)), format)?;
    target.graph()
}

/// Writes a block to a program of the compiler, its inputs in the order of `ports`.
pub(super) fn lower(
    target: &Program,
    program: &process::Program,
    (section, ports): (Section, &[Port]),
    format: Format,
) -> Result<(), CompileError> {
    let mut lowering = Lowering { program: target.clone(), format, sources: HashMap::new() };
    for port in ports {
        let ty = lowering.ty(port.ty);
        let value = match port.source {
            Source::Setting(_) => target.uniform(&port.name, ty),
            _ => target.input(&port.name, ty),
        };
        lowering.sources.entry(port.source).or_default().push(value);
    }
    let mut values: Vec<Value> = vec![];
    for node in program.block(section).nodes() {
        let operands: Vec<Value> = node.operands.iter().map(|id| values[id.index()]).collect();
        let operand_ty = node.operands.first().map(|&id| program.block(section).node(id).ty);
        let mut value = lowering.node(node, operand_ty, &operands)?;
        if let Some(name) = &node.name {
            value = value.named(name);
        }
        values.push(value);
    }
    for outgoing in program.results(section) {
        let value = outgoing.value.map_or_else(|| target.lit(1, 1), |id| values[id.index()]);
        target.output(&outgoing.name, value);
    }
    Ok(())
}

/// A block that becomes a program of the compiler.
struct Lowering {
    program: Program,
    format: Format,
    /// By source its port, or those of its partial sums.
    sources: HashMap<Source, Vec<Value>>,
}

impl Lowering {
    const fn ty(&self, scalar: Scalar) -> Type {
        match scalar {
            Scalar::Float => Type::Float(self.format),
            Scalar::Int => Type::Signed(INT.width),
            Scalar::Bool => Type::BOOL,
        }
    }

    fn node(&self, node: &Node, operand_ty: Option<Scalar>, operands: &[Value]) -> Result<Value, CompileError> {
        Ok(match (node.operation, operands) {
            (Operation::Input(source), _) => sum(&self.sources[&source]),
            (Operation::Literal(literal), _) => self.literal(literal),
            (Operation::ExpNegative, &[a]) => self.exp_negative(a)?,
            (operation, &[a]) => self.unary(operation, a),
            (Operation::Multiply, &[a, b]) if operand_ty == Some(Scalar::Int) => (a * b).resize(INT.width),
            (operation, &[a, b]) => binary(operation, a, b),
            (Operation::MultiplyAdd, &[a, b, c]) => a.fma(b, c),
            (Operation::Select, &[condition, a, b]) => condition.mux(a, b),
            (other, _) => unreachable!("the parser gives {other:?} other operands than {}", operands.len()),
        })
    }

    fn literal(&self, literal: Literal) -> Value {
        match literal {
            Literal::Float(bits) => self.program.float(self.format, f32::from_bits(bits).into()),
            Literal::Int(value) => self.program.constant(self.ty(Scalar::Int), u64::from(value as u32)),
            Literal::Bool(value) => self.program.lit(1, value.into()),
        }
    }

    fn unary(&self, operation: Operation, a: Value) -> Value {
        match operation {
            Operation::Reciprocal => a.recip(),
            Operation::SquareRoot => a.sqrt(),
            Operation::ReciprocalSquareRoot => a.rsqrt(),
            Operation::Absolute => a.abs(),
            Operation::Negate => -a,
            Operation::Not => !a,
            Operation::ToFloat => a.to_float(self.format, INT.fraction),
            Operation::ToInt => a.to_fixed(INT),
            other => unreachable!("the parser gives {other:?} more operands"),
        }
    }

    /// `e^−a` from a table over `[0, EXP_NEGATIVE_END)`; what lies beyond its end saturates there, at 0.
    fn exp_negative(&self, a: Value) -> Result<Value, CompileError> {
        let shape = EXP_NEGATIVE_TABLE;
        let width = shape.index_bits + shape.fraction_bits;
        let argument = Fixed { width, fraction: width - EXP_NEGATIVE_END.ilog2(), signed: Signedness::Unsigned };
        let table = Rc::new(Table::new(shape, exp_neg::samples(EXP_NEGATIVE_END.into(), shape))?);
        let value = a.to_fixed(argument).kernel(&table).to_float(self.format, shape.value_bits);
        let no_number = self.program.constant(Type::Float(self.format), self.format.quiet_nan());
        Ok(a.eq(a).mux(value, no_number))
    }
}

fn binary(operation: Operation, a: Value, b: Value) -> Value {
    match operation {
        Operation::Add => a + b,
        Operation::Subtract => a - b,
        Operation::Multiply => a * b,
        Operation::Divide => a / b,
        Operation::Minimum => a.min(b),
        Operation::Maximum => a.max(b),
        Operation::Less => a.lt(b),
        Operation::LessOrEqual => a.le(b),
        Operation::Equal => a.eq(b),
        Operation::And => a & b,
        Operation::Or => a | b,
        Operation::Xor => a ^ b,
        other => unreachable!("the parser gives {other:?} another number of operands"),
    }
}

/// `((p0 + p1) + (p2 + p3)) + ((p4 + p5) + (p6 + p7))` of a sum's partial sums, or the value of what is no sum.
fn sum(parts: &[Value]) -> Value {
    match *parts {
        [value] => value,
        [p0, p1, p2, p3, p4, p5, p6, p7] => ((p0 + p1) + (p2 + p3)) + ((p4 + p5) + (p6 + p7)),
        _ => unreachable!("a source has one port, a sum {PARTIAL_SUMS}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::process::library::{PROGRAMS, program};
    use rtl::elaborate;

    #[test]
    fn every_block_of_the_library_is_a_module_of_its_name() {
        for (name, _) in PROGRAMS {
            let program = program(name);
            for section in Section::ALL {
                let datapath = datapath(&program, section, Format::F32.flushed(), 1, &Options::default());
                if program.results(section).is_empty() {
                    assert!(matches!(datapath, Err(CompileError::NoOutput { .. })), "{name}: nothing to compile");
                    continue;
                }
                let datapath = datapath.unwrap_or_else(|error| panic!("{error}"));
                assert_eq!(datapath.manifest.unit, format!("{name}_{}", section.name()));
                assert_eq!(datapath.manifest.initiation_interval, if section == Section::Kernel { 1 } else { 8 });
                elaborate(&datapath.module).unwrap_or_else(|error| panic!("{error}"));
            }
        }
    }

    #[test]
    fn rates_out_of_range_are_rejected() {
        let compile = |section, rate| datapath(&program("mls"), section, Format::F32, rate, &Options::default());
        assert!(compile(Section::Final, 8).is_ok());
        for rate in [0, 9, u32::MAX] {
            let error = compile(Section::Final, rate).err();
            assert!(matches!(error, Some(CompileError::InitiationInterval { .. })), "rate {rate}: {error:?}");
        }
    }
}
