//! The priority queues' ports.

use super::Events;
use crate::search::records::{Candidates, QueryResult, Radius, Shape, Start, Thread};
use crate::unit::{Record, Visitor, stream};

/// What the unit sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// A thread taking up a query.
    pub start: Option<Start>,
    /// Squared distances.
    pub candidates: Option<Candidates>,
    /// Threads whose search is over.
    pub finish: Option<Thread>,
    /// Whether the consumer takes a result.
    pub result_ready: bool,
}

/// What the unit shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Out {
    /// Whether a beat of distances is accepted.
    pub candidates_ready: bool,
    /// A thread's radius after a leaf.
    pub radius: Option<Radius>,
    /// Whether a finished thread is accepted.
    pub finish_ready: bool,
    /// A thread whose results are safe.
    pub released: Option<Thread>,
    /// Neighbors, nearest first.
    pub result: Option<QueryResult>,
    /// What happened in the last cycle.
    pub events: Events,
}

impl Events {
    pub(in crate::search) fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.field("event_beat", &mut self.beat);
        visitor.field("event_insert", &mut self.insert);
        visitor.field("event_insert_wait", &mut self.insert_wait);
    }
}

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        stream(visitor, shape, "start_", &mut self.start);
        stream(visitor, shape, "candidates_", &mut self.candidates);
        stream(visitor, shape, "finish_", &mut self.finish);
        visitor.field("result_ready", &mut self.result_ready);
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("candidates_ready", &mut self.candidates_ready);
        stream(visitor, shape, "radius_", &mut self.radius);
        visitor.field("finish_ready", &mut self.finish_ready);
        stream(visitor, shape, "released_", &mut self.released);
        stream(visitor, shape, "result_", &mut self.result);
        self.events.visit(visitor);
    }
}
