//! A point processor with its program, ready to be asked.

use super::counters::PointsCounters;
use super::generate::PointsCore;
use super::host::{PointsHost, Task, Work};
use crate::generated::{Progress, verilate};
use crate::process::Answer;
use crate::search::{MemorySettings, Reuse, SearchEngine, SearchError, Tree};
use pointcore_contract::points::Config;
use pointcore_contract::points::units::top::Out;
use pointcore_golden::points::Top;
use pointcore_golden::unit::{Model, Ported, Unit};
use pointcore_tb::lockstep::{Flow, Lockstep, RESET_CYCLES, Stall, Stalls, Stimulus};
use pointcore_tb::verilated::{Library, Trace};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What a run brought.
#[derive(Clone, Debug)]
pub struct PointsOutcome {
    /// What left with each query.
    pub answers: Vec<Answer>,
    /// What the host counted.
    pub counters: PointsCounters,
    /// Cycles simulated, those that load the tree among them.
    pub simulated_cycles: u64,
    /// Time the simulation took.
    pub elapsed: Duration,
}

/// A core with its program.
pub struct PointsSession {
    config: Config,
    core: PointsCore,
    /// The verilated core, unless the golden model answers alone.
    library: Option<Arc<Library>>,
    engine: SearchEngine,
    memory: MemorySettings,
    reuse: Reuse,
    stall: Stall,
    seed: u64,
    reproduce: String,
}

impl PointsSession {
    /// Generates the core of a configuration, and verilates it if it is to run.
    ///
    /// # Errors
    /// Configuration or memory settings are not valid, or tools are missing or fail.
    pub fn open(config: Config, memory: MemorySettings, engine: SearchEngine) -> Result<Self, SearchError> {
        config.validate()?;
        memory.validate()?;
        let core = PointsCore::generate(&config)?;
        let library = if engine == SearchEngine::Golden { None } else { Some(verilate(&core.design, Trace::Off)?) };
        let (reuse, stall, seed, reproduce) = (Reuse::default(), Stall::Never, 1, String::new());
        Ok(Self { config, core, library, engine, memory, reuse, stall, seed, reproduce })
    }

    /// Holds streams back at random, chooses among answers of the memory and the hardware's uninitialized values.
    #[must_use]
    pub fn randomized(mut self, stall: Stall, seed: u64) -> Self {
        (self.stall, self.seed) = (stall, seed);
        self
    }

    /// Lets the neighbor cache answer within these limits.
    ///
    /// # Errors
    /// A factor has no meaning.
    pub fn reusing(mut self, reuse: Reuse) -> Result<Self, SearchError> {
        reuse.validate()?;
        self.reuse = reuse;
        Ok(self)
    }

    /// The command to print when hardware and model differ.
    #[must_use]
    pub fn reproduced_by(mut self, command: String) -> Self {
        self.reproduce = command;
        self
    }

    /// The configuration.
    #[must_use]
    pub const fn config(&self) -> &Config {
        &self.config
    }

    /// Sends queries one after the other; as many are under way at a time as the core has threads. The tree must have been
    /// built for the same configuration, of the same points.
    ///
    /// # Errors
    /// The tree is another one's; hardware and model differ; the core is stuck.
    pub fn run(&self, tree: &Tree, task: Task<'_>, progress: Progress) -> Result<PointsOutcome, SearchError> {
        tree.check(&self.config.search)?;
        let work = Work { config: &self.config, tree, task, reuse: self.reuse, memory: self.memory };
        let stalls = Stalls::new(self.stall, fastrand::Rng::with_seed(self.seed));
        let host = PointsHost::new(work, stalls, self.seed, progress);
        let started = Instant::now();
        let (host, simulated_cycles) = match (self.engine, &self.library) {
            (SearchEngine::Hardware, Some(library)) => self.hardware(library, host),
            (SearchEngine::Lockstep, Some(library)) => self.lockstep(library, host),
            _ => Ok(self.golden(host)),
        }?;
        let elapsed = started.elapsed();
        if host.is_stuck {
            let (answered, queries) = (host.answered, task.queries.len());
            return Err(SearchError::Stuck { cycle: simulated_cycles, answered, queries });
        }
        let (answers, counters) = host.into_results();
        Ok(PointsOutcome { answers, counters, simulated_cycles, elapsed })
    }

    fn golden<'a>(&self, mut host: PointsHost<'a>) -> (PointsHost<'a>, u64) {
        let mut top = Top::new(&self.config, self.core.latencies());
        let (mut cycle, mut outputs) = (0, Out::default());
        while host.drive(cycle, &outputs) == Flow::Continue {
            outputs = top.outputs();
            top.clock(host.inputs());
            cycle += 1;
        }
        (host, cycle)
    }

    fn hardware<'a>(
        &self,
        library: &Arc<Library>,
        mut host: PointsHost<'a>,
    ) -> Result<(PointsHost<'a>, u64), SearchError> {
        let mut model = library.instantiate(self.seed);
        let (mut inputs, mut outputs) = (library.reset_inputs(), vec![0; library.outputs().len()]);
        for _ in 0..RESET_CYCLES {
            model.step(&inputs, &mut outputs)?;
        }
        inputs.fill(0);
        let mut cycle = 0;
        while Stimulus::drive(&mut host, cycle, &outputs, &mut inputs) == Flow::Continue {
            model.step(&inputs, &mut outputs)?;
            cycle += 1;
        }
        Ok((host, cycle))
    }

    fn lockstep<'a>(&self, library: &Arc<Library>, host: PointsHost<'a>) -> Result<(PointsHost<'a>, u64), SearchError> {
        let mut golden = Ported::new(&self.config, Top::new(&self.config, self.core.latencies()));
        let golden = move |inputs: &[u64], outputs: &mut [u64]| golden.step(inputs, outputs);
        // The host finds out by itself when nothing moves.
        let lockstep = Lockstep::new(library, golden, self.seed).limit(u64::MAX);
        let run = lockstep.reproduced_by(self.reproduce.clone()).run(host)?;
        Ok((run.stimulus, run.report.cycles))
    }
}
