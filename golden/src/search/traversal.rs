//! Node traversal: descends to the leaf on the query's side and remembers the other side of every plane it passes (thesis
//! 6.6.2).
//!
//! Threads share a ring of two stages: a node is fetched, then visited. A query on a plane goes to the right. A leaf is sent off as soon as it is found; that it is
//! reached follows the thread's paths through their datapath, so that the thread pops none before they are pushed. A path's
//! squared distance is that of the query to its plane, `(c − split)²`, each operation rounded.

mod nodes;

use super::records::{Descent, LeafVisit, Node, NodeRecord, Path, Point, Push, Shape, Start, Thread, TreeWrite};
use crate::datapath::Datapath;
use crate::number::Number;
use crate::stream::Skid;
use crate::unit::{Model, Record, Visitor, stream};
use nodes::Nodes;
use pointcore_contract::Format;
use pointcore_contract::search::Config;

/// What the unit sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Write to the node memory, without a tree cache.
    pub tree: Option<TreeWrite>,
    /// Whether the tree cache takes a node.
    pub node_ready: bool,
    /// Nodes from the tree cache.
    pub record: Option<NodeRecord>,
    /// A thread taking up a query.
    pub start: Option<Start>,
    /// Descents from the root.
    pub descend: Option<Descent>,
    /// Descents from a path that was not taken before.
    pub resume: Option<Descent>,
    /// Whether the leaf unit takes a leaf.
    pub leaf_ready: bool,
}

/// What the unit shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Out {
    /// Nodes that the tree cache is to look up.
    pub node: Option<Descent>,
    /// Whether a node from the tree cache is accepted.
    pub record_ready: bool,
    /// Whether a descent from the root is accepted.
    pub descend_ready: bool,
    /// Whether a descent from a path is accepted.
    pub resume_ready: bool,
    /// A path for the thread's stack.
    pub push: Option<Push>,
    /// Leaves reached.
    pub leaf: Option<LeafVisit>,
    /// A thread whose paths down to a leaf have all been pushed.
    pub reached: Option<Thread>,
    /// A node was visited in the last cycle.
    pub event_node: bool,
}

/// A node and what is needed to decide on it.
#[derive(Clone, Copy, Debug)]
struct Visit {
    descent: Descent,
    node: Node,
    point: Point,
}

#[derive(Clone, Copy, Debug)]
enum Decision {
    Leaf(LeafVisit),
    Inner { near: Descent, far: u32, coordinate: u32, split: u32 },
}

impl Decision {
    /// The leaf that is found.
    const fn leaf(self) -> Option<LeafVisit> {
        match self {
            Self::Leaf(leaf) => Some(leaf),
            Self::Inner { .. } => None,
        }
    }

    /// Where the descent goes on.
    const fn near(self) -> Option<Descent> {
        match self {
            Self::Leaf(_) => None,
            Self::Inner { near, .. } => Some(near),
        }
    }
}

/// What leaves the path datapath.
#[derive(Clone, Copy, Debug)]
enum Step {
    Reached(Thread),
    Push(Push),
}

/// The node traversal.
#[derive(Clone, Debug)]
pub struct Traversal {
    shape: Shape,
    geometry: Format,
    depth: u32,
    nodes: Nodes,
    points: Vec<Point>,
    descend: Skid<Descent>,
    resume: Skid<Descent>,
    /// The ring's stages f and v.
    fetched: Option<Descent>,
    visited: Option<Visit>,
    /// What v held before, on its way to the path pipeline: s.
    decided: Option<Decision>,
    path: Datapath<Step>,
    leaf: Skid<LeafVisit>,
    event_node: bool,
}

impl Traversal {
    /// The unit with a path pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            shape: Shape::new(config),
            geometry: config.geometry,
            depth: config.tree_depth,
            nodes: Nodes::new(config),
            points: vec![Point::default(); config.threads as usize],
            descend: Skid::default(),
            resume: Skid::default(),
            fetched: None,
            visited: None,
            decided: None,
            path: Datapath::new(latency, 1),
            leaf: Skid::default(),
            event_node: false,
        }
    }

    fn decide(&self, visit: Visit) -> Decision {
        let Visit { descent: Descent { thread, node: address }, node, point } = visit;
        let deepest = address >> self.depth != 0;
        if deepest || node.internal_leaf {
            let level = address.ilog2(); // Nodes count from 1.
            return Decision::Leaf(LeafVisit { thread, leaf: (address << (self.depth - level)) - (1 << self.depth) });
        }
        let coordinate = point[usize::from(node.dimension.min(2))];
        let (left, right) = (2 * address, 2 * address + 1);
        let is_left = self.number(coordinate).is_below(self.number(node.split));
        let (near, far) = if is_left { (left, right) } else { (right, left) };
        Decision::Inner { near: Descent { thread, node: near }, far, coordinate, split: node.split }
    }

    fn step(&self, decision: Decision) -> Step {
        match decision {
            Decision::Leaf(leaf) => Step::Reached(leaf.thread),
            Decision::Inner { near, far, coordinate, split } => {
                let distance = self.number(coordinate) - self.number(split);
                let path = Path { node: far, distance2: (distance * distance).bits() };
                Step::Push(Push { thread: near.thread, path })
            }
        }
    }

    fn number(&self, bits: u32) -> Number {
        Number::new(self.geometry, bits)
    }
}

impl Model for Traversal {
    type Shape = Shape;
    type In = In;
    type Out = Out;

    fn shape(&self) -> Shape {
        self.shape
    }

    fn outputs(&self) -> Out {
        Out {
            node: self.nodes.wanted(),
            record_ready: self.nodes.takes_record(),
            descend_ready: self.descend.in_ready(),
            resume_ready: self.resume.in_ready(),
            push: match self.path.out() {
                Some(Step::Push(push)) => Some(*push),
                _ => None,
            },
            leaf: self.leaf.out().copied(),
            reached: match self.path.out() {
                Some(Step::Reached(thread)) => Some(*thread),
                _ => None,
            },
            event_node: self.event_node,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let decision = self.visited.map(|visit| self.decide(visit));
        let found = decision.and_then(Decision::leaf);
        let leaf_has_room = found.is_none() || self.leaf.in_ready();
        let advances = self.path.in_ready() && self.nodes.has_room() && leaf_has_room;
        let decided = self.decided.filter(|_| advances);
        self.path.step(decided.map(|decision| self.step(decision)), true);
        self.leaf.step(found.filter(|_| advances), inputs.leaf_ready);
        self.event_node = advances && decision.is_some();

        let child = decision.and_then(Decision::near);
        let takes_resume = advances && child.is_none();
        let takes_descend = takes_resume && self.resume.out().is_none();
        let wanted = self.fetched;
        if advances {
            self.decided = decision;
            self.visited = self.nodes.read(wanted).map(|NodeRecord { descent, node }| {
                let point = self.points[descent.thread.index()];
                Visit { descent, node, point }
            });
            self.fetched = child.or(self.resume.out().copied()).or(self.descend.out().copied());
        }
        self.nodes.step(wanted, advances, inputs);
        self.resume.step(inputs.resume, takes_resume);
        self.descend.step(inputs.descend, takes_descend);

        if let Some(start) = inputs.start {
            self.points[start.thread.index()] = start.query.point;
        }
    }
}

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        if shape.tree_cache {
            visitor.field("node_ready", &mut self.node_ready);
            stream(visitor, shape, "record_", &mut self.record);
        } else {
            stream(visitor, shape, "tree_", &mut self.tree);
        }
        stream(visitor, shape, "start_", &mut self.start);
        stream(visitor, shape, "descend_", &mut self.descend);
        stream(visitor, shape, "resume_", &mut self.resume);
        visitor.field("leaf_ready", &mut self.leaf_ready);
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        if shape.tree_cache {
            stream(visitor, shape, "node_", &mut self.node);
            visitor.field("record_ready", &mut self.record_ready);
        }
        visitor.field("descend_ready", &mut self.descend_ready);
        visitor.field("resume_ready", &mut self.resume_ready);
        stream(visitor, shape, "push_", &mut self.push);
        stream(visitor, shape, "leaf_", &mut self.leaf);
        stream(visitor, shape, "reached_", &mut self.reached);
        visitor.field("event_node", &mut self.event_node);
    }
}

#[cfg(test)]
mod tests;
