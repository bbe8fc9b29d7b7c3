//! Records of points and their squared distances.

use super::{Point, Shape, Thread, visit_point};
use crate::unit::{Record, Visitor};

/// The most points a beat holds.
pub const LANES_MAX: usize = 8;

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
