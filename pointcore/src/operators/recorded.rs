//! A core's operators alone, side by side, recorded with operands that they tend to get wrong: in the core they are never given
//! most of these, and what they make of the others hardly shows at its ports.

use super::Operation;
use crate::generated::GenerateError;
use crate::recording::Recording;
use crate::stimuli::operands::FloatCases;
use fastrand::Rng;
use pointcore_contract::{Direction, Format, Port};
use rtl::{Design, Module, elaborate};
use std::iter;

/// Triples of operands in each format, beside those of numbers at the ends of its range.
const CASES: usize = 1000;
/// Cycles that are disabled, of all.
const HELD: f64 = 0.125;

/// Records the operators of a core; the module with one of each goes with the recording. There is none where the core has none.
///
/// # Errors
/// A fault of the generator.
pub fn record_operators(core: &Design) -> Result<Option<(Design, Recording)>, GenerateError> {
    let operations: Vec<_> = core.modules().iter().filter_map(Operation::of).collect();
    let mut formats: Vec<Format> = Vec::new();
    for operation in &operations {
        if !formats.contains(&operation.format) {
            formats.push(operation.format);
        }
    }
    let Some(width) = operations.iter().map(Operation::width).max() else { return Ok(None) };
    let name = format!("{}_operators", core.top().trim_end_matches("_top"));
    let design = elaborate(&side_by_side(&name, &operations, width))?;
    let cases = formats.iter().map(|&format| {
        let cases = FloatCases::new(format, 0);
        let directed = cases.directed() as usize;
        cases.skip(directed).take(CASES).chain(pairs(format))
    });
    // The first answers do not count yet, and the last operands are to be answered, too.
    let cases = cases.flatten().chain(iter::repeat_n([0; 3], longest(&operations) as usize));
    let recording = record(&design, &operations, width, cases);
    Ok(Some((design, recording)))
}

/// All pairs of zero, one, numbers at the ends of the range, and no number.
fn pairs(format: Format) -> impl Iterator<Item = [u64; 3]> {
    let smallest = 1 << format.mantissa;
    let positive = [0, smallest, format.one(), format.infinity() - 1, format.infinity(), format.quiet_nan()];
    let numbers = positive.into_iter().flat_map(move |number| [number, number | format.sign_mask()]);
    numbers.clone().flat_map(move |a| numbers.clone().map(move |b| [a, b, a]))
}

/// Operators that are given the same, each its low bits, and enabled together; what they answer counts when it is of operands in all.
fn side_by_side(name: &str, operations: &[Operation], width: u32) -> Module {
    let mut module = Module::new(name, "The floating-point operators of a core side by side.");
    let enable = module.input("enable", 1);
    let operands = ["a", "b", "c"].map(|name| module.input(name, width));
    let full = longest(operations);
    let taken = module.reg_reset("taken", full.ilog2() + 1, 0);
    let valid = module.wire("valid", taken.eq_lit(full.into()));
    module.next(taken, (enable & !valid).mux(taken.add_lit(1), taken));
    let results = operations.iter().enumerate().map(|(place, operation)| {
        // A core may have several that differ in their pipelines only.
        let name = format!("{}_{place}", operation.name);
        let result = operation.place(&mut module, &name, enable, &operands);
        (name, result)
    });
    let results: Vec<_> = results.collect();
    module.pulse_out("results", "valid", valid, results);
    module
}

/// Enabled cycles until every operator answers.
fn longest(operations: &[Operation]) -> u32 {
    operations.iter().map(|operation| operation.operator.latency).max().unwrap_or(0)
}

fn record(
    design: &Design,
    operations: &[Operation],
    width: u32,
    mut cases: impl Iterator<Item = [u64; 3]>,
) -> Recording {
    let ports = design.ports().iter().filter(|port| port.name != "clk").map(|port| Port {
        name: port.name.clone(),
        width: port.width,
        direction: match port.direction {
            rtl::Direction::Input => Direction::Input,
            rtl::Direction::Output => Direction::Output,
        },
    });
    let mut recording = Recording::new(ports.collect());
    let mut random = Rng::with_seed(0);
    let full = longest(operations) as usize;
    let mut taken: Vec<[u64; 3]> = Vec::new();
    let mut waiting = cases.next();
    while let Some(operands) = waiting {
        let enabled = random.f64() >= HELD;
        let [a, b, c] = operands;
        let is_valid = taken.len() >= full;
        let answer = |operation: &Operation| {
            let of = taken.len().checked_sub(operation.operator.latency as usize).filter(|_| is_valid);
            of.map_or(0, |of| operation.result(taken[of], width))
        };
        let outputs: Vec<_> = iter::once(is_valid.into()).chain(operations.iter().map(answer)).collect();
        recording.push(&[0, enabled.into(), a, b, c], &outputs);
        if enabled {
            taken.push(operands);
            waiting = cases.next();
        }
    }
    recording
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration;
    use std::collections::BTreeSet;
    use std::path::Path;

    fn core(text: &str) -> Design {
        let configuration = configuration::parse(Path::new("core.toml"), text);
        let module = configuration.unwrap_or_else(|error| panic!("{error}")).module();
        elaborate(&module.unwrap_or_else(|error| panic!("{error}"))).unwrap_or_else(|error| panic!("{error}"))
    }

    /// The floating-point modules of a design, with their text.
    fn operators(design: &Design) -> BTreeSet<&(String, String)> {
        design.files().iter().filter(|(module, _)| module.starts_with("float_")).collect()
    }

    #[test]
    fn every_operator_of_a_core_is_there_as_it_is_in_the_core() {
        // The renderer has a table, whose values are the core's.
        let narrow = "kind = \"splat\"\nfeatures.geometry = \"bf16\"\n";
        for (kind, tables) in
            [("kind = \"splat\"\n", 1), (narrow, 1), ("kind = \"search\"\n", 0), ("kind = \"points\"\n", 0)]
        {
            let core = core(kind);
            let recorded = record_operators(&core).unwrap_or_else(|error| panic!("{error}"));
            let (design, recording) = recorded.expect("it has operators");
            let (of_core, alone) = (operators(&core), operators(&design));
            assert!(alone.is_subset(&of_core), "{kind}: {alone:?}");
            assert_eq!(alone.len() + tables, of_core.len(), "{kind}: {alone:?}");
            assert!(recording.cycles() > CASES, "{kind}");
        }
    }
}
