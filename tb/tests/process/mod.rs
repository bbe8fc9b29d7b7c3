//! Programs of the processing module: every block of the library and of random programs against the golden model, and
//! what operators they take.

mod block;
pub mod cloud;
mod cost;
mod generator;
mod library;
pub mod scene;
pub mod stage;

use crate::compiler::model::{build, compile_all, run};
use block::{Counts, Golden, moderate, settings};
use fastrand::Rng;
use pointcore_contract::Format;
use pointcore_contract::process::{Program, Section};
use pointcore_hdl::process::program::{graph, interval};
use pointcore_tb::lockstep::Stall;

/// Tokens sent through each block under each stall pattern.
const TOKENS: usize = 300;

/// A program in a format at a rate.
struct Case {
    program: Program,
    format: Format,
    rate: u32,
}

/// Runs all blocks of programs side by side, hardware and golden model in lockstep; returns how often the flags of each
/// were low and high.
fn agree(cases: Vec<Case>, seed: u64) -> Vec<(String, Counts)> {
    let mut rng = Rng::with_seed(seed);
    let (mut graphs, mut goldens) = (vec![], vec![]);
    for Case { program, format, rate } in cases {
        let settings = settings(&program, format, &mut rng, moderate);
        for section in Section::ALL.into_iter().filter(|&section| !program.results(section).is_empty()) {
            let graph = graph(&program, section, format).unwrap_or_else(|error| panic!("{error}"));
            graphs.push((graph, interval(section, rate)));
            goldens.push(Golden::new(program.clone(), section, format, settings.clone()));
        }
    }
    let (design, mut compiled) = compile_all(graphs, &mut rng);
    assert_eq!(design.combinational_paths(), [], "streams are registered on both sides");
    let mut counts = vec![];
    for (block, golden) in compiled.iter_mut().zip(goldens) {
        block.uniforms = golden.uniforms();
        counts.push(golden.counts());
        block.golden = Some(Box::new(golden));
    }
    let library = build(&design);
    for stall in [Stall::Never, Stall::Random(0.3), Stall::Bursts(30)] {
        let report = run(&library, &compiled, &[], TOKENS, seed, stall);
        for (index, block) in compiled.iter().enumerate() {
            let unit = block.graph.unit();
            assert_eq!(report.transfers(&format!("in_{index}")), TOKENS as u64, "{unit}");
            assert_eq!(report.transfers(&format!("out_{index}")), TOKENS as u64, "{unit}");
        }
    }
    compiled.iter().map(|block| block.graph.unit().to_owned()).zip(counts).collect()
}
