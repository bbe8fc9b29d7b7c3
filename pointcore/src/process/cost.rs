//! What hardware a program takes, from its compiled blocks.

use crate::area::proxy::Proxy;
use crate::generated::GenerateError;
use pointcore_contract::Format;
use pointcore_contract::process::{Program, Section};
use pointcore_hdl::compiler::{Manifest, Options};
use pointcore_hdl::process::program::datapath;
use rtl::elaborate;
use serde::Serialize;

/// Operators by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Operators {
    /// Sums and differences, those that accumulate among them.
    pub add: u32,
    /// Products.
    pub mul: u32,
    /// Quotients and reciprocals.
    pub div: u32,
    /// Roots and their reciprocals.
    pub sqrt: u32,
    /// All others: comparisons, conversions.
    pub other: u32,
}

/// Thesis table 6.2, by the library's program of the same task.
pub const THESIS: [(&str, Operators); 2] = [
    ("covariance", Operators { add: 38, mul: 49, div: 2, sqrt: 2, other: 0 }),
    ("mls", Operators { add: 29, mul: 32, div: 3, sqrt: 2, other: 0 }),
];

/// A block as a pipeline.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct BlockCost {
    /// Its name.
    pub block: &'static str,
    /// Cycles from its operands to its results.
    pub latency: u32,
    /// Cycles from one token to the next.
    pub interval: u32,
    /// Its operators.
    pub operators: Operators,
    /// Bits of registers and memories, and what look-up tables are spent on.
    #[serde(skip)]
    pub proxy: Proxy,
    /// Bits of its registers.
    pub register_bits: u64,
}

/// What a program takes: its blocks, and the adders of its sums among the operators of all.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// The program.
    pub program: String,
    /// Cycles a neighbor.
    pub rate: u32,
    /// Operators of all blocks and of the sums.
    pub operators: Operators,
    /// Its blocks.
    pub blocks: Vec<BlockCost>,
}

impl Cost {
    /// That of a program at a neighbor in `rate` cycles.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn of(program: &Program, format: Format, rate: u32) -> Result<Self, GenerateError> {
        let mut operators = Operators { add: (program.sums.len() as u32).div_ceil(rate), ..Operators::default() };
        let mut blocks = vec![];
        for section in Section::ALL.into_iter().filter(|&section| !program.results(section).is_empty()) {
            let datapath = datapath(program, section, format, rate, &Options::default())?;
            let proxy = Proxy::of(&elaborate(&datapath.module)?);
            let Manifest { latency, initiation_interval, operators: used, .. } = datapath.manifest;
            let mut own = Operators::default();
            for (class, used) in used {
                own.add(&class, used.instances);
                operators.add(&class, used.instances);
            }
            let register_bits = proxy.register_bits;
            let block = section.name();
            blocks.push(BlockCost {
                block,
                latency,
                interval: initiation_interval,
                operators: own,
                proxy,
                register_bits,
            });
        }
        Ok(Self { program: program.name().to_owned(), rate, operators, blocks })
    }

    /// Those of the thesis for the same task, if it says so.
    #[must_use]
    pub fn thesis(&self) -> Option<Operators> {
        THESIS.iter().find(|(name, _)| *name == self.program).map(|(_, operators)| *operators)
    }
}

impl Operators {
    /// Counts operators of a class, such as `add.f32`.
    fn add(&mut self, class: &str, instances: u32) {
        let kind = class.split_once('.').map_or(class, |(kind, _)| kind);
        *match kind {
            "add" => &mut self.add,
            "mul" => &mut self.mul,
            "div" | "recip" => &mut self.div,
            "sqrt" | "rsqrt" => &mut self.sqrt,
            _ => &mut self.other,
        } += instances;
    }
}
