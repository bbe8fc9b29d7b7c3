//! A frame on the hardware, on its golden model, or on both in lockstep.

use super::activity::{Activity, Watched};
use super::encode::EncodedFrame;
use super::generate::SplatCore;
use super::host::{SplatCounters, SplatHost};
use super::mask::{end_records, outputs};
use super::memory::ReconstructionBuffer;
use crate::generated::Progress;
use crate::memory::MemorySettings;
use crate::waveform::Waveform;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Fragment;
use pointcore_contract::splat::units::top;
use pointcore_contract::unit::count;
use pointcore_contract::{read, write};
use pointcore_golden::splat::Top;
use pointcore_golden::splat::top::{In, Out};
use pointcore_golden::unit::{Model, Ported, Unit};
use pointcore_tb::lockstep::{Flow, Lockstep, LockstepError, RESET_CYCLES, Stall, Stalls};
use pointcore_tb::verilated::{Library, VerilatedError};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Cycles a splat may take before a run counts as stuck, on top of [`STUCK_BASE_CYCLES`].
const STUCK_CYCLES_PER_SPLAT: u64 = 20_000;
/// Cycles any frame may take: clearing, flushing.
const STUCK_BASE_CYCLES: u64 = 10_000_000;

/// What a run brought.
pub struct SplatOutcome {
    /// Fragments as they came, without the end.
    pub fragments: Vec<Fragment>,
    /// What the host counted.
    pub counters: SplatCounters,
    /// What the core did, cycle by cycle.
    pub activity: Activity,
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
    /// How the reconstruction buffer answers.
    pub memory: MemorySettings,
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
    /// A frame on its hardware, never held back, to its end.
    #[must_use]
    pub const fn new(config: &'a Config, frame: &'a EncodedFrame) -> Self {
        let memory = ReconstructionBuffer::SETTINGS;
        Self { config, frame, memory, stall: Stall::Never, seed: 1, progress: &|_, _| {}, stop_after: None }
    }

    fn host(&self) -> SplatHost<'a> {
        let stalls = Stalls::new(self.stall, fastrand::Rng::with_seed(self.seed));
        SplatHost::new(self.config, self.frame, self.memory, stalls, self.progress).stop_after(self.stop_after)
    }

    fn limit(&self) -> u64 {
        STUCK_BASE_CYCLES + STUCK_CYCLES_PER_SPLAT * self.frame.records.len() as u64
    }

    /// The golden model alone.
    ///
    /// # Errors
    /// The frame does not come to its end.
    pub fn golden(&self, core: &SplatCore) -> Result<SplatOutcome, LockstepError> {
        let mut golden = self.model(core);
        let run = self.alone(|inputs, outputs| {
            *outputs = golden.outputs();
            golden.clock(inputs);
            Ok(())
        })?;
        Ok(run.with(golden.activity))
    }

    /// The golden model, watched.
    fn model(&self, core: &SplatCore) -> Watched {
        Watched::new(self.config, Top::new(self.config, &core.latencies()))
    }

    /// The hardware alone, with a waveform if one is asked for.
    ///
    /// # Errors
    /// An assertion of the hardware fails, or the frame does not come to its end.
    pub fn hardware(&self, library: &Arc<Library>, waveform: Option<&Waveform>) -> Result<SplatOutcome, LockstepError> {
        let mut model = library.instantiate(self.seed);
        let Some(waveform) = waveform else {
            return self.at_ports(library.reset_inputs(), |inputs, outputs| model.step(inputs, outputs));
        };
        waveform.begin(&mut model)?;
        let mut step = 0_u64;
        self.at_ports(library.reset_inputs(), |inputs, outputs| {
            if let Some(cycle) = step.checked_sub(RESET_CYCLES) {
                waveform.before(cycle, &mut model)?;
            }
            step += 1;
            model.step(inputs, outputs)
        })
    }

    /// The inputs of the run's first cycles, one row of words a cycle, as [`VerilatedModel::run_bare`](pointcore_tb::verilated::VerilatedModel::run_bare)
    /// replays them.
    ///
    /// # Errors
    /// As [`SplatRunner::hardware`].
    pub fn record(&self, library: &Arc<Library>) -> Result<Vec<u64>, LockstepError> {
        let mut model = library.instantiate(self.seed);
        let mut rows = Vec::new();
        self.at_ports(library.reset_inputs(), |inputs, outputs| {
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
        let mut golden = Ported::new(self.config, self.model(core));
        let step = |inputs: &[u64], outputs: &mut [u64]| golden.step(inputs, outputs);
        let lockstep = Lockstep::new(library, step, self.seed).limit(self.limit());
        let reproduce = format!("pointcore run SCENE --seed {}", self.seed);
        let interface = (top::UNIT.interface)(self.config);
        let lockstep = lockstep.mask(end_records(&interface, &outputs(&interface)));
        let run = lockstep.reproduced_by(reproduce).run(self.host())?;
        let run = Run { host: run.stimulus, simulated_cycles: run.report.cycles, elapsed: started.elapsed() };
        Ok(run.with(golden.into_model().activity))
    }

    /// Resets a device and drives it without comparing, a word a port.
    fn at_ports(
        &self,
        reset: Vec<u64>,
        mut step: impl FnMut(&[u64], &mut [u64]) -> Result<(), VerilatedError>,
    ) -> Result<SplatOutcome, LockstepError> {
        let (mut inputs, mut words) = (reset, vec![0; count(&top::UNIT.ports(self.config)).1]);
        for _ in 0..RESET_CYCLES {
            step(&inputs, &mut words)?;
        }
        inputs.fill(0);
        let mut activity = Activity::at_ports(self.config);
        let run = self.alone(|seen, outputs| {
            // The reset comes first.
            write(self.config, *seen, &mut inputs[1..]);
            step(&inputs, &mut words)?;
            *outputs = read(self.config, &words);
            activity.see_ports(seen, outputs);
            Ok(())
        })?;
        Ok(run.with(activity))
    }

    /// Drives a device out of reset without comparing. Its outputs are written where they stay: those of all ports are large.
    fn alone(
        &self,
        mut step: impl FnMut(&In, &mut Out) -> Result<(), VerilatedError>,
    ) -> Result<Run<'a>, LockstepError> {
        let started = Instant::now();
        let mut host = self.host();
        let (mut cycle, mut outputs) = (0, Out::default());
        while host.drive(cycle, &outputs) == Flow::Continue {
            if cycle == self.limit() {
                return Err(LockstepError::Unfinished { cycles: cycle, seed: self.seed });
            }
            step(host.inputs(), &mut outputs)?;
            cycle += 1;
        }
        Ok(Run { host, simulated_cycles: cycle, elapsed: started.elapsed() })
    }
}

/// A run as the host saw it.
struct Run<'a> {
    host: SplatHost<'a>,
    simulated_cycles: u64,
    elapsed: Duration,
}

impl Run<'_> {
    fn with(self, activity: Activity) -> SplatOutcome {
        let Self { host: SplatHost { fragments, counters, .. }, simulated_cycles, elapsed } = self;
        SplatOutcome { fragments, counters, activity, simulated_cycles, elapsed }
    }
}
