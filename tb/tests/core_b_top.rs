//! The whole neighbor search against its model in every cycle, and against brute force, on small random trees, with a
//! memory that answers late and out of order.

use pointcore_golden::core_b::{Latencies, Top};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::core_b::top;
use pointcore_spec::core_b::{Config, ports};

use crate::core_b::environment::{Feeds, Rule};
use crate::core_b::memory::Memory;
use crate::core_b::tree::Tree;
use crate::core_b::{all, configs, lockstep, number, query};

const QUERIES: u64 = 40;

/// The host and the memory.
#[derive(Clone)]
struct Host {
    tree: Tree,
    queries: Vec<Vec<u64>>,
    /// Tree writes that have not been taken.
    writes_left: usize,
    /// Requests for points, and for records of a tree in external memory.
    points: Memory,
    records: Memory,
    /// Neighbors by query: found, index, distance.
    results: Vec<Vec<(bool, u64, f32)>>,
    closed: Vec<bool>,
}

impl Host {
    fn ask(&self, feeds: &mut Feeds) {
        self.queries.iter().for_each(|query| feeds.feed("query", query.clone()));
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
            "result" => {
                let &[query, last, found, index, distance2] = fields else { panic!("a result has five fields") };
                let query = query as usize;
                assert!(!self.closed[query], "a result after the last of query {query}");
                self.closed[query] = last != 0;
                self.results[query].push((found != 0, index, number(&self.tree.config, distance2)));
            }
            _ => {}
        }
    }
}

fn check(host: &Host) {
    for (number, query) in host.queries.iter().enumerate() {
        assert!(host.closed[number], "query {number} has no last result");
        let (point, expected) = (host.tree.point(query), host.tree.nearest(query));
        let found: Vec<_> = host.results[number].iter().filter(|(found, ..)| *found).collect();
        assert_eq!(found.iter().map(|(.., distance2)| *distance2).collect::<Vec<_>>(), expected, "query {number}");
        assert_eq!(host.results[number].len(), expected.len().max(1), "query {number}");
        let mut indices: Vec<_> = found.iter().map(|(_, index, _)| *index).collect();
        assert!(found.iter().all(|(_, index, distance2)| host.tree.distance2(*index, point) == *distance2));
        indices.sort_unstable();
        indices.dedup();
        assert_eq!(indices.len(), expected.len(), "query {number} has a neighbor twice");
    }
}

/// Cores with points in a cache, with a tree in external memory, with both and with neither.
fn cores() -> [Config; 4] {
    let [bare, points, tree, both] = configs();
    [
        bare,
        Config { point_cache: 4, ..points },
        Config { tree_cache: 16, ..tree },
        Config { point_cache: 2, tree_cache: 32, ..both },
    ]
}

#[test]
fn searches_agree_with_the_model_and_with_brute_force() {
    for config in cores() {
        let core = top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let [path, distance] = ["traversal", "leaf"].map(|unit| core.manifests[unit].latency);
        let latencies = Latencies { path, distance, neighbor_cache: None };
        let begin = |feeds: &mut Feeds| {
            let tree = Tree::random(&config, &mut feeds.random);
            let queries = (0..QUERIES).map(|number| query(&config, number, &mut feeds.random)).collect();
            let host = Host {
                writes_left: tree.writes.len(),
                tree,
                queries,
                points: Memory::default(),
                records: Memory::default(),
                results: vec![vec![]; QUERIES as usize],
                closed: vec![false; QUERIES as usize],
            };
            match config.tree_cache {
                0 => host.tree.writes.iter().for_each(|write| feeds.feed("tree", write.clone())),
                _ => host.ask(feeds),
            }
            host
        };
        lockstep(&core.module, &Top::new(&config, latencies), &ports::top(&config), begin, all, |host, report| {
            check(host);
            let [hits, misses] = ["event_point_hit", "event_point_miss"].map(|event| report.events(event));
            match config.point_cache {
                0 => assert!(report.transfers("fetch") >= QUERIES, "every query visits a leaf"),
                _ => assert!(hits + misses >= QUERIES && hits > 0 && misses > 0, "{hits} hits, {misses} misses"),
            }
            if config.tree_cache > 0 {
                let [hits, misses] = ["event_tree_hit", "event_tree_miss"].map(|event| report.events(event));
                assert!(hits > misses && misses > 0, "{hits} hits, {misses} misses");
            }
        });
    }
}
