//! A case: a configuration, and run after run on it. Everything follows from a seed and the case's number.

use super::device::{AnyConfig, Core, Device, RunError};
use crate::LabError;
use fastrand::Rng;
use pointcore_tb::lockstep::LockstepError;
use pointcore_tb::verilated::{BuildOptions, Builder, Optimization, Trace};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::sync::Arc;

/// Which case.
#[derive(Clone, Debug)]
pub struct Case {
    /// The seed of all cases of a campaign.
    pub seed: u64,
    /// Its number.
    pub number: u64,
    /// Its configuration and the file that holds it; without one, it is random: even numbers are renderers, odd ones search cores.
    pub given: Option<(PathBuf, AnyConfig)>,
}

/// A run that was not clean.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CaseFailure {
    /// The run's number in its case.
    pub run: u64,
    /// The command that makes this run alone.
    pub reproduce: String,
    /// What went wrong: cycle, ports, both values, inputs, waveform.
    pub text: String,
}

/// What came of a case.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CaseOutcome {
    /// Its number.
    pub case: u64,
    /// Of which core.
    pub core: Core,
    /// Clean cycles.
    pub cycles: u64,
    /// Clean runs, each from a reset to the end of all its frames or searches.
    pub runs: u64,
    /// Frames or queries that came out.
    pub items: u64,
    /// The configuration, as a file.
    pub configuration: String,
    /// The run that ended it, if one did.
    pub failure: Option<CaseFailure>,
}

/// How much of a case is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Runs until they have taken so many cycles.
    Cycles(u64),
    /// This run alone.
    Run(u64),
}

/// What else decides a seed, so that configurations and runs have nothing in common.
const CONFIGURATION: u64 = u64::MAX;

impl Case {
    /// Its core.
    #[must_use]
    pub fn core(&self) -> Core {
        match &self.given {
            Some((_, config)) => config.core(),
            None if self.number.is_multiple_of(2) => Core::Splat,
            None => Core::Search,
        }
    }

    /// A seed of its own for each of its parts.
    fn seed_of(&self, part: u64) -> u64 {
        // Each draw spreads what was mixed in over all bits.
        let mix = |seed: u64, part: u64| Rng::with_seed(seed ^ part).u64(..);
        mix(mix(mix(0, self.seed), self.number), part)
    }

    /// Its configuration.
    #[must_use]
    pub fn configuration(&self) -> AnyConfig {
        let random = || AnyConfig::random(self.core(), &mut Rng::with_seed(self.seed_of(CONFIGURATION)));
        self.given.as_ref().map_or_else(random, |(_, config)| config.clone())
    }

    /// The command that makes one of its runs alone.
    fn command(&self, run: u64) -> String {
        let Self { seed, number, given } = self;
        match given {
            Some((path, _)) => format!("pointcore soak --seed {seed} --configuration {} --run {run}", path.display()),
            None => format!("pointcore soak --seed {seed} --case {number} --run {run}"),
        }
    }

    /// Its core, compiled for speed.
    ///
    /// # Errors
    /// It could not be generated, compiled or loaded.
    pub fn device(&self, builder: &Arc<Builder>) -> Result<Device, LabError> {
        let options = BuildOptions { optimization: Optimization::OF_CORES, trace: Trace::Off };
        Device::build(&self.configuration(), builder, options)
    }

    /// Runs it on its core; a run that is not clean ends it.
    ///
    /// # Errors
    /// The core could not be run: nothing is said of hardware and model.
    pub fn run(&self, device: &Device, extent: Extent) -> Result<CaseOutcome, LabError> {
        let mut outcome = CaseOutcome {
            case: self.number,
            core: self.core(),
            cycles: 0,
            runs: 0,
            items: 0,
            configuration: self.configuration().text(),
            failure: None,
        };
        let (mut number, most) = match extent {
            Extent::Cycles(cycles) => (0, cycles),
            Extent::Run(run) => (run, 1),
        };
        while outcome.cycles < most {
            match device.run(self.seed_of(number), &self.command(number)) {
                Ok(ran) => {
                    outcome.cycles += ran.cycles;
                    outcome.items += ran.pending.done as u64;
                    outcome.runs += 1;
                }
                Err(RunError::Lockstep(LockstepError::Verilated(error))) => return Err(error.into()),
                Err(error) => {
                    let (reproduce, text) = (self.command(number), error.to_string());
                    outcome.failure = Some(CaseFailure { run: number, reproduce, text });
                    return Ok(outcome);
                }
            }
            number += 1;
        }
        Ok(outcome)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn a_case_follows_from_seed_and_number_alone() {
        let case = |seed, number| Case { seed, number, given: None };
        let text = |seed, number| case(seed, number).configuration().text();
        assert_eq!(text(3, 8), text(3, 8));
        let numbers = 0..50;
        let different: HashSet<_> = numbers.flat_map(|number| [text(3, number), text(4, number)]).collect();
        assert!(different.len() > 95, "{} of 100", different.len());
        assert_ne!(case(3, 8).seed_of(0), case(3, 8).seed_of(1));
        assert_eq!(case(3, 8).command(5), "pointcore soak --seed 3 --case 8 --run 5");
    }
}
