//! Records of the tree and of the way through it.

use super::Thread;
use crate::record;
use crate::search::Config;
use crate::search::config::DIMENSION_BITS;

/// What a node holds.
#[record(config: Config)]
pub struct Node {
    /// Where its plane cuts its dimension.
    #[bits(config.geometry.width())]
    pub split: u32,
    /// Its dimension.
    #[bits(DIMENSION_BITS)]
    pub dimension: u8,
    /// It is a leaf.
    pub internal_leaf: bool,
}

/// Where the points of a leaf lie.
#[record(config: Config)]
pub struct Bucket {
    /// The first beat.
    #[bits(config.beat_bits())]
    pub begin: u32,
    /// The number of beats, at least one.
    #[bits(config.beats_bits())]
    pub beats: u8,
}

/// A write to the tree memories by the host.
#[record(config: Config)]
pub struct TreeWrite {
    /// Chooses the leaf table, else the node memory.
    pub is_leaf: bool,
    /// The leaf's number or the node.
    #[bits(config.tree_depth)]
    pub address: u32,
    /// What a node holds.
    pub node: Node,
    /// What a leaf holds.
    pub bucket: Bucket,
}

/// A request for a record of a tree in external memory.
#[record(config: Config)]
pub struct Lookup {
    /// Thread under which it is answered.
    pub thread: Thread,
    /// The node, or `2^tree_depth + l` for leaf `l` of the deepest level.
    #[bits(config.node_bits())]
    pub address: u32,
}

/// A record of a tree in external memory: of a node its first part counts, of a leaf its second.
#[record(config: Config)]
pub struct TreeRecord {
    /// The request that it answers.
    pub lookup: Lookup,
    /// What a node holds.
    pub node: Node,
    /// What a leaf holds.
    pub bucket: Bucket,
}

/// Where a thread is to descend from.
#[record(config: Config)]
pub struct Descent {
    /// Thread.
    pub thread: Thread,
    /// Node: 1 is the root, `2i` and `2i + 1` are the children of `i`.
    #[bits(config.node_bits())]
    pub node: u32,
}

/// A node where a thread's descent has come to.
#[record(config: Config)]
pub struct NodeRecord {
    /// Whose it is and its address.
    pub descent: Descent,
    /// What it holds.
    pub node: Node,
}

/// A path not taken.
#[record(config: Config)]
pub struct Path {
    /// The subtree's root.
    #[bits(config.node_bits())]
    pub node: u32,
    /// Squared distance of the query to the splitting plane before it.
    #[bits(config.square_bits())]
    pub distance2: u32,
}

/// A path not taken by a thread.
#[record(config: Config)]
pub struct Push {
    /// Thread.
    pub thread: Thread,
    /// Path.
    pub path: Path,
}

/// A leaf that a thread has reached.
#[record(config: Config)]
pub struct LeafVisit {
    /// Thread.
    pub thread: Thread,
    /// The leaf's number among those of the deepest level (eq. 6.7).
    #[bits(config.tree_depth)]
    pub leaf: u32,
}
