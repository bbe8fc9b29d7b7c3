//! Short searches, recorded at the ports of the golden model: the test that goes with generated Verilog.

use super::SearchError;
use super::generate::SearchCore;
use crate::recording::{Recorder, Recording};
use crate::stimuli::pace::Paces;
use crate::stimuli::searcher::{Answers, BEAT, Bounds, FETCH, QUERY, RESULT, STREAMS, Script, Searcher};
use crate::stimuli::surroundings::Surroundings;
use fastrand::Rng;
use pointcore_contract::search::{Config, units};
use pointcore_golden::search::Top;
use pointcore_tb::lockstep::Flow;

/// Runs, each with a tree of its own: what a fault needs to show comes in one of them.
const RUNS: u64 = 112;
/// How much there is in a run.
const BOUNDS: Bounds = Bounds { searches: 2, points: 60, queries: 8, latency_cycles: 20, reset_cycles: 2000 };
/// One of so many runs has more of everything, and a memory that answers at once: queues inside the core fill.
const BUSY_EVERY: u64 = 4;
/// One more of as many is so, but for one of these streams, which hardly moves: what is before it fills.
const NARROW: [usize; 4] = [FETCH, RESULT, BEAT, QUERY];
const BUSY: Bounds = Bounds { points: 200, queries: 16, ..BOUNDS };
const AT_ONCE: Answers = Answers { latency: 1, window: 1 };
/// Cycles without a transfer after which the model is stuck: streams are held for hundreds.
const QUIET_CYCLES: u64 = 20_000;

/// Records searches on the hardware of a configuration.
///
/// # Errors
/// The core is stuck.
pub fn record(config: &Config, core: &SearchCore) -> Result<Recording, SearchError> {
    let mut recorder = Recorder::new(config, &units::top::UNIT, Top::new(config, core.latencies()));
    for seed in 0..RUNS {
        let mut random = Rng::with_seed(seed);
        let free = || Paces::in_turns(STREAMS, None);
        let busy = |random: &mut Rng, paces| Script { paces, answers: AT_ONCE, ..Script::random(config, BUSY, random) };
        let script = match seed % BUSY_EVERY {
            0 => busy(&mut random, free()),
            1 => {
                let narrow = NARROW[(seed / BUSY_EVERY) as usize % NARROW.len()];
                let paces = free().hardly(narrow, &mut random);
                busy(&mut random, paces)
            }
            _ => Script::random(config, BOUNDS, &mut random),
        };
        let mut host = Searcher::new(config, script, None, QUIET_CYCLES, random);
        // Caches forget the tree of the run before.
        recorder.reset();
        let mut cycle = 0;
        while recorder.drive(cycle, &mut host) == Flow::Continue {
            cycle += 1;
        }
        if let Some(cycle) = host.stuck() {
            let pending = host.pending();
            return Err(SearchError::Stuck { cycle, answered: pending.done, queries: pending.expected });
        }
    }
    Ok(recorder.into_recording())
}
