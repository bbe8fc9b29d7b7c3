//! The caches.

use super::events::{NeighborCacheEvents, PointCacheEvents, TreeCacheEvents};
use crate::search::Config;
use crate::search::records::{
    Beat, CacheSetup, CachedQuery, CachedResult, Descent, Fetch, LeafVisit, Lookup, NodeRecord, Query, QueryResult,
    TreeRecord,
};
use crate::unit;

/// Keeps the points of whole leaves.
#[unit(search_point_cache, config: Config)]
#[when(config.point_cache > 0)]
pub struct PointCache {
    /// Leaves wanted.
    fetch: In<Fetch>,
    /// Their points.
    beat: Out<Beat>,
    /// Requests to the memory.
    miss: Out<Fetch>,
    /// Points from memory.
    fill: In<Beat>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<PointCacheEvents>,
}

/// Keeps nodes and leaves of a tree in external memory.
#[unit(search_tree_cache, config: Config)]
#[when(config.tree_cache > 0)]
pub struct TreeCache {
    /// Nodes that the traversal has come to.
    node: In<Descent>,
    /// Leaves reached.
    leaf: In<LeafVisit>,
    /// Nodes for the traversal.
    record: Out<NodeRecord>,
    /// Requests for the points of leaves.
    fetch: Out<Fetch>,
    /// Requests to the memory.
    lookup: Out<Lookup>,
    /// Records from memory, in any order.
    fill: In<TreeRecord>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<TreeCacheEvents>,
}

/// Answers a query with the neighborhood of one close by.
#[unit(search_neighbor_cache, config: Config)]
#[when(config.neighbor_cache > 0)]
pub struct NeighborCache {
    /// How neighborhoods are judged, not while a query is under way.
    setup: PulseIn<CacheSetup>,
    /// Queries.
    query: In<CachedQuery>,
    /// Queries that no neighborhood covers, with their tickets for numbers.
    search: Out<Query>,
    /// Neighbors that a search found, nearest first, a search after the other.
    found: In<QueryResult>,
    /// Neighbors, nearest first to the query that was searched for, a query after the other.
    result: Out<CachedResult>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<NeighborCacheEvents>,
}
