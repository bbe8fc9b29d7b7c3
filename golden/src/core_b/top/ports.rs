//! The core's ports.

use crate::core_b::events::Events;
use crate::core_b::records::{Beat, CacheSetup, CachedQuery, CachedResult, Fetch, Shape, TreeWrite};
use crate::unit::{Record, Visitor, stream};

/// What the core sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Write to the tree memories, not while a query is under way.
    pub tree: Option<TreeWrite>,
    /// With a neighbor cache, how it judges its neighborhoods, not while a query is under way.
    pub setup: Option<CacheSetup>,
    /// Queries.
    pub query: Option<CachedQuery>,
    /// Whether the memory takes a request.
    pub fetch_ready: bool,
    /// Points from memory: the beats of a request in order and together, requests in any order.
    pub beat: Option<Beat>,
    /// Whether the consumer takes a result.
    pub result_ready: bool,
}

/// What the core shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Out {
    /// Whether a query is accepted.
    pub query_ready: bool,
    /// Requests to the memory.
    pub fetch: Option<Fetch>,
    /// Whether a beat is accepted.
    pub beat_ready: bool,
    /// Neighbors, nearest first, a query after the other.
    pub result: Option<CachedResult>,
    /// What happened in the last cycle.
    pub events: Events,
}

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        stream(visitor, shape, "tree_", &mut self.tree);
        if shape.neighbor_cache {
            stream(visitor, shape, "setup_", &mut self.setup);
        }
        stream(visitor, shape, "query_", &mut self.query);
        visitor.field("fetch_ready", &mut self.fetch_ready);
        stream(visitor, shape, "beat_", &mut self.beat);
        visitor.field("result_ready", &mut self.result_ready);
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("query_ready", &mut self.query_ready);
        stream(visitor, shape, "fetch_", &mut self.fetch);
        visitor.field("beat_ready", &mut self.beat_ready);
        stream(visitor, shape, "result_", &mut self.result);
        self.events.visit(shape, visitor);
    }
}
