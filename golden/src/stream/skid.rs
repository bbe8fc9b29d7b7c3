//! `Skid`: a queue of two whose head is at the output.
//!
//! Shape: items of type `T`, at most two at a time. A push is taken while fewer than two are held at the start of the
//! cycle, even if the head is popped in it.

use std::collections::VecDeque;

/// Items that a skid buffer holds.
const CAPACITY: usize = 2;

/// Cycle-accurate model of `stream_skid`.
#[derive(Clone, Debug)]
pub struct Skid<T> {
    items: VecDeque<T>,
}

impl<T> Default for Skid<T> {
    fn default() -> Self {
        Self { items: VecDeque::with_capacity(CAPACITY) }
    }
}

impl<T> Skid<T> {
    /// `in_ready` in this cycle.
    #[must_use]
    pub fn in_ready(&self) -> bool {
        self.items.len() < CAPACITY
    }

    /// What the output shows in this cycle; `None` while `out_valid` is low.
    #[must_use]
    pub fn out(&self) -> Option<&T> {
        self.items.front()
    }

    /// The clock edge: `input` is the item shown at the input, taken if [`Skid::in_ready`].
    pub fn step(&mut self, input: Option<T>, out_ready: bool) {
        let accepted = input.filter(|_| self.in_ready());
        if out_ready {
            self.items.pop_front();
        }
        self.items.extend(accepted);
    }
}
