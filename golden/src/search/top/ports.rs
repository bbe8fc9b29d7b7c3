//! The core's ports.

use crate::search::events::Events;
use crate::search::records::{
    Beat, CacheSetup, CachedQuery, CachedResult, Fetch, Lookup, Shape, TreeRecord, TreeWrite,
};
use crate::unit::{Record, Visitor, stream};

/// What the core sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Write to the tree memories, not while a query is under way; without a tree cache.
    pub tree: Option<TreeWrite>,
    /// Whether the memory takes a request for a record of the tree.
    pub lookup_ready: bool,
    /// Records of the tree from memory, in any order.
    pub record: Option<TreeRecord>,
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
    /// Requests for records of the tree, with a tree cache.
    pub lookup: Option<Lookup>,
    /// Whether a record of the tree is accepted.
    pub record_ready: bool,
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
        if shape.tree_cache {
            visitor.field("lookup_ready", &mut self.lookup_ready);
            stream(visitor, shape, "record_", &mut self.record);
        } else {
            stream(visitor, shape, "tree_", &mut self.tree);
        }
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
        if shape.tree_cache {
            stream(visitor, shape, "lookup_", &mut self.lookup);
            visitor.field("record_ready", &mut self.record_ready);
        }
        visitor.field("query_ready", &mut self.query_ready);
        stream(visitor, shape, "fetch_", &mut self.fetch);
        visitor.field("beat_ready", &mut self.beat_ready);
        stream(visitor, shape, "result_", &mut self.result);
        self.events.visit(shape, visitor);
    }
}
