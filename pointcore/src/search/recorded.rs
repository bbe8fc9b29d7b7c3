//! A short search, recorded at the ports of the golden model: the test that goes with generated Verilog.
//!
//! It is to notice faults, so nothing in it is always the same: [`Scattered`] says how.

use super::generate::SearchCore;
use super::host::{End, SearchHost};
use super::reuse::QueryKind;
use super::samples::queries_near;
use super::scattered::Scattered;
use super::work::Work;
use super::{MemorySettings, PointSet, Query, Reuse, SearchError, Splitting, Tree};
use crate::recording::Recording;
use fastrand::Rng;
use pointcore_contract::search::{Config, units};
use pointcore_contract::{count, read, write};
use pointcore_golden::search::Top;
use pointcore_golden::search::top::Out;
use pointcore_golden::unit::{Ported, Unit};
use pointcore_tb::lockstep::{Flow, Stall, Stalls};

/// Points of the search, unless the tree or the point memory hold less.
const POINTS: usize = 200;
/// Queries of each search.
const QUERIES: usize = 24;
/// Neighbors a query asks for at most.
const LARGEST_K: u32 = 8;
/// Radius of queries where all must have one.
const RADIUS: f32 = 0.4;
/// The searches: when sources and sinks idle, cycles of the memory's latency, and among how many requests it chooses the
/// next that it answers. Latencies are short, for the recording shall be.
const SEARCHES: [(Stall, u64, usize); 3] =
    [(Stall::Random(0.2), 8, 3), (Stall::Bursts(40), 2, 1), (Stall::Random(0.6), 4, 2)];
/// The seed of points, queries and stalls.
const SEED: u64 = 1;

/// Records a search on the hardware of a configuration.
///
/// # Errors
/// The configuration is not valid, or the core is stuck.
pub fn record(config: &Config, core: &SearchCore) -> Result<Recording, SearchError> {
    let mut random = Rng::with_seed(SEED);
    // A beat may hold a single point.
    let held =
        ((config.bucket as usize) << config.tree_depth).min((1_usize << config.index_bits) / config.lanes as usize);
    let places: Vec<_> = (0..POINTS.min(held)).map(|_| [(); 3].map(|()| 2.0 * random.f32() - 1.0)).collect();
    let points = PointSet::new(config.geometry, &places)?;
    let tree = Tree::build(config, &points, Splitting::Packed)?;
    let scattered = Scattered::new(config, &tree, &mut random);
    let mut recorder = Recorder::new(config, core, scattered);
    for (stall, latency_cycles, reorder_window) in SEARCHES {
        let (queries, kind) = queries(config, &points, &mut random);
        let reuse = Reuse::default();
        let encoded = queries.iter().enumerate().map(|(index, query)| query.encode(config, reuse, index));
        let encoded = encoded.collect::<Result<Vec<_>, SearchError>>()?;
        let memory = MemorySettings { latency_cycles, reorder_window, ..MemorySettings::default() };
        recorder.run(Work { config, tree: &tree, queries: &encoded, reuse, kind, memory }, stall)?;
    }
    Ok(recorder.recording)
}

/// Queries near the points; a neighbor cache takes those of one kind, and balls at any k.
fn queries(config: &Config, points: &PointSet, random: &mut Rng) -> (Vec<Query>, QueryKind) {
    let k = config.neighbors.min(LARGEST_K);
    let mut queries = queries_near(points.points(), k, QUERIES, random);
    if config.neighbor_cache == 0 {
        return (queries, QueryKind::Nearest);
    }
    queries.iter_mut().for_each(|query| (query.k, query.radius) = (k, Some(RADIUS)));
    (queries, QueryKind::Ball)
}

/// The golden model, one search after the other.
struct Recorder<'a> {
    config: &'a Config,
    golden: Ported<Top>,
    scattered: Scattered,
    inputs: Vec<u64>,
    outputs: Vec<u64>,
    recording: Recording,
}

impl<'a> Recorder<'a> {
    fn new(config: &'a Config, core: &SearchCore, scattered: Scattered) -> Self {
        let list = units::top::UNIT.ports(config);
        let (inputs, outputs) = count(&list);
        Self {
            config,
            golden: Ported::new(config, Top::new(config, core.latencies())),
            scattered,
            inputs: vec![0; inputs],
            outputs: vec![0; outputs],
            recording: Recording::new(list),
        }
    }

    fn run(&mut self, work: Work, stall: Stall) -> Result<(), SearchError> {
        let stalls = Stalls::new(stall, Rng::with_seed(SEED));
        let mut host = SearchHost::new(work, stalls, SEED, &|_, _| {});
        let (mut cycle, mut seen) = (0, Out::default());
        while host.drive(cycle, &seen) == Flow::Continue {
            // The reset comes first.
            write(self.config, self.scattered.inputs(host.inputs()), &mut self.inputs[1..]);
            self.golden.step(&self.inputs, &mut self.outputs);
            self.recording.push(&self.inputs, &self.outputs);
            seen = self.scattered.outputs(&read(self.config, &self.outputs));
            cycle += 1;
        }
        if host.end == Some(End::Stuck) {
            return Err(SearchError::Stuck { cycle, answered: host.answered(), queries: host.queries() });
        }
        Ok(())
    }
}
