//! What carries out programs.

use super::ProcessError;
use super::neighborhoods::Neighborhoods;
use super::timing::Timing;
use crate::search::PointSet;
use pointcore_contract::Format;
use pointcore_contract::process::Program;
use pointcore_golden::process::{Interpreter, Neighborhood};
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// A program with all that it reads, as words.
pub struct Job<'a> {
    /// The program.
    pub program: &'a Arc<Program>,
    /// The format of its floats.
    pub format: Format,
    /// A word for each of the settings'.
    pub settings: &'a [u32],
    /// Iterations of a query at most.
    pub iterations: u32,
    /// The words of each query.
    pub queries: &'a [Vec<u32>],
    /// The words of each point as a neighbor.
    pub points: &'a [Vec<u32>],
    /// The points' positions.
    pub set: &'a PointSet,
    /// The neighbors of a position, by their indices.
    pub neighborhoods: &'a Neighborhoods,
}

/// What came of a job.
#[derive(Clone, Debug)]
pub struct Carried {
    /// The answers in the order of the queries.
    pub answers: Vec<Answer>,
    /// What it took, if time was counted.
    pub timing: Option<Timing>,
}

/// A query that left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Words of the outputs.
    pub outputs: Vec<u32>,
    /// Iterations that it took.
    pub iterations: u32,
    /// It was not done, but had no iteration left.
    pub capped: bool,
    /// Neighbors of its last iteration, where they were counted.
    pub neighbors: Option<u32>,
}

/// What carries out programs: a model, or a core in lockstep with one.
pub trait Engine {
    /// What reports call it.
    fn name(&self) -> &'static str;

    /// Carries a job out; `progress` hears how many queries have left.
    ///
    /// # Errors
    /// Hardware and model differ, or cannot be run.
    fn run(&self, job: &Job<'_>, progress: &(dyn Fn(u64) + Sync)) -> Result<Carried, ProcessError>;
}

/// The golden interpreter, which is bit-exact and knows no time.
pub struct Interpreted;

impl Engine for Interpreted {
    fn name(&self) -> &'static str {
        "golden interpreter"
    }

    fn run(&self, job: &Job<'_>, progress: &(dyn Fn(u64) + Sync)) -> Result<Carried, ProcessError> {
        let interpreter = Interpreter::new((**job.program).clone(), job.format, job.settings.to_vec(), job.iterations);
        let done = AtomicU64::new(0);
        let answer = |words: &Vec<u32>| {
            let mut found = 0;
            let outcome = interpreter.run(words, |position| {
                let near = job.neighborhoods.of(position);
                found = near.len() as u32;
                let farthest = near.len().saturating_sub(1);
                let neighbors = near.iter().map(|&index| job.points[index as usize].clone()).collect();
                Neighborhood { neighbors, farthest }
            });
            progress(done.fetch_add(1, Ordering::Relaxed) + 1);
            Answer {
                outputs: outcome.outputs,
                iterations: outcome.iterations,
                capped: outcome.capped,
                neighbors: Some(found),
            }
        };
        Ok(Carried { answers: job.queries.par_iter().map(answer).collect(), timing: None })
    }
}
