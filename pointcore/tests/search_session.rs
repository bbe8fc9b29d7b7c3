//! Searches through the library: neighbors equal those of a search through all points, bit for bit, on model and hardware.

use pointcore::number::encode;
use pointcore::search::samples::{point_sets, queries_near};
use pointcore::search::{
    MemorySettings, Order, PointSet, PointSource, Query, Reuse, SearchEngine, SearchError, SearchOutcome, Session,
    Splitting, Tree, kdtree::depth_for,
};
use pointcore_contract::Format;
use pointcore_contract::search::Config;
use pointcore_golden::reference::neighbors::nearest;
use pointcore_tb::lockstep::{Stall, seed};

fn random() -> fastrand::Rng {
    fastrand::Rng::with_seed(seed().expect("POINTCORE_SEED is a number"))
}

fn sets(count: usize) -> Vec<(&'static str, Vec<[f32; 3]>)> {
    point_sets(count, &mut random())
}

fn queries(points: &[[f32; 3]], neighbors: u32, count: usize) -> Vec<Query> {
    queries_near(points, neighbors, count, &mut random())
}

/// Compares every neighbor with a search through all points; returns how many there are.
fn check(name: &str, config: &Config, points: &PointSet, queries: &[Query], outcome: &SearchOutcome) -> usize {
    let format = config.geometry;
    let encoded = points.encoded();
    let mut count = 0;
    for (index, (query, found)) in queries.iter().zip(&outcome.neighbors).enumerate() {
        let at = query.point.map(|number| encode(format, number));
        let radius2 = query.radius.map_or(format.infinity() as u32, |radius| encode(format, radius * radius));
        let expected = nearest(format, &encoded, at, query.k as usize, radius2);
        let expected: Vec<u32> = expected.iter().map(|neighbor| neighbor.distance2).collect();
        let distances: Vec<u32> = found.iter().map(|neighbor| encode(format, neighbor.distance2)).collect();
        assert_eq!(distances, expected, "{name}, query {index}: {query:?}");
        for neighbor in found {
            let distance2 = nearest(format, &encoded[neighbor.point as usize..][..1], at, 1, u32::MAX)[0].distance2;
            assert_eq!(distance2, encode(format, neighbor.distance2), "{name}, query {index}: {neighbor:?}");
        }
        let mut distinct: Vec<_> = found.iter().map(|neighbor| neighbor.point).collect();
        distinct.sort_unstable();
        distinct.dedup();
        assert_eq!(distinct.len(), found.len(), "{name}, query {index}: a neighbor is found once");
        count += found.len();
    }
    count
}

fn open(
    config: &Config,
    points: &PointSet,
    splitting: Splitting,
    memory: MemorySettings,
    engine: SearchEngine,
) -> Session {
    let tree = Tree::build(config, points, splitting).unwrap_or_else(|error| panic!("{error}"));
    Session::open(config.clone(), tree, memory, engine).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn neighbors_in_sets_of_all_kinds_equal_brute_force() {
    const POINTS: usize = 700;
    let memories = [
        MemorySettings::default(),
        MemorySettings { latency_cycles: 300, reorder_window: 8, ..MemorySettings::default() },
        MemorySettings { latency_cycles: 1, bytes_per_cycle: Some(2.5), burst_bytes: 64, reorder_window: 3 },
    ];
    let formats = [Format::F32.flushed(), Format::F32, Format::F24, Format::F24.flushed()];
    let splittings = [Splitting::Median, Splitting::Packed, Splitting::Midpoint];
    for (index, (name, cloud)) in sets(POINTS).iter().enumerate() {
        for (lanes, splitting) in [1, 4, 8].into_iter().zip(splittings) {
            let config = Config {
                geometry: formats[(index + lanes as usize) % formats.len()],
                lanes,
                bucket: 5 + 3 * lanes,
                tree_depth: depth_for(POINTS, 5 + 3 * lanes) + (index % 2) as u32,
                leaves_in_flight: 1 + index as u32 % 3,
                ..Config::default()
            };
            let points = PointSet::new(config.geometry, cloud).expect("the points are finite");
            let queries = queries(cloud, config.neighbors, 60);
            let memory = memories[(index + lanes as usize) % memories.len()];
            let session =
                open(&config, &points, splitting, memory, SearchEngine::Golden).randomized(Stall::Random(0.2), 3);
            let outcome = session.search(&queries).unwrap_or_else(|error| panic!("{error}"));
            let found = check(name, &config, &points, &queries, &outcome);
            assert!(found > 100, "{found} neighbors in {name}");
            assert_eq!(outcome.counters.results, found as u64);
        }
    }
}

/// Every plane of a lattice's tree goes through points or between two layers of them; so do the queries, and some radii end exactly there.
#[test]
fn queries_on_splitting_planes_equal_brute_force() {
    const EDGE: u16 = 6;
    let cloud: Vec<[f32; 3]> =
        (0..EDGE.pow(3)).map(|i| [i % EDGE, i / EDGE % EDGE, i / EDGE / EDGE].map(f32::from)).collect();
    let steps = || (0..2 * EDGE).map(|step| f32::from(step) / 2.0);
    let radii = [None, Some(1.0), Some(f32::EPSILON), Some(0.5)];
    let queries: Vec<Query> = steps()
        .flat_map(|x| steps().map(move |y| [x, y, 2.5]))
        .zip(radii.into_iter().cycle())
        .map(|(point, radius)| Query { point, k: 8, radius })
        .collect();
    for splitting in [Splitting::Median, Splitting::Packed, Splitting::Midpoint] {
        let config = Config { bucket: 4, tree_depth: depth_for(cloud.len(), 4) + 2, ..Config::default() };
        let points = PointSet::new(config.geometry, &cloud).expect("the points are finite");
        let outcome =
            open(&config, &points, splitting, MemorySettings::default(), SearchEngine::Golden).search(&queries);
        let outcome = outcome.unwrap_or_else(|error| panic!("{error}"));
        assert!(check("lattice", &config, &points, &queries, &outcome) > queries.len());
    }
}

#[test]
fn hardware_answers_as_its_model_in_every_cycle() {
    const POINTS: usize = 200;
    let config = Config { lanes: 2, bucket: 8, tree_depth: 6, neighbors: 9, threads: 4, ..Config::default() };
    for (name, cloud) in sets(POINTS) {
        let points = PointSet::new(config.geometry, &cloud).expect("the points are finite");
        let queries = queries(&cloud, config.neighbors, 25);
        let memory = MemorySettings { reorder_window: 4, ..MemorySettings::default() };
        let search = |engine| {
            let session = open(&config, &points, Splitting::Packed, memory, engine).randomized(Stall::Random(0.1), 5);
            session.search(&queries).unwrap_or_else(|error| panic!("{name}: {error}"))
        };
        let [golden, hardware, lockstep] =
            [SearchEngine::Golden, SearchEngine::Hardware, SearchEngine::Lockstep].map(search);
        check(name, &config, &points, &queries, &golden);
        for other in [hardware, lockstep] {
            assert_eq!((&other.neighbors, &other.counters), (&golden.neighbors, &golden.counters), "{name}");
            assert_eq!(other.simulated_cycles, golden.simulated_cycles);
        }
    }
}

#[test]
fn numbers_may_repeat_while_queries_are_under_way() {
    // Four bits tell 16 queries apart; 32 threads would take more.
    let config = Config { threads: 32, index_bits: 4, bucket: 8, tree_depth: 1, ..Config::default() };
    let cloud: Vec<_> = (0..16_u8).map(|x| [f32::from(x), 0.0, 0.0]).collect();
    let points = PointSet::new(config.geometry, &cloud).expect("the points are finite");
    let queries = queries(&cloud, config.neighbors, 100);
    let session = open(&config, &points, Splitting::Median, MemorySettings::default(), SearchEngine::Golden);
    let outcome = session.search(&queries).unwrap_or_else(|error| panic!("{error}"));
    assert!(check("few numbers", &config, &points, &queries, &outcome) > 100);
    assert!(session.search(&[]).unwrap_or_else(|error| panic!("{error}")).neighbors.is_empty());
}

#[test]
fn what_has_no_answer_is_refused() {
    let config = Config { tree_depth: 1, ..Config::default() };
    let points = PointSet::new(config.geometry, &[[0.0; 3]]).expect("the point is finite");
    let session = open(&config, &points, Splitting::Median, MemorySettings::default(), SearchEngine::Golden);
    let sound = Query { point: [1.0; 3], k: 1, radius: None };
    let refused = session.search(&[sound, Query { k: 17, ..sound }]);
    assert!(matches!(refused, Err(SearchError::Query { index: 1, .. })));
    let tree = Tree::build(&config, &points, Splitting::Median).expect("one point fits");
    let other = Config { lanes: 4, ..config };
    let refused = Session::open(other, tree, MemorySettings::default(), SearchEngine::Golden);
    assert!(matches!(refused.err(), Some(SearchError::OtherTree)));
}

/// Runs of queries that take turns.
const RUNS: usize = 7;

/// Queries spread around points, for 6 neighbors or within a radius, each asked again next in its run.
fn coherent(points: &PointSet, radius: Option<f32>) -> Vec<Query> {
    let places = Order::Grid { columns: 8, rows: 8 }.places(points, Some(300), 1);
    let query = |place| Query { point: points.rounded(place), k: 6, radius };
    places.into_iter().flat_map(|place| [query(place); 2]).collect()
}

#[test]
fn caches_leave_answers_exact() {
    let small = Config { bucket: 8, tree_depth: 7, threads: 2, ..Config::default() };
    let configs = [
        Config { tree_cache: 32, ..small.clone() },
        Config { tree_cache: 256, point_cache: 0, lanes: 4, ..small.clone() },
        Config { neighbor_cache: 16, ..small.clone() },
        Config { neighbor_cache: 12, tree_cache: 64, geometry: Format::F24, ..small },
    ];
    let memory = MemorySettings { latency_cycles: 30, reorder_window: 4, burst_bytes: 32, ..MemorySettings::default() };
    for config in configs {
        let points = PointSet::load(config.geometry, &PointSource::Surface(1000)).expect("the surface is finite");
        for radius in [None, Some(0.2)] {
            let queries = coherent(&points, radius);
            let session = open(&config, &points, Splitting::Median, memory, SearchEngine::Golden)
                .randomized(Stall::Random(0.1), 2)
                .interleaved(RUNS);
            let outcome = session.search(&queries).unwrap_or_else(|error| panic!("{error}"));
            assert!(check("surface", &config, &points, &queries, &outcome) > 1000);
            let events = outcome.counters.events(&config);
            for (size, hits) in
                [(config.tree_cache, events.tree_cache.hit), (config.neighbor_cache, events.neighbor_cache.hit)]
            {
                assert_eq!(hits > 10, size > 0, "{hits} hits with {config:?}, radius {radius:?}");
            }
            assert_eq!(outcome.counters.records, events.tree_cache.miss);
        }
    }
}

#[test]
fn hardware_with_every_cache_answers_as_its_model() {
    let config = Config {
        bucket: 8,
        tree_depth: 6,
        threads: 4,
        neighbors: 7,
        neighbor_cache: 4,
        tree_cache: 32,
        point_cache: 8,
        ..Config::default()
    };
    let points = PointSet::load(config.geometry, &PointSource::Surface(500)).expect("the surface is finite");
    for radius in [None, Some(0.3)] {
        let queries = coherent(&points, radius);
        let search = |engine| {
            let session =
                open(&config, &points, Splitting::Packed, MemorySettings::default(), engine).interleaved(RUNS);
            session.search(&queries).unwrap_or_else(|error| panic!("{error}"))
        };
        let [golden, lockstep] = [SearchEngine::Golden, SearchEngine::Lockstep].map(search);
        assert!(check("surface", &config, &points, &queries, &lockstep) > 1000);
        assert_eq!((&lockstep.neighbors, &lockstep.counters), (&golden.neighbors, &golden.counters));
    }
}

#[test]
fn approximate_neighbors_keep_their_tolerance() {
    const EPSILON: f32 = 0.5;
    let config = Config { bucket: 8, tree_depth: 7, threads: 2, neighbor_cache: 8, ..Config::default() };
    let points = PointSet::load(config.geometry, &PointSource::Surface(1000)).expect("the surface is finite");
    let queries = coherent(&points, None);
    let hits = |epsilon| {
        let session = open(&config, &points, Splitting::Median, MemorySettings::default(), SearchEngine::Golden);
        let session = session.reusing(Reuse { epsilon, ..Reuse::default() }).expect("the tolerance is valid");
        let session = session.interleaved(RUNS);
        let outcome = session.search(&queries).unwrap_or_else(|error| panic!("{error}"));
        let checked = pointcore::search::check(&points, &queries, &outcome.neighbors, epsilon);
        let checked = checked.unwrap_or_else(|difference| panic!("{difference}"));
        assert_eq!(checked.exact == queries.len(), epsilon == 0.0, "{checked:?}");
        outcome.counters.events(&config).neighbor_cache.hit
    };
    let (exact, approximate) = (hits(0.0), hits(EPSILON));
    assert!(exact < approximate, "{exact} hits exactly, {approximate} with tolerance");
}

#[test]
fn queries_of_a_neighbor_cache_are_alike() {
    let config = Config { tree_depth: 1, neighbor_cache: 2, ..Config::default() };
    let points = PointSet::new(config.geometry, &[[0.0; 3]]).expect("the point is finite");
    let session = open(&config, &points, Splitting::Median, MemorySettings::default(), SearchEngine::Golden);
    let query = Query { point: [1.0; 3], k: 1, radius: None };
    let refused = session.search(&[query, Query { radius: Some(1.0), ..query }]);
    assert!(matches!(refused, Err(SearchError::Query { index: 1, .. })));
}
