//! Outputs beside the formulas in f64, within bounds that are derived (`pointcore_golden::reference::operators`).
//!
//! Of each query its last iteration is compared, from the position where it began: bounds hold for one iteration. Where
//! it began the golden interpreter says, given one iteration fewer.

mod formulas;
mod validity;

use super::stage::Stage;
use super::words::decode_word;
use formulas::Formula;
use glam::DVec3;
use pointcore_contract::process::Scalar;
use pointcore_golden::process::{Interpreter, Neighborhood};
use pointcore_golden::reference::operators::Point;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;

/// An output beside that of f64.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The program and its output.
    pub output: String,
    /// Queries compared.
    pub compared: usize,
    /// Queries of which no bound is known: their neighborhoods are too degenerate, or rounding decides.
    pub unbounded: usize,
    /// Queries in which it is off by more than its bound.
    pub violations: usize,
    /// The largest error.
    pub error: f64,
    /// The bound of that query.
    pub bound: f64,
    /// The largest share of its bound that an error has.
    pub share: f64,
    /// The query with that share.
    pub query: usize,
}

/// Outputs that are not those of f64, or of which nothing is known.
#[derive(Clone, Debug, PartialEq)]
pub enum Uncompared {
    /// There are no formulas of a program.
    Unknown(String),
    /// No query could be compared.
    Nothing(String),
    /// An output is off by more than its bound.
    Violation(Comparison),
}

impl fmt::Display for Uncompared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(program) => {
                write!(
                    f,
                    "--check: there are no formulas in f64 of `{program}`, but of {}",
                    Formula::names().join(", ")
                )
            }
            Self::Nothing(program) => write!(f, "--check: no query of `{program}` is valid, so nothing was compared"),
            Self::Violation(Comparison { output, violations, compared, query, .. }) => write!(
                f,
                "{output}: {violations} of {compared} queries are off by more than the bound, query {query} the most: see the report"
            ),
        }
    }
}

/// What a query's output is off by, and may be.
struct Off {
    output: &'static str,
    error: f64,
    bound: f64,
}

/// An iteration as formulas take it.
struct Iteration<'a> {
    /// The query where it began.
    query: Point,
    /// Where the query's way began.
    start: DVec3,
    /// Iterations before it.
    count: u32,
    cloud: Vec<Point>,
    settings: &'a [f64],
    /// The unit of rounding.
    u: f64,
}

/// What left, by name.
struct Left<'a> {
    stage: &'a Stage,
    words: &'a [u32],
}

impl Left<'_> {
    fn words(&self, name: &str) -> impl Iterator<Item = f64> {
        let place = self.stage.program.outputs.find(name).expect("the library's programs have their outputs");
        let words = &self.words[place.first..place.first + place.ty.words()];
        words.iter().map(move |&word| decode_word(self.stage.format, place.ty.scalar(), word))
    }

    fn number(&self, name: &str) -> f64 {
        self.words(name).next().expect("a field has a word")
    }

    fn vector(&self, name: &str) -> DVec3 {
        DVec3::from_slice(&self.words(name).collect::<Vec<_>>())
    }
}

/// Whether there are formulas of all programs of an operation.
///
/// # Errors
/// The first without.
pub fn known<'a>(programs: impl IntoIterator<Item = &'a str>) -> Result<(), Uncompared> {
    let unknown = programs.into_iter().find(|name| Formula::of(name).is_none());
    unknown.map_or(Ok(()), |name| Err(Uncompared::Unknown(name.to_owned())))
}

/// Compares what left of all stages.
///
/// # Errors
/// There is nothing to compare.
pub fn compare(stages: &[Stage]) -> Result<Vec<Comparison>, Uncompared> {
    let mut all = vec![];
    for stage in stages {
        let found = compare_stage(stage)?;
        if found.iter().all(|comparison| comparison.compared == 0) {
            return Err(Uncompared::Nothing(stage.program.name().to_owned()));
        }
        all.extend(found);
    }
    Ok(all)
}

/// The first output that is off by more than its bound.
///
/// # Errors
/// It.
pub fn within_bounds(compared: &[Comparison]) -> Result<(), Uncompared> {
    let violation = compared.iter().find(|comparison| comparison.violations > 0);
    violation.map_or(Ok(()), |comparison| Err(Uncompared::Violation(comparison.clone())))
}

fn compare_stage(stage: &Stage) -> Result<Vec<Comparison>, Uncompared> {
    let name = stage.program.name();
    let formula = Formula::of(name).ok_or_else(|| Uncompared::Unknown(name.to_owned()))?;
    let settings: Vec<f64> =
        stage.settings.iter().map(|&word| decode_word(stage.format, Scalar::Float, word)).collect();
    let points: Vec<Point> = stage.points.iter().map(|words| point(stage, words)).collect();
    let interpreter =
        |iterations| Interpreter::new((*stage.program).clone(), stage.format, stage.settings.clone(), iterations);
    let needed = stage.answers.iter().map(|answer| answer.iterations - 1).filter(|count| *count > 0);
    let interpreters: BTreeMap<u32, Interpreter> = needed.map(|count| (count, interpreter(count))).collect();
    let off = |(index, words): (usize, &Vec<u32>)| {
        let answer = &stage.answers[index];
        let count = answer.iterations - 1;
        let start = point(stage, words);
        let begun = interpreters.get(&count).map_or([words[0], words[1], words[2]], |interpreter| {
            let neighbors = |position| {
                let near = stage.neighborhoods.of(position);
                let neighbors: Vec<_> = near.iter().map(|&index| stage.points[index as usize].clone()).collect();
                Neighborhood { farthest: neighbors.len().saturating_sub(1), neighbors }
            };
            let outputs = interpreter.run(words, neighbors).outputs;
            let first = stage.program.outputs.find("position").map_or(0, |place| place.first);
            [0, 1, 2].map(|axis| outputs[first + axis])
        });
        let cloud = stage.neighborhoods.of(begun).iter().map(|&index| points[index as usize].clone()).collect();
        let query = Point { position: point(stage, &begun).position, attributes: start.attributes };
        let u = pointcore_golden::reference::operators::unit(stage.format);
        let iteration = Iteration { query, start: start.position, count, cloud, settings: &settings, u };
        formula.off(&iteration, &Left { stage, words: &answer.outputs })
    };
    let offs: Vec<Vec<Off>> = stage.queries.par_iter().enumerate().map(off).collect();
    Ok(formula.outputs().iter().map(|output| worst(name, output, &offs)).collect())
}

/// The worst query of an output.
fn worst(program: &str, output: &str, offs: &[Vec<Off>]) -> Comparison {
    let output_name = format!("{program}.{output}");
    let mut worst = Comparison {
        output: output_name,
        compared: 0,
        unbounded: 0,
        violations: 0,
        error: 0.0,
        bound: 0.0,
        share: 0.0,
        query: 0,
    };
    for (query, off) in offs.iter().enumerate().flat_map(|(query, offs)| offs.iter().map(move |off| (query, off))) {
        if off.output != output {
            continue;
        }
        if !off.bound.is_finite() {
            worst.unbounded += 1;
            continue;
        }
        worst.compared += 1;
        let is_within = off.error <= off.bound;
        worst.violations += usize::from(!is_within);
        if off.error > worst.error || off.error.is_nan() {
            (worst.error, worst.bound) = (off.error, off.bound);
        }
        let share = if off.error == 0.0 { 0.0 } else { off.error / off.bound };
        if share > worst.share || (!is_within && share.is_nan()) {
            (worst.share, worst.query) = (share, query);
        }
    }
    worst
}

/// A query or a neighbor of its words.
fn point(stage: &Stage, words: &[u32]) -> Point {
    let numbers: Vec<f64> = words.iter().map(|&word| decode_word(stage.format, Scalar::Float, word)).collect();
    Point { position: DVec3::from_slice(&numbers), attributes: numbers[3..].to_vec() }
}
