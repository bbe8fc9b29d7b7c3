//! Records of the tree and of the way through it.

use super::{Shape, Thread};
use crate::unit::{Record, Visitor};

/// A write to the tree memories by the host.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TreeWrite {
    /// Chooses the leaf table, else the node memory.
    pub is_leaf: bool,
    /// The leaf's number or the node.
    pub address: u32,
    /// Where the node's plane cuts its dimension.
    pub split: u32,
    /// The node's dimension.
    pub dimension: u8,
    /// The node is a leaf.
    pub internal_leaf: bool,
    /// The leaf's first beat.
    pub begin: u32,
    /// The leaf's number of beats.
    pub beats: u8,
}

impl Record<Shape> for TreeWrite {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("is_leaf", &mut self.is_leaf);
        visitor.field("address", &mut self.address);
        visitor.field("split", &mut self.split);
        visitor.field("dimension", &mut self.dimension);
        visitor.field("internal_leaf", &mut self.internal_leaf);
        visitor.field("begin", &mut self.begin);
        visitor.field("beats", &mut self.beats);
    }
}

/// Where a thread is to descend from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Descent {
    /// Thread.
    pub thread: Thread,
    /// Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    pub node: u32,
}

impl Record<Shape> for Descent {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.thread.visit(shape, visitor);
        visitor.field("node", &mut self.node);
    }
}

/// A path not taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Path {
    /// The subtree's root.
    pub node: u32,
    /// Squared distance of the query to the splitting plane before it.
    pub distance2: u32,
}

impl Record<Shape> for Path {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("node", &mut self.node);
        visitor.field("distance2", &mut self.distance2);
    }
}

/// A path not taken by a thread.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Push {
    /// Thread.
    pub thread: Thread,
    /// Path.
    pub path: Path,
}

impl Record<Shape> for Push {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.thread.visit(shape, visitor);
        self.path.visit(shape, visitor);
    }
}

/// A leaf that a thread has reached.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LeafVisit {
    /// Thread.
    pub thread: Thread,
    /// The leaf's number among those of the deepest level (eq. 6.7).
    pub leaf: u32,
}

impl Record<Shape> for LeafVisit {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.thread.visit(shape, visitor);
        visitor.field("leaf", &mut self.leaf);
    }
}
