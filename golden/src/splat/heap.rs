//! Heap: a priority queue of splat copies by tile, cyclically from the current one, and by arrival within a tile (eq. 5.14).
//!
//! The model is an ordered map with the hardware's timing; arrival numbers do not wrap here. In the hardware they do: their top
//! bit is an epoch, whose number is taken again only after its last entry left, so that two epochs can be told apart.

use crate::stream::Skid;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::HeapEntry;
pub use pointcore_contract::splat::units::heap::{In, Out};
use std::collections::BTreeMap;

/// The heap.
#[derive(Clone, Debug)]
pub struct Heap {
    capacity: usize,
    epoch_bits: u32,
    /// Pointers by tile and number of arrival.
    entries: BTreeMap<(u32, u64), u16>,
    arrivals: u64,
    current: u32,
    /// Entries of the even and of the odd epoch.
    alive: [u32; 2],
    /// Cycles an operation takes.
    interval: u32,
    /// Cycles until the next one may begin.
    resting: u32,
    out: Skid<HeapEntry>,
}

impl Heap {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self::numbered(config, config.sequence_bits())
    }

    /// The unit after reset with arrival numbers of so many bits.
    #[must_use]
    pub fn numbered(config: &Config, sequence_bits: u32) -> Self {
        Self {
            capacity: config.heap_capacity() as usize,
            epoch_bits: sequence_bits - 1,
            entries: BTreeMap::new(),
            arrivals: 0,
            current: 0,
            alive: [0; 2],
            interval: config.heap_interval,
            resting: 0,
            out: Skid::default(),
        }
    }

    /// Which of the two epoch numbers an arrival bears.
    fn epoch(&self, arrival: u64) -> usize {
        ((arrival >> self.epoch_bits) & 1) as usize
    }

    /// The next arrival begins an epoch whose number entries still bear.
    fn is_epoch_taken(&self) -> bool {
        self.arrivals.trailing_zeros() >= self.epoch_bits && self.alive[self.epoch(self.arrivals)] > 0
    }

    fn pops(&self) -> bool {
        self.resting == 0 && !self.entries.is_empty() && self.out.in_ready()
    }

    fn in_ready(&self) -> bool {
        self.resting == 0 && !self.is_epoch_taken() && (self.entries.len() < self.capacity || self.pops())
    }

    fn pop(&mut self) -> Option<HeapEntry> {
        let from_current = self.entries.range((self.current, 0)..).next();
        let (&key, &pointer) = from_current.or_else(|| self.entries.first_key_value())?;
        self.entries.remove(&key);
        let (tile, arrival) = key;
        self.alive[self.epoch(arrival)] -= 1;
        self.current = tile;
        Some(HeapEntry { tile, pointer })
    }

    fn push(&mut self, entry: HeapEntry) {
        self.entries.insert((entry.tile, self.arrivals), entry.pointer);
        self.alive[self.epoch(self.arrivals)] += 1;
        self.arrivals += 1;
    }
}

impl Model for Heap {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let empty = self.entries.is_empty() && self.out.out().is_none();
        Out { in_ready: self.in_ready(), out: self.out.out().copied(), empty }
    }

    fn clock(&mut self, inputs: &In) {
        let pushed = inputs.input.filter(|_| self.in_ready());
        let popped = if self.pops() { self.pop() } else { None };
        if let Some(entry) = pushed {
            self.push(entry);
        }
        self.resting = self.resting.checked_sub(1).unwrap_or(self.interval - 1);
        self.out.step(popped, inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::for_each_seed;

    /// Every pop against a search through all entries present; tiny epochs, so that arrival numbers wrap all the time.
    #[test]
    fn pops_the_least_entry_in_cyclic_order() {
        for_each_seed("heap", |random| {
            let heap_interval = random.u32(1..=2) * 2;
            let config = Config { heap_levels: 3, heap_interval, ..Config::default() };
            let mut heap = Heap::numbered(&config, 4);
            let (mut present, mut shown) = (Vec::new(), Vec::new());
            let (mut current, mut pops, mut full) = (0, 0, 0);
            for pointer in 0..4000_u16 {
                let input = random.bool().then(|| HeapEntry { tile: random.u32(0..5), pointer });
                let inputs = In { input, out_ready: random.u8(0..8) == 0 };
                let before = heap.outputs();
                if heap.pops() {
                    let key = |entry: &&HeapEntry| (entry.tile < current, entry.tile);
                    // `min_by_key` returns the first of equal entries: the one that came first.
                    let least = *present.iter().min_by_key(key).expect("the heap pops what is there");
                    present.retain(|entry| *entry != least);
                    current = least.tile;
                    shown.push(least);
                }
                full += usize::from(present.len() == 7);
                present.extend(input.filter(|_| before.in_ready));
                heap.clock(&inputs);
                if let Some(entry) = before.out.filter(|_| inputs.out_ready) {
                    assert_eq!(entry, shown.remove(0));
                    pops += 1;
                }
                assert_eq!(heap.entries.len(), present.len());
                assert_eq!(heap.alive.iter().sum::<u32>() as usize, present.len());
            }
            assert!(pops > 400 && full > 50, "{pops} entries left the heap, which was full in {full} cycles");
        });
    }

    #[test]
    fn an_epoch_waits_for_its_last_entry() {
        let config = Config { heap_levels: 4, ..Config::default() };
        let mut heap = Heap::numbered(&config, 2);
        let mut entered = 0;
        for cycle in 0..40 {
            entered += u32::from(heap.outputs().in_ready);
            heap.clock(&In { input: Some(HeapEntry { tile: cycle, pointer: 0 }), out_ready: false });
        }
        // Two left for the output queue, and an epoch has two numbers: the third epoch may begin, the fourth bears the
        // number of the second, which is there in full.
        assert_eq!(entered, 6);
        for cycle in 0..40 {
            entered += u32::from(heap.outputs().in_ready);
            heap.clock(&In { input: Some(HeapEntry { tile: cycle, pointer: 0 }), out_ready: true });
        }
        assert!(entered > 16, "the heap goes on when entries leave");
    }
}
