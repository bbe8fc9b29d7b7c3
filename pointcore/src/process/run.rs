//! An operation over a cloud: stage after stage, pass after pass.

use super::ProcessError;
use super::attributes;
use super::cloud::Cloud;
use super::engine::Engine;
use super::neighborhoods::{NEIGHBORS_LIMIT, Neighborhoods};
use super::operation::{Operation, config};
use super::outcome::{Processed, Summary};
use super::scale::Scale;
use super::settings;
use super::stage::Pass;
use glam::DVec3;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The most iterations of a query that a core counts.
pub const ITERATIONS_LIMIT: u32 = (1 << pointcore_contract::process::config::ITERATION_BITS) - 1;

/// Which positions are asked about.
#[derive(Clone, Debug)]
pub enum Queries {
    /// Points of the cloud, by their indices.
    Points(Vec<usize>),
    /// Points of the cloud, so many columns and rows of a pattern around each: fields `u` and `v`.
    Pattern {
        /// The points.
        points: Vec<usize>,
        /// Columns and rows.
        sides: [u32; 2],
    },
    /// Others, with attributes of their own.
    Cloud(Box<Cloud>),
    /// Positions without attributes.
    Places(Vec<DVec3>),
}

/// What is asked of an operation.
#[derive(Clone, Debug)]
pub struct Process<'a> {
    /// What is done.
    pub operation: &'a Operation,
    /// Neighbors of a query at most.
    pub k: u32,
    /// Only neighbors nearer than this count.
    pub radius: Option<f64>,
    /// Iterations of a query at most.
    pub iterations: u32,
    /// How often the points are replaced by what leaves, once at least; more than once only where the queries are all points.
    pub passes: u32,
    /// Settings by name; others follow from the points.
    pub settings: &'a BTreeMap<String, Vec<f64>>,
    /// Numbers that all points have.
    pub attributes: &'a BTreeMap<String, Vec<f64>>,
}

/// Carries an operation out; `progress` hears how many queries of a pass have left.
///
/// # Errors
/// Names, values or points that do not suit the operation, and what the engine finds.
pub fn process(
    cloud: &Cloud,
    queries: &Queries,
    process: &Process<'_>,
    engine: &dyn Engine,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Processed, ProcessError> {
    process.check(queries, cloud)?;
    let mut cloud = cloud.clone();
    let mut timings = vec![];
    for _ in 1..process.passes {
        let processed = process.pass(&cloud, queries, engine, progress)?;
        timings.extend(processed.summary.timings);
        cloud = cloud.moved(processed.places)?;
    }
    let mut processed = process.pass(&cloud, queries, engine, progress)?;
    processed.summary.timings.splice(0..0, timings);
    processed.summary.passes = process.passes;
    Ok(processed)
}

impl Process<'_> {
    fn check(&self, queries: &Queries, cloud: &Cloud) -> Result<(), ProcessError> {
        settings::check_names(self.operation, self.settings)?;
        attributes::check_names(self.operation, self.attributes)?;
        for program in self.operation.stages() {
            config(Arc::clone(program), cloud.set.format()).validate()?;
        }
        if !(1..=NEIGHBORS_LIMIT).contains(&self.k) {
            return Err(ProcessError::Neighbors(self.k));
        }
        if !(1..=ITERATIONS_LIMIT).contains(&self.iterations) {
            return Err(ProcessError::Iterations(self.iterations));
        }
        let program = self.operation.name().to_owned();
        if self.passes > 1 {
            let is_whole = matches!(queries, Queries::Points(points) if points.iter().copied().eq(0..cloud.len()));
            if !self.operation.moves() {
                return Err(ProcessError::Passes { program, passes: self.passes });
            }
            if !is_whole {
                return Err(ProcessError::Queries(program));
            }
        }
        let is_points = matches!(queries, Queries::Points(_));
        if self.operation.stages().len() > 1 && !is_points { Err(ProcessError::Queries(program)) } else { Ok(()) }
    }

    /// All stages, once.
    fn pass(
        &self,
        cloud: &Cloud,
        queries: &Queries,
        engine: &dyn Engine,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Processed, ProcessError> {
        let scale = Scale::of(&cloud.set, self.k, self.radius);
        let neighborhoods = Arc::new(Neighborhoods::new(&cloud.set, self.k, self.radius)?);
        let mut summary = self.summary(cloud, engine);
        let mut cloud = cloud.clone();
        let pass = Pass { process: self, scale, neighborhoods: &neighborhoods, engine, progress };
        let (last, before) = self.operation.stages().split_last().expect("an operation has a program");
        let mut stages = vec![];
        for program in before {
            let all = Queries::Points((0..cloud.len()).collect());
            let processed = pass.stage(program, &mut cloud, &all, &mut summary)?;
            stages.extend(processed.stages);
            for column in processed.columns {
                for (part, numbers) in column.parts.iter().zip(column.numbers) {
                    let values = (0..numbers.len()).map(|index| numbers.number(index)).collect();
                    cloud.insert(part, values, &format!("output of `{}`", program.name()));
                }
            }
        }
        let mut processed = pass.stage(last, &mut cloud, queries, &mut summary)?;
        processed.stages.splice(0..0, stages);
        Ok(processed)
    }

    pub(super) fn summary(&self, cloud: &Cloud, engine: &dyn Engine) -> Summary {
        Summary {
            operation: self.operation.name().to_owned(),
            engine: engine.name(),
            points: cloud.name.clone(),
            point_count: cloud.len(),
            left_out: cloud.left_out(),
            queries: 0,
            passes: 1,
            iterations: 0,
            iterations_max: 0,
            capped: 0,
            invalid: None,
            neighbors: None,
            lonely: None,
            timings: vec![],
            settings: vec![],
            attributes: vec![],
        }
    }
}
