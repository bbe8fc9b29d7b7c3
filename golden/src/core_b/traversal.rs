//! Node traversal: descends to the leaf on the query's side and remembers the other side of every plane it passes (thesis
//! 6.6.2).
//!
//! Threads share a ring of three stages that moves on whenever the path datapath does. A query on a plane goes to the right.
//! A path's squared distance is that of the query to its plane, `(c − split)²`, each operation rounded.

use super::records::{Descent, LeafVisit, Path, Point, Push, Shape, Start, Thread, TreeWrite};
use crate::datapath::Datapath;
use crate::number::Number;
use crate::stream::Skid;
use crate::unit::{Model, Record, Visitor, stream};
use pointcore_spec::Format;
use pointcore_spec::core_b::Config;

/// What the unit sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Write to the node memory.
    pub tree: Option<TreeWrite>,
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
    /// Whether a descent from the root is accepted.
    pub descend_ready: bool,
    /// Whether a descent from a path is accepted.
    pub resume_ready: bool,
    /// A path for the thread's stack.
    pub push: Option<Push>,
    /// Leaves reached.
    pub leaf: Option<LeafVisit>,
    /// The thread of the leaf that was pushed in the last cycle.
    pub reached: Option<Thread>,
    /// A node was visited in the last cycle.
    pub event_node: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Node {
    split: u32,
    dimension: u8,
    internal_leaf: bool,
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

/// What leaves the path datapath.
#[derive(Clone, Copy, Debug)]
enum Step {
    Leaf(LeafVisit),
    Push(Push),
}

/// The node traversal.
#[derive(Clone, Debug)]
pub struct Traversal {
    shape: Shape,
    geometry: Format,
    depth: u32,
    nodes: Vec<Node>,
    points: Vec<Point>,
    descend: Skid<Descent>,
    resume: Skid<Descent>,
    /// The ring's stages t0, t1, t2.
    looked_up: Option<Descent>,
    read: Option<Visit>,
    decided: Option<Decision>,
    path: Datapath<Step>,
    leaf: Skid<LeafVisit>,
    reached: Option<Thread>,
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
            nodes: vec![Node::default(); 1 << config.tree_depth],
            points: vec![Point::default(); config.threads as usize],
            descend: Skid::default(),
            resume: Skid::default(),
            looked_up: None,
            read: None,
            decided: None,
            path: Datapath::new(latency, 1),
            leaf: Skid::default(),
            reached: None,
            event_node: false,
        }
    }

    /// Address in the node memory; a leaf of the deepest level reads what does not matter.
    fn address(&self, node: u32) -> usize {
        node as usize & (self.nodes.len() - 1)
    }

    fn read(&self, descent: Descent) -> Visit {
        let node = self.nodes[self.address(descent.node)];
        Visit { descent, node, point: self.points[descent.thread.index()] }
    }

    fn decide(&self, visit: Visit) -> Decision {
        let Visit { descent: Descent { thread, node: address }, node, point } = visit;
        let deepest = address >> self.depth != 0;
        if deepest || node.internal_leaf {
            let level = address.ilog2(); // Nodes count from 1.
            return Decision::Leaf(LeafVisit { thread, leaf: self.address(address << (self.depth - level)) as u32 });
        }
        let coordinate = point[usize::from(node.dimension.min(2))];
        let (left, right) = (2 * address, 2 * address + 1);
        let is_left = self.number(coordinate).is_below(self.number(node.split));
        let (near, far) = if is_left { (left, right) } else { (right, left) };
        Decision::Inner { near: Descent { thread, node: near }, far, coordinate, split: node.split }
    }

    fn step(&self, decision: Decision) -> Step {
        match decision {
            Decision::Leaf(leaf) => Step::Leaf(leaf),
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
            descend_ready: self.descend.in_ready(),
            resume_ready: self.resume.in_ready(),
            push: match self.path.out() {
                Some(Step::Push(push)) => Some(*push),
                _ => None,
            },
            leaf: self.leaf.out().copied(),
            reached: self.reached,
            event_node: self.event_node,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let advances = self.path.in_ready();
        let (leaf, steps) = match self.path.out() {
            Some(Step::Leaf(leaf)) if self.leaf.in_ready() => (Some(*leaf), true),
            Some(Step::Leaf(_)) => (None, false),
            _ => (None, true),
        };
        let decided = self.decided.filter(|_| advances);
        self.path.step(decided.map(|decision| self.step(decision)), steps);
        self.leaf.step(leaf, inputs.leaf_ready);
        self.reached = leaf.map(|leaf| leaf.thread);
        self.event_node = decided.is_some();

        let child = match decided {
            Some(Decision::Inner { near, .. }) => Some(near),
            _ => None,
        };
        let takes_resume = advances && child.is_none();
        let takes_descend = takes_resume && self.resume.out().is_none();
        if advances {
            self.decided = self.read.map(|visit| self.decide(visit));
            self.read = self.looked_up.map(|descent| self.read(descent));
            self.looked_up = child.or(self.resume.out().copied()).or(self.descend.out().copied());
        }
        self.resume.step(inputs.resume, takes_resume);
        self.descend.step(inputs.descend, takes_descend);

        if let Some(start) = inputs.start {
            self.points[start.thread.index()] = start.query.point;
        }
        if let Some(write) = inputs.tree.filter(|write| !write.is_leaf) {
            let TreeWrite { address, split, dimension, internal_leaf, .. } = write;
            self.nodes[address as usize] = Node { split, dimension, internal_leaf };
        }
    }
}

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        stream(visitor, shape, "tree_", &mut self.tree);
        stream(visitor, shape, "start_", &mut self.start);
        stream(visitor, shape, "descend_", &mut self.descend);
        stream(visitor, shape, "resume_", &mut self.resume);
        visitor.field("leaf_ready", &mut self.leaf_ready);
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("descend_ready", &mut self.descend_ready);
        visitor.field("resume_ready", &mut self.resume_ready);
        stream(visitor, shape, "push_", &mut self.push);
        stream(visitor, shape, "leaf_", &mut self.leaf);
        stream(visitor, shape, "reached_", &mut self.reached);
        visitor.field("event_node", &mut self.event_node);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core_b::records::Query;

    const THREAD: Thread = Thread { thread: 2 };

    /// Three levels: the root splits x at 1, its left child y at 2; its right child is an internal leaf.
    fn unit(point: [f32; 3]) -> Traversal {
        let mut traversal = Traversal::new(&Config { tree_depth: 3, ..Config::default() }, 2);
        let nodes =
            [(1, 0, 1.0_f32, false), (2, 1, 2.0, false), (3, 0, 0.0, true), (4, 2, 3.0, false), (5, 2, 4.0, false)];
        for (address, dimension, split, internal_leaf) in nodes {
            let split = split.to_bits();
            let write = TreeWrite { address, dimension, split, internal_leaf, ..TreeWrite::default() };
            traversal.clock(&In { tree: Some(write), ..In::default() });
        }
        let query = Query { point: point.map(f32::to_bits), ..Query::default() };
        traversal.clock(&In { start: Some(Start { thread: THREAD, query }), ..In::default() });
        traversal
    }

    /// Descends from a node: what is pushed, in order, and the leaf.
    fn descend(traversal: &mut Traversal, node: u32) -> (Vec<(u32, f32)>, u32) {
        traversal.clock(&In { descend: Some(Descent { thread: THREAD, node }), ..In::default() });
        let mut pushed = Vec::new();
        for _ in 0..40 {
            let out = traversal.outputs();
            pushed.extend(out.push.map(|push| (push.path.node, f32::from_bits(push.path.distance2))));
            traversal.clock(&In { leaf_ready: true, ..In::default() });
            if let Some(visit) = out.leaf {
                assert_eq!(visit.thread, THREAD);
                assert_eq!(out.reached, Some(THREAD), "shown with the leaf, which found the queue empty");
                return (pushed, visit.leaf);
            }
        }
        panic!("the descent ends within the cycles of three levels");
    }

    #[test]
    fn the_far_sides_are_pushed_from_the_root_down() {
        assert_eq!(descend(&mut unit([0.5, 5.0, 1.0]), 1), (vec![(3, 0.25), (4, 9.0), (11, 9.0)], 2));
        assert_eq!(descend(&mut unit([0.5, 1.5, 3.5]), 2), (vec![(5, 0.25), (8, 0.25)], 1), "from a path");
    }

    #[test]
    fn a_query_on_a_plane_goes_right_and_an_internal_leaf_ends_the_descent() {
        assert_eq!(descend(&mut unit([1.0, 0.0, 0.0]), 1), (vec![(2, 0.0)], 4));
    }

    #[test]
    fn a_descent_shares_the_ring_with_others() {
        let mut traversal = unit([0.5, 1.5, 3.5]);
        let (mut sent, mut reached, mut visits) = (0, 0, 0);
        for _ in 0..200 {
            let out = traversal.outputs();
            let input = (sent < 20).then_some(Descent { thread: THREAD, node: 1 });
            sent += u32::from(input.is_some() && out.descend_ready);
            reached += u32::from(out.reached.is_some());
            visits += u32::from(out.event_node);
            traversal.clock(&In { descend: input, leaf_ready: true, ..In::default() });
            if reached == 20 {
                break;
            }
        }
        assert_eq!((reached, visits), (20, 80), "four nodes on the way to each leaf");
    }

    #[test]
    fn leaves_that_are_not_taken_stop_the_ring_and_lose_nothing() {
        let mut traversal = unit([2.0, 0.0, 0.0]);
        let step = |traversal: &mut Traversal, leaf_ready| {
            let out = traversal.outputs();
            traversal.clock(&In { descend: Some(Descent { thread: THREAD, node: 1 }), leaf_ready, ..In::default() });
            (u32::from(out.descend_ready), u32::from(out.leaf.is_some() && leaf_ready))
        };
        let sent: u32 = (0..100).map(|_| step(&mut traversal, false).0).sum();
        assert!((2..12).contains(&sent), "{sent} descents are held in the unit");
        let (more, left) = (0..100).map(|_| step(&mut traversal, true)).fold((0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
        assert!(left > 40 && sent + more - left < 12, "{sent} + {more} entered, {left} left");
    }
}
