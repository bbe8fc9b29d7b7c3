//! Floating-point operators, each with its golden twin.

mod recorded;

pub use recorded::record_operators;

use pointcore_contract::{Fixed, Format, Signedness};
use pointcore_golden::float as golden;
use pointcore_hdl::float::{self as hdl, Operator};
use rtl::{Expr, Module, ModuleSummary, cat};
use std::str::FromStr;

/// What the names of their modules begin with.
const PREFIX: &str = "float_";

/// An operator on numbers of one format.
#[derive(Clone, Copy, Debug)]
pub struct OnFloats {
    /// Its name.
    pub name: &'static str,
    /// The pipeline registers that it has if no others are asked for.
    pub stages: fn(Format) -> u32,
    module: fn(Format, u32) -> Operator,
    operands: usize,
    golden: fn(Format, [u64; 3]) -> u64,
}

/// All of them.
pub const ON_FLOATS: [OnFloats; 14] = {
    use hdl::{add, compare, div, fma, minmax, mul, recip_newton, rsqrt, rsqrt_newton, sqrt};
    const fn of(
        name: &'static str,
        stages: fn(Format) -> u32,
        module: fn(Format, u32) -> Operator,
        operands: usize,
        golden: fn(Format, [u64; 3]) -> u64,
    ) -> OnFloats {
        OnFloats { name, stages, module, operands, golden }
    }
    [
        of("add", add::stages, add::module, 2, |f, [a, b, _]| golden::add(f, a, b)),
        of("mul", mul::stages, mul::module, 2, |f, [a, b, _]| golden::mul(f, a, b)),
        of("fma", fma::stages, fma::module, 3, |f, [a, b, c]| golden::fma(f, a, b, c)),
        of("div", div::stages, div::module, 2, |f, [a, b, _]| golden::div(f, a, b)),
        of("recip", div::stages, div::recip, 1, |f, [a, ..]| golden::recip(f, a)),
        of("sqrt", sqrt::stages, sqrt::module, 1, |f, [a, ..]| golden::sqrt(f, a)),
        of("rsqrt", rsqrt::stages, rsqrt::module, 1, |f, [a, ..]| golden::rsqrt(f, a)),
        of("recip_newton", recip_newton::stages, recip_newton::module, 1, |f, [a, ..]| golden::recip_newton(f, a)),
        of("rsqrt_newton", rsqrt_newton::stages, rsqrt_newton::module, 1, |f, [a, ..]| golden::rsqrt_newton(f, a)),
        of("min", minmax::stages, minmax::min, 2, |f, [a, b, _]| golden::min(f, a, b)),
        of("max", minmax::stages, minmax::max, 2, |f, [a, b, _]| golden::max(f, a, b)),
        of("lt", compare::stages, compare::lt, 2, |f, [a, b, _]| golden::lt(f, a, b) as u64),
        of("le", compare::stages, compare::le, 2, |f, [a, b, _]| golden::le(f, a, b) as u64),
        of("eq", compare::stages, compare::eq, 2, |f, [a, b, _]| golden::eq(f, a, b) as u64),
    ]
};

/// What an operator takes from a triple of operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Operands {
    /// The low bits of the first ones, by number.
    Floats(usize),
    /// The low bits of `c·b·a`, as many as that.
    Bits(u32),
}

/// An operator in hardware, and what it computes.
pub struct Operation {
    /// Which one it is.
    pub name: String,
    /// The format of its operands, or of its result where these are integers.
    pub format: Format,
    /// The hardware.
    pub operator: Operator,
    golden: Box<dyn Fn([u64; 3]) -> u64>,
    operands: Operands,
}

impl Operation {
    /// One on numbers of a format, with so many pipeline registers.
    #[must_use]
    pub fn on_floats(format: Format, of: &OnFloats, stages: u32) -> Self {
        let golden = of.golden;
        Self {
            name: of.name.to_owned(),
            format,
            operator: (of.module)(format, stages),
            golden: Box::new(move |operands| golden(format, operands)),
            operands: Operands::Floats(of.operands),
        }
    }

    /// From one format to another.
    #[must_use]
    pub fn convert(format: Format, to: Format, stages: u32) -> Self {
        Self {
            name: format!("convert_{to}").replace('-', "_"),
            format,
            operator: hdl::convert::module(format, to, stages),
            golden: Box::new(move |[a, ..]| golden::convert(format, to, a)),
            operands: Operands::Floats(1),
        }
    }

    /// To fixed point.
    #[must_use]
    pub fn to_fixed(format: Format, fixed: Fixed, stages: u32) -> Self {
        Self {
            name: format!("to_fixed_{}", plain(fixed)),
            format,
            operator: hdl::to_fixed::module(format, fixed, stages),
            golden: Box::new(move |[a, ..]| golden::to_fixed(format, a, fixed)),
            operands: Operands::Floats(1),
        }
    }

    /// From fixed point.
    #[must_use]
    pub fn from_fixed(format: Format, fixed: Fixed, stages: u32) -> Self {
        Self {
            name: format!("from_fixed_{}", plain(fixed)),
            format,
            operator: hdl::from_fixed::module(format, fixed, stages),
            golden: Box::new(move |[a, ..]| golden::from_fixed(format, a, fixed)),
            operands: Operands::Bits(fixed.width),
        }
    }

    /// A table, which is looked up with so many bits.
    pub fn table(
        name: &str,
        format: Format,
        operator: Operator,
        bits: u32,
        golden: impl Fn(u64) -> u64 + 'static,
    ) -> Self {
        let (name, golden) = (name.to_owned(), Box::new(move |[a, ..]: [u64; 3]| golden(a)));
        Self { name, format, operator, golden, operands: Operands::Bits(bits) }
    }

    /// That of a design's module, unless it is another kind of module, or a table, whose values its parameters do not tell.
    #[must_use]
    pub fn of(module: &ModuleSummary) -> Option<Self> {
        fn value<T: FromStr>(module: &ModuleSummary, name: &str) -> Option<T> {
            module.parameters.iter().find(|(known, _)| known == name)?.1.parse().ok()
        }
        let name = module.unit.strip_prefix(PREFIX)?;
        let stages = value(module, "stages")?;
        if name == "convert" {
            return Some(Self::convert(value(module, "from")?, value(module, "to")?, stages));
        }
        let format = value(module, "format")?;
        if let Some(of) = ON_FLOATS.iter().find(|of| of.name == name) {
            return Some(Self::on_floats(format, of, stages));
        }
        let signed = match value::<String>(module, "integer")?.as_str() {
            "signed" => Signedness::Signed,
            _ => Signedness::Unsigned,
        };
        let fixed = Fixed { width: value(module, "width")?, fraction: value(module, "fraction")?, signed };
        match name {
            "to_fixed" => Some(Self::to_fixed(format, fixed, stages)),
            "from_fixed" => Some(Self::from_fixed(format, fixed, stages)),
            _ => None,
        }
    }

    /// Bits of each operand that it needs at least.
    #[must_use]
    pub fn width(&self) -> u32 {
        match self.operands {
            Operands::Floats(_) => self.format.width(),
            Operands::Bits(bits) => bits.div_ceil(3).max(self.format.width()),
        }
    }

    /// Places the operator in a module, under a name, with operands of such a width or more; returns its result.
    pub fn place(&self, module: &mut Module, name: &str, enable: Expr, operands: &[Expr; 3]) -> Expr {
        let instance = module.instance(name, self.operator.module.clone());
        module.connect(instance, "enable", enable);
        for (port, value) in self.connections(operands) {
            module.connect(instance, port, value);
        }
        module.out(instance, "y")
    }

    /// What its ports are connected to.
    fn connections(&self, operands: &[Expr; 3]) -> Vec<(&'static str, Expr)> {
        match self.operands {
            Operands::Floats(count) => {
                let low = operands.iter().map(|operand| operand.trunc(self.format.width()));
                ["a", "b", "c"].into_iter().zip(low).take(count).collect()
            }
            Operands::Bits(width) => vec![("a", cat(operands.iter().rev().copied()).trunc(width))],
        }
    }

    /// What it makes of operands, each of so many bits.
    #[must_use]
    pub fn result(&self, operands: [u64; 3], width: u32) -> u64 {
        let low = |value: u128, bits: u32| (value & ((1 << bits) - 1)) as u64;
        (self.golden)(match self.operands {
            Operands::Floats(_) => operands.map(|operand| low(operand.into(), self.format.width())),
            Operands::Bits(bits) => {
                let all = operands.iter().rev().fold(0, |all, operand| all << width | u128::from(*operand));
                [low(all, bits), 0, 0]
            }
        })
    }
}

/// A fixed-point format as part of a name.
fn plain(Fixed { width, fraction, signed }: Fixed) -> String {
    let sign = if signed == Signedness::Signed { 's' } else { 'u' };
    format!("{sign}{width}q{fraction}")
}
