//! Hardware floating-point operators against the golden ones, all operators of a format in one model.

mod operations;

use crate::LabError;
pub use operations::Stages;

use operations::operations;
use pointcore::operators::Operation;
use pointcore::stimuli::operands::FloatCases;
use pointcore_contract::Format;
use pointcore_tb::verilated::{BuildOptions, Builder, Optimization, VerilatedModel, VerilogSource};
use rtl::{Module, elaborate};
use std::fmt;

/// What became of one operator.
#[derive(Clone, Debug)]
pub struct OperatorReport {
    /// The operator, and its other format where it has one.
    pub operation: String,
    /// Results compared.
    pub cases: u64,
    /// Results that differed.
    pub mismatches: u64,
    /// The first of them.
    pub first: Option<Mismatch>,
}

/// A result that differed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// The operands `a`, `b`, `c`, used or not.
    pub operands: [u64; 3],
    /// What the hardware said.
    pub hardware: u64,
    /// What it should have said.
    pub golden: u64,
}

impl fmt::Display for OperatorReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} of {} cases differ", self.operation, self.mismatches, self.cases)?;
        if let Some(Mismatch { operands: [a, b, c], hardware, golden }) = self.first {
            write!(f, ", first a={a:#x} b={b:#x} c={c:#x}: hardware {hardware:#x}, golden {golden:#x}")?;
        }
        Ok(())
    }
}

/// Whether the operators are held up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enable {
    /// Never: a case every cycle.
    Always,
    /// At random, half of the cycles, with other operands waiting.
    Random,
}

/// Runs `cases` operand triples through every operator of `format`.
///
/// # Errors
/// When the hardware cannot be described, built or run; differences are no errors but in the reports.
pub fn check_format(
    format: Format,
    stages: Stages,
    enable: Enable,
    cases: u64,
    seed: u64,
) -> Result<Vec<OperatorReport>, LabError> {
    let operations = operations(format, stages);
    let design = elaborate(&top(format, &operations))?;
    let source = VerilogSource::from(&design);
    let options = BuildOptions { optimization: Optimization::Quick, ..BuildOptions::default() };
    let mut model = Builder::new()?.build(&source, options)?.instantiate(seed);
    compare(&mut model, &operations, FloatCases::new(format, seed), enable, cases)
}

/// All operators side by side.
fn top(format: Format, operations: &[Operation]) -> Module {
    let mut module = Module::new("float_check", "Every floating-point operator of one format.");
    module.parameter("format", format);
    let width = format.width();
    let enable = module.input("enable", 1);
    let operands = ["a", "b", "c"].map(|name| module.input(name, width));
    for operation in operations {
        let result = operation.place(&mut module, &operation.name, enable, &operands);
        module.output(&format!("y_{}", operation.name), result);
    }
    module
}

fn compare(
    model: &mut VerilatedModel,
    operations: &[Operation],
    mut source: FloatCases,
    enable: Enable,
    cases: u64,
) -> Result<Vec<OperatorReport>, LabError> {
    let mut reports: Vec<OperatorReport> = operations
        .iter()
        .map(|operation| OperatorReport { operation: operation.name.clone(), cases: 0, mismatches: 0, first: None })
        .collect();
    let longest = operations.iter().map(|operation| operation.operator.latency).max().unwrap_or(0);
    let mut stall = fastrand::Rng::with_seed(0);
    // The triples that entered last, at their number modulo the length.
    let mut entered = vec![[0; 3]; longest as usize + 1];
    let slots = entered.len() as u64;
    let (mut outputs, mut accepted) = (vec![0; operations.len()], 0);
    let mut waiting = [0; 3];
    while accepted < cases + u64::from(longest) {
        let enabled = enable == Enable::Always || stall.bool();
        waiting = if enabled || stall.bool() { source.next().unwrap_or(waiting) } else { waiting };
        let [a, b, c] = waiting;
        model.step(&[0, u64::from(enabled), a, b, c], &mut outputs)?;
        for ((operation, report), &hardware) in operations.iter().zip(&mut reports).zip(&outputs) {
            let Some(number) = accepted.checked_sub(u64::from(operation.operator.latency)) else { continue };
            if number >= cases {
                continue;
            }
            let operands = entered[(number % slots) as usize];
            let golden = operation.result(operands, operation.format.width());
            report.cases += 1;
            if hardware != golden {
                report.mismatches += 1;
                report.first.get_or_insert(Mismatch { operands, hardware, golden });
            }
        }
        if enabled {
            entered[(accepted % slots) as usize] = waiting;
            accepted += 1;
        }
    }
    Ok(reports)
}
