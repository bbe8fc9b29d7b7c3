//! Tree cache: keeps records of a tree in external memory (the second column of thesis table 6.3).
//!
//! A line a record, chosen by the low bits of its address: a node's own, or `2^tree_depth + l` for leaf `l`. A node of the deepest
//! level needs no record and gets one of zeros. The lines are cleared after reset, one a cycle; a model has none to clear, but waits
//! as long.

use super::events::Served;
use super::records::{Bucket, Descent, Fetch, LeafVisit, Lookup, Node, NodeRecord, Shape, TreeRecord};
use crate::stream::{Fifo, Skid};
use crate::unit::{Model, Record, Visitor, stream};
use pointcore_contract::search::Config;
use pointcore_contract::search::ports::TREE_CACHE_EVENTS;
use std::mem::discriminant;

/// What the unit sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Nodes that the traversal has come to.
    pub node: Option<Descent>,
    /// Leaves reached.
    pub leaf: Option<LeafVisit>,
    /// Whether the traversal takes a node's record.
    pub record_ready: bool,
    /// Whether a leaf's request is taken.
    pub fetch_ready: bool,
    /// Whether the memory takes a request.
    pub lookup_ready: bool,
    /// Records from memory, in any order.
    pub fill: Option<TreeRecord>,
}

/// What the unit shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Out {
    /// Whether a node is accepted.
    pub node_ready: bool,
    /// Whether a leaf is accepted.
    pub leaf_ready: bool,
    /// Nodes with what they hold.
    pub record: Option<NodeRecord>,
    /// Requests for the points of leaves.
    pub fetch: Option<Fetch>,
    /// Requests to the memory.
    pub lookup: Option<Lookup>,
    /// Whether a record from memory is accepted.
    pub fill_ready: bool,
    /// Records found in the cache and not, in the last cycle.
    pub events: Served,
}

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
    shape: Shape,
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
    events: Served,
}

impl TreeCache {
    /// The unit after reset, for a configuration with a tree cache.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let (nodes, leaves) = (config.threads, config.threads * config.leaves_in_flight);
        Self {
            shape: Shape::new(config),
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
            events: Served::default(),
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
    type Shape = Shape;
    type In = In;
    type Out = Out;

    fn shape(&self) -> Shape {
        self.shape
    }

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
        self.events = Served { hit: served.is_some() && counts, miss: missed.is_some() };

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

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        stream(visitor, shape, "node_", &mut self.node);
        stream(visitor, shape, "leaf_", &mut self.leaf);
        visitor.field("record_ready", &mut self.record_ready);
        visitor.field("fetch_ready", &mut self.fetch_ready);
        visitor.field("lookup_ready", &mut self.lookup_ready);
        stream(visitor, shape, "fill_", &mut self.fill);
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("node_ready", &mut self.node_ready);
        visitor.field("leaf_ready", &mut self.leaf_ready);
        stream(visitor, shape, "record_", &mut self.record);
        stream(visitor, shape, "fetch_", &mut self.fetch);
        stream(visitor, shape, "lookup_", &mut self.lookup);
        visitor.field("fill_ready", &mut self.fill_ready);
        self.events.visit(visitor, TREE_CACHE_EVENTS);
    }
}

#[cfg(test)]
mod tests;
