//! What a run of the search core counts.

use crate::tally::{Counts, Tally};
use pointcore_contract::search::Config;
use pointcore_contract::search::units::Events;

/// What a run counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SearchCounters {
    /// Cycles from the first query offered to the last result.
    pub cycles: u64,
    /// Cycles in which the core reported each of its events.
    events: Tally,
    /// Requests to the memory.
    pub requests: u64,
    /// Records of the tree taken from the memory.
    pub records: u64,
    /// Beats taken from the memory.
    pub beats: u64,
    /// Bytes that the memory moved, whole bursts.
    pub bytes: u64,
    /// Cycles in which a beat was on offer and not taken.
    pub beat_wait: u64,
    /// Cycles in which a query was on offer and not taken.
    pub query_wait: u64,
    /// Neighbors that came out; with a neighbor cache, more than were wanted.
    pub results: u64,
}

impl SearchCounters {
    /// Nothing so far.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self { events: Tally::new::<Events>(config), ..Self::default() }
    }

    /// Counts a cycle's events.
    pub fn count(&mut self, config: &Config, events: Events) {
        self.events.count(config, events);
    }

    /// Cycles in which the core reported each event; 0 for those that it does not have.
    #[must_use]
    pub fn events(&self, config: &Config) -> Events<Counts> {
        self.events.read(config)
    }
}
