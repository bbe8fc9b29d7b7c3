//! The records that flow through the search core.
//!
//! Coordinates and squared distances are values of [`Config::geometry`], of which every format fits a `u32`; everything else is an
//! unsigned integer.

mod cache;
mod points;
mod tree;

pub use cache::{CacheSetup, CachedQuery, CachedResult};
pub use points::{Beat, BeatPlace, Candidates, Fetch, LANES_MAX, Points, Radius};
pub use tree::{Bucket, Descent, LeafVisit, Lookup, Node, NodeRecord, Path, Push, TreeRecord, TreeWrite};

use super::config::Config;
use crate::record;

/// Names of a point's coordinates.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// A point's coordinates.
pub type Point = [u32; 3];

/// A query: what is sought, and for which number.
#[record(config: Config)]
pub struct Query {
    /// Its number, which its results bear.
    #[bits(config.index_bits)]
    pub number: u32,
    /// Neighbors wanted.
    #[bits(config.rank_bits())]
    pub k: u8,
    /// Squared radius within which neighbors count.
    #[bits(config.geometry.width())]
    #[below(config.geometry.sign_mask())]
    pub radius2: u32,
    /// Where.
    #[name(AXES[i])]
    #[bits(config.geometry.width())]
    pub point: [u32; 3],
}

/// One neighbor of a query, nearest first. A query without any neighbor has one result with `found` low.
#[record(config: Config)]
pub struct QueryResult {
    /// The query's number.
    #[bits(config.index_bits)]
    pub number: u32,
    /// Closes the query.
    pub last: bool,
    /// Low for a query without any neighbor.
    pub found: bool,
    /// The neighbor's place in the point memory.
    #[bits(config.index_bits)]
    pub index: u32,
    /// Its squared distance.
    #[bits(config.geometry.width())]
    #[below(config.geometry.sign_mask())]
    pub distance2: u32,
}

/// A thread alone.
#[record(config: Config)]
pub struct Thread {
    /// Thread.
    #[bits(config.thread_bits())]
    #[below(config.threads)]
    pub thread: u8,
}

impl Thread {
    /// The thread's place among what is held for each thread.
    #[must_use]
    pub fn index(self) -> usize {
        usize::from(self.thread)
    }
}

/// A thread taking up a query.
#[record(config: Config)]
pub struct Start {
    /// Thread.
    pub thread: Thread,
    /// Query.
    pub query: Query,
}
