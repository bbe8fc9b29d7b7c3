//! The records that a core with a neighbor cache exchanges with the host.

use super::{Query, QueryResult};
use crate::record;
use crate::search::Config;

/// How the neighbor cache judges its neighborhoods (thesis table 6.1).
#[record(config: Config)]
pub struct CacheSetup {
    /// Queries are balls, else k nearest neighbors.
    pub ball: bool,
    /// Factor of the distance to the farthest neighbor.
    #[bits(config.geometry.width())]
    pub far_scale: u32,
    /// Factor of what is left of it.
    #[bits(config.geometry.width())]
    pub margin_scale: u32,
}

/// A query as the host sends it.
#[record(config: Config)]
pub struct CachedQuery {
    /// What is searched for when no neighborhood covers it.
    pub query: Query,
    /// With a neighbor cache, the radius around it within which a neighborhood must be complete to cover it: 0 for k nearest
    /// neighbors, the radius of a ball query.
    #[when(config.neighbor_cache > 0)]
    #[bits(config.geometry.width())]
    pub reach: u32,
}

impl From<Query> for CachedQuery {
    fn from(query: Query) -> Self {
        Self { query, reach: 0 }
    }
}

/// A neighbor of a query as the host receives it.
#[record(config: Config)]
pub struct CachedResult {
    /// The neighbor.
    pub result: QueryResult,
    /// With a neighbor cache, its squared distance is that to the query whose neighborhood is reused.
    #[when(config.neighbor_cache > 0)]
    pub cached: bool,
}
