//! The point processor as an engine, and the time it takes.

use super::ProcessError;
use super::engine::{Carried, Engine, Job};
use crate::points::{PointsOutcome, PointsSession, Task};
use crate::search::{MemorySettings, Reuse, SearchEngine, Splitting, Tree, config_for};
use pointcore_contract::points::Config;
use pointcore_contract::{process, search};
use pointcore_tb::lockstep::Stall;
use serde::Serialize;
use std::sync::{Arc, Mutex};

/// Queries under way where nothing says how many.
const THREADS: u32 = 128;
/// Points of a line, and lines that are kept.
const LINE_POINTS: u32 = 4;
const LINES: u32 = 256;

/// A point processor, and how it is simulated.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// What is simulated.
    pub engine: SearchEngine,
    /// The hardware, but for its program; without one it follows from the points and from what is asked.
    pub hardware: Option<Config>,
    /// Cycles a neighbor, where the hardware follows from the points.
    pub rate: u32,
    /// How the tree is built.
    pub splitting: Splitting,
    /// How the memory answers.
    pub memory: MemorySettings,
    /// What a neighbor cache may answer.
    pub reuse: Reuse,
    /// Neighborhoods that the neighbor cache holds, where the hardware follows from the points.
    pub neighbor_cache: u32,
    /// How streams are held back.
    pub stall: Stall,
    /// Seed of all that is left to chance.
    pub seed: u64,
    /// The command to print when hardware and model differ.
    pub reproduce: String,
}

/// The point processor, its model, or both in lockstep.
pub struct Timed {
    simulation: Simulation,
    /// The last one.
    session: Mutex<Option<Arc<PointsSession>>>,
}

/// What a program took on the point processor.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// The program.
    pub program: String,
    /// Queries that left.
    pub queries: u64,
    /// Cycles from the first query to the last result.
    pub cycles: u64,
    /// Cycles a neighbor that the kernel is built for.
    pub rate: u32,
    /// Neighbors that the kernel took.
    pub neighbors: u64,
    /// Cycles in which a neighbor waited for the kernel.
    pub kernel_wait: u64,
    /// Iterations beyond the first of each query.
    pub again: u64,
    /// Lines of points that were there.
    pub line_hits: u64,
    /// Lines of points that were not.
    pub line_misses: u64,
    /// Searches that the neighbor cache spared.
    pub reused: u64,
    /// Searches that it did not.
    pub searched: u64,
    /// Bytes that the memory moved.
    pub bytes: u64,
    /// Cycles simulated, those that load the tree among them.
    pub simulated_cycles: u64,
    /// Time the simulation took.
    pub seconds: f64,
}

impl Timing {
    fn of(config: &Config, outcome: &PointsOutcome) -> Self {
        let events = outcome.counters.events(config);
        let (search, process) = (events.search, events.process);
        Self {
            program: config.process.program.name().to_owned(),
            queries: outcome.answers.len() as u64,
            cycles: outcome.counters.cycles,
            rate: config.process.rate,
            neighbors: process.kernel,
            kernel_wait: process.kernel_wait,
            again: process.again,
            line_hits: process.gather.hit,
            line_misses: process.gather.miss,
            reused: search.neighbor_cache.hit,
            searched: search.neighbor_cache.miss,
            bytes: outcome.counters.bytes,
            simulated_cycles: outcome.simulated_cycles,
            seconds: outcome.elapsed.as_secs_f64(),
        }
    }

    /// Cycles a query.
    #[must_use]
    pub fn cycles_per_query(&self) -> f64 {
        self.cycles as f64 / self.queries.max(1) as f64
    }

    /// Share of the cycles in which the kernel is busy with a neighbor.
    #[must_use]
    pub fn kernel_busy(&self) -> f64 {
        (self.neighbors * u64::from(self.rate)) as f64 / self.cycles.max(1) as f64
    }

    /// Share of the searches that the neighbor cache spared; none without one.
    #[must_use]
    pub fn saved(&self) -> Option<f64> {
        let all = self.reused + self.searched;
        (all > 0).then(|| self.reused as f64 / all as f64)
    }
}

impl Simulation {
    /// The point processor that follows from the points and from what is asked.
    #[must_use]
    pub fn of(engine: SearchEngine) -> Self {
        Self {
            engine,
            hardware: None,
            rate: 1,
            splitting: Splitting::Packed,
            memory: MemorySettings::default(),
            reuse: Reuse::default(),
            neighbor_cache: 0,
            stall: Stall::Never,
            seed: 1,
            reproduce: String::new(),
        }
    }

    /// The hardware for a job.
    #[must_use]
    pub fn config(&self, job: &Job<'_>) -> Config {
        let program = Arc::clone(job.program);
        if let Some(hardware) = &self.hardware {
            let process = process::Config { program, ..hardware.process.clone() };
            return Config { search: hardware.search.clone(), process };
        }
        let k = job.neighborhoods.k();
        let searched = if self.neighbor_cache > 0 && job.neighborhoods.radius().is_none() { k + 1 } else { k };
        let search = search::Config {
            geometry: job.format,
            neighbor_cache: self.neighbor_cache,
            ..config_for(job.points.len(), searched, self.splitting)
        };
        let process = process::Config {
            program,
            format: search.geometry,
            index_bits: search.index_bits,
            neighbors: search.neighbors,
            threads: THREADS,
            rate: self.rate,
            line_points: LINE_POINTS,
            cache_lines: LINES,
        };
        Config { search, process }
    }
}

impl Timed {
    /// Nothing is generated before the first job.
    #[must_use]
    pub const fn new(simulation: Simulation) -> Self {
        Self { simulation, session: Mutex::new(None) }
    }

    /// The session of a configuration: the last one, if it is that one.
    fn session(&self, config: Config) -> Result<Arc<PointsSession>, ProcessError> {
        let simulation = &self.simulation;
        let mut last = self.session.lock().expect("nobody panics while opening a session");
        if let Some(session) = last.as_ref().filter(|session| *session.config() == config) {
            return Ok(Arc::clone(session));
        }
        let session = PointsSession::open(config, simulation.memory, simulation.engine)?.reusing(simulation.reuse)?;
        let session = session.randomized(simulation.stall, simulation.seed).reproduced_by(simulation.reproduce.clone());
        Ok(Arc::clone(last.insert(Arc::new(session))))
    }
}

impl Engine for Timed {
    fn name(&self) -> &'static str {
        match self.simulation.engine {
            SearchEngine::Golden => "golden model of the point processor",
            SearchEngine::Hardware => "generated point processor",
            SearchEngine::Lockstep => "generated point processor in lockstep with its model",
        }
    }

    fn run(&self, job: &Job<'_>, progress: &(dyn Fn(u64) + Sync)) -> Result<Carried, ProcessError> {
        let config = self.simulation.config(job);
        let tree = Tree::build(&config.search, job.set, self.simulation.splitting)?;
        let session = self.session(config)?;
        let task = Task {
            settings: job.settings,
            iterations: job.iterations,
            queries: job.queries,
            points: job.points,
            k: job.neighborhoods.k(),
            radius: job.neighborhoods.radius(),
        };
        let queries = job.queries.len() as f64;
        let outcome = session.run(&tree, task, &|_, share| progress((share * queries) as u64))?;
        progress(job.queries.len() as u64);
        let timing = Some(Timing::of(session.config(), &outcome));
        Ok(Carried { answers: outcome.answers, timing })
    }
}
