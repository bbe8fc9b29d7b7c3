//! What a run of the search core counts.

use pointcore_contract::search::Config;
use pointcore_contract::search::units::Events;
use pointcore_contract::{Domain, Visit, Visitor, Word, Words, fields};

/// The terms of counters: how often a bit was set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts;

impl Domain for Counts {
    type Bits<W: Word> = u64;
}

/// What a run counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SearchCounters {
    /// Cycles from the first query offered to the last result.
    pub cycles: u64,
    /// Cycles in which the core reported each of its events, in their order.
    events: Vec<u64>,
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
        Self { events: vec![0; fields::<Events>(config).len()], ..Self::default() }
    }

    /// Counts a cycle's events.
    pub fn count(&mut self, config: &Config, mut events: Events) {
        events.visit(config, &mut EventCounter(self.events.iter_mut()));
    }

    /// Cycles in which the core reported each event; 0 for those that it does not have.
    #[must_use]
    pub fn events(&self, config: &Config) -> Events<Counts> {
        let mut counts = Events::default();
        counts.visit(config, &mut Reader(self.events.iter()));
        counts
    }
}

const FEWER_EVENTS: &str = "the core has the events of its configuration";

/// Adds up events.
struct EventCounter<'a>(std::slice::IterMut<'a, u64>);

impl Visitor<Words> for EventCounter<'_> {
    fn bits<W: Word>(&mut self, value: &mut W) {
        *self.0.next().expect(FEWER_EVENTS) += value.to_word();
    }
}

/// Gives events their counts.
struct Reader<'a>(std::slice::Iter<'a, u64>);

impl Visitor<Counts> for Reader<'_> {
    fn bits<W: Word>(&mut self, value: &mut u64) {
        *value = *self.0.next().expect(FEWER_EVENTS);
    }
}
