//! The records that a core with a neighbor cache exchanges with the host.

use super::{Query, QueryResult, Shape};
use crate::unit::{Record, Visitor};

/// How the cache judges its neighborhoods.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CacheSetup {
    /// Queries are balls, else k nearest neighbors.
    pub ball: bool,
    /// Factor of the distance to the farthest neighbor.
    pub far_scale: u32,
    /// Factor of what is left of it.
    pub margin_scale: u32,
}

impl Record<Shape> for CacheSetup {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("ball", &mut self.ball);
        visitor.field("far_scale", &mut self.far_scale);
        visitor.field("margin_scale", &mut self.margin_scale);
    }
}

/// A query as the host sends it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CachedQuery {
    /// What is searched for when no neighborhood covers it.
    pub query: Query,
    /// Radius around it within which a neighborhood must be complete to cover it.
    pub reach: u32,
}

impl Record<Shape> for CachedQuery {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.query.visit(shape, visitor);
        visitor.field("reach", &mut self.reach);
    }
}

/// A neighbor of a query.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CachedResult {
    /// The neighbor.
    pub result: QueryResult,
    /// Its squared distance is that to the query whose neighborhood is reused.
    pub cached: bool,
}

impl Record<Shape> for CachedResult {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.result.visit(shape, visitor);
        visitor.field("cached", &mut self.cached);
    }
}
