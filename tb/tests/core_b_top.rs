//! The whole neighbor search against its model in every cycle, and against brute force, on small random trees, with a
//! memory that answers late and out of order.

use pointcore_golden::core_b::{Latencies, Top};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::core_b::top;
use pointcore_spec::core_b::ports;

use crate::core_b::environment::{Feeds, Rule};
use crate::core_b::tree::Tree;
use crate::core_b::{all, configs, lockstep, query};

const QUERIES: u64 = 40;

/// The host and the memory.
#[derive(Clone)]
struct Host {
    tree: Tree,
    queries: Vec<Vec<u64>>,
    /// Tree writes that have not been taken.
    writes_left: usize,
    /// Requests under way in the memory: thread, address, beats.
    requests: Vec<Vec<u64>>,
    answering: bool,
    /// Neighbors by query: found, index, distance.
    results: Vec<Vec<(bool, u64, f32)>>,
    closed: Vec<bool>,
}

impl Host {
    /// Answers one request after the other, any of them first.
    fn answer(&mut self, feeds: &mut Feeds) {
        if self.answering || self.requests.is_empty() {
            return;
        }
        self.answering = true;
        let request = self.requests.swap_remove(feeds.random.usize(..self.requests.len()));
        let [thread, address, beats] = request[..] else { panic!("a request has three fields") };
        for beat in address..address + beats {
            let mut item = vec![thread, beat, u64::from(beat + 1 == address + beats)];
            item.extend(self.tree.beat(beat));
            feeds.feed("beat", item);
        }
    }
}

impl Rule for Host {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "tree" => {
                self.writes_left -= 1;
                if self.writes_left == 0 {
                    self.queries.iter().for_each(|query| feeds.feed("query", query.clone()));
                }
            }
            "fetch" => {
                self.requests.push(fields.to_vec());
                self.answer(feeds);
            }
            "beat" if fields[2] != 0 => {
                self.answering = false;
                self.answer(feeds);
            }
            "result" => {
                let &[number, last, found, index, distance2] = fields else { panic!("a result has five fields") };
                let number = number as usize;
                assert!(!self.closed[number], "a result after the last of query {number}");
                self.closed[number] = last != 0;
                self.results[number].push((found != 0, index, f32::from_bits(distance2 as u32)));
            }
            _ => {}
        }
    }
}

fn check(host: &Host) {
    for (number, query) in host.queries.iter().enumerate() {
        assert!(host.closed[number], "query {number} has no last result");
        let point = [3, 4, 5].map(|field| f32::from_bits(query[field] as u32));
        let expected = host.tree.nearest(point, query[1] as usize, f32::from_bits(query[2] as u32));
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

#[test]
fn searches_agree_with_the_model_and_with_brute_force() {
    for config in configs() {
        let core = top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let [path, distance] = ["traversal", "leaf"].map(|unit| core.manifests[unit].latency);
        let latencies = Latencies { path, distance, neighbor_cache: None };
        let begin = |feeds: &mut Feeds| {
            let tree = Tree::random(&config, &mut feeds.random);
            tree.writes.iter().for_each(|write| feeds.feed("tree", write.clone()));
            let queries = (0..QUERIES).map(|number| query(&config, number, &mut feeds.random)).collect();
            let count = QUERIES as usize;
            Host {
                writes_left: tree.writes.len(),
                tree,
                queries,
                requests: vec![],
                answering: false,
                results: vec![vec![]; count],
                closed: vec![false; count],
            }
        };
        lockstep(&core.module, &Top::new(&config, latencies), &ports::top(&config), begin, all, |host, report| {
            check(host);
            assert!(report.transfers("fetch") >= QUERIES, "every query visits a leaf");
        });
    }
}
