//! Records of the tree and of the way through it.

use super::{Shape, Thread};
use crate::unit::{Record, Visitor};

/// What a node holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Node {
    /// Where its plane cuts its dimension.
    pub split: u32,
    /// Its dimension.
    pub dimension: u8,
    /// It is a leaf.
    pub internal_leaf: bool,
}

impl Record<Shape> for Node {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("split", &mut self.split);
        visitor.field("dimension", &mut self.dimension);
        visitor.field("internal_leaf", &mut self.internal_leaf);
    }
}

/// Where the points of a leaf lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bucket {
    /// The first beat.
    pub begin: u32,
    /// The number of beats, at least one.
    pub beats: u8,
}

impl Record<Shape> for Bucket {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("begin", &mut self.begin);
        visitor.field("beats", &mut self.beats);
    }
}

/// A write to the tree memories by the host.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TreeWrite {
    /// Chooses the leaf table, else the node memory.
    pub is_leaf: bool,
    /// The leaf's number or the node.
    pub address: u32,
    /// What a node holds.
    pub node: Node,
    /// What a leaf holds.
    pub bucket: Bucket,
}

impl Record<Shape> for TreeWrite {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("is_leaf", &mut self.is_leaf);
        visitor.field("address", &mut self.address);
        self.node.visit(shape, visitor);
        self.bucket.visit(shape, visitor);
    }
}

/// A request for a record of a tree in external memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lookup {
    /// Thread under which it is answered.
    pub thread: Thread,
    /// The node, or `2^tree_depth + l` for leaf `l` of the deepest level.
    pub address: u32,
}

impl Record<Shape> for Lookup {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.thread.visit(shape, visitor);
        visitor.field("address", &mut self.address);
    }
}

/// A record of a tree in external memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TreeRecord {
    /// The request that it answers.
    pub lookup: Lookup,
    /// What a node holds.
    pub node: Node,
    /// What a leaf holds.
    pub bucket: Bucket,
}

impl Record<Shape> for TreeRecord {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.lookup.visit(shape, visitor);
        self.node.visit(shape, visitor);
        self.bucket.visit(shape, visitor);
    }
}

/// A node where a thread's descent has come to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NodeRecord {
    /// Whose it is and its address.
    pub descent: Descent,
    /// What it holds.
    pub node: Node,
}

impl Record<Shape> for NodeRecord {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.descent.visit(shape, visitor);
        self.node.visit(shape, visitor);
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
