//! The arithmetic compiler (thesis 6.6): from a straight-line program over typed values to a pipeline that never stalls.
//!
//! A program is written with [`Program`] and the operators of [`Value`], or built node by node as a [`Graph`].
//! [`compile`] folds constants and common subexpressions, schedules every operation for the latency of its operator and
//! the wanted initiation interval, lets operations of one kind share operators, sums together with their products, holds
//! values until they are needed, and wraps the result in `valid`/`ready` streams:
//!
//! * `in`: ports `in_valid`, `in_ready`, `in_<input>`; one port `<uniform>` each; `out`: `out_valid`, `out_ready`,
//!   `out_<output>`.
//! * The pipeline steps in every cycle. Its phase starts at 0 after reset and steps with it, modulo the initiation interval.
//!   Behind it stands a queue with a place for every token that may be under way. There are as many credits; a token takes
//!   one along and gives it back when it leaves the queue, or is dropped. `in_ready` is high in phase 0 while there is one.
//! * A token's results enter the queue exactly [`Manifest::latency`] cycles after the one that accepted it, if its keep
//!   condition holds. Nothing at `out` depends on `in`, or the reverse, within a cycle.
//! * Where results are [taken at once](Taking::AtOnce), there is neither queue nor credit.
//!
//! The golden twin of this timing is `pointcore_golden::datapath`.

mod bind;
mod combine;
mod compound;
mod cost;
mod delay;
mod emit;
mod emitter;
mod encode;
mod error;
mod evaluate;
mod graph;
mod labels;
mod lower;
mod manifest;
mod multiply;
mod operation;
mod operators;
mod optimize;
mod output;
mod phases;
mod plan;
mod program;
mod schedule;
mod table;
mod types;
mod typing;
mod value;

pub use compound::Compound;
pub use cost::BLOCK_MEMORY_LEVELS;
pub use error::CompileError;
pub use graph::{Graph, Node, ValueId};
pub use manifest::{Manifest, OperatorUse};
pub use operation::Operation;
pub use operators::OperatorStages;
pub use program::Program;
pub use table::Table;
pub use types::{Type, WIDTH_MAX};
pub use value::Value;
pub(crate) use value::name;

use rtl::Module;

/// Above it, choosing among operands costs more than the operators that sharing saves.
pub const INITIATION_INTERVAL_MAX: u32 = 64;

/// What to make of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Cycles from one token to the next; operators are shared among as many operations.
    pub initiation_interval: u32,
    /// Pipeline stages of operators.
    pub stages: OperatorStages,
    /// When results are taken.
    pub taking: Taking,
    /// Levels of logic that are as late as its inputs are in their cycle.
    pub input_levels: u32,
}

/// When what a datapath shows is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Taking {
    /// Sooner or later: results wait in a queue.
    #[default]
    Later,
    /// Always in the cycle in which it is shown: no result waits, and every token is admitted.
    AtOnce,
}

impl Default for Options {
    /// A token a cycle, operators with as many stages as they like, results that wait.
    fn default() -> Self {
        Self { initiation_interval: 1, stages: OperatorStages::default(), taking: Taking::default(), input_levels: 0 }
    }
}

impl Options {
    /// The same at another initiation interval.
    #[must_use]
    pub fn with_interval(&self, initiation_interval: u32) -> Self {
        Self { initiation_interval, ..self.clone() }
    }

    /// The same of results that are always taken at once.
    #[must_use]
    pub fn taken_at_once(&self) -> Self {
        Self { taking: Taking::AtOnce, ..self.clone() }
    }

    /// The same with `stages` in all operators of a class, as [`OperatorStages::with`], unless it is told of that class already.
    #[must_use]
    pub fn with_stages(mut self, class: &str, stages: u32) -> Self {
        if self.stages.of(class).is_none() {
            self.stages = self.stages.with(class, stages);
        }
        self
    }
}

/// A compiled program.
pub struct Datapath {
    /// The hardware.
    pub module: Module,
    /// Its timing and cost.
    pub manifest: Manifest,
}

/// Compiles a program written in Rust.
///
/// # Errors
/// The first mistake made while building the program; no output; an initiation interval out of range.
pub fn compile(program: &Program, options: &Options) -> Result<Datapath, CompileError> {
    compile_graph(&program.graph()?, options)
}

/// Compiles a program from any front end.
///
/// # Errors
/// No output; an initiation interval out of range.
pub fn compile_graph(graph: &Graph, options: &Options) -> Result<Datapath, CompileError> {
    let initiation_interval = options.initiation_interval;
    if graph.outputs().is_empty() {
        return Err(CompileError::NoOutput { unit: graph.unit().to_owned() });
    }
    if !(1..=INITIATION_INTERVAL_MAX).contains(&initiation_interval) {
        let (unit, maximum) = (graph.unit().to_owned(), INITIATION_INTERVAL_MAX);
        return Err(CompileError::InitiationInterval { unit, initiation_interval, maximum });
    }
    let graph = combine::combine(optimize::optimize(graph), initiation_interval);
    let mut plan = plan::Plan::new(&graph, initiation_interval, &options.stages);
    plan.input_levels = options.input_levels;
    let schedule = schedule::schedule(&graph, &plan, initiation_interval);
    let (module, manifest) = emit::emit(&graph, &plan, &schedule, options);
    Ok(Datapath { module, manifest })
}
