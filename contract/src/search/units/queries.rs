//! Units that work on queries and points.

use super::events::QueueEvents;
use crate::search::Config;
use crate::search::records::{
    Beat, Candidates, Descent, Fetch, LeafVisit, Query, QueryResult, Radius, Start, Thread, TreeWrite,
};
use crate::unit;

/// Gives queries to threads and threads to the units that work for them.
#[unit(search_threads, config: Config)]
pub struct Threads {
    /// Queries.
    query: In<Query>,
    /// A thread taking up a query.
    start: PulseOut<Start>,
    /// Descents from the root.
    descend: Out<Descent>,
    /// Threads that want their next path.
    pop: Out<Thread>,
    /// Threads whose search is over.
    finish: Out<Thread>,
    /// A thread's descent ended in a leaf.
    reached: PulseIn<Thread>,
    /// All points of a leaf are in the thread's queue.
    leaf_done: PulseIn<Thread>,
    /// No point of a leaf was near enough for the thread's queue.
    skipped: PulseIn<Thread>,
    /// A thread's stack was empty.
    empty: PulseIn<Thread>,
    /// A thread whose results are safe.
    released: PulseIn<Thread>,
    /// A query waited for a free thread.
    event_thread_wait: Output<bool>,
}

/// Fetches the points of leaves and computes their squared distances; with a tree cache, which knows the leaves, distances alone.
#[unit(search_leaf, config: Config)]
pub struct Leaf {
    /// Write to the leaf table.
    #[when(config.tree_cache == 0)]
    tree: PulseIn<TreeWrite>,
    /// Leaves reached.
    #[when(config.tree_cache == 0)]
    leaf: In<LeafVisit>,
    /// Requests to the memory.
    #[when(config.tree_cache == 0)]
    fetch: Out<Fetch>,
    /// A thread taking up a query.
    start: PulseIn<Start>,
    /// Points from memory.
    beat: In<Beat>,
    /// Their squared distances.
    candidates: Out<Candidates>,
}

/// Takes out beats without a point near enough.
#[unit(search_sieve, config: Config)]
pub struct Sieve {
    /// A thread taking up a query.
    start: PulseIn<Start>,
    /// A thread's new radius.
    radius: PulseIn<Radius>,
    /// Squared distances; the beats of a leaf come together.
    candidates: In<Candidates>,
    /// Beats with a point that is near enough.
    kept: Out<Candidates>,
    /// The thread of a leaf of which no beat was kept.
    skipped: PulseOut<Thread>,
}

/// Keeps each thread's nearest points so far, sorted.
#[unit(search_queue, config: Config)]
pub struct Queue {
    /// A thread taking up a query.
    start: PulseIn<Start>,
    /// Squared distances.
    candidates: In<Candidates>,
    /// A thread's radius after a leaf.
    radius: PulseOut<Radius>,
    /// Threads whose search is over.
    finish: In<Thread>,
    /// A thread whose results are safe.
    released: PulseOut<Thread>,
    /// Neighbors, nearest first.
    result: Out<QueryResult>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<QueueEvents>,
}
