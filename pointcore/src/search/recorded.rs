//! A short search, recorded at the ports of the golden model: the test that goes with generated Verilog.

use super::generate::SearchCore;
use super::reuse::QueryKind;
use super::run::SearchRunner;
use super::samples::queries_near;
use super::work::Work;
use super::{MemorySettings, PointSet, Reuse, SearchError, Splitting, Tree};
use crate::recording::Recording;
use fastrand::Rng;
use pointcore_contract::search::Config;
use pointcore_tb::lockstep::Stall;

/// Points of the search, unless the tree or the point memory hold less.
const POINTS: usize = 200;
/// Queries of the search.
const QUERIES: usize = 12;
/// Neighbors a query asks for at most.
const LARGEST_K: u32 = 8;
/// Radius of queries where all must have one.
const RADIUS: f32 = 0.4;
/// Latency of the memory: short, for the vectors shall be few.
const LATENCY_CYCLES: u64 = 8;
/// Idle cycles of every source and sink, so that streams are held back, too.
const STALLS: Stall = Stall::Random(0.2);
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
    let mut queries = queries_near(points.points(), config.neighbors.min(LARGEST_K), QUERIES, &mut random);
    let mut kind = QueryKind::Nearest;
    if config.neighbor_cache > 0 {
        // It takes queries of one kind, and balls at any k.
        kind = QueryKind::Ball;
        let k = config.neighbors.min(LARGEST_K);
        queries.iter_mut().for_each(|query| (query.k, query.radius) = (k, Some(RADIUS)));
    }
    let reuse = Reuse::default();
    let encoded = queries.iter().enumerate().map(|(index, query)| query.encode(config, reuse, index));
    let encoded = encoded.collect::<Result<Vec<_>, SearchError>>()?;
    let memory = MemorySettings { latency_cycles: LATENCY_CYCLES, ..MemorySettings::default() };
    let work = Work { config, tree: &tree, queries: &encoded, reuse, kind, memory };
    SearchRunner { work, stall: STALLS, seed: SEED, progress: &|_, _| {}, reproduce: "" }.record(core)
}
