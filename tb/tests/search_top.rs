//! The whole neighbor search against its model in every cycle, and against brute force, on small random trees, with a
//! memory that answers late and out of order.

use std::cell::Cell;
use std::collections::BTreeSet;

use pointcore_contract::search::{Config, units};
use pointcore_golden::search::{CacheLatencies, Latencies, Top};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::search::top;

use crate::search::environment::{Feeds, Rule};
use crate::search::memory::Memory;
use crate::search::tree::Tree;
use crate::search::{
    Coordinate, all, cache_scales, close_coordinate, configs, coordinate, fine_coordinate, lockstep, number, query_at,
    word,
};
use crate::support::cases;

const QUERIES: u64 = 40;
/// How much farther than a ball query asks its cached neighborhood reaches.
const EXTENSION: f32 = 1.25;

/// What the host asks a core with a neighbor cache for, with the same k in every query.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    Nearest,
    Ball,
}

/// What came of a query.
#[derive(Clone, Default)]
struct Answer {
    /// Found, index, distance.
    results: Vec<(bool, u64, f32)>,
    cached: bool,
    closed: bool,
}

/// The host and the memory.
#[derive(Clone)]
struct Host {
    tree: Tree,
    /// No format rounds its distances.
    is_exact: bool,
    /// Of a core with a neighbor cache.
    mode: Option<Mode>,
    queries: Vec<Vec<u64>>,
    /// Tree writes that have not been taken.
    writes_left: usize,
    /// Requests for points, and for records of a tree in external memory.
    points: Memory,
    records: Memory,
    /// By query.
    answers: Vec<Answer>,
}

/// Queries to a core with a neighbor cache: near as many places as it has entries, off the grid of the points so that few
/// distances tie.
fn coherent_queries(coordinate: Coordinate, config: &Config, mode: Mode, random: &mut fastrand::Rng) -> Vec<Vec<u64>> {
    let fine = |random: &mut fastrand::Rng| f32::from(random.i8(-3..=3)) / 32.0;
    let places: Vec<_> =
        (0..config.neighbor_cache).map(|_| [(); 3].map(|()| coordinate(random) + fine(random))).collect();
    let query = |query| {
        let mut point = places[random.usize(..places.len())];
        if random.bool() {
            point[random.usize(..3)] += fine(random);
        }
        let reach = [0.5, 1.0, 2.0][random.usize(..3)];
        let (radius2, reach) = match mode {
            Mode::Nearest => (f32::INFINITY, 0.0),
            Mode::Ball => ((EXTENSION * reach) * (EXTENSION * reach), reach),
        };
        let numbers = [radius2, point[0], point[1], point[2], reach].map(|number| word(config, number));
        [query, config.neighbors.into()].into_iter().chain(numbers).collect()
    };
    (0..QUERIES).map(query).collect()
}

impl Host {
    fn new(config: &Config, random: &mut fastrand::Rng) -> Self {
        let (coordinate, is_exact): (Coordinate, _) = match random.u8(..4) {
            0 | 1 => (coordinate, true),
            2 => (fine_coordinate, false),
            _ => (close_coordinate, false),
        };
        let tree = Tree::over(coordinate, config, random);
        let mode = (config.neighbor_cache > 0).then(|| if random.bool() { Mode::Nearest } else { Mode::Ball });
        let queries = match mode {
            None => (0..QUERIES).map(|number| query_at(coordinate, config, number, random)).collect(),
            Some(mode) => coherent_queries(coordinate, config, mode, random),
        };
        Self {
            is_exact,
            mode,
            writes_left: tree.writes.len(),
            tree,
            queries,
            points: Memory::default(),
            records: Memory::default(),
            answers: vec![Answer::default(); QUERIES as usize],
        }
    }

    fn set_up(&self, feeds: &mut Feeds) {
        let Some(mode) = self.mode else { return self.load(feeds) };
        let margin_scale = if mode == Mode::Ball { 1.0 } else { 0.5 };
        let scales = cache_scales(&self.tree.config, margin_scale, &mut feeds.random);
        feeds.feed("setup", [&[u64::from(mode == Mode::Ball)], &scales[..]].concat());
    }

    fn load(&self, feeds: &mut Feeds) {
        match self.tree.config.tree_cache {
            0 => self.tree.writes.iter().for_each(|write| feeds.feed("tree", write.clone())),
            _ => self.ask(feeds),
        }
    }

    fn ask(&self, feeds: &mut Feeds) {
        self.queries.iter().for_each(|query| feeds.feed("query", query.clone()));
    }

    fn result(&mut self, fields: &[u64]) {
        let query = fields[0] as usize;
        let answer = &mut self.answers[query];
        assert!(!answer.closed, "a result after the last of query {query}");
        answer.closed = fields[1] == 1;
        answer.results.push((fields[2] == 1, fields[3], number(&self.tree.config, fields[4])));
        answer.cached = fields.get(5) == Some(&1);
    }
}

fn send_points(tree: &Tree, feeds: &mut Feeds, request: &[u64]) {
    let &[thread, address, beats] = request else { panic!("a request has three fields") };
    tree.beats(thread, address, beats).for_each(|beat| feeds.feed("beat", beat));
}

fn send_record(tree: &Tree, feeds: &mut Feeds, request: &[u64]) {
    feeds.feed("record", [request, tree.record(request[1])].concat());
}

impl Rule for Host {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "setup" => self.load(feeds),
            "tree" => {
                self.writes_left -= 1;
                if self.writes_left == 0 {
                    self.ask(feeds);
                }
            }
            "fetch" => self.points.request(feeds, fields, |feeds, request| send_points(&self.tree, feeds, request)),
            "beat" if fields[2] == 1 => {
                self.points.answered(feeds, |feeds, request| send_points(&self.tree, feeds, request));
            }
            "lookup" => self.records.request(feeds, fields, |feeds, request| send_record(&self.tree, feeds, request)),
            "record" => self.records.answered(feeds, |feeds, request| send_record(&self.tree, feeds, request)),
            "result" => self.result(fields),
            _ => {}
        }
    }
}

fn check(host: &Host) {
    for ((number, query), answer) in host.queries.iter().enumerate().zip(&host.answers) {
        assert!(answer.closed, "query {number} has no last result");
        if !host.is_exact {
            continue;
        }
        let (point, mut expected) = (host.tree.point(query), host.tree.nearest(query));
        if host.mode == Some(Mode::Nearest) && expected.len() as u64 == query[1] {
            expected.pop();
        }
        let found: Vec<_> = answer.results.iter().filter(|(found, ..)| *found).collect();
        let mut distances: Vec<_> = found.iter().map(|(_, index, _)| host.tree.distance2(*index, point)).collect();
        if answer.cached {
            distances.sort_by(f32::total_cmp);
            if host.mode == Some(Mode::Ball) {
                // A neighborhood that is reused reaches farther than it need, and not as far as a search would.
                let reach = host.tree.reach(query);
                distances.retain(|&distance2| distance2 < reach * reach);
                expected.retain(|&distance2| distance2 < reach * reach);
            }
        } else {
            assert!(found.iter().zip(&distances).all(|((.., found), distance2)| found == distance2), "query {number}");
        }
        assert_eq!(distances, expected, "query {number}");
        assert_eq!(answer.results.len(), found.len().max(1), "query {number}");
        let indices: BTreeSet<_> = found.iter().map(|(_, index, _)| *index).collect();
        assert_eq!(indices.len(), found.len(), "query {number} has a neighbor twice");
    }
}

/// Cores with points and neighborhoods in caches, with a tree in external memory, with points in a cache and the tree in external
/// memory, and with none of all that.
fn cores() -> [Config; 4] {
    let [bare, points, tree, both] = configs();
    [
        bare,
        Config { point_cache: 4, neighbor_cache: 8, ..points },
        Config { tree_cache: 16, ..tree },
        Config { point_cache: 2, tree_cache: 32, ..both },
    ]
}

#[test]
fn searches_agree_with_the_model_and_with_brute_force() {
    for config in cases(cores()) {
        let reused = Cell::new(0);
        let core = top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let [path, distance] = ["traversal", "leaf"].map(|unit| core.manifests[unit].latency);
        let cache_latency = |unit: &str| core.manifests.get(unit).map(|manifest| manifest.latency);
        let neighbor_cache =
            cache_latency("check").zip(cache_latency("cover")).map(|(check, cover)| CacheLatencies { check, cover });
        let latencies = Latencies { path, distance, neighbor_cache };
        let begin = |feeds: &mut Feeds| {
            let host = Host::new(&config, &mut feeds.random);
            host.set_up(feeds);
            host
        };
        lockstep(
            &config,
            &core.module,
            &Top::new(&config, latencies),
            &units::top::UNIT,
            begin,
            all,
            |host, report| {
                check(host);
                let cached = host.answers.iter().filter(|answer| answer.cached).count() as u64;
                let searches = QUERIES - cached;
                if config.neighbor_cache > 0 {
                    let events = ["event_cache_hit", "event_cache_miss"].map(|event| report.events(event));
                    assert_eq!(events, [cached, searches]);
                    assert!(searches > 0);
                    reused.set(reused.get() + cached);
                }
                let [hits, misses] = ["event_point_hit", "event_point_miss"].map(|event| report.events(event));
                match config.point_cache {
                    0 => assert!(report.transfers("fetch") >= searches, "every query visits a leaf"),
                    _ => assert!(hits + misses >= searches && hits > 0 && misses > 0, "{hits} hits, {misses} misses"),
                }
                if config.tree_cache > 0 {
                    let [hits, misses] = ["event_tree_hit", "event_tree_miss"].map(|event| report.events(event));
                    assert!(hits > 0 && misses > 0, "{hits} hits, {misses} misses");
                }
            },
        );
        assert!(config.neighbor_cache == 0 || reused.get() > 0, "no neighborhood was reused");
    }
}
