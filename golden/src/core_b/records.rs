//! The records that flow between core B's units, field for field as the specification's `core_b::records` lists them.
//!
//! Encoded numbers are `u32`: every format the search computes in fits.

use crate::unit::{Record, Visitor};
use pointcore_spec::core_b::Config;

/// The most points a beat holds.
pub const LANES_MAX: usize = 8;

/// What the layout of the records depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Points of a beat.
    pub lanes: usize,
}

impl Shape {
    /// The layout of a configuration.
    #[must_use]
    pub const fn new(config: &Config) -> Self {
        Self { lanes: config.lanes as usize }
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

/// A request for the points of a leaf.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fetch {
    /// Thread under which it is answered.
    pub thread: Thread,
    /// First beat.
    pub address: u32,
    /// Number of beats, at least one.
    pub beats: u8,
}

impl Record<Shape> for Fetch {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.thread.visit(shape, visitor);
        visitor.field("address", &mut self.address);
        visitor.field("beats", &mut self.beats);
    }
}

/// Whose a beat is and where it lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BeatPlace {
    /// Thread.
    pub thread: Thread,
    /// Address in the point memory.
    pub address: u32,
    /// Closes its leaf.
    pub last: bool,
}

impl BeatPlace {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.thread.visit(shape, visitor);
        visitor.field("address", &mut self.address);
        visitor.field("last", &mut self.last);
    }
}

/// A beat of points from memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Beat {
    /// Thread and address.
    pub place: BeatPlace,
    /// A point a lane; NaN where there is none.
    pub points: [Point; LANES_MAX],
}

impl Record<Shape> for Beat {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.place.visit(shape, visitor);
        for (point, names) in self.points[..shape.lanes].iter_mut().zip(POINTS) {
            visit_point(point, names, visitor);
        }
    }
}

const POINTS: [[&str; 3]; LANES_MAX] = [
    ["x0", "y0", "z0"],
    ["x1", "y1", "z1"],
    ["x2", "y2", "z2"],
    ["x3", "y3", "z3"],
    ["x4", "y4", "z4"],
    ["x5", "y5", "z5"],
    ["x6", "y6", "z6"],
    ["x7", "y7", "z7"],
];

/// A beat of squared distances.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Candidates {
    /// Thread and address.
    pub place: BeatPlace,
    /// A squared distance a lane; NaN where there is no point.
    pub distances: [u32; LANES_MAX],
}

impl Record<Shape> for Candidates {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.place.visit(shape, visitor);
        for (distance, name) in self.distances[..shape.lanes].iter_mut().zip(DISTANCES) {
            visitor.field(name, distance);
        }
    }
}

const DISTANCES: [&str; LANES_MAX] =
    ["distance0", "distance1", "distance2", "distance3", "distance4", "distance5", "distance6", "distance7"];

/// A thread's search radius after a leaf.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Radius {
    /// Thread.
    pub thread: Thread,
    /// Squared radius.
    pub radius2: u32,
}

impl Record<Shape> for Radius {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.thread.visit(shape, visitor);
        visitor.field("radius2", &mut self.radius2);
    }
}
