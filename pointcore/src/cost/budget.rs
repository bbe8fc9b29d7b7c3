//! Hardware within a budget: of what renders a scene, the fastest that a device holds.
//!
//! What is tried differs in time alone, never in a bit of the frame: rasterizers, the cycles that a splat takes in transform and setup, and
//! how many copies wait for their tile. A frame takes no fewer cycles than its busiest part; what waiting adds is not known before.

use crate::area::device::{Device, Needs, Shortage};
use crate::area::estimate::Estimator;
use crate::area::proxy::Proxy;
use crate::area::recorded::recorded;
use crate::configuration::Configuration;
use crate::generated::GenerateError;
use crate::plan::{Plan, PlanError, Planner, Size, Work};
use crate::scene::Scene;
use crate::splat::{Fates, SplatCore, SplatCounters, bounds};
use pointcore_contract::splat::Config;
use serde::Serialize;
use std::fmt;

/// Rasterizers that are tried.
const RASTERIZERS: [u32; 4] = [8, 4, 2, 1];
/// The most powers of two by which splats are slowed down in transform and setup.
const SLOWER_MAX: u32 = 3;
/// The most levels of copies that are left out: fewer and tiles are fetched again and again.
const FEWER_LEVELS_MAX: u32 = 4;

/// What hardware may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Budget {
    /// Look-up tables of four inputs, those in the place of carry cells included.
    pub luts: Option<u64>,
    /// A device that is to hold it.
    pub device: Option<Device>,
}

/// Hardware that was tried.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Candidate {
    /// Rasterizers.
    pub rasterizers: u32,
    /// Cycles a splat in transform and setup.
    pub interval: u32,
    /// Copies that wait in all lanes.
    pub copies: u32,
    /// Cycles that a frame takes at least.
    pub cycles: u64,
    /// What it takes.
    pub needs: Needs,
    /// What there is too little of.
    pub shortages: Vec<Shortage>,
}

/// A plan within a budget, and what was tried before it.
#[derive(Clone, Debug)]
pub struct Budgeted {
    /// The plan.
    pub plan: Plan,
    /// What was tried, the plan's own last.
    pub tried: Vec<Candidate>,
}

/// Why there is no plan within a budget.
#[derive(Debug, thiserror::Error)]
pub enum BudgetError {
    /// No hardware for the scene, whatever the budget.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A fault of the generator.
    #[error(transparent)]
    Generate(#[from] GenerateError),
    /// The smallest does not fit.
    #[error("no hardware for this scene fits {budget}: the smallest takes {}; {}", list(shortages), remedy(*budget))]
    TooSmall {
        /// The budget.
        budget: Budget,
        /// What there is too little of.
        shortages: Vec<Shortage>,
    },
}

fn list(shortages: &[Shortage]) -> String {
    shortages.iter().map(Shortage::to_string).collect::<Vec<_>>().join(", ")
}

fn remedy(budget: Budget) -> &'static str {
    match budget.device {
        Some(_) => "name a larger device, or choose smaller number formats in [overrides]",
        None => "allow more, or choose smaller number formats in [overrides]",
    }
}

impl fmt::Display for Budget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.device, self.luts) {
            (Some(device), Some(luts)) => write!(f, "{luts} look-up tables of an {}", device.name),
            (Some(device), None) => write!(f, "an {}", device.name),
            (None, Some(luts)) => write!(f, "{luts} look-up tables"),
            (None, None) => write!(f, "anything"),
        }
    }
}

impl Budget {
    fn shortages(&self, needs: &Needs) -> Vec<Shortage> {
        let device = self.device.unwrap_or(Device::UNLIMITED);
        needs.shortages(&Device { luts: device.luts.min(self.luts.unwrap_or(u64::MAX)), ..device })
    }
}

/// Cycles that a frame takes at least.
fn least_cycles(config: &Config, Work { splats, copies, samples }: Work) -> u64 {
    let fates = Fates { drawn: splats, set_up: splats, copies, ..Fates::default() };
    let mut counters = SplatCounters::default();
    counters.events.sample = samples;
    bounds(config, &fates, &counters).iter().map(|bound| bound.cycles).max().unwrap_or_default()
}

/// What hardware takes: as recorded, or counted and estimated.
fn needs(config: &Config, estimator: &Estimator) -> Result<Needs, GenerateError> {
    if let Some(known) = recorded(&Configuration::Splat(config.clone())) {
        return Ok(known.needs);
    }
    let core = SplatCore::generate(config)?;
    Ok(Needs::counted(&core.design, estimator.lut4(&Proxy::of(&core.design))))
}

impl Budgeted {
    /// The fastest hardware for a scene within a budget; what the scene's overrides say stays as it is.
    ///
    /// # Errors
    /// Hardware that the scene cannot have, or none that fits.
    pub fn of(scene: &Scene, budget: Budget, estimator: &Estimator) -> Result<Self, BudgetError> {
        let planner = Planner::new(scene, &scene.overrides)?;
        let plans = sizes(&planner).into_iter().map(|size| Ok((size, planner.plan(size)?)));
        let plans = plans.collect::<Result<Vec<_>, PlanError>>()?;
        let mut plans: Vec<_> =
            plans.into_iter().map(|(size, plan)| (least_cycles(&plan.config, planner.work()), size, plan)).collect();
        // Of those that take as long, the one with fewer rasterizers and more cycles a splat is the smaller.
        plans.sort_by_key(|(cycles, size, _)| (*cycles, size.rasterizers, std::cmp::Reverse(size.slower)));
        plans.dedup_by(|(_, _, later), (_, _, earlier)| later.config == earlier.config);
        let mut tried = vec![];
        for (cycles, size, plan) in plans {
            if let Some(plan) = fitting(&planner, budget, estimator, (size, plan), cycles, &mut tried)? {
                return Ok(Self { plan, tried });
            }
        }
        let size = |candidate: &Candidate| (candidate.needs.lut4.map(|lut4| lut4 as u64), candidate.needs.block_rams);
        let smallest = tried.into_iter().min_by_key(size);
        Err(BudgetError::TooSmall { budget, shortages: smallest.map(|tried| tried.shortages).unwrap_or_default() })
    }
}

/// The sizes that a scene leaves open.
fn sizes(planner: &Planner) -> Vec<Size> {
    let given = planner.size();
    let rasterizers = if planner.is_free("rasterizers") { RASTERIZERS.to_vec() } else { vec![given.rasterizers] };
    let is_paced = ["transform_interval", "setup_interval"].into_iter().any(|key| planner.is_free(key));
    let slower = 0..=if is_paced { SLOWER_MAX } else { 0 };
    let sizes = rasterizers.into_iter().flat_map(|rasterizers| slower.clone().map(move |slower| (rasterizers, slower)));
    sizes.map(|(rasterizers, slower)| Size { rasterizers, slower, ..given }).collect()
}

/// The hardware if it fits, with as many copies as fit.
fn fitting(
    planner: &Planner,
    budget: Budget,
    estimator: &Estimator,
    (size, mut plan): (Size, Plan),
    cycles: u64,
    tried: &mut Vec<Candidate>,
) -> Result<Option<Plan>, BudgetError> {
    for fewer_levels in 0..=if planner.is_free("heap_levels") { FEWER_LEVELS_MAX } else { 0 } {
        if fewer_levels > 0 {
            plan = planner.plan(Size { fewer_levels, ..size })?;
        }
        let config = &plan.config;
        let needs = needs(config, estimator)?;
        let shortages = budget.shortages(&needs);
        let (fits, only_memory) = (shortages.is_empty(), shortages.iter().all(Shortage::is_of_block_ram));
        tried.push(Candidate {
            rasterizers: config.rasterizers,
            interval: config.setup_interval,
            copies: config.copies_held() * config.rasterizers,
            cycles,
            needs,
            shortages,
        });
        if fits {
            return Ok(Some(plan));
        }
        if !only_memory {
            break;
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::area::estimate::Fit;
    use std::path::Path;

    /// A look-up table for each bit of a sum.
    fn estimator() -> Estimator {
        let fit = Fit { weights: [1.0, 0.0, 0.0, 0.0], units: 9, median_error: 0.0 };
        serde_json::from_value(serde_json::json!({ "cores": [], "fit": fit })).expect("an estimator")
    }

    fn within(settings: &[&str], luts: u64) -> Result<Budgeted, BudgetError> {
        let knot = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/knot.toml"));
        let settings: Vec<_> = settings.iter().map(|setting| (*setting).to_owned()).collect();
        let scene = Scene::load(knot, &settings).expect("a shipped scene");
        Budgeted::of(&scene, Budget { luts: Some(luts), device: None }, &estimator())
    }

    #[test]
    fn less_is_slower_and_renders_the_same() {
        let luts =
            |budgeted: &Budgeted| budgeted.tried.last().and_then(|tried| tried.needs.lut4).expect("an estimate") as u64;
        let free = within(&[], u64::MAX).expect("anything fits");
        assert_eq!((free.plan.config.rasterizers, free.tried.len()), (8, 1), "{:?}", free.tried);
        let half = within(&[], luts(&free) / 2).expect("half of it is enough");
        let quarter = within(&[], luts(&free) / 4).expect("so is a quarter");
        for (larger, smaller, share) in [(&free, &half, 2), (&half, &quarter, 4)] {
            assert!(luts(smaller) <= luts(&free) / share, "{:?}", smaller.tried);
            assert!(larger.tried.last().map(|tried| tried.cycles) < smaller.tried.last().map(|tried| tried.cycles));
            let Config {
                rasterizers, memory_ports, transform_interval, setup_interval, heap_levels, splat_levels, ..
            } = larger.plan.config;
            let sizes = Config {
                rasterizers,
                memory_ports,
                transform_interval,
                setup_interval,
                heap_levels,
                splat_levels,
                ..smaller.plan.config.clone()
            };
            assert_eq!(sizes, larger.plan.config, "they differ in more than their size");
        }
    }

    #[test]
    fn overrides_stay() {
        let two = within(&["overrides.rasterizers=2", "overrides.setup_interval=4"], u64::MAX).expect("anything fits");
        assert_eq!((two.plan.config.rasterizers, two.plan.config.setup_interval), (2, 4));
    }

    #[test]
    fn what_never_fits_says_what_the_smallest_takes() {
        let error = within(&[], 5).expect_err("nothing has five look-up tables").to_string();
        assert!(error.contains("fits 5 look-up tables: the smallest takes") && error.contains("allow more"), "{error}");
    }
}
