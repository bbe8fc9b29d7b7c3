//! The tree cache against its model, with records that compete for lines and a memory that answers out of order.

use pointcore_contract::search::records::{Bucket, Node};
use pointcore_contract::search::{Config, units};
use pointcore_contract::{Record, fields};
use pointcore_golden::search::TreeCache;
use pointcore_hdl::search::tree_cache;

use crate::search::environment::{Feeds, Rule};
use crate::search::memory::Memory;
use crate::search::{all, configs, lockstep};
use crate::support::cases;

const REQUESTS: u64 = 600;
/// Records that are asked for again and again: the nodes near the root and the leaves on the left.
const FAVORITES: u64 = 4;

/// Threads that ask for a node or for leaves.
#[derive(Clone)]
struct Requests {
    config: Config,
    left: u64,
    /// Seed of the records.
    seed: u64,
    memory: Memory,
    /// Nodes and leaves without an answer: thread and address.
    nodes: Vec<[u64; 2]>,
    leaves: Vec<[u64; 2]>,
    /// Nodes of the deepest level.
    deepest: u64,
}

/// The fields of a record, as good as any.
fn content<R: Record>(config: &R::Config, seed: u64, address: u64) -> Vec<u64> {
    let mut random = fastrand::Rng::with_seed(seed ^ address);
    fields::<R>(config).iter().map(|field| random.u64(..1 << field.width)).collect()
}

impl Requests {
    fn chosen(feeds: &mut Feeds, all: u64) -> u64 {
        let among = [FAVORITES, all][feeds.random.usize(..2)];
        feeds.random.u64(..among)
    }

    fn ask_node(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.left > 0 {
            self.left -= 1;
            let node = 1 + Self::chosen(feeds, (2 << self.config.tree_depth) - 1);
            self.deepest += node >> self.config.tree_depth;
            self.nodes.push([thread, node]);
            feeds.feed("node", vec![thread, node]);
        }
    }

    fn ask_leaf(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.left > 0 {
            self.left -= 1;
            let leaf = Self::chosen(feeds, 1 << self.config.tree_depth);
            self.leaves.push([thread, leaf]);
            feeds.feed("leaf", vec![thread, leaf]);
        }
    }
}

/// A record as the memory sends it: what is not its own is noise.
fn answer(config: &Config, seed: u64, feeds: &mut Feeds, request: &[u64]) {
    let noise = feeds.random.u64(..);
    let (node, bucket) = match request[1] >> config.tree_depth {
        0 => (request[1], noise),
        _ => (noise, request[1]),
    };
    let fields = [content::<Node>(config, seed, node), content::<Bucket>(config, seed, bucket)];
    feeds.feed("fill", [request, &fields.concat()].concat());
}

/// Takes a request off a list.
fn close(open: &mut Vec<[u64; 2]>, matches: impl Fn(&[u64; 2]) -> bool) {
    let position = open.iter().position(matches);
    open.swap_remove(position.expect("an answer belongs to a request"));
}

impl Rule for Requests {
    const SEEDS: u64 = 160;

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        let (config, seed) = (&self.config, self.seed);
        match stream {
            "lookup" => self.memory.request(feeds, fields, |feeds, request| answer(config, seed, feeds, request)),
            "fill" => self.memory.answered(feeds, |feeds, request| answer(config, seed, feeds, request)),
            "record" => {
                let &[thread, node, ..] = fields else { panic!("a record begins with its thread and node") };
                let of_deepest = node >> config.tree_depth != 0;
                let expected = content::<Node>(config, seed, node);
                assert_eq!(fields[2..], if of_deepest { vec![0; 3] } else { expected }, "node {node}");
                close(&mut self.nodes, |request| *request == [thread, node]);
                self.ask_node(feeds, thread);
            }
            "fetch" => {
                let is_of = |&[thread, leaf]: &[u64; 2]| {
                    let place = content::<Bucket>(config, seed, (1 << config.tree_depth) + leaf);
                    fields[0] == thread && fields[1..] == place
                };
                close(&mut self.leaves, is_of);
                self.ask_leaf(feeds, fields[0]);
            }
            _ => {}
        }
    }
}

#[test]
fn records_are_kept_and_replaced_as_in_the_model() {
    // Fewer lines than records, as many, and more.
    for (config, tree_cache) in cases(configs().into_iter().zip([16, 16, 32, 64])) {
        let config = Config { tree_cache, ..config };
        let begin = |feeds: &mut Feeds| {
            let (memory, nodes, leaves) = (Memory::default(), vec![], vec![]);
            let (config, seed) = (config.clone(), feeds.random.u64(..));
            let (threads, leaves_in_flight) = (config.threads, config.leaves_in_flight);
            let mut requests = Requests { config, left: REQUESTS, seed, memory, nodes, leaves, deepest: 0 };
            for thread in 0..threads.into() {
                requests.ask_node(feeds, thread);
                (0..leaves_in_flight).for_each(|_| requests.ask_leaf(feeds, thread));
            }
            requests
        };
        let (module, model) = (tree_cache::module(&config), TreeCache::new(&config));
        lockstep(&config, &module, &model, &units::tree_cache::UNIT, begin, all, |requests, report| {
            assert!(requests.left == 0 && requests.nodes.is_empty() && requests.leaves.is_empty());
            let [hits, misses] = ["event_tree_hit", "event_tree_miss"].map(|event| report.events(event));
            assert_eq!((hits + misses, misses), (REQUESTS - requests.deepest, report.transfers("lookup")));
            assert!(hits > REQUESTS / 10 && misses > 10, "{hits} hits, {misses} misses");
        });
    }
}
