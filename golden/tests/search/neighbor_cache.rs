//! With a neighbor cache: what a reused neighborhood promises holds for every answer.

use crate::driver::{Answer, Bench, Surroundings};
use crate::tree::{Tree, build, decode, encode};
use crate::{cloud, first_seed};
use fastrand::Rng;
use pointcore_contract::Format;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{CacheSetup, CachedQuery, Query};
use pointcore_golden::reference::neighbors::{BruteForce, Neighbor, nearest_f64};
use pointcore_golden::search::leaf::squared_distance;
use pointcore_golden::search::{CacheLatencies, Latencies};
use std::collections::HashSet;

const FORMATS: [Format; 4] = [Format::F32.flushed(), Format::F24, Format::F32, Format::F24.flushed()];

/// Threads, neighbors, neighborhoods cached.
const SIZES: [(u32, u32, u32); 8] =
    [(1, 2, 1), (16, 16, 8), (4, 9, 2), (32, 64, 32), (32, 8, 1), (1, 20, 32), (7, 33, 8), (16, 4, 2)];

/// By how much `far_scale` is below its due, so that rounding never covers too much: eight units in the last place.
fn slack(format: Format) -> f32 {
    8.0 / (1_u32 << format.mantissa) as f32
}

/// For k nearest neighbors within `1 + epsilon` of the true ones, table 6.1.
fn for_nearest(format: Format, epsilon: f32) -> CacheSetup {
    CacheSetup {
        ball: false,
        far_scale: encode(format, (1.0 + epsilon) * (1.0 - slack(format))),
        margin_scale: encode(format, 1.0 / (2.0 + epsilon)),
    }
}

/// For balls without tolerance.
fn for_balls(format: Format) -> CacheSetup {
    CacheSetup { ball: true, far_scale: encode(format, 1.0 - slack(format)), margin_scale: encode(format, 1.0) }
}

/// Places of queries: near a few points in turn, or anywhere.
fn places(points: &[[f32; 3]], count: usize, step: f32, random: &mut Rng) -> Vec<[f32; 3]> {
    let centers: Vec<_> = (0..random.usize(1..4)).map(|_| points[random.usize(..points.len())]).collect();
    let mut place = || {
        let center = centers[random.usize(..centers.len())];
        if random.u8(0..6) == 0 {
            [(); 3].map(|()| random.f32() * 2.0 - 1.0)
        } else {
            center.map(|coordinate| coordinate + (random.f32() - 0.5) * step)
        }
    };
    (0..count).map(|_| place()).collect()
}

/// What a test runs on.
struct Scene {
    config: Config,
    points: Vec<[f32; 3]>,
    tree: Tree,
    latencies: Latencies,
    surroundings: Surroundings,
}

impl Scene {
    fn new(index: usize, point_count: usize, random: &mut Rng) -> Self {
        let (threads, neighbors, neighbor_cache) = SIZES[index % SIZES.len()];
        let config = Config {
            geometry: FORMATS[(index + index / SIZES.len()) % FORMATS.len()],
            threads,
            neighbors,
            neighbor_cache,
            lanes: [1, 4, 2, 8][index / 2 % 4],
            tree_depth: 6,
            point_cache: [0, 8][random.usize(..2)],
            tree_cache: [0, 64][random.usize(..2)],
            ..Config::default()
        };
        assert_eq!(config.validate(), Ok(()));
        let mut points = cloud(point_count, random);
        let tree = build(&config, &mut points, random);
        let cache = CacheLatencies { check: random.u32(1..60), cover: random.u32(1..60) };
        let latencies = Latencies { path: 9, distance: 15, neighbor_cache: Some(cache) };
        let surroundings = Surroundings { latency: [1, 500, 30][index % 3], pauses: random.u8(0..6) };
        Self { config, points, tree, latencies, surroundings }
    }

    fn bench(&self, random: &mut Rng) -> Bench<'_> {
        Bench::new(&self.config, self.latencies, &self.tree, self.surroundings, random.u64(..))
    }

    /// Answers to queries in bursts, each once, in the order of their numbers.
    fn ask(&self, bench: &mut Bench, setup: CacheSetup, queries: &[CachedQuery], random: &mut Rng) -> Vec<Answer> {
        bench.set_up(setup);
        let hits = bench.neighbor_hits;
        let mut answers = Vec::new();
        for burst in queries.chunks(random.usize(1..=2 * self.config.neighbor_cache as usize)) {
            answers.extend(bench.search(burst));
            bench.idle(random.u64(0..100));
        }
        answers.sort_by_key(|answer| answer.number);
        assert!(answers.iter().map(|answer| answer.number).eq(0..queries.len() as u32), "a query is answered once");
        assert_eq!(bench.neighbor_hits - hits, answers.iter().filter(|answer| answer.cached).count() as u64);
        for Answer { neighbors, .. } in &answers {
            let indices: HashSet<_> = neighbors.iter().map(|(index, _)| *index).collect();
            assert_eq!(indices.len(), neighbors.len(), "a neighbor is found once");
        }
        answers
    }

    /// The answer's squared distances to the query itself, in order.
    fn distances2(&self, query: &Query, answer: &Answer) -> Vec<u32> {
        let distance2 = |(index, _): &(u32, u32)| {
            squared_distance(self.config.geometry, self.tree.points[*index as usize], query.point)
        };
        let mut distances2: Vec<_> = answer.neighbors.iter().map(distance2).collect();
        if !answer.cached {
            assert!(answer.neighbors.iter().map(|(_, found)| found).eq(&distances2), "in order, for the query itself");
        }
        distances2.sort_unstable();
        distances2
    }

    fn brute_force(&self) -> BruteForce<'_> {
        BruteForce::new(self.config.geometry, &self.tree.points)
    }

    /// Searches for k nearest neighbors: the cache is asked for one more.
    fn nearest_queries(&self, k: u32, count: usize, step: f32, random: &mut Rng) -> Vec<CachedQuery> {
        let format = self.config.geometry;
        let query = |(number, place): (usize, [f32; 3])| Query {
            number: number as u32,
            k: k as u8 + 1,
            radius2: format.infinity() as u32,
            point: place.map(|coordinate| encode(format, coordinate)),
        };
        let places = places(&self.points, count, step, random);
        places.into_iter().enumerate().map(query).map(CachedQuery::from).collect()
    }
}

fn in_order(neighbors: &[Neighbor<u32>]) -> Vec<u32> {
    neighbors.iter().map(|neighbor| neighbor.distance2).collect()
}

#[test]
fn exact_neighborhoods_are_those_of_brute_force() {
    let mut random = Rng::with_seed(first_seed());
    let (mut hits, mut asked) = ([0; SIZES.len()], 0);
    for index in 0..2 * SIZES.len() {
        let point_count = if index % 5 == 4 { random.usize(1..12) } else { random.usize(100..400) };
        let scene = Scene::new(index, point_count, &mut random);
        let brute_force = scene.brute_force();
        let mut bench = scene.bench(&mut random);
        let most = scene.config.neighbors - 1;
        for k in [1, most, random.u32(1..=most)] {
            let queries = scene.nearest_queries(k, 150, 0.03, &mut random);
            let setup = for_nearest(scene.config.geometry, 0.0);
            let answers = scene.ask(&mut bench, setup, &queries, &mut random);
            for (CachedQuery { query, .. }, answer) in queries.iter().zip(&answers) {
                let expected = in_order(&brute_force.nearest(query.point, k as usize, query.radius2));
                assert_eq!(scene.distances2(query, answer), expected, "{query:?}, {answer:?} of {:?}", scene.config);
            }
            asked += queries.len();
        }
        hits[index % SIZES.len()] += bench.neighbor_hits;
    }
    println!("{hits:?} of {asked} queries covered");
    assert!(hits.iter().all(|hits| *hits > 50));
}

/// As few points as are asked for: all of them are the neighborhood of every query.
#[test]
fn all_points_are_the_neighborhood_of_every_query() {
    let mut random = Rng::with_seed(first_seed());
    for (index, (_, neighbors, _)) in SIZES.into_iter().enumerate() {
        let k = (neighbors - 1).min(12);
        let scene = Scene::new(index, k as usize, &mut random);
        let mut bench = scene.bench(&mut random);
        let queries = scene.nearest_queries(k, 100, 1.0, &mut random);
        let setup = for_nearest(scene.config.geometry, 0.0);
        let answers = scene.ask(&mut bench, setup, &queries, &mut random);
        assert!(answers.iter().all(|answer| answer.neighbors.len() == k as usize));
        assert!(bench.neighbor_hits > 0 && answers[99].cached, "{} covered", bench.neighbor_hits);
    }
}

#[test]
fn approximate_neighborhoods_are_within_their_tolerance() {
    let mut random = Rng::with_seed(first_seed());
    let mut hits = Vec::new();
    let mut worst: f64 = 0.0;
    for epsilon in [0.1, 0.2, 0.5] {
        let mut covered = 0;
        for index in 0..2 * SIZES.len() {
            let scene = Scene::new(index, 300, &mut random);
            let mut bench = scene.bench(&mut random);
            let format = scene.config.geometry;
            let points: Vec<_> = scene.tree.points.iter().map(|point| decode(format, *point)).collect();
            let k = random.u32(1..scene.config.neighbors);
            let queries = scene.nearest_queries(k, 150, 0.1, &mut random);
            let answers = scene.ask(&mut bench, for_nearest(format, epsilon), &queries, &mut random);
            for (CachedQuery { query, .. }, answer) in queries.iter().zip(&answers) {
                assert_eq!(answer.neighbors.len(), k as usize);
                let place = decode(format, query.point);
                let distance = |index: u32| {
                    let [x, y, z] = [0, 1, 2].map(|axis| points[index as usize][axis] - place[axis]);
                    (x * x + y * y + z * z).sqrt()
                };
                let farthest = answer.neighbors.iter().map(|(index, _)| distance(*index)).fold(0.0, f64::max);
                let nearest = nearest_f64(&points, place, k as usize, f64::INFINITY);
                let expected = nearest[k as usize - 1].distance2.sqrt();
                assert!(farthest <= expected * (1.0 + f64::from(epsilon)), "{farthest} for {expected}, ε = {epsilon}");
                worst = worst.max(farthest / expected - 1.0);
            }
            covered += bench.neighbor_hits;
        }
        hits.push(covered);
    }
    println!("{hits:?} covered, a neighborhood is {:.1} % too large at most", 100.0 * worst);
    assert!(hits.iter().all(|hits| *hits > 300) && worst > 0.1);
}

#[test]
fn balls_hold_all_that_lies_within() {
    /// What the host searches in for the radius wanted.
    const ALPHA: f32 = 1.3;
    let mut random = Rng::with_seed(first_seed());
    let (mut hits, mut kept, mut partial) = (0, 0, 0);
    for index in 0..2 * SIZES.len() {
        let scene = Scene::new(index, 400, &mut random);
        let format = scene.config.geometry;
        let brute_force = scene.brute_force();
        let mut bench = scene.bench(&mut random);
        let radius = random.f32() * 0.4 + 0.05;
        let k = scene.config.neighbors - index as u32 % 2;
        let mut queries = scene.nearest_queries(k - 1, 150, 0.1, &mut random);
        for CachedQuery { query, reach } in &mut queries {
            let radius = radius * (1.0 - random.f32() * 0.3);
            query.radius2 = encode(format, (ALPHA * radius).powi(2));
            *reach = encode(format, radius);
        }
        let answers = scene.ask(&mut bench, for_balls(format), &queries, &mut random);
        for (CachedQuery { query, reach }, answer) in queries.iter().zip(&answers) {
            let radius = decode(format, [*reach; 3])[0] as f32;
            let radius2 = encode(format, radius * radius);
            let mut within = scene.distances2(query, answer);
            within.retain(|distance2| *distance2 < radius2);
            // A search that found as many as it may is cut off; a neighborhood that is reused reaches as far as is asked.
            let is_cut_off = !answer.cached && answer.neighbors.len() == k as usize;
            let most = if is_cut_off { k as usize } else { scene.points.len() };
            let expected = in_order(&brute_force.nearest(query.point, most, radius2));
            assert_eq!(within, expected, "{query:?}, {answer:?} of {:?}", scene.config);
            kept += within.len();
            partial += usize::from(answer.cached && within.len() < answer.neighbors.len());
        }
        hits += bench.neighbor_hits;
    }
    println!("{hits} covered, {partial} of them with points beyond the radius; {kept} neighbors");
    assert!(hits > 500 && partial > 100 && kept > 5000);
}

/// Points on a wavy surface, at random within the cells of a lattice.
fn surface(side: u32, random: &mut Rng) -> Vec<[f32; 3]> {
    let mut place = |cell: u32| (cell as f32 + random.f32()) / side as f32;
    let mut point = |cell: u32| {
        let [x, y] = [place(cell % side), place(cell / side)];
        [x, y, 0.1 * (5.0 * x).sin()]
    };
    (0..side * side).map(&mut point).collect()
}

/// Queries that come together save about as many searches as queries each of which waits for the answer to the one before it:
/// while a neighborhood is searched for, those that it will cover are not.
#[test]
fn queries_side_by_side_are_not_searched_for_together() {
    const K: u32 = 16;
    const SIDE: u32 = 30;
    const PATTERN: u32 = 6;
    let mut random = Rng::with_seed(first_seed());
    let config = Config { threads: 16, neighbors: K + 1, neighbor_cache: 8, tree_depth: 6, ..Config::default() };
    let points = surface(SIDE, &mut random);
    let mut in_tree = points.clone();
    let tree = build(&config, &mut in_tree, &mut random);
    let step = 1.0 / (SIDE * PATTERN) as f32;
    let around = |point: &[f32; 3]| {
        let [x, y, z] = *point;
        (0..PATTERN * PATTERN).map(move |cell| {
            let (row, place) = (cell / PATTERN, cell % PATTERN);
            let column = if row.is_multiple_of(2) { place } else { PATTERN - 1 - place };
            [x + column as f32 * step, y + row as f32 * step, z]
        })
    };
    let query = |(number, place): (usize, [f32; 3])| {
        let point = place.map(|coordinate| encode(config.geometry, coordinate));
        let radius2 = config.geometry.infinity() as u32;
        CachedQuery::from(Query { number: number as u32, k: K as u8 + 1, radius2, point })
    };
    let queries: Vec<_> = points.iter().take(40).flat_map(around).enumerate().map(query).collect();

    let cache = CacheLatencies { check: 25, cover: 37 };
    let latencies = Latencies { path: 9, distance: 15, neighbor_cache: Some(cache) };
    let saved_in_bursts_of = |burst: usize| {
        let surroundings = Surroundings { latency: 40, pauses: 0 };
        let mut bench = Bench::new(&config, latencies, &tree, surroundings, 1);
        bench.set_up(for_nearest(config.geometry, 0.2));
        for queries in queries.chunks(burst) {
            bench.search(queries);
            bench.idle(u64::from(cache.cover) + 10);
        }
        bench.neighbor_hits as f64 / queries.len() as f64
    };
    let [alone, together] = [1, queries.len()].map(saved_in_bursts_of);
    println!("{alone:.3} saved one after the other, {together:.3} together");
    assert!(alone > 0.5 && together > 0.8 * alone, "{together} saved of {alone}");
}
