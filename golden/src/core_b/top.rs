//! The whole core: all units wired up, cycle for cycle.
//!
//! In a cycle every unit first shows its outputs, which depend on registers only, then all are clocked.

use super::records::{Beat, Fetch, Query, QueryResult, Shape, TreeWrite};
use super::{
    Latencies, Leaf, Queue, Recursion, Sieve, Stack, Threads, Traversal, leaf, queue, recursion, sieve, stack, threads,
    traversal,
};
use crate::unit::{Model, Record, Visitor, stream};
use pointcore_spec::core_b::Config;

/// What the core sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Write to the tree memories, not while a query is under way.
    pub tree: Option<TreeWrite>,
    /// Queries.
    pub query: Option<Query>,
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
    pub result: Option<QueryResult>,
    /// What happened in the last cycle.
    pub events: Events,
}

/// What the core did in the last cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Events {
    /// A node was visited.
    pub node: bool,
    /// A path was popped.
    pub pop: bool,
    /// Of the queue.
    pub queue: queue::Events,
    /// A query waited for a free thread.
    pub thread_wait: bool,
}

/// The whole core.
#[derive(Clone, Debug)]
pub struct Top {
    shape: Shape,
    threads: Threads,
    traversal: Traversal,
    stack: Stack,
    recursion: Recursion,
    leaf: Leaf,
    sieve: Sieve,
    queue: Queue,
}

impl Top {
    /// The core after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, latencies: Latencies) -> Self {
        Self {
            shape: Shape::new(config),
            threads: Threads::new(config),
            traversal: Traversal::new(config, latencies.path),
            stack: Stack::new(config),
            recursion: Recursion::new(config),
            leaf: Leaf::new(config, latencies.distance),
            sieve: Sieve::new(config),
            queue: Queue::new(config),
        }
    }
}

impl Model for Top {
    type Shape = Shape;
    type In = In;
    type Out = Out;

    fn shape(&self) -> Shape {
        self.shape
    }

    fn outputs(&self) -> Out {
        let threads = self.threads.outputs();
        let leaf = self.leaf.outputs();
        let queue = self.queue.outputs();
        Out {
            query_ready: threads.query_ready,
            fetch: leaf.fetch,
            beat_ready: leaf.beat_ready,
            result: queue.result,
            events: Events {
                node: self.traversal.outputs().event_node,
                pop: self.recursion.outputs().event_pop,
                queue: queue.events,
                thread_wait: threads.event_thread_wait,
            },
        }
    }

    fn clock(&mut self, inputs: &In) {
        let threads = self.threads.outputs();
        let traversal = self.traversal.outputs();
        let stack = self.stack.outputs();
        let recursion = self.recursion.outputs();
        let leaf = self.leaf.outputs();
        let sieve = self.sieve.outputs();
        let queue = self.queue.outputs();

        let start = threads.start;
        self.threads.clock(&threads::In {
            query: inputs.query,
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
            start,
            descend: threads.descend,
            resume: recursion.resume,
            leaf_ready: leaf.leaf_ready,
        });
        self.stack.clock(&stack::In { push: traversal.push, pop: recursion.pop });
        self.recursion.clock(&recursion::In {
            start,
            radius: queue.radius,
            input: threads.pop,
            top: stack.top,
            resume_ready: traversal.resume_ready,
        });
        self.leaf.clock(&leaf::In {
            tree: inputs.tree,
            start,
            leaf: traversal.leaf,
            fetch_ready: inputs.fetch_ready,
            beat: inputs.beat,
            candidates_ready: sieve.candidates_ready,
        });
        self.sieve.clock(&sieve::In {
            start,
            radius: queue.radius,
            candidates: leaf.candidates,
            kept_ready: queue.candidates_ready,
        });
        self.queue.clock(&queue::In {
            start,
            candidates: sieve.kept,
            finish: threads.finish,
            result_ready: inputs.result_ready,
        });
    }
}

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        stream(visitor, shape, "tree_", &mut self.tree);
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
        visitor.field("event_node", &mut self.events.node);
        visitor.field("event_pop", &mut self.events.pop);
        self.events.queue.visit(visitor);
        visitor.field("event_thread_wait", &mut self.events.thread_wait);
    }
}
