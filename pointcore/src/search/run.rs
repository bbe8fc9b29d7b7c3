//! Queries on the hardware, on its golden model, or on both in lockstep.

use super::SearchError;
use super::counters::SearchCounters;
use super::generate::SearchCore;
use super::host::{End, SearchHost};
use super::query::Neighbor;
use super::work::Work;
use crate::generated::Progress;
use crate::waveform::Waveform;
use pointcore_golden::search::Top;
use pointcore_golden::search::top::Out;
use pointcore_golden::unit::{Model, Ported, Unit};
use pointcore_tb::lockstep::{Flow, Lockstep, RESET_CYCLES, Stall, Stalls, Stimulus};
use pointcore_tb::verilated::Library;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What a run brought.
#[derive(Clone, Debug)]
pub struct SearchOutcome {
    /// Neighbors by query, nearest first.
    pub neighbors: Vec<Vec<Neighbor>>,
    /// Cycles of each query, from its offer to its last result: those in which others are under way, too.
    pub query_cycles: Vec<u32>,
    /// What the host counted.
    pub counters: SearchCounters,
    /// Cycles simulated, those that load the tree among them.
    pub simulated_cycles: u64,
    /// Time the simulation took.
    pub elapsed: Duration,
}

/// Queries ready to be run, on one engine or another, with one pattern of stalls or another.
#[derive(Clone)]
pub struct SearchRunner<'a> {
    /// Tree, queries, memory.
    pub work: Work<'a>,
    /// When the host holds back.
    pub stall: Stall,
    /// Seed of the stalls, of the memory's order and of the hardware's uninitialized values.
    pub seed: u64,
    /// Hears of the progress.
    pub progress: Progress<'a>,
    /// The command that makes this run, printed with a failure.
    pub reproduce: &'a str,
}

impl<'a> SearchRunner<'a> {
    fn host(&self) -> SearchHost<'a> {
        let stalls = Stalls::new(self.stall, fastrand::Rng::with_seed(self.seed));
        SearchHost::new(self.work, stalls, self.seed, self.progress)
    }

    /// The golden model alone.
    ///
    /// # Errors
    /// The core is stuck.
    pub fn golden(&self, core: &SearchCore) -> Result<SearchOutcome, SearchError> {
        let started = Instant::now();
        let mut top = Top::new(self.work.config, core.latencies());
        let mut host = self.host();
        let (mut cycle, mut outputs) = (0, Out::default());
        while host.drive(cycle, &outputs) == Flow::Continue {
            outputs = top.outputs();
            top.clock(host.inputs());
            cycle += 1;
        }
        finish(host, cycle, started)
    }

    /// The hardware alone, with a waveform if one is asked for.
    ///
    /// # Errors
    /// An assertion of the hardware fails, or the core is stuck.
    pub fn hardware(&self, library: &Arc<Library>, waveform: Option<&Waveform>) -> Result<SearchOutcome, SearchError> {
        let started = Instant::now();
        let mut model = library.instantiate(self.seed);
        if let Some(waveform) = waveform {
            waveform.begin(&mut model)?;
        }
        let (mut inputs, mut outputs) = (library.reset_inputs(), vec![0; library.outputs().len()]);
        for _ in 0..RESET_CYCLES {
            model.step(&inputs, &mut outputs)?;
        }
        inputs.fill(0);
        let mut host = self.host();
        let mut cycle = 0;
        while Stimulus::drive(&mut host, cycle, &outputs, &mut inputs) == Flow::Continue {
            if let Some(waveform) = waveform {
                waveform.before(cycle, &mut model)?;
            }
            model.step(&inputs, &mut outputs)?;
            cycle += 1;
        }
        finish(host, cycle, started)
    }

    /// Hardware and model, every output compared in every cycle.
    ///
    /// # Errors
    /// The first difference, or the core is stuck.
    pub fn lockstep(&self, core: &SearchCore, library: &Arc<Library>) -> Result<SearchOutcome, SearchError> {
        let started = Instant::now();
        let mut golden = Ported::new(self.work.config, Top::new(self.work.config, core.latencies()));
        let golden = move |inputs: &[u64], outputs: &mut [u64]| golden.step(inputs, outputs);
        // The host finds out by itself when nothing moves.
        let lockstep = Lockstep::new(library, golden, self.seed).limit(u64::MAX);
        let run = lockstep.reproduced_by(self.reproduce.to_owned()).run(self.host())?;
        finish(run.stimulus, run.report.cycles, started)
    }
}

fn finish(host: SearchHost, cycle: u64, started: Instant) -> Result<SearchOutcome, SearchError> {
    if host.end == Some(End::Stuck) {
        return Err(SearchError::Stuck { cycle, answered: host.answered(), queries: host.queries() });
    }
    let (counters, neighbors, query_cycles) = host.into_results();
    Ok(SearchOutcome { neighbors, query_cycles, counters, simulated_cycles: cycle, elapsed: started.elapsed() })
}
