//! Tickets: the queries that are searched for, each under a number of its own.

use crate::core_b::records::Query;

#[derive(Clone, Copy, Debug, Default)]
struct Ticket {
    taken: bool,
    query: Query,
}

/// All tickets.
#[derive(Clone, Debug)]
pub(super) struct Tickets(Vec<Ticket>);

impl Tickets {
    pub(super) fn new(tickets: u32) -> Self {
        Self(vec![Ticket::default(); tickets as usize])
    }

    /// The lowest free ticket.
    pub(super) fn free(&self) -> Option<u32> {
        self.0.iter().position(|ticket| !ticket.taken).map(|ticket| ticket as u32)
    }

    /// Whether one more query may be compared while so many are.
    pub(super) fn admit(&self, compared: usize) -> bool {
        compared + self.0.iter().filter(|ticket| ticket.taken).count() < self.0.len()
    }

    pub(super) fn query(&self, ticket: u32) -> Query {
        self.0[ticket as usize].query
    }

    pub(super) fn take(&mut self, ticket: u32, query: Query) {
        self.0[ticket as usize] = Ticket { taken: true, query };
    }

    pub(super) fn give_back(&mut self, ticket: u32) {
        self.0[ticket as usize].taken = false;
    }
}
