//! The arithmetic compiler: random programs at every initiation interval, and what sharing and delays must achieve.

pub mod generator;
mod interpreter;
pub mod model;
mod programs;

use fastrand::Rng;
use generator::{program, table};
use model::{build, compile_all, run};
use pointcore_tb::lockstep::{SEED_VARIABLE, Stall, seeds};
use std::collections::BTreeSet;

/// Initiation intervals of the random programs.
const INTERVALS: [u32; 5] = [1, 2, 3, 4, 8];
/// Random programs at each of them.
const PROGRAMS_PER_INTERVAL: usize = 2;
/// Operations of a random program.
const OPERATIONS: usize = 24;
/// Kinds of operations, ports and constants included.
const KINDS: usize = 35;
/// Tokens sent through each under each stall pattern.
const TOKENS: usize = 300;

#[test]
fn random_programs_agree_with_the_interpreter_in_every_cycle() {
    for seed in seeds(1).expect("the seed is a number") {
        println!("{SEED_VARIABLE}={seed} cargo test -p pointcore-tb --test units compiler::random_programs");
        let mut rng = Rng::with_seed(seed);
        let intervals = INTERVALS.iter().flat_map(|&interval| [interval; PROGRAMS_PER_INTERVAL]);
        let programs = intervals.enumerate().map(|(index, interval)| {
            (program(&mut rng, &format!("program_{index}_interval_{interval}"), OPERATIONS), interval)
        });
        let programs = programs.collect();
        let (design, compiled) = compile_all(programs, &mut rng);
        let nodes = compiled.iter().flat_map(|program| program.graph.nodes());
        let kinds: BTreeSet<&str> = nodes.map(|node| node.operation.mnemonic()).collect();
        assert_eq!(kinds.len(), KINDS, "the programs have {kinds:?}");
        assert_eq!(design.combinational_paths(), [], "streams are registered on both sides");
        let library = build(&design);
        let (golden_table, _) = table();
        for stall in [Stall::Never, Stall::Random(0.3), Stall::Bursts(30)] {
            let report = run(&library, &compiled, std::slice::from_ref(&golden_table), TOKENS, seed, stall);
            for (index, program) in compiled.iter().enumerate() {
                assert_eq!(report.transfers(&format!("in_{index}")), TOKENS as u64);
                let kept = report.transfers(&format!("out_{index}"));
                assert!(program.graph.keep().is_some() || kept == TOKENS as u64, "program {index} dropped tokens");
            }
        }
    }
}
