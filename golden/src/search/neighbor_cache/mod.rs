//! Coherent neighbor cache: answers a query near an earlier one with that one's neighborhood (thesis 6.4.2, 6.5.3 and 6.6.3).
//!
//! Queries are checked against all entries in turn, a few queries at a time; those that no entry covers are searched for, and
//! what is found takes the place of the least recently used entry that nobody reads. An answer is always read from an entry.
//! A query near one that is not answered yet is checked when that one's neighborhood is there.
//!
//! A neighborhood that is reused bears the distances to the query it was found for. Of neighborhoods that cover a query the one
//! with the lowest number answers it.

mod check;
mod copy;
mod coverage;
mod deliver;
mod entries;
mod follow;
mod grid;
mod lead;
#[cfg(test)]
mod tests;
mod tickets;

use super::CacheLatencies;
use crate::stream::Skid;
use crate::unit::Model;
use check::{Check, Verdict};
use copy::{Copy, Step};
use deliver::{Answer, Deliver};
use entries::Entries;
use follow::Follow;
use lead::{Asked, Lead, Role};
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{CacheSetup, Query};
use pointcore_contract::search::units::NeighborCacheEvents;
pub use pointcore_contract::search::units::neighbor_cache::{In, Out};
use tickets::Tickets;

/// A neighbor in an entry.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Neighbor {
    index: u32,
    distance2: u32,
}

/// The coherent neighbor cache.
#[derive(Clone, Debug)]
pub struct NeighborCache {
    setup: CacheSetup,
    lead: Lead,
    follow: Follow,
    /// Leaders whose fate has become known in the cycle before.
    finished: Vec<usize>,
    check: Check,
    tickets: Tickets,
    search: Skid<Query>,
    copy: Copy,
    entries: Entries,
    neighborhoods: Vec<Vec<Neighbor>>,
    deliver: Deliver,
    events: NeighborCacheEvents,
}

impl NeighborCache {
    /// The unit after reset, of a configuration that has one.
    #[must_use]
    pub fn new(config: &Config, latencies: CacheLatencies) -> Self {
        let (entries, neighbors) = (config.neighbor_cache as usize, config.neighbors as usize);
        Self {
            setup: CacheSetup::default(),
            lead: Lead::new(config),
            follow: Follow::new(config),
            finished: Vec::new(),
            check: Check::new(config.geometry, latencies.check),
            tickets: Tickets::new(config.tickets()),
            search: Skid::default(),
            copy: Copy::new(config.geometry, latencies.cover),
            entries: Entries::new(entries),
            neighborhoods: vec![vec![Neighbor::default(); neighbors]; entries],
            deliver: Deliver::new(),
            events: NeighborCacheEvents::default(),
        }
    }

    /// The verdict on the item that leaves the check in this cycle.
    fn leaving(&self) -> Option<Verdict> {
        self.check.verdict(self.copy.target()).filter(|verdict| match verdict {
            Verdict::Hit { .. } => self.deliver.in_ready(),
            Verdict::Miss { .. } => self.search.in_ready(),
            Verdict::Pass => true,
        })
    }

    /// The query that goes to the search, under its ticket; a complete neighborhood gives back its own.
    fn search_for(&mut self, verdict: Option<Verdict>, step: &Step) -> Option<Query> {
        let searched = match verdict {
            Some(Verdict::Miss { asked }) => Some(asked),
            _ => None,
        };
        let returns = match step {
            Step::Take { result, .. } if result.last => Some(result.number),
            _ => None,
        };
        let ticket = self.tickets.clock(searched, returns);
        searched.zip(ticket).map(|(asked, number)| Query { number, ..asked.query.query })
    }

    /// Takes a query in, and returns the one that goes to be compared.
    fn ask(&mut self, inputs: &In, verdict: Option<Verdict>) -> Option<Asked> {
        let room = self.check.in_ready();
        let next = self.follow.next();
        let role = self.lead.role(self.follow.has_room(), room && next.is_none());
        let hit = match verdict {
            Some(Verdict::Hit { asked, .. }) => asked.leader,
            _ => None,
        };
        let finishing = hit.into_iter().chain(self.copy.finished()).collect();
        let finished = std::mem::replace(&mut self.finished, finishing);
        let measured = verdict.and_then(|_| self.check.margin());
        self.lead.clock(inputs.query, role, measured, &finished, inputs.setup.is_some());
        let (enters, leads) = match role {
            Some(Role::Follows { query, leader }) => (Some((query, leader)), None),
            Some(Role::Leads { asked, .. }) => (None, Some(asked)),
            None => (None, None),
        };
        self.follow.clock(enters, room, &finished);
        next.filter(|_| room).map(|query| Asked { query, leader: None }).or(leads)
    }

    /// Writes a neighbor to its place.
    fn store(&mut self, step: &Step) {
        let Step::Take { copying, result } = step else { return };
        if result.found {
            let place = &mut self.neighborhoods[copying.entry][usize::from(copying.copied)];
            *place = Neighbor { index: result.index, distance2: result.distance2 };
        }
    }
}

/// The answer that a hit or a complete neighborhood gives; they never come together.
const fn answer(verdict: Option<Verdict>, step: &Step) -> Option<Answer> {
    match (verdict, step) {
        (Some(Verdict::Hit { entry, asked }), _) => {
            Some(Answer { entry, number: asked.query.query.number, cached: true })
        }
        (_, Step::Take { copying, result }) if result.last => {
            Some(Answer { entry: copying.entry, number: copying.query.number, cached: false })
        }
        _ => None,
    }
}

impl Model for NeighborCache {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            query_ready: self.lead.in_ready(),
            search: self.search.out().copied(),
            found_ready: self.copy.in_ready(),
            result: self.deliver.out().copied(),
            events: self.events,
        }
    }

    fn clock(&mut self, inputs: &In) {
        // All decisions are made on the registers as they were at the start of the cycle.
        let verdict = self.leaving();
        let hit = matches!(verdict, Some(Verdict::Hit { .. }));
        let miss = matches!(verdict, Some(Verdict::Miss { .. }));
        let step = self.copy.step(&self.entries, hit, self.deliver.in_ready());
        let answer = answer(verdict, &step);

        let asked = self.ask(inputs, verdict);
        let admits = self.tickets.admit(self.check.compared());
        self.check.clock(asked, verdict, self.copy.target(), admits, &self.entries, &self.setup);
        let released = self.deliver.clock(answer, &self.entries, &self.neighborhoods, inputs.result_ready);
        let started = match step {
            Step::Start { ticket, .. } => Some(self.tickets.query(ticket)),
            Step::Wait | Step::Take { .. } => None,
        };
        let searched = self.search_for(verdict, &step);
        self.search.step(searched, inputs.search_ready);
        self.store(&step);
        self.copy.clock(inputs.found, &step, started, &mut self.entries, &self.setup);

        if let Some(answer) = answer {
            self.entries.add_reader(answer.entry);
        }
        if let Some(entry) = released {
            self.entries.remove_reader(entry);
        }
        if let Some(Verdict::Hit { entry, .. }) = verdict {
            self.entries.touch(entry);
        }
        if let Some(setup) = inputs.setup {
            self.setup = setup;
            self.entries.forget();
        }
        self.events = NeighborCacheEvents { hit, miss };
    }
}
