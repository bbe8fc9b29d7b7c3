//! The search core, nearest neighbors in a kd-tree, unit by unit as docs/search.md and its pages describe it.
//!
//! A unit is a [`Model`](crate::unit::Model) over what the contract says that it sees and shows; [`Ported`](crate::unit::Ported) gives
//! it ports.

pub mod leaf;
pub mod neighbor_cache;
pub mod point_cache;
pub mod queue;
pub mod recursion;
pub mod sieve;
pub mod stack;
pub mod threads;
pub mod top;
pub mod traversal;
pub mod tree_cache;

pub use leaf::Leaf;
pub use neighbor_cache::NeighborCache;
pub use point_cache::PointCache;
pub use queue::Queue;
pub use recursion::Recursion;
pub use sieve::Sieve;
pub use stack::Stack;
pub use threads::Threads;
pub use top::Top;
pub use traversal::Traversal;
pub use tree_cache::TreeCache;

/// Stages of the compiled pipelines, from the manifests that the generator writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latencies {
    /// Of the squared distance to a splitting plane.
    pub path: u32,
    /// Of the squared distances to a beat of points, no less than of a path: it has a path's operations and more.
    pub distance: u32,
    /// Of the neighbor cache, where there is one.
    pub neighbor_cache: Option<CacheLatencies>,
}

/// Stages of the neighbor cache's pipelines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CacheLatencies {
    /// Of the coherence check.
    pub check: u32,
    /// Of the value that queries are compared with.
    pub cover: u32,
}
