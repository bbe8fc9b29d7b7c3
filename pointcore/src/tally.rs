//! How often each event of a core was reported.

use pointcore_contract::{Domain, Record, Visitor, Word, Words, fields};

/// The terms of counters: how often a bit was set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts;

impl Domain for Counts {
    type Bits<W: Word> = u64;
}

/// Counters of a record's bits, in their order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally(Vec<u64>);

impl Tally {
    /// Nothing so far.
    #[must_use]
    pub fn new<R: Record>(config: &R::Config) -> Self {
        Self(vec![0; fields::<R>(config).len()])
    }

    /// Counts a cycle's events.
    pub fn count<R: Record<Domain = Words>>(&mut self, config: &R::Config, mut events: R) {
        events.visit(config, &mut Counter(self.0.iter_mut()));
    }

    /// Cycles in which the core reported each event; 0 for those that it does not have.
    #[must_use]
    pub fn read<R: Record<Domain = Counts> + Default>(&self, config: &R::Config) -> R {
        let mut counts = R::default();
        counts.visit(config, &mut Reader(self.0.iter()));
        counts
    }
}

const FEWER_EVENTS: &str = "the core has the events of its configuration";

/// Adds up events.
struct Counter<'a>(std::slice::IterMut<'a, u64>);

impl Visitor<Words> for Counter<'_> {
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
