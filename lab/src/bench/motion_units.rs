//! Motion blur in hardware: cases beside f64, and cycle by cycle.

use crate::motion::check::{Units, case};
use crate::motion::{configurations, lockstep};
use crate::{Figures, LabError, note};
use fastrand::Rng;
use pointcore::stimuli::motion::Family;
use pointcore_contract::splat::Config;
use rayon::prelude::*;

/// Cases beside f64, over all configurations.
const GOLDEN_CASES: u64 = 1_000_000;
/// Cases in lockstep.
const RTL_CASES: u64 = 100_000;
/// Cases with one source of randomness.
const BATCH: u64 = 2_000;

/// Measures both units on cases of all families.
///
/// # Errors
/// A fault of the generator, or a tool is missing or fails.
pub fn figures(figures: &mut Figures) -> Result<(), LabError> {
    counted(GOLDEN_CASES, RTL_CASES, figures)
}

/// As [`figures()`], of so many cases.
///
/// # Errors
/// As there.
pub fn counted(golden_cases: u64, rtl_cases: u64, figures: &mut Figures) -> Result<(), LabError> {
    let configurations = configurations();
    let count = configurations.len() as u64;
    let measured = configurations.par_iter().enumerate().map(|(index, config)| {
        let seed = index as u64;
        // What does not come out even goes to the first.
        let share = |cases: u64| cases / count + if index == 0 { cases % count } else { 0 };
        let golden = tally(config, share(golden_cases), seed);
        note!("motion, {}: {} cases beside f64", config.geometry, golden.cases);
        Ok((golden, lockstep::run(config, share(rtl_cases), seed)?))
    });
    let measured = measured.collect::<Result<Vec<_>, LabError>>()?;
    let golden = measured.iter().fold(Tally::default(), |all, (golden, _)| all.plus(golden));
    let rtl_cases: u64 = measured.iter().map(|(_, rtl)| rtl.cases).sum();
    let mismatches: u64 = measured.iter().map(|(_, rtl)| rtl.mismatches).sum();
    let mut insert = |key: &str, value: serde_json::Value| _ = figures.insert(format!("motion.{key}"), value);
    insert("golden_cases", golden.cases.into());
    insert("golden_covered", golden.covered.into());
    insert("golden_well_posed", golden.well_posed.into());
    insert("violations", golden.violations.into());
    insert("worst_error", golden.worst.into());
    insert("worst_error_well_posed", golden.worst_well_posed.into());
    insert("rtl_cases", rtl_cases.into());
    insert("mismatches", mismatches.into());
    Ok(())
}

/// What came of cases, each evaluated from a footprint in f64 that was rounded, and drawn from the splat.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    cases: u64,
    covered: u64,
    well_posed: u64,
    violations: u64,
    /// Of a share, in `f32`.
    worst: f64,
    worst_well_posed: f64,
}

impl Tally {
    fn plus(&self, other: &Self) -> Self {
        Self {
            cases: self.cases + other.cases,
            covered: self.covered + other.covered,
            well_posed: self.well_posed + other.well_posed,
            violations: self.violations + other.violations,
            worst: self.worst.max(other.worst),
            worst_well_posed: self.worst_well_posed.max(other.worst_well_posed),
        }
    }
}

/// So many cases of a configuration.
fn tally(config: &Config, cases: u64, seed: u64) -> Tally {
    let units = Units::new(config);
    let batches = (0..cases.div_ceil(BATCH)).into_par_iter();
    let batch = |batch: u64| {
        let mut random = Rng::with_seed(seed << 32 | batch);
        let families = Family::ALL.into_iter().cycle();
        let mut tally = Tally::default();
        let count = BATCH.min(cases - batch * BATCH) as usize;
        for case in families.filter_map(|family| case(&mut random, family, config)).take(count) {
            tally.cases += 1;
            for result in [units.evaluate(&case), units.draw(&case)] {
                match result {
                    Ok(outcome) => {
                        tally.covered += u64::from(outcome.is_inside);
                        tally.well_posed += u64::from(outcome.is_inside && outcome.is_well_posed);
                        if config.geometry.mantissa == pointcore_contract::Format::F32.mantissa {
                            tally.worst = tally.worst.max(outcome.error);
                        }
                        if outcome.is_well_posed {
                            tally.worst_well_posed = tally.worst_well_posed.max(outcome.error);
                        }
                    }
                    Err(violation) => {
                        note!("{:?}: {violation}: {case:?}", case.moved.family);
                        tally.violations += 1;
                    }
                }
            }
        }
        tally
    };
    batches.map(batch).reduce(Tally::default, |one, other| one.plus(&other))
}
