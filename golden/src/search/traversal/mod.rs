//! Node traversal: descends to the leaf on the query's side and remembers the other side of every plane it passes (thesis
//! 6.6.2).
//!
//! Threads share a ring of two stages: a node is fetched, then visited. A query on a plane goes to the right. A leaf is sent off as soon as it is found; that it is
//! reached follows the thread's paths through their datapath, so that the thread pops none before they are pushed. A path's
//! squared distance is that of the query to its plane, `(c − split)²`, each operation rounded.

mod nodes;

use crate::datapath::{Datapath, Token};
use crate::number::Number;
use crate::stream::Skid;
use crate::unit::Model;
use nodes::Nodes;
use pointcore_contract::Format;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Descent, LeafVisit, Node, NodeRecord, Path, Point, Push, Thread};
pub use pointcore_contract::search::units::traversal::{In, Out};

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
            geometry: config.geometry,
            depth: config.tree_depth,
            nodes: Nodes::new(config),
            points: vec![Point::default(); config.threads as usize],
            descend: Skid::default(),
            resume: Skid::default(),
            fetched: None,
            visited: None,
            decided: None,
            path: Datapath::always_taken(latency, 1),
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
    type Config = Config;
    type In = In;
    type Out = Out;

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
        self.path.step(decided.map(|decision| Token::Kept(self.step(decision))), true);
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

#[cfg(test)]
mod tests;
