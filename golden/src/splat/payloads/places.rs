//! Places of payloads: which are free, and how many copies of the splats in the others are on their way.

use crate::stream::{Fifo, Skid};
use pointcore_contract::splat::Config;

/// Cycles from the beginning of an operation to its sum.
const OPERATION_CYCLES: usize = 3;

/// A splat whose copies have come: all of them, or those so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Closed {
    /// Where it lies.
    pub place: u16,
    /// How many they are.
    pub copies: u32,
}

/// A number that is added to a place's balance.
#[derive(Clone, Copy, Debug)]
struct Operation {
    place: u16,
    amount: u32,
}

/// The places.
#[derive(Clone, Debug)]
pub(super) struct Places {
    /// Those that are known to be free after reset.
    cleared: usize,
    /// Copies that came less those that left; those that came are added together, when the splat is closed. The numbers wrap.
    balances: Vec<u32>,
    /// The largest number.
    mask: u32,
    free: Option<u16>,
    released: Fifo<u16>,
    closes: Skid<Closed>,
    left: Option<u16>,
    /// What is under way, the latest first.
    operations: [Option<Operation>; OPERATION_CYCLES],
}

impl Places {
    /// The places after reset.
    pub fn new(config: &Config) -> Self {
        let places = config.splats_held() as usize;
        Self {
            cleared: 0,
            balances: vec![0; places],
            mask: (1 << config.copy_count_bits()) - 1,
            free: None,
            released: Fifo::new(places.max(2)),
            closes: Skid::default(),
            left: None,
            operations: [None; OPERATION_CYCLES],
        }
    }

    /// A splat can be closed in this cycle.
    pub fn may_close(&self) -> bool {
        self.closes.in_ready()
    }

    /// The place for the next splat, if there is one.
    pub const fn free(&self) -> Option<u16> {
        self.free
    }

    /// Those that are free.
    #[cfg(test)]
    pub fn released(&self) -> usize {
        let mut queue = self.released.clone();
        let mut count = usize::from(self.free.is_some());
        // An item needs a cycle to the output.
        for _ in 0..=2 * self.balances.len() {
            count += usize::from(queue.out().is_some());
            queue.step(None, true);
        }
        count
    }

    /// An operation takes effect; returns the place if nothing is left to come or to go there.
    fn settle(&mut self, Operation { place, amount }: Operation) -> Option<u16> {
        let balance = &mut self.balances[usize::from(place)];
        *balance = balance.wrapping_add(amount) & self.mask;
        (*balance == 0).then_some(place)
    }

    /// A cycle: a splat is `closed`, another has `begun` at the free place, a copy of the place `left` leaves.
    pub fn step(&mut self, closed: Option<Closed>, begun: bool, left: Option<u16>) {
        let [.., settles] = self.operations;
        let released = match settles {
            Some(operation) => self.settle(operation),
            None if self.cleared < self.balances.len() => {
                self.cleared += 1;
                Some(self.cleared as u16 - 1)
            }
            None => None,
        };
        let begins = match self.left {
            Some(place) => Some(Operation { place, amount: self.mask }),
            None => self.closes.out().map(|&Closed { place, copies }| Operation { place, amount: copies }),
        };
        self.closes.step(closed, self.left.is_none());
        let [first, second, _] = self.operations;
        self.operations = [begins, first, second];
        self.left = left;

        let takes = self.free.is_none();
        let head = self.released.out().copied();
        self.released.step(released, takes);
        if takes {
            self.free = head;
        } else if begun {
            self.free = None;
        }
    }
}
