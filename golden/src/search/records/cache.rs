//! The records that a core exchanges with the host; some of their fields are there only with a neighbor cache.

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
    /// With a neighbor cache, the radius around it within which a neighborhood must be complete to cover it.
    pub reach: u32,
}

impl From<Query> for CachedQuery {
    fn from(query: Query) -> Self {
        Self { query, reach: 0 }
    }
}

impl Record<Shape> for CachedQuery {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.query.visit(shape, visitor);
        if shape.neighbor_cache {
            visitor.field("reach", &mut self.reach);
        }
    }
}

/// A neighbor of a query.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CachedResult {
    /// The neighbor.
    pub result: QueryResult,
    /// With a neighbor cache, its squared distance is that to the query whose neighborhood is reused.
    pub cached: bool,
}

impl Record<Shape> for CachedResult {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.result.visit(shape, visitor);
        if shape.neighbor_cache {
            visitor.field("cached", &mut self.cached);
        }
    }
}
