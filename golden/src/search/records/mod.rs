//! The records that flow between the search core's units, field for field as the specification's `search::records` lists them.
//!
//! Encoded numbers are `u32`: every format the search computes in fits.

mod cache;
mod points;
mod tree;

pub use cache::{CacheSetup, CachedQuery, CachedResult};
pub use points::{Beat, BeatPlace, Candidates, Fetch, LANES_MAX, Radius};
pub use tree::{Bucket, Descent, LeafVisit, Lookup, Node, NodeRecord, Path, Push, TreeRecord, TreeWrite};

use crate::unit::{Record, Visitor};
use pointcore_contract::search::Config;

/// What the layout of the records depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Points of a beat.
    pub lanes: usize,
    /// The core has a point cache.
    pub point_cache: bool,
    /// The tree is in external memory, behind a tree cache.
    pub tree_cache: bool,
    /// The core has a neighbor cache.
    pub neighbor_cache: bool,
}

impl Shape {
    /// The layout of a configuration.
    #[must_use]
    pub const fn new(config: &Config) -> Self {
        Self {
            lanes: config.lanes as usize,
            point_cache: config.point_cache > 0,
            tree_cache: config.tree_cache > 0,
            neighbor_cache: config.neighbor_cache > 0,
        }
    }
}

/// A point's coordinates.
pub type Point = [u32; 3];

fn visit_point(point: &mut Point, names: [&'static str; 3], visitor: &mut impl Visitor) {
    for (coordinate, name) in point.iter_mut().zip(names) {
        visitor.field(name, coordinate);
    }
}

/// A query as the host sends it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Query {
    /// Its number, which its results bear.
    pub number: u32,
    /// Neighbors wanted.
    pub k: u8,
    /// Squared radius within which neighbors count.
    pub radius2: u32,
    /// Where.
    pub point: Point,
}

impl Record<Shape> for Query {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("number", &mut self.number);
        visitor.field("k", &mut self.k);
        visitor.field("radius2", &mut self.radius2);
        visit_point(&mut self.point, ["x", "y", "z"], visitor);
    }
}

/// A neighbor of a query.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct QueryResult {
    /// The query's number.
    pub number: u32,
    /// Closes the query.
    pub last: bool,
    /// Low for a query without any neighbor.
    pub found: bool,
    /// The neighbor's place in the point memory.
    pub index: u32,
    /// Its squared distance.
    pub distance2: u32,
}

impl Record<Shape> for QueryResult {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("number", &mut self.number);
        visitor.field("last", &mut self.last);
        visitor.field("found", &mut self.found);
        visitor.field("index", &mut self.index);
        visitor.field("distance2", &mut self.distance2);
    }
}

/// A thread alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Thread {
    /// Thread.
    pub thread: u8,
}

impl Thread {
    /// The thread's place among what is held for each thread.
    #[must_use]
    pub fn index(self) -> usize {
        usize::from(self.thread)
    }
}

impl Record<Shape> for Thread {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("thread", &mut self.thread);
    }
}

/// A thread taking up a query.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Start {
    /// Thread.
    pub thread: Thread,
    /// Query.
    pub query: Query,
}

impl Record<Shape> for Start {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.thread.visit(shape, visitor);
        self.query.visit(shape, visitor);
    }
}
