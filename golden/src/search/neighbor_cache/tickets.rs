//! Tickets: the queries that are searched for, each under a number of its own.

use super::lead::Asked;
use pointcore_contract::search::records::{CachedQuery, Query};

#[derive(Clone, Copy, Debug, Default)]
struct Ticket {
    taken: bool,
    query: Query,
    leader: Option<usize>,
}

/// All tickets.
#[derive(Clone, Debug)]
pub(super) struct Tickets {
    tickets: Vec<Ticket>,
    /// The one that the next search is given; it is taken already.
    next: Option<u32>,
}

impl Tickets {
    pub(super) fn new(tickets: u32) -> Self {
        Self { tickets: vec![Ticket::default(); tickets as usize], next: None }
    }

    /// Whether one more query may be compared while so many are.
    pub(super) fn admit(&self, compared: usize) -> bool {
        let taken = self.tickets.iter().filter(|ticket| ticket.taken).count();
        compared + taken - usize::from(self.next.is_some()) < self.tickets.len()
    }

    /// The query, and its number among the leaders if it leads.
    pub(super) fn query(&self, ticket: u32) -> (Query, Option<usize>) {
        let Ticket { query, leader, .. } = self.tickets[ticket as usize];
        (query, leader)
    }

    /// One clock edge: gives the query that is `searched` for, if there is one, its ticket, and takes back one that `returns`.
    pub(super) fn clock(&mut self, searched: Option<Asked>, returns: Option<u32>) -> Option<u32> {
        let given = searched.map(|Asked { query: CachedQuery { query, .. }, leader }| {
            let ticket = self.next.take().expect("a ticket is there for every query that was admitted");
            let place = &mut self.tickets[ticket as usize];
            (place.query, place.leader) = (query, leader);
            ticket
        });
        if self.next.is_none()
            && let Some(lowest) = self.tickets.iter().position(|ticket| !ticket.taken)
        {
            self.tickets[lowest].taken = true;
            self.next = Some(lowest as u32);
        }
        if let Some(ticket) = returns {
            self.tickets[ticket as usize].taken = false;
        }
        given
    }
}
