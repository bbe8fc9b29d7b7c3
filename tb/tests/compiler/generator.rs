//! Random programs and random tokens for them.

use fastrand::Rng;
use pointcore_contract::{Fixed, Format, Signedness, TableShape};
use pointcore_golden::float;
use pointcore_hdl::compiler::{Graph, Operation, Table, Type, ValueId};
use std::rc::Rc;

/// The table that programs interpolate in.
const SHAPE: TableShape = TableShape { index_bits: 4, fraction_bits: 6, value_bits: 8 };
/// Widest integer in a program: products of two fit a port.
const INTEGER_WIDTH: u32 = 24;
/// Random operands tried for an operation before another one has its turn.
const ATTEMPTS: usize = 50;
/// Share of inputs that are drawn from all bit patterns; the others are near one.
const WILD_SHARE: f64 = 0.3;
/// Distance from one of the tame inputs, as a power of two.
const TAME_EXPONENT: i64 = 6;

/// The golden table and its copy for programs.
pub fn table() -> (float::Table, Rc<Table>) {
    let golden = float::kernel_table(3.0, SHAPE);
    let values = golden.values().iter().map(|&value| value as u64).collect();
    (golden, Rc::new(Table::new(SHAPE, values).expect("the golden table has its shape")))
}

/// A program of about `size` operations over all kinds of values.
pub fn program(rng: &mut Rng, unit: &str, size: usize) -> Graph {
    let formats = [Format::F32, Format::F24, Format::F16, Format::BF16, Format::F32.flushed(), Format::F24.flushed()];
    let formats = [formats[rng.usize(..formats.len())], formats[rng.usize(..formats.len())]];
    let mut graph = Graph::new(unit, "Random arithmetic.");
    let well_formed = "ports and constants of the generator are well formed";
    for index in 0..rng.usize(3..6) {
        let ty = match index {
            0 => Type::Float(formats[0]),
            1 => Type::Unsigned(SHAPE.index_bits + SHAPE.fraction_bits),
            _ => any_type(rng, formats),
        };
        graph.input(&format!("x{index}"), ty).expect(well_formed);
    }
    for index in 0..rng.usize(1..3) {
        graph.uniform(&format!("m{index}"), any_type(rng, formats)).expect(well_formed);
    }
    let ty = any_type(rng, formats);
    let constant = sample(rng, ty);
    graph.constant(ty, constant).expect(well_formed);
    let (_, table) = table();
    let first = graph.nodes().len();
    // All operations in turn, so that a few programs have every one; a kind that finds no operands is passed over.
    let mut turn = rng.usize(..);
    while graph.nodes().len() < first + size {
        turn = turn.wrapping_add(1);
        for _ in 0..ATTEMPTS {
            let operations = operations(rng, formats, &table);
            let operation = operations[turn % operations.len()].clone();
            let operands = operands(rng, &graph, &operation);
            // Many combinations are ill typed; the compiler's own check sorts them out.
            if graph.apply(operation, &operands).is_ok() {
                break;
            }
        }
    }
    outputs(rng, &mut graph);
    graph
}

/// Outputs for what nothing else uses, so that little of the program is dead, and sometimes a keep condition.
fn outputs(rng: &mut Rng, graph: &mut Graph) {
    let ids: Vec<ValueId> = graph.ids().collect();
    let used: Vec<ValueId> = graph.nodes().iter().flat_map(|node| node.operands.clone()).collect();
    let unused = ids.iter().filter(|id| !used.contains(id));
    for (index, &id) in unused.enumerate() {
        graph.output(&format!("y{index}"), id).expect("output names are distinct");
    }
    let conditions: Vec<ValueId> = ids.into_iter().filter(|id| graph.nodes()[id.index()].ty == Type::BOOL).collect();
    if !conditions.is_empty() && rng.bool() {
        graph.keep_if(conditions[rng.usize(..conditions.len())]).expect("conditions are one bit");
    }
}

fn any_type(rng: &mut Rng, formats: [Format; 2]) -> Type {
    match rng.u32(..5) {
        0..3 => Type::Float(formats[rng.usize(..2)]),
        3 => Type::Unsigned(rng.u32(1..=INTEGER_WIDTH)),
        _ => Type::Signed(rng.u32(1..=INTEGER_WIDTH)),
    }
}

/// One of every kind with random parameters.
fn operations(rng: &mut Rng, formats: [Format; 2], table: &Rc<Table>) -> Vec<Operation> {
    let format = formats[rng.usize(..2)];
    let width = rng.u32(1..=INTEGER_WIDTH);
    let signed = if rng.bool() { Signedness::Signed } else { Signedness::Unsigned };
    let fixed = Fixed { width, fraction: rng.u32(..12), signed };
    let low = rng.u32(..12);
    vec![
        Operation::Add,
        Operation::Subtract,
        Operation::Multiply,
        Operation::MultiplyAdd,
        Operation::Divide,
        Operation::SquareRoot,
        Operation::Reciprocal,
        Operation::ReciprocalSquareRoot,
        Operation::ReciprocalNewton,
        Operation::ReciprocalSquareRootNewton,
        Operation::Minimum,
        Operation::Maximum,
        Operation::Less,
        Operation::LessOrEqual,
        Operation::Equal,
        Operation::Negate,
        Operation::Absolute,
        Operation::Convert(format),
        Operation::ToFixed(fixed),
        Operation::ToFloat { format, fraction: rng.u32(..12) },
        Operation::Interpolate(Rc::clone(table)),
        Operation::Not,
        Operation::And,
        Operation::Or,
        Operation::Xor,
        Operation::Mux,
        Operation::Bits { high: low + rng.u32(..12), low },
        Operation::Cat,
        Operation::ShiftLeft(rng.u32(..12)),
        Operation::ShiftRight(rng.u32(..12)),
        Operation::Resize(width),
        Operation::Reinterpret(Type::Float(format)),
    ]
}

/// Operands of which at least the last two have one type, which is what most operations want.
fn operands(rng: &mut Rng, graph: &Graph, operation: &Operation) -> Vec<ValueId> {
    let ids: Vec<ValueId> = graph.ids().collect();
    let any = |rng: &mut Rng| ids[rng.usize(..ids.len())];
    let like = |rng: &mut Rng, id: ValueId| {
        let same = |other: &&ValueId| graph.nodes()[other.index()].ty == graph.nodes()[id.index()].ty;
        let candidates: Vec<&ValueId> = ids.iter().filter(same).collect();
        *candidates[rng.usize(..candidates.len())]
    };
    let first = any(rng);
    match operation {
        Operation::MultiplyAdd => vec![first, like(rng, first), like(rng, first)],
        Operation::Mux => {
            let second = any(rng);
            vec![first, second, like(rng, second)]
        }
        Operation::Cat => vec![first, any(rng)],
        Operation::Add
        | Operation::Subtract
        | Operation::Multiply
        | Operation::Divide
        | Operation::Minimum
        | Operation::Maximum
        | Operation::Less
        | Operation::LessOrEqual
        | Operation::Equal
        | Operation::And
        | Operation::Or
        | Operation::Xor => vec![first, like(rng, first)],
        _ => vec![first],
    }
}

/// A random value of a type; floats are mostly of moderate size.
pub fn sample(rng: &mut Rng, ty: Type) -> u64 {
    match ty {
        Type::Float(format) if rng.f64() > WILD_SHARE => {
            let exponent = i64::from(format.bias()) + rng.i64(-TAME_EXPONENT..=TAME_EXPONENT);
            let fraction = rng.u64(..) & ((1 << format.mantissa) - 1);
            (exponent as u64) << format.mantissa | fraction | if rng.bool() { format.sign_mask() } else { 0 }
        }
        _ => rng.u64(..) & ty.mask(),
    }
}
