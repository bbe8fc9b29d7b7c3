//! Tree cache: keeps records of a tree in external memory (the second column of thesis table 6.3).
//!
//! A line a record, chosen by the low bits of its address: a node's own, or `2^tree_depth + l` for leaf `l`. A node of the deepest
//! level needs no record and gets one of zeros. The lines are cleared after reset, one a cycle; a model has none to clear, but waits
//! as long.

use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Bucket, Descent, Fetch, LeafVisit, Lookup, Node, NodeRecord, TreeRecord};
use pointcore_contract::search::units::TreeCacheEvents;
pub use pointcore_contract::search::units::tree_cache::{In, Out};
use std::mem::discriminant;

/// What a request asks for, by the output that answers it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wanted {
    Node,
    /// A node that needs no record.
    DeepestNode,
    Leaf,
}

/// A record that the cache keeps.
#[derive(Clone, Copy, Debug)]
struct Line {
    address: u32,
    node: Node,
    bucket: Bucket,
}

/// A request with the line that it read.
#[derive(Clone, Copy, Debug)]
struct LookedUp {
    lookup: Lookup,
    wanted: Wanted,
    line: Option<Line>,
}

/// What leaves the unit for a request.
#[derive(Clone, Copy, Debug)]
enum Answer {
    Record(NodeRecord),
    Fetch(Fetch),
}

impl LookedUp {
    /// The answer, if the line that was read has it.
    fn answer(&self) -> Option<Answer> {
        let line = self.line.filter(|line| line.address == self.lookup.address);
        match self.wanted {
            Wanted::Node => line.map(|line| record(self.lookup, line.node)),
            Wanted::DeepestNode => Some(record(self.lookup, Node::default())),
            Wanted::Leaf => line.map(|line| fetch(self.lookup, line.bucket)),
        }
    }
}

fn record(Lookup { thread, address }: Lookup, node: Node) -> Answer {
    Answer::Record(NodeRecord { descent: Descent { thread, node: address }, node })
}

fn fetch(Lookup { thread, .. }: Lookup, Bucket { begin, beats }: Bucket) -> Answer {
    Answer::Fetch(Fetch { thread, address: begin, beats })
}

/// The tree cache.
#[derive(Clone, Debug)]
pub struct TreeCache {
    tree_depth: u32,
    lines: Vec<Option<Line>>,
    /// Lines that the hardware has cleared since reset.
    cleared: usize,
    node: Fifo<Descent>,
    leaf: Fifo<LeafVisit>,
    fill: Skid<TreeRecord>,
    /// The stages b and c.
    reading: Option<LookedUp>,
    looked_up: Option<LookedUp>,
    record: Skid<NodeRecord>,
    fetch: Skid<Fetch>,
    lookup: Skid<Lookup>,
    events: TreeCacheEvents,
}

impl TreeCache {
    /// The unit after reset, for a configuration with a tree cache.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let (nodes, leaves) = (config.threads, config.threads * config.leaves_in_flight);
        Self {
            tree_depth: config.tree_depth,
            lines: vec![None; config.tree_cache as usize],
            cleared: 0,
            node: Fifo::new(nodes.max(2) as usize),
            leaf: Fifo::new(leaves.max(2) as usize),
            fill: Skid::default(),
            reading: None,
            looked_up: None,
            record: Skid::default(),
            fetch: Skid::default(),
            lookup: Skid::default(),
            events: TreeCacheEvents::default(),
        }
    }

    fn line(&self, address: u32) -> usize {
        address as usize & (self.lines.len() - 1)
    }

    /// Of the deepest level, where leaves have the addresses of nodes.
    fn is_deepest(&self, address: u32) -> bool {
        address >> self.tree_depth != 0
    }

    /// The next request; leaves come first.
    fn look_up(&self) -> Option<LookedUp> {
        let node = |Descent { thread, node: address }: &Descent| {
            let wanted = if self.is_deepest(*address) { Wanted::DeepestNode } else { Wanted::Node };
            (Lookup { thread: *thread, address: *address }, wanted)
        };
        let leaf = |LeafVisit { thread, leaf }: &LeafVisit| {
            (Lookup { thread: *thread, address: 1 << self.tree_depth | leaf }, Wanted::Leaf)
        };
        let (lookup, wanted) = self.leaf.out().map(leaf).or(self.node.out().map(node))?;
        Some(LookedUp { lookup, wanted, line: self.lines[self.line(lookup.address)] })
    }

    fn has_room(&self, answer: &Answer) -> bool {
        match answer {
            Answer::Record(_) => self.record.in_ready(),
            Answer::Fetch(_) => self.fetch.in_ready(),
        }
    }

    /// What a record from memory answers.
    fn filled(&self, fill: &TreeRecord) -> Answer {
        if self.is_deepest(fill.lookup.address) {
            fetch(fill.lookup, fill.bucket)
        } else {
            record(fill.lookup, fill.node)
        }
    }
}

impl Model for TreeCache {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            node_ready: self.node.in_ready(),
            leaf_ready: self.leaf.in_ready(),
            record: self.record.out().copied(),
            fetch: self.fetch.out().copied(),
            lookup: self.lookup.out().copied(),
            fill_ready: self.fill.in_ready(),
            events: self.events,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let is_clear = self.cleared == self.lines.len();
        self.cleared += usize::from(!is_clear);
        let fill = self.fill.out().copied().filter(|fill| is_clear && self.has_room(&self.filled(fill)));
        let filled = fill.map(|fill| self.filled(&fill));
        let is_taken = |answer: &Answer| filled.is_some_and(|filled| discriminant(&filled) == discriminant(answer));

        let answer = self.looked_up.and_then(|request| request.answer());
        let served = answer.filter(|answer| self.has_room(answer) && !is_taken(answer));
        let misses = answer.is_none() && self.lookup.in_ready();
        let missed = self.looked_up.filter(|_| misses).map(|request| request.lookup);
        let counts = self.looked_up.is_some_and(|request| request.wanted != Wanted::DeepestNode);
        self.events = TreeCacheEvents { hit: served.is_some() && counts, miss: missed.is_some() };

        let (mut record, mut fetch) = (None, None);
        for answer in [filled, served].into_iter().flatten() {
            match answer {
                Answer::Record(answer) => record = Some(answer),
                Answer::Fetch(answer) => fetch = Some(answer),
            }
        }
        let advances = self.looked_up.is_none() || served.is_some() || missed.is_some();
        let takes_leaf = advances && is_clear;
        let takes_node = takes_leaf && self.leaf.out().is_none();
        if advances {
            self.looked_up = self.reading.take();
            self.reading = if is_clear { self.look_up() } else { None };
        }
        if let Some(TreeRecord { lookup: Lookup { address, .. }, node, bucket }) = fill {
            let line = self.line(address);
            self.lines[line] = Some(Line { address, node, bucket });
        }
        self.record.step(record, inputs.record_ready);
        self.fetch.step(fetch, inputs.fetch_ready);
        self.lookup.step(missed, inputs.lookup_ready);
        self.node.step(inputs.node, takes_node);
        self.leaf.step(inputs.leaf, takes_leaf);
        self.fill.step(inputs.fill, fill.is_some());
    }
}

#[cfg(test)]
mod tests;
