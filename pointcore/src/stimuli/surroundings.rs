//! What the hosts of both cores have in common.

use fastrand::Rng;
use pointcore_tb::lockstep::{Stimulus, Streams};
use pointcore_tb::verilated::{Direction, Library};

/// Cycles that a core is watched for after everything has come out.
const AFTER_CYCLES: u64 = 100;

/// A stimulus that knows when the core is stuck.
pub trait Surroundings: Stimulus + Clone {
    /// The cycle in which it gave up, if it did.
    fn stuck(&self) -> Option<u64>;

    /// How far it came.
    fn pending(&self) -> Pending;

    /// The same, but it waits for ever.
    #[must_use]
    fn without_watch(self) -> Self;
}

/// How far a run came.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pending {
    /// Frames or queries that have come out.
    pub done: usize,
    /// Those that went in, or will.
    pub expected: usize,
    /// What they are.
    pub what: &'static str,
}

/// Fills the fields of streams that offer nothing: a core that looks at them is wrong.
#[derive(Clone, Debug)]
pub struct Idle {
    random: Rng,
    /// Of each stream into the core: its flag, and its fields with their largest values.
    streams: Vec<(usize, Vec<(usize, u64)>)>,
}

impl Idle {
    /// For a core whose inputs come in the contract's order.
    #[must_use]
    pub fn new(library: &Library, random: Rng) -> Self {
        let streams = Streams::of(library);
        let inputs = streams.iter().filter(|stream| stream.direction == Direction::Input);
        let largest = |field: usize| u64::MAX >> (u64::BITS - library.inputs()[field].width);
        let fields = |fields: &[usize]| fields.iter().map(|&field| (field, largest(field))).collect();
        let streams = inputs.map(|stream| (stream.valid, fields(&stream.fields))).collect();
        Self { random, streams }
    }

    /// Fills them for a cycle.
    pub fn fill(&mut self, inputs: &mut [u64]) {
        for (valid, fields) in &self.streams {
            if inputs[*valid] == 0 {
                fields.iter().for_each(|&(field, largest)| inputs[field] = self.random.u64(..) & largest);
            }
        }
    }
}

/// Watches for the end of a run: everything has come out, or nothing moves any more.
#[derive(Clone, Debug)]
pub struct Watch {
    quiet_cycles: u64,
    last_transfer: u64,
    complete_since: Option<u64>,
    stuck: Option<u64>,
}

impl Watch {
    /// Gives up after so many cycles without a transfer.
    #[must_use]
    pub const fn new(quiet_cycles: u64) -> Self {
        Self { quiet_cycles, last_transfer: 0, complete_since: None, stuck: None }
    }

    /// Something moved.
    pub const fn moved(&mut self, cycle: u64) {
        self.last_transfer = cycle;
    }

    /// Whether the run is over.
    pub fn is_over(&mut self, cycle: u64, is_complete: bool) -> bool {
        if is_complete {
            return cycle - *self.complete_since.get_or_insert(cycle) >= AFTER_CYCLES;
        }
        if cycle.saturating_sub(self.last_transfer) > self.quiet_cycles {
            self.stuck = Some(cycle);
        }
        self.stuck.is_some()
    }

    /// The cycle in which it gave up.
    #[must_use]
    pub const fn stuck(&self) -> Option<u64> {
        self.stuck
    }
}

/// Cycles in which a core is reset, the last one first: in most runs never, else within so many cycles.
#[must_use]
pub fn resets(within: u64, random: &mut Rng) -> Vec<u64> {
    let count = if random.u8(..4) == 0 { random.usize(1..=2) } else { 0 };
    let mut cycles: Vec<_> = (0..count).map(|_| random.u64(1..within)).collect();
    // A reset of several cycles.
    if let Some(first) = cycles.first().copied() {
        cycles.extend((1..random.u64(1..4)).map(|cycle| first + cycle));
    }
    cycles.sort_unstable_by(|a, b| b.cmp(a));
    cycles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn silence_is_told_from_a_run_that_is_complete() {
        let mut watch = Watch::new(10);
        watch.moved(5);
        assert!(!watch.is_over(15, false) && watch.stuck().is_none());
        assert!(watch.is_over(16, false) && watch.stuck() == Some(16));
        let mut watch = Watch::new(10);
        let over = (0..200).find(|&cycle| watch.is_over(cycle, cycle >= 8));
        assert_eq!((over, watch.stuck()), (Some(8 + AFTER_CYCLES), None));
    }

    #[test]
    fn resets_come_last_first_and_often_not_at_all() {
        let all: Vec<_> = (0..100).map(|seed| resets(1000, &mut Rng::with_seed(seed))).collect();
        assert!(all.iter().all(|cycles| cycles.is_sorted_by(|a, b| a >= b)));
        let (with, without) = (all.iter().filter(|cycles| !cycles.is_empty()).count(), all.len());
        assert!(with > 10 && with < without / 2, "{with} of {without}");
    }
}
