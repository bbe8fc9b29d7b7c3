use super::*;
use crate::testing::for_each_seed;
use fastrand::Rng;
use pointcore_contract::search::records::Thread;
use std::collections::VecDeque;

const TREE_DEPTH: u32 = 6;
const LINES: u32 = 16;

/// What the memory has at an address, a leaf if the top bit is set.
fn contents(address: u32) -> (Node, Bucket) {
    if address >> TREE_DEPTH == 0 {
        let node = Node { split: 3 * address, dimension: (address % 3) as u8, internal_leaf: address % 2 == 1 };
        (node, Bucket::default())
    } else {
        (Node::default(), Bucket { begin: 5 * address, beats: (address % 7) as u8 + 1 })
    }
}

fn node(thread: u8, node: u32) -> Descent {
    Descent { thread: Thread { thread }, node }
}

fn leaf(thread: u8, leaf: u32) -> LeafVisit {
    LeafVisit { thread: Thread { thread }, leaf }
}

/// The right answers.
fn record_of(descent: Descent) -> NodeRecord {
    let is_deepest = descent.node >> TREE_DEPTH != 0;
    NodeRecord { descent, node: if is_deepest { Node::default() } else { contents(descent.node).0 } }
}

fn fetch_of(visit: LeafVisit) -> Fetch {
    let Bucket { begin, beats } = contents(1 << TREE_DEPTH | visit.leaf).1;
    Fetch { thread: visit.thread, address: begin, beats }
}

/// The unit with requests that wait, and a memory.
struct Bench {
    cache: TreeCache,
    nodes: VecDeque<Descent>,
    leaves: VecDeque<LeafVisit>,
    memory: Vec<Lookup>,
    /// The request that the memory answers.
    answered: Option<Lookup>,
    records: Vec<NodeRecord>,
    fetches: Vec<Fetch>,
    hits: u32,
    misses: u32,
}

impl Bench {
    /// A cache whose lines are clear.
    fn new() -> Self {
        let config = Config { tree_cache: LINES, tree_depth: TREE_DEPTH, threads: 4, ..Config::default() };
        let mut bench = Self {
            cache: TreeCache::new(&config),
            nodes: VecDeque::new(),
            leaves: VecDeque::new(),
            memory: vec![],
            answered: None,
            records: vec![],
            fetches: vec![],
            hits: 0,
            misses: 0,
        };
        (0..LINES).for_each(|_| bench.cache.clock(&In::default()));
        bench
    }

    fn clock(&mut self, random: &mut Rng, stalls: bool) {
        let mut goes_on = || !stalls || random.u8(0..4) > 0;
        let out = self.cache.outputs();
        let inputs = In {
            node: self.nodes.front().copied().filter(|_| goes_on()),
            leaf: self.leaves.front().copied().filter(|_| goes_on()),
            record_ready: goes_on(),
            fetch_ready: goes_on(),
            lookup_ready: goes_on(),
            fill: self.answered.filter(|_| goes_on()).map(|lookup| {
                let (node, bucket) = contents(lookup.address);
                TreeRecord { lookup, node, bucket }
            }),
        };
        if inputs.node.is_some() && out.node_ready {
            self.nodes.pop_front();
        }
        if inputs.leaf.is_some() && out.leaf_ready {
            self.leaves.pop_front();
        }
        if inputs.fill.is_some() && out.fill_ready {
            self.answered = None;
        }
        self.records.extend(out.record.filter(|_| inputs.record_ready));
        self.fetches.extend(out.fetch.filter(|_| inputs.fetch_ready));
        self.memory.extend(out.lookup.filter(|_| inputs.lookup_ready));
        self.hits += u32::from(out.events.hit);
        self.misses += u32::from(out.events.miss);
        self.cache.clock(&inputs);
        if self.answered.is_none() && !self.memory.is_empty() {
            self.answered = Some(self.memory.swap_remove(random.usize(..self.memory.len())));
        }
    }

    /// Sends a request and waits; returns hits and misses.
    fn serve(&mut self, nodes: &[Descent], leaves: &[LeafVisit]) -> (u32, u32) {
        (self.hits, self.misses) = (0, 0);
        self.nodes.extend(nodes);
        self.leaves.extend(leaves);
        (0..60).for_each(|_| self.clock(&mut Rng::with_seed(1), false));
        (self.hits, self.misses)
    }
}

#[test]
fn nothing_is_looked_up_before_the_lines_are_clear() {
    let config = Config { tree_cache: LINES, tree_depth: TREE_DEPTH, ..Config::default() };
    let mut cache = TreeCache::new(&config);
    let shown = (0..100_u32).find(|cycle| {
        let lookup = cache.outputs().lookup;
        cache.clock(&In { node: (*cycle == 0).then(|| node(0, 1)), ..In::default() });
        lookup.is_some()
    });
    // Taken in the cycle after the last line, its line there in the next, missed in the one after, shown by the queue.
    assert_eq!(shown, Some(LINES + 3));
}

#[test]
fn a_record_is_fetched_once_and_then_served_to_any_thread() {
    let mut bench = Bench::new();
    assert_eq!(bench.serve(&[node(0, 5)], &[]), (0, 1));
    assert_eq!(bench.serve(&[node(3, 5), node(1, 5)], &[]), (2, 0));
    assert_eq!(bench.records, [node(0, 5), node(3, 5), node(1, 5)].map(record_of));
    assert_eq!(bench.serve(&[], &[leaf(0, 6)]), (0, 1));
    assert_eq!(bench.serve(&[], &[leaf(2, 6)]), (1, 0));
    assert_eq!(bench.fetches, [leaf(0, 6), leaf(2, 6)].map(fetch_of));
}

#[test]
fn a_record_gives_way_to_the_next_of_its_line() {
    let mut bench = Bench::new();
    assert_eq!(bench.serve(&[node(0, 5)], &[leaf(0, 6)]), (0, 2));
    assert_eq!(bench.serve(&[node(0, 5 + LINES)], &[]), (0, 1), "of the same line, with another tag");
    assert_eq!(bench.serve(&[node(0, 5)], &[leaf(0, 6)]), (1, 1));
    assert_eq!(bench.serve(&[], &[leaf(0, 5)]), (0, 1), "a leaf is no node of its number");
    assert_eq!(bench.serve(&[node(0, 5)], &[]), (0, 1));
}

#[test]
fn a_node_of_the_deepest_level_needs_no_record() {
    let mut bench = Bench::new();
    let deepest = node(2, 1 << TREE_DEPTH | 9);
    assert_eq!(bench.serve(&[deepest], &[]), (0, 0));
    assert_eq!(bench.serve(&[deepest], &[leaf(2, 9)]), (0, 1), "the record of its address is the leaf's");
    assert_eq!(bench.serve(&[deepest], &[]), (0, 0));
    assert_eq!(bench.records, [record_of(deepest); 3]);
}

#[test]
fn leaves_are_looked_up_before_nodes() {
    let mut bench = Bench::new();
    let mut order = Vec::new();
    bench.leaves.extend((0..4).map(|number| leaf(0, number)));
    bench.nodes.extend((1..5).map(|number| node(0, number)));
    for _ in 0..60 {
        order.extend(bench.cache.outputs().lookup.map(|lookup| lookup.address >> TREE_DEPTH));
        bench.clock(&mut Rng::with_seed(1), false);
    }
    assert_eq!(order, [1, 1, 1, 1, 0, 0, 0, 0]);
}

/// Any requests under random stalls: every one is answered with what the memory has, and none of an answer is lost.
#[test]
fn every_request_is_answered_whatever_the_memory_does() {
    for_each_seed("tree_cache", |random: &mut Rng| {
        let mut bench = Bench::new();
        let (mut nodes, mut leaves) = (Vec::new(), Vec::new());
        for cycle in 0..12_000 {
            if cycle < 10_000 && bench.nodes.is_empty() && random.bool() {
                // Every level as often, as in searches.
                let first = 1 << random.u32(0..=TREE_DEPTH);
                let request = node(random.u8(0..4), random.u32(first..2 * first));
                bench.nodes.push_back(request);
                nodes.push(record_of(request));
            }
            if cycle < 10_000 && bench.leaves.is_empty() && random.u8(0..4) == 0 {
                let request = leaf(random.u8(0..4), random.u32(0..20));
                bench.leaves.push_back(request);
                leaves.push(fetch_of(request));
            }
            bench.clock(random, true);
        }
        let key = |record: &NodeRecord| (record.descent.thread.thread, record.descent.node);
        nodes.sort_by_key(key);
        bench.records.sort_by_key(key);
        assert!(bench.records == nodes);
        let key = |fetch: &Fetch| (fetch.thread.thread, fetch.address);
        leaves.sort_by_key(key);
        bench.fetches.sort_by_key(key);
        assert!(bench.fetches == leaves);
        assert!(bench.hits > 500 && bench.misses > 500, "{} hits and {} misses", bench.hits, bench.misses);
    });
}
