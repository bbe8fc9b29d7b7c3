//! Short runs, recorded at the ports of the golden model: the test that goes with generated Verilog.

use super::generate::PointsCore;
use super::host::{PointsHost, Task, Work};
use crate::number::encode;
use crate::recording::{Recorder, Recording};
use crate::search::{MemorySettings, PointSet, Reuse, SearchError, Splitting, Tree};
use fastrand::Rng;
use pointcore_contract::points::{Config, units};
use pointcore_contract::process::{Scalar, Word};
use pointcore_golden::points::Top;
use pointcore_tb::lockstep::{Flow, Stall, Stalls};

/// Runs, each with points of its own.
const RUNS: u64 = 12;
const POINTS: usize = 60;
const QUERIES: usize = 12;
const ITERATIONS: u32 = 3;
const LATENCY_CYCLES: u64 = 12;

/// A word of a program that is no extreme.
fn word(config: &Config, random: &mut Rng, Word { ty, .. }: &Word) -> u32 {
    match ty {
        Scalar::Float => encode(config.process.format, 2.0 * random.f32() - 1.0),
        Scalar::Int => random.u32(..),
        Scalar::Bool => random.u32(..2),
    }
}

/// Records runs on the hardware of a configuration.
///
/// # Errors
/// The core is stuck.
pub fn record(config: &Config, core: &PointsCore) -> Result<Recording, SearchError> {
    let mut recorder = Recorder::new(config, &units::top::UNIT, Top::new(config, core.latencies()));
    for seed in 0..RUNS {
        let random = &mut Rng::with_seed(seed);
        let Config { search, process } = config;
        let program = &process.program;
        let most = ((search.bucket as usize) << search.tree_depth).min(1 << (search.index_bits - 1));
        let point = |_| std::array::from_fn(|_| 2.0 * random.f32() - 1.0);
        let set = PointSet::new(search.geometry, &(0..POINTS.min(most)).map(point).collect::<Vec<_>>())?;
        let tree = Tree::build(search, &set, Splitting::Median)?;
        let mut words = |layout: &[Word]| layout.iter().map(|item| word(config, random, item)).collect::<Vec<u32>>();
        let attributes = program.neighbor.words().split_off(3);
        let points: Vec<Vec<u32>> =
            set.encoded().iter().map(|position| [&position[..], &words(&attributes)].concat()).collect();
        let settings = words(&program.settings.words());
        let queries: Vec<Vec<u32>> = (0..QUERIES).map(|_| words(&program.query.words())).collect();
        let largest = search.neighbors - u32::from(search.neighbor_cache > 0);
        let k = random.u32(1..=largest.max(1));
        let radius = random.bool().then_some(0.7);
        let task = Task { settings: &settings, iterations: ITERATIONS, queries: &queries, points: &points, k, radius };
        let memory = MemorySettings { latency_cycles: LATENCY_CYCLES, ..MemorySettings::default() };
        let work = Work { config, tree: &tree, task, reuse: Reuse::default(), memory };
        let stalls = Stalls::new(Stall::Varied, random.fork());
        let mut host = PointsHost::new(work, stalls, seed, &|_, _| {});
        // Caches forget the points of the run before.
        recorder.reset();
        let mut cycle = 0;
        while recorder.drive(cycle, &mut host) == Flow::Continue {
            cycle += 1;
        }
        if host.is_stuck {
            return Err(SearchError::Stuck { cycle, answered: host.answered, queries: QUERIES });
        }
    }
    Ok(recorder.into_recording())
}
