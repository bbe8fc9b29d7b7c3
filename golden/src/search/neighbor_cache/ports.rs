//! The neighbor cache's ports.

use crate::search::events::Served;
use crate::search::records::{CacheSetup, CachedQuery, CachedResult, Query, QueryResult, Shape};
use crate::unit::{Record, Visitor, stream};
use pointcore_contract::search::ports::NEIGHBOR_CACHE_EVENTS;

/// What the unit sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// How neighborhoods are judged, not while a query is under way.
    pub setup: Option<CacheSetup>,
    /// Queries.
    pub query: Option<CachedQuery>,
    /// Whether the search takes a query.
    pub search_ready: bool,
    /// Neighbors that a search found, nearest first, a search after the other.
    pub found: Option<QueryResult>,
    /// Whether the consumer takes a result.
    pub result_ready: bool,
}

/// What the unit shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Out {
    /// Whether a query is accepted.
    pub query_ready: bool,
    /// Queries that no neighborhood covers, with their tickets for numbers.
    pub search: Option<Query>,
    /// Whether a neighbor is accepted.
    pub found_ready: bool,
    /// Neighbors, nearest first to the query that was searched for, a query after the other.
    pub result: Option<CachedResult>,
    /// What happened in the last cycle.
    pub events: Served,
}

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        stream(visitor, shape, "setup_", &mut self.setup);
        stream(visitor, shape, "query_", &mut self.query);
        visitor.field("search_ready", &mut self.search_ready);
        stream(visitor, shape, "found_", &mut self.found);
        visitor.field("result_ready", &mut self.result_ready);
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("query_ready", &mut self.query_ready);
        stream(visitor, shape, "search_", &mut self.search);
        visitor.field("found_ready", &mut self.found_ready);
        stream(visitor, shape, "result_", &mut self.result);
        self.events.visit(visitor, NEIGHBOR_CACHE_EVENTS);
    }
}
