//! What units did in the last cycle, as the core counts it.

use super::queue;
use super::records::Shape;
use crate::unit::{Record, Visitor};
use pointcore_contract::search::ports::{NEIGHBOR_CACHE_EVENTS, POINT_CACHE_EVENTS, TREE_CACHE_EVENTS};

/// What a cache did in the last cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Served {
    /// It had what was wanted.
    pub hit: bool,
    /// It had not.
    pub miss: bool,
}

impl Served {
    pub(super) fn visit(&mut self, visitor: &mut impl Visitor, [hit, miss]: [&'static str; 2]) {
        visitor.field(hit, &mut self.hit);
        visitor.field(miss, &mut self.miss);
    }
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
    /// Of the point cache, if there is one.
    pub point_cache: Served,
    /// Of the tree cache, if there is one.
    pub tree_cache: Served,
    /// Of the neighbor cache, if there is one.
    pub neighbor_cache: Served,
}

impl Record<Shape> for Events {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("event_node", &mut self.node);
        visitor.field("event_pop", &mut self.pop);
        self.queue.visit(visitor);
        visitor.field("event_thread_wait", &mut self.thread_wait);
        if shape.point_cache {
            self.point_cache.visit(visitor, POINT_CACHE_EVENTS);
        }
        if shape.tree_cache {
            self.tree_cache.visit(visitor, TREE_CACHE_EVENTS);
        }
        if shape.neighbor_cache {
            self.neighbor_cache.visit(visitor, NEIGHBOR_CACHE_EVENTS);
        }
    }
}
