//! The operators that are compared, each with its golden twin.

use pointcore_contract::{Fixed, Format, Signedness, TableShape};
use pointcore_golden::float as golden;
use pointcore_hdl::float::{self as hdl, Operator};
use rtl::{Expr, cat};

/// Pipeline registers of the operators under test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stages {
    /// Each operator's default.
    Default,
    /// This many, as far as an operator allows.
    Fixed(u32),
}

/// Fixed-point formats to convert from and to: plain, with all bits below the point, and with bits only far below it, where
/// subnormal numbers of small formats count.
const FIXED: [Fixed; 4] = [
    Fixed { width: 32, fraction: 0, signed: Signedness::Signed },
    Fixed { width: 20, fraction: 8, signed: Signedness::Signed },
    Fixed { width: 9, fraction: 9, signed: Signedness::Unsigned },
    Fixed { width: 12, fraction: 34, signed: Signedness::Unsigned },
];

/// Shape of the interpolated tables under test.
const TABLE: TableShape = TableShape { index_bits: 6, fraction_bits: 10, value_bits: 12 };
/// Decay of the Gaussian under test.
const GAMMA: f64 = 4.0;

/// What an operator takes from the triple of operands.
enum Operands {
    /// The first of them, by number.
    Floats(usize),
    /// The low bits of `b·a`, as many as that.
    Bits(u32),
}

/// An operator under test.
pub(super) struct Operation {
    pub name: String,
    pub operator: Operator,
    pub golden: Box<dyn Fn([u64; 3]) -> u64>,
    operands: Operands,
}

impl Operation {
    /// What the operator's ports are connected to.
    pub fn connections(&self, operands: &[Expr; 3]) -> Vec<(&'static str, Expr)> {
        match self.operands {
            Operands::Floats(count) => ["a", "b", "c"].into_iter().zip(operands.iter().cloned()).take(count).collect(),
            Operands::Bits(width) => vec![("a", cat([operands[1], operands[0]]).trunc(width))],
        }
    }
}

/// Collects operations of one format.
struct Collector {
    format: Format,
    stages: Stages,
    operations: Vec<Operation>,
}

impl Collector {
    fn stages(&self, default: u32) -> u32 {
        match self.stages {
            Stages::Default => default,
            Stages::Fixed(stages) => stages,
        }
    }

    fn push(
        &mut self,
        name: String,
        operator: Operator,
        operands: Operands,
        golden: impl Fn([u64; 3]) -> u64 + 'static,
    ) {
        self.operations.push(Operation { name, operator, golden: Box::new(golden), operands });
    }

    /// An operator on numbers of one format.
    fn floats(
        &mut self,
        name: &str,
        stages: fn(Format) -> u32,
        module: fn(Format, u32) -> Operator,
        count: usize,
        golden: fn(Format, [u64; 3]) -> u64,
    ) {
        let format = self.format;
        let operator = module(format, self.stages(stages(format)));
        self.push(name.into(), operator, Operands::Floats(count), move |operands| golden(format, operands));
    }

    fn conversions(&mut self) {
        let format = self.format;
        for (name, other) in Format::NAMED {
            for (name, to) in [(name.to_owned(), other), (format!("{name}_ftz"), other.flushed())] {
                let operator = hdl::convert::module(format, to, self.stages(hdl::convert::stages(format, to)));
                let golden = move |[a, ..]: [u64; 3]| golden::convert(format, to, a);
                self.push(format!("convert_{name}"), operator, Operands::Floats(1), golden);
            }
        }
        for (index, fixed) in FIXED.into_iter().enumerate() {
            let operator = hdl::to_fixed::module(format, fixed, self.stages(hdl::to_fixed::stages(format, fixed)));
            let golden = move |[a, ..]: [u64; 3]| golden::to_fixed(format, a, fixed);
            self.push(format!("to_fixed_{index}"), operator, Operands::Floats(1), golden);
            let operator = hdl::from_fixed::module(format, fixed, self.stages(hdl::from_fixed::stages(format, fixed)));
            let golden = move |operands| golden::from_fixed(format, low_bits(format, operands, fixed.width), fixed);
            self.push(format!("from_fixed_{index}"), operator, Operands::Bits(fixed.width), golden);
        }
    }

    fn tables(&mut self) {
        let format = self.format;
        let width = TABLE.index_bits + TABLE.fraction_bits;
        let tables = [
            ("exp_neg", hdl::exp_neg::samples(GAMMA, TABLE), golden::kernel_table(GAMMA, TABLE)),
            ("erf", hdl::erf::samples(TABLE), golden::erf_table(TABLE)),
            ("integral", hdl::erf::integral_samples(GAMMA, TABLE), golden::kernel_integral_table(GAMMA, TABLE)),
        ];
        for (name, samples, table) in tables {
            let operator = hdl::table::module(TABLE, &samples, self.stages(hdl::table::stages(TABLE)));
            let golden = move |operands| table.interpolate(low_bits(format, operands, width));
            self.push(name.into(), operator, Operands::Bits(width), golden);
        }
    }
}

/// The low `width` bits of `b·a`.
fn low_bits(format: Format, [a, b, _]: [u64; 3], width: u32) -> u64 {
    (b << format.width() | a) & (u64::MAX >> (u64::BITS - width))
}

/// Every operator of a format.
pub(super) fn operations(format: Format, stages: Stages) -> Vec<Operation> {
    use hdl::{add, compare, div, fma, minmax, mul, recip_newton, rsqrt, rsqrt_newton, sqrt};
    let mut all = Collector { format, stages, operations: vec![] };
    all.floats("add", add::stages, add::module, 2, |f, [a, b, _]| golden::add(f, a, b));
    all.floats("mul", mul::stages, mul::module, 2, |f, [a, b, _]| golden::mul(f, a, b));
    all.floats("fma", fma::stages, fma::module, 3, |f, [a, b, c]| golden::fma(f, a, b, c));
    all.floats("div", div::stages, div::module, 2, |f, [a, b, _]| golden::div(f, a, b));
    all.floats("recip", div::stages, div::recip, 1, |f, [a, ..]| golden::recip(f, a));
    all.floats("sqrt", sqrt::stages, sqrt::module, 1, |f, [a, ..]| golden::sqrt(f, a));
    all.floats("rsqrt", rsqrt::stages, rsqrt::module, 1, |f, [a, ..]| golden::rsqrt(f, a));
    all.floats("recip_newton", recip_newton::stages, recip_newton::module, 1, |f, [a, ..]| golden::recip_newton(f, a));
    all.floats("rsqrt_newton", rsqrt_newton::stages, rsqrt_newton::module, 1, |f, [a, ..]| golden::rsqrt_newton(f, a));
    all.floats("min", minmax::stages, minmax::min, 2, |f, [a, b, _]| golden::min(f, a, b));
    all.floats("max", minmax::stages, minmax::max, 2, |f, [a, b, _]| golden::max(f, a, b));
    all.floats("lt", compare::stages, compare::lt, 2, |f, [a, b, _]| golden::lt(f, a, b).into());
    all.floats("le", compare::stages, compare::le, 2, |f, [a, b, _]| golden::le(f, a, b).into());
    all.floats("eq", compare::stages, compare::eq, 2, |f, [a, b, _]| golden::eq(f, a, b).into());
    all.conversions();
    all.tables();
    all.operations
}
