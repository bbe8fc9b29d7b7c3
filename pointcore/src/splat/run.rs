//! A frame on the hardware, on its golden model, or on both in lockstep.

use super::encode::EncodedFrame;
use super::generate::SplatCore;
use super::host::{SplatCounters, SplatHost};
use super::mask::end_records;
use crate::generated::Progress;
use crate::recording::Recording;
use pointcore_contract::count;
use pointcore_contract::splat::{Config, ports};
use pointcore_golden::splat::Top;
use pointcore_golden::unit::{Ported, Unit};
use pointcore_tb::lockstep::{Flow, Lockstep, LockstepError, Stall, Stalls, Stimulus};
use pointcore_tb::verilated::{Library, VerilatedError};
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Cycles a splat may take before a run counts as stuck, on top of [`STUCK_BASE_CYCLES`].
const STUCK_CYCLES_PER_SPLAT: u64 = 20_000;
/// Cycles any frame may take: clearing, flushing.
const STUCK_BASE_CYCLES: u64 = 10_000_000;

/// What a run brought.
pub struct SplatOutcome {
    /// Fragments, field by field.
    pub fragments: Vec<u64>,
    /// What the host counted.
    pub counters: SplatCounters,
    /// Cycles simulated.
    pub simulated_cycles: u64,
    /// Time the simulation took.
    pub elapsed: Duration,
}

/// A frame ready to be run, on one engine or another, with one pattern of stalls or another.
#[derive(Clone)]
pub struct SplatRunner<'a> {
    /// The hardware's configuration.
    pub config: &'a Config,
    /// The frame.
    pub frame: &'a EncodedFrame,
    /// When the host holds back.
    pub stall: Stall,
    /// Seed of the stalls and of the hardware's uninitialized values.
    pub seed: u64,
    /// Hears of the progress.
    pub progress: Progress<'a>,
    /// Cut the run off after so many cycles, for timing.
    pub stop_after: Option<u64>,
}

impl<'a> SplatRunner<'a> {
    fn host(&self) -> SplatHost<'a> {
        let stalls = Stalls::new(self.stall, fastrand::Rng::with_seed(self.seed));
        SplatHost::new(self.config, self.frame, stalls, self.progress)
    }

    fn limit(&self) -> u64 {
        STUCK_BASE_CYCLES + STUCK_CYCLES_PER_SPLAT * self.frame.count() as u64
    }

    /// The golden model alone.
    ///
    /// # Errors
    /// The frame does not come to its end.
    pub fn golden(&self, core: &SplatCore) -> Result<SplatOutcome, LockstepError> {
        let mut golden = Ported::new(self.config, Top::new(self.config, &core.latencies()));
        self.alone(count(&ports::top(self.config)), |inputs, outputs| {
            golden.step(inputs, outputs);
            Ok(())
        })
    }

    /// The hardware alone; with a path, a waveform of the whole run is written there.
    ///
    /// # Errors
    /// An assertion of the hardware fails, or the frame does not come to its end.
    pub fn hardware(&self, library: &Arc<Library>, waveform: Option<&Path>) -> Result<SplatOutcome, LockstepError> {
        let mut model = library.instantiate(self.seed);
        if let Some(path) = waveform {
            model.open_trace(path)?;
        }
        let counts = (library.inputs().len(), library.outputs().len());
        self.alone(counts, |inputs, outputs| model.step(inputs, outputs))
    }

    /// What the golden model's ports carry in every cycle, after it has idled for so many.
    ///
    /// # Errors
    /// The frame does not come to its end.
    pub fn recording(&self, core: &SplatCore, settling_cycles: u64) -> Result<Recording, LockstepError> {
        let list = ports::top(self.config);
        let mut recording = Recording::new(list.clone()).after(settling_cycles);
        let mut golden = Ported::new(self.config, Top::new(self.config, &core.latencies()));
        let mut remaining = settling_cycles;
        self.alone(count(&list), |inputs, outputs| {
            // The reset is no part of it.
            if inputs[0] != 0 {
                golden.step(inputs, outputs);
                return Ok(());
            }
            let idle = vec![0; inputs.len()];
            while remaining > 0 {
                golden.step(&idle, outputs);
                remaining -= 1;
            }
            golden.step(inputs, outputs);
            recording.push(inputs, outputs);
            Ok(())
        })?;
        Ok(recording)
    }

    /// The inputs of the run's first cycles, one row of words a cycle, as [`VerilatedModel::run_bare`](pointcore_tb::verilated::VerilatedModel::run_bare)
    /// replays them.
    ///
    /// # Errors
    /// As [`SplatRunner::hardware`].
    pub fn record(&self, library: &Arc<Library>) -> Result<Vec<u64>, LockstepError> {
        let mut model = library.instantiate(self.seed);
        let mut rows = Vec::new();
        self.alone((library.inputs().len(), library.outputs().len()), |inputs, outputs| {
            rows.extend(inputs);
            model.step(inputs, outputs)
        })?;
        Ok(rows)
    }

    /// Hardware and model, every output compared in every cycle.
    ///
    /// # Errors
    /// The first difference, or the frame does not come to its end.
    pub fn lockstep(&self, core: &SplatCore, library: &Arc<Library>) -> Result<SplatOutcome, LockstepError> {
        let started = Instant::now();
        let mut golden = Ported::new(self.config, Top::new(self.config, &core.latencies()));
        let golden = move |inputs: &[u64], outputs: &mut [u64]| golden.step(inputs, outputs);
        let lockstep = Lockstep::new(library, golden, self.seed).limit(self.limit());
        let reproduce = format!("pointcore run SCENE --seed {}", self.seed);
        let stimulus = CutOff { host: self.host(), stop_after: self.stop_after };
        let run = lockstep.mask(end_records(&ports::top(self.config))).reproduced_by(reproduce).run(stimulus)?;
        Ok(SplatOutcome {
            fragments: run.stimulus.host.fragments,
            counters: run.stimulus.host.counters,
            simulated_cycles: run.report.cycles,
            elapsed: started.elapsed(),
        })
    }

    /// Drives one device without comparing.
    fn alone(
        &self,
        (inputs, outputs): (usize, usize),
        mut step: impl FnMut(&[u64], &mut [u64]) -> Result<(), VerilatedError>,
    ) -> Result<SplatOutcome, LockstepError> {
        let started = Instant::now();
        let (mut inputs, mut outputs) = (vec![0; inputs], vec![0; outputs]);
        inputs[0] = 1;
        for _ in 0..pointcore_tb::lockstep::RESET_CYCLES {
            step(&inputs, &mut outputs)?;
        }
        inputs[0] = 0;
        let mut stimulus = CutOff { host: self.host(), stop_after: self.stop_after };
        let mut cycle = 0;
        while stimulus.drive(cycle, &outputs, &mut inputs) == Flow::Continue {
            if cycle == self.limit() {
                return Err(LockstepError::Unfinished { cycles: cycle, seed: self.seed });
            }
            step(&inputs, &mut outputs)?;
            cycle += 1;
        }
        let elapsed = started.elapsed();
        let host = stimulus.host;
        Ok(SplatOutcome { fragments: host.fragments, counters: host.counters, simulated_cycles: cycle, elapsed })
    }
}

/// The host of a run that may be cut off.
#[derive(Clone)]
struct CutOff<'a> {
    host: SplatHost<'a>,
    stop_after: Option<u64>,
}

impl Stimulus for CutOff<'_> {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        if self.stop_after == Some(cycle) { Flow::Done } else { self.host.drive(cycle, outputs, inputs) }
    }
}
