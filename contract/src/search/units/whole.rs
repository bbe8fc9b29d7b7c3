//! The whole core.

use super::events::Events;
use crate::search::Config;
use crate::search::records::{Beat, CacheSetup, CachedQuery, CachedResult, Fetch, Lookup, TreeRecord, TreeWrite};
use crate::unit;

/// The neighbor search.
#[unit(search_top, config: Config)]
pub struct Top {
    /// Write to the tree memories, not while a query is under way.
    #[when(config.tree_cache == 0)]
    tree: PulseIn<TreeWrite>,
    /// Requests for records of the tree.
    #[when(config.tree_cache > 0)]
    lookup: Out<Lookup>,
    /// Records of the tree from memory, in any order.
    #[when(config.tree_cache > 0)]
    record: In<TreeRecord>,
    /// How the neighbor cache judges its neighborhoods, not while a query is under way.
    #[when(config.neighbor_cache > 0)]
    setup: PulseIn<CacheSetup>,
    /// Queries.
    query: In<CachedQuery>,
    /// Requests to the memory.
    fetch: Out<Fetch>,
    /// Points from memory: the beats of a request in order and together, requests in any order.
    beat: In<Beat>,
    /// Neighbors, nearest first, a query after the other.
    result: Out<CachedResult>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<Events>,
}
