//! The whole core: all units wired up, cycle for cycle.
//!
//! In a cycle every unit first shows its outputs, which depend on registers only, then all are clocked.

use super::{
    Latencies, Leaf, NeighborCache, PointCache, Queue, Recursion, Sieve, Stack, Threads, Traversal, TreeCache, leaf,
    neighbor_cache, point_cache, queue, recursion, sieve, stack, threads, traversal, tree_cache,
};
use crate::unit::Model;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::CachedResult;
use pointcore_contract::search::units::Events;
pub use pointcore_contract::search::units::top::{In, Out};

/// The whole core.
#[derive(Clone, Debug)]
pub struct Top {
    threads: Threads,
    traversal: Traversal,
    tree_cache: Option<TreeCache>,
    stack: Stack,
    recursion: Recursion,
    leaf: Leaf,
    point_cache: Option<PointCache>,
    sieve: Sieve,
    queue: Queue,
    neighbor_cache: Option<NeighborCache>,
}

impl Top {
    /// The core after reset, with pipelines of the given lengths.
    ///
    /// # Panics
    /// When it has a neighbor cache and no latencies of it, or the other way round.
    #[must_use]
    pub fn new(config: &Config, latencies: Latencies) -> Self {
        assert_eq!(config.neighbor_cache > 0, latencies.neighbor_cache.is_some(), "a neighbor cache has latencies");
        Self {
            threads: Threads::new(config),
            traversal: Traversal::new(config, latencies.path),
            tree_cache: (config.tree_cache > 0).then(|| TreeCache::new(config)),
            stack: Stack::new(config),
            recursion: Recursion::new(config),
            leaf: Leaf::new(config, latencies.distance),
            point_cache: (config.point_cache > 0).then(|| PointCache::new(config)),
            sieve: Sieve::new(config),
            queue: Queue::new(config),
            neighbor_cache: latencies.neighbor_cache.map(|latencies| NeighborCache::new(config, latencies)),
        }
    }
}

/// What a part shows; nothing, if it is not there.
fn outputs<M: Model<Out: Default>>(part: &Option<M>) -> M::Out {
    part.as_ref().map(Model::outputs).unwrap_or_default()
}

impl Model for Top {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let threads = self.threads.outputs();
        let traversal = self.traversal.outputs();
        let tree_cache = outputs(&self.tree_cache);
        let leaf = self.leaf.outputs();
        let point_cache = outputs(&self.point_cache);
        let queue = self.queue.outputs();
        let neighbor_cache = outputs(&self.neighbor_cache);
        let (fetch, beat_ready) = match self.point_cache {
            Some(_) => (point_cache.miss, point_cache.fill_ready),
            None => (leaf.fetch.or(tree_cache.fetch), leaf.beat_ready),
        };
        let (query_ready, result) = match self.neighbor_cache {
            Some(_) => (neighbor_cache.query_ready, neighbor_cache.result),
            None => (threads.query_ready, queue.result.map(|result| CachedResult { result, cached: false })),
        };
        Out {
            lookup: tree_cache.lookup,
            record_ready: tree_cache.fill_ready,
            query_ready,
            fetch,
            beat_ready,
            result,
            events: Events {
                node: traversal.event_node,
                pop: self.recursion.outputs().event_pop,
                queue: queue.events,
                thread_wait: threads.event_thread_wait,
                point_cache: point_cache.events,
                tree_cache: tree_cache.events,
                neighbor_cache: neighbor_cache.events,
            },
        }
    }

    fn clock(&mut self, inputs: &In) {
        let threads = self.threads.outputs();
        let traversal = self.traversal.outputs();
        let tree_cache = outputs(&self.tree_cache);
        let stack = self.stack.outputs();
        let recursion = self.recursion.outputs();
        let leaf = self.leaf.outputs();
        let point_cache = outputs(&self.point_cache);
        let sieve = self.sieve.outputs();
        let queue = self.queue.outputs();
        let neighbor_cache = outputs(&self.neighbor_cache);

        let (query, result_ready) = match self.neighbor_cache {
            Some(_) => (neighbor_cache.search, neighbor_cache.found_ready),
            None => (inputs.query.map(|cached| cached.query), inputs.result_ready),
        };
        let start = threads.start;
        self.threads.clock(&threads::In {
            query,
            descend_ready: traversal.descend_ready,
            pop_ready: recursion.in_ready,
            finish_ready: queue.finish_ready,
            reached: traversal.reached,
            leaf_done: queue.radius.map(|radius| radius.thread),
            skipped: sieve.skipped,
            empty: recursion.empty,
            released: queue.released,
        });
        self.traversal.clock(&traversal::In {
            tree: inputs.tree,
            node_ready: tree_cache.node_ready,
            record: tree_cache.record,
            start,
            descend: threads.descend,
            resume: recursion.resume,
            leaf_ready: leaf.leaf_ready || tree_cache.leaf_ready,
        });
        self.stack.clock(&stack::In { push: traversal.push, pop: recursion.pop });
        self.recursion.clock(&recursion::In {
            start,
            radius: queue.radius,
            input: threads.pop,
            top_empty: stack.top_empty,
            top: stack.top,
            resume_ready: traversal.resume_ready,
        });
        let (fetch_ready, beat) = match self.point_cache {
            Some(_) => (point_cache.fetch_ready, point_cache.beat),
            None => (inputs.fetch_ready, inputs.beat),
        };
        if let Some(cache) = &mut self.tree_cache {
            cache.clock(&tree_cache::In {
                node: traversal.node,
                leaf: traversal.leaf,
                record_ready: traversal.record_ready,
                fetch_ready,
                lookup_ready: inputs.lookup_ready,
                fill: inputs.record,
            });
        }
        self.leaf.clock(&leaf::In {
            tree: inputs.tree,
            start,
            leaf: traversal.leaf,
            fetch_ready,
            beat,
            candidates_ready: sieve.candidates_ready,
        });
        if let Some(cache) = &mut self.point_cache {
            cache.clock(&point_cache::In {
                fetch: leaf.fetch.or(tree_cache.fetch),
                beat_ready: leaf.beat_ready,
                miss_ready: inputs.fetch_ready,
                fill: inputs.beat,
            });
        }
        self.sieve.clock(&sieve::In {
            start,
            radius: queue.radius,
            candidates: leaf.candidates,
            kept_ready: queue.candidates_ready,
        });
        self.queue.clock(&queue::In { start, candidates: sieve.kept, finish: threads.finish, result_ready });
        if let Some(cache) = &mut self.neighbor_cache {
            cache.clock(&neighbor_cache::In {
                setup: inputs.setup,
                query: inputs.query,
                search_ready: threads.query_ready,
                found: queue.result,
                result_ready: inputs.result_ready,
            });
        }
    }
}
