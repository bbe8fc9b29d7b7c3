//! What units did in the last cycle: the counters behind the bound of a run and the stalls by cause.

use crate::record;
use crate::search::Config;

/// What the priority queues did.
#[record(config: Config)]
pub struct QueueEvents {
    /// A priority queue was done with a beat of points.
    #[name("event_beat")]
    pub beat: bool,
    /// A neighbor was inserted.
    #[name("event_insert")]
    pub insert: bool,
    /// A beat stayed for one more insertion.
    #[name("event_insert_wait")]
    #[when(config.lanes > 1)]
    pub insert_wait: bool,
}

/// Leaves that the point cache had, and had not.
#[record(config: Config)]
pub struct PointCacheEvents {
    /// The point cache had a leaf that was wanted.
    #[name("event_point_hit")]
    pub hit: bool,
    /// The point cache lacked a leaf that was wanted.
    #[name("event_point_miss")]
    pub miss: bool,
}

/// Records that the tree cache had, and had not.
#[record(config: Config)]
pub struct TreeCacheEvents {
    /// The tree cache had a record that was wanted.
    #[name("event_tree_hit")]
    pub hit: bool,
    /// The tree cache lacked a record that was wanted.
    #[name("event_tree_miss")]
    pub miss: bool,
}

/// Queries that the neighbor cache answered, and did not.
#[record(config: Config)]
pub struct NeighborCacheEvents {
    /// A neighborhood of the neighbor cache covered a query.
    #[name("event_cache_hit")]
    pub hit: bool,
    /// No neighborhood of the neighbor cache covered a query.
    #[name("event_cache_miss")]
    pub miss: bool,
}

/// What a core did.
#[record(config: Config)]
pub struct Events {
    /// A node was visited.
    #[name("event_node")]
    pub node: bool,
    /// A path was popped.
    #[name("event_pop")]
    pub pop: bool,
    /// Of the queues.
    pub queue: QueueEvents,
    /// A query waited for a free thread.
    #[name("event_thread_wait")]
    pub thread_wait: bool,
    /// Of the point cache.
    #[when(config.point_cache > 0)]
    pub point_cache: PointCacheEvents,
    /// Of the tree cache.
    #[when(config.tree_cache > 0)]
    pub tree_cache: TreeCacheEvents,
    /// Of the neighbor cache.
    #[when(config.neighbor_cache > 0)]
    pub neighbor_cache: NeighborCacheEvents,
}
