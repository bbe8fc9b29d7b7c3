//! Node traversal against its model on small random trees.

use pointcore_contract::search::{Config, units};
use pointcore_golden::search::Traversal;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::search::traversal;

use crate::search::environment::{Feeds, Rule};
use crate::search::memory::Memory;
use crate::search::tree::Tree;
use crate::search::{all, configs, lockstep, number, start};
use crate::support::cases;

const DESCENTS: u64 = 400;

/// Each thread comes back with a path that it pushed, or with another query when it has none. Nodes that the unit does not
/// hold come back with their records.
#[derive(Clone)]
struct Threads {
    config: Config,
    tree: Tree,
    memory: Memory,
    writes_left: usize,
    starts_left: u64,
    paths: Vec<Vec<u64>>,
}

impl Threads {
    fn begin(&mut self, feeds: &mut Feeds) {
        (0..self.config.threads.into()).for_each(|thread| self.restart(feeds, thread));
    }

    fn restart(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.starts_left > 0 {
            self.starts_left -= 1;
            let mut start = start(&self.config, thread, self.starts_left, &mut feeds.random);
            let coordinates = start.len() - 3;
            for coordinate in &mut start[coordinates..] {
                let close = self.close(&mut feeds.random);
                if number(&self.config, close).is_normal() && feeds.random.bool() {
                    *coordinate = close;
                }
            }
            feeds.feed("start", start);
        }
    }

    /// A coordinate that differs from a node's plane in one bit.
    fn close(&self, random: &mut fastrand::Rng) -> u64 {
        let planes: Vec<u64> = self.tree.writes.iter().filter(|write| write[0] == 0).map(|write| write[2]).collect();
        planes[random.usize(..planes.len())] ^ 1 << random.u32(..self.config.geometry.width())
    }
}

/// Sends the record of a node; nobody looks at that of one on the deepest level.
fn answer(tree: &Tree, feeds: &mut Feeds, node: &[u64]) {
    let record = match node[1] >> tree.config.tree_depth {
        0 => &tree.record(node[1])[..3],
        _ => &[0; 3],
    };
    feeds.feed("record", [node, record].concat());
}

impl Rule for Threads {
    const SEEDS: u64 = 20;

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "tree" => {
                self.writes_left -= 1;
                if self.writes_left == 0 {
                    self.begin(feeds);
                }
            }
            "node" => self.memory.request(feeds, fields, |feeds, request| answer(&self.tree, feeds, request)),
            "record" => self.memory.answered(feeds, |feeds, request| answer(&self.tree, feeds, request)),
            "start" => {
                // Any node is a tree's root.
                let nodes: Vec<u64> = self.tree.nodes().collect();
                let root = nodes[feeds.random.usize(0..nodes.len())];
                feeds.feed("descend", vec![fields[0], root]);
            }
            "push" => self.paths[fields[0] as usize].push(fields[1]),
            "reached" => match self.paths[fields[0] as usize].pop() {
                Some(node) => feeds.feed("resume", vec![fields[0], node]),
                None => self.restart(feeds, fields[0]),
            },
            _ => {}
        }
    }
}

#[test]
fn descents_agree_with_the_model_and_visit_every_leaf() {
    let [.., many, wide] = configs();
    let without_nodes = [many, wide].map(|config| Config { tree_cache: 16, ..config });
    for config in cases(configs().into_iter().chain(without_nodes)) {
        let unit = traversal::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let begin = |feeds: &mut Feeds| {
            let tree = Tree::fine(&config, &mut feeds.random);
            let mut threads = Threads {
                config: config.clone(),
                writes_left: tree.writes.len(),
                tree,
                memory: Memory::default(),
                starts_left: DESCENTS,
                paths: vec![vec![]; config.threads as usize],
            };
            match config.tree_cache {
                0 => threads.tree.writes.iter().for_each(|write| feeds.feed("tree", write.clone())),
                _ => threads.begin(feeds),
            }
            threads
        };
        let model = Traversal::new(&config, unit.manifest.latency);
        lockstep(&config, &unit.module, &model, &units::traversal::UNIT, begin, all, |threads, report| {
            assert_eq!(report.transfers("descend"), DESCENTS);
            assert_eq!(report.transfers("leaf"), DESCENTS + report.transfers("push"), "a path ends in a leaf each");
            assert!(threads.paths.iter().all(Vec::is_empty));
        });
    }
}
