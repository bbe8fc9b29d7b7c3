//! The composed model of the search core: its answers equal those of a brute-force search whatever the timing, and always come.

mod driver;
mod neighbor_cache;
mod tree;

use driver::{Answer, Bench, Surroundings};
use fastrand::Rng;
use pointcore_contract::Format;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::Query;
use pointcore_golden::reference::neighbors;
use pointcore_golden::search::Latencies;
use pointcore_golden::search::leaf::squared_distance;
use std::collections::HashSet;
use tree::{Tree, build, encode};

/// Pipelines of plausible lengths.
const LATENCIES: Latencies = Latencies { path: 9, distance: 15, neighbor_cache: None };

/// Random configurations that are tried.
const CONFIGURATIONS: u32 = 100;

fn first_seed() -> u64 {
    let seed = std::env::var("POINTCORE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    println!("reproduce with POINTCORE_SEED={seed} cargo test -p pointcore-golden --test search");
    seed
}

/// Points in a cube, some of them on a coarse lattice: equal distances, points on planes and equal points.
fn cloud(count: usize, random: &mut Rng) -> Vec<[f32; 3]> {
    let mut point = |index: usize| {
        let point = [(); 3].map(|()| random.f32() * 2.0 - 1.0);
        if index.is_multiple_of(3) { point.map(|number| (number * 4.0).round() / 4.0) } else { point }
    };
    (0..count).map(&mut point).collect()
}

/// Queries at points and between them.
fn queries(config: &Config, points: &[[f32; 3]], count: u32, random: &mut Rng) -> Vec<Query> {
    (0..count)
        .map(|number| {
            let point = points[random.usize(..points.len())];
            let offset = if random.bool() { random.f32() * 0.3 } else { 0.0 };
            let radius2 = match random.u8(0..3) {
                0 => f32::INFINITY,
                _ => random.f32().powi(4) * 3.0,
            };
            Query {
                number,
                k: random.u32(1..=config.neighbors) as u8,
                radius2: encode(config.geometry, radius2),
                point: point.map(|coordinate| encode(config.geometry, coordinate + offset)),
            }
        })
        .collect()
}

/// Every query is answered once, by neighbors that are there, at the distances that a search through all points finds.
fn check(config: &Config, tree: &Tree, queries: &[Query], answers: &[Answer]) {
    assert_eq!(answers.len(), queries.len());
    let numbers: HashSet<_> = answers.iter().map(|answer| answer.number).collect();
    assert_eq!(numbers.len(), queries.len(), "a query is answered once");
    for Answer { number, neighbors, .. } in answers {
        let query = &queries[*number as usize];
        let k = usize::from(query.k);
        let nearest = neighbors::nearest(config.geometry, &tree.points, query.point, k, query.radius2);
        let expected: Vec<_> = nearest.iter().map(|neighbor| neighbor.distance2).collect();
        let distances: Vec<_> = neighbors.iter().map(|(_, distance2)| *distance2).collect();
        assert_eq!(distances, expected, "{query:?} with {config:?}");
        let indices: HashSet<_> = neighbors.iter().map(|(index, _)| *index).collect();
        assert_eq!(indices.len(), neighbors.len(), "a neighbor is found once");
        for (index, distance2) in neighbors {
            let point = tree.points[*index as usize];
            assert_eq!(squared_distance(config.geometry, point, query.point), *distance2);
        }
    }
}

/// What runs have counted.
#[derive(Debug, Default)]
struct Counts {
    neighbors: usize,
    internal_leaves: usize,
    point_hits: u64,
    tree_hits: u64,
}

impl Counts {
    /// Asks a random tree the same queries twice, in random surroundings, and checks the answers.
    fn run(&mut self, config: &Config, latency: u64, random: &mut Rng) {
        assert_eq!(config.validate(), Ok(()));
        let capacity = (config.bucket as usize) << config.tree_depth;
        let mut points = cloud(random.usize(1..=capacity.min(400)), random);
        let tree = build(config, &mut points, random);
        let queries = queries(config, &points, 30, random);
        // The distance to a point takes the operations of that to a plane, and more.
        let path = random.u32(1..20);
        let latencies = Latencies { path, distance: path + random.u32(0..20), neighbor_cache: None };
        let surroundings = Surroundings { latency, pauses: random.u8(0..6) };
        let mut bench = Bench::new(config, latencies, &tree, surroundings, random.u64(..));
        for _ in 0..2 {
            let answers = bench.search(&queries);
            check(config, &tree, &queries, &answers);
            self.neighbors += answers.iter().map(|answer| answer.neighbors.len()).sum::<usize>();
        }
        assert!(config.point_cache > 0 || bench.point_hits == 0);
        assert!(config.tree_cache > 0 || bench.tree_hits == 0);
        self.internal_leaves += tree.internal_leaves;
        self.point_hits += bench.point_hits;
        self.tree_hits += bench.tree_hits;
    }
}

#[test]
fn answers_equal_a_search_through_all_points_with_and_without_every_part() {
    let mut random = Rng::with_seed(first_seed());
    let formats = [Format::F32.flushed(), Format::F24, Format::F32, Format::F24.flushed()];
    let sizes = [(1, 1, 1), (32, 64, 4), (16, 16, 2), (3, 7, 3), (2, 33, 1), (8, 10, 4)].into_iter().cycle();
    let parts =
        [0, 2, 8, 64].into_iter().flat_map(|point_cache| [0, 16, 256].map(|tree_cache| (point_cache, tree_cache)));
    let parts = parts.flat_map(|parts| [1, 2, 4, 8].map(|lanes| (parts, lanes)));
    let mut counts = Counts::default();
    for (index, (parts, (threads, neighbors, leaves_in_flight))) in parts.zip(sizes).enumerate() {
        let ((point_cache, tree_cache), lanes) = parts;
        let config = Config {
            geometry: formats[random.usize(..formats.len())],
            threads,
            neighbors,
            lanes,
            tree_depth: random.u32(6..9),
            bucket: random.u32(4..20),
            leaves_in_flight,
            point_cache,
            tree_cache,
            ..Config::default()
        };
        counts.run(&config, [1, 30, 500][index / 4 % 3], &mut random);
    }
    println!("{counts:?}");
    assert!(counts.neighbors > 10_000 && counts.internal_leaves > 100);
    assert!(counts.point_hits > 1000 && counts.tree_hits > 10_000);
}

#[test]
fn searches_end_in_any_configuration() {
    let mut random = Rng::with_seed(first_seed());
    let mut counts = Counts::default();
    for _ in 0..CONFIGURATIONS {
        let config = Config {
            geometry: [Format::F32.flushed(), Format::F24, Format::F32, Format::F24.flushed()][random.usize(..4)],
            threads: random.u32(1..=32),
            neighbors: random.u32(1..=64),
            lanes: 1 << random.u32(0..=3),
            tree_depth: random.u32(1..=10),
            bucket: random.u32(1..=40),
            leaves_in_flight: random.u32(1..=4),
            point_cache: if random.bool() { 1 << random.u32(1..=8) } else { 0 },
            tree_cache: if random.bool() { 1 << random.u32(4..=10) } else { 0 },
            ..Config::default()
        };
        counts.run(&config, random.u64(1..=500), &mut random);
    }
    println!("{counts:?}");
    assert!(counts.neighbors > 10_000 && counts.point_hits > 1000 && counts.tree_hits > 10_000);
}

/// Cycles for the same queries in a memory of long latency.
fn cycles(threads: u32, leaves_in_flight: u32) -> u64 {
    let config = Config { threads, leaves_in_flight, tree_depth: 6, neighbors: 8, point_cache: 0, ..Config::default() };
    let mut random = Rng::with_seed(first_seed());
    let mut points = cloud(800, &mut random);
    let tree = build(&config, &mut points, &mut random);
    let queries = queries(&config, &points, 100, &mut random);
    let surroundings = Surroundings { latency: 400, pauses: 0 };
    let mut bench = Bench::new(&config, LATENCIES, &tree, surroundings, 1);
    let answers = bench.search(&queries);
    check(&config, &tree, &queries, &answers);
    assert!(bench.visits > 1000 && bench.beats > 1000, "{} nodes visited, {} beats", bench.visits, bench.beats);
    bench.cycles
}

#[test]
fn threads_and_leaves_in_flight_hide_the_memorys_latency() {
    let (lonely, eager, many) = (cycles(1, 1), cycles(1, 3), cycles(16, 1));
    println!("{lonely} cycles; {eager} with three leaves in flight, {many} with sixteen threads");
    assert!(many * 5 < lonely, "sixteen threads overlap their fetches");
    assert!(eager < lonely, "so do the leaves of one");
}
