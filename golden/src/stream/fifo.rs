//! `Fifo`: a queue whose head needs a cycle to reach the output.
//!
//! Shape: items of type `T`, at most `depth` at a time, the one at the output included. The output shows an item or
//! nothing; items behind it are in storage, which an item enters at the end of the cycle in which it is pushed and
//! leaves at the end of the first later cycle in which the output is empty or popped. A full queue refuses a push even
//! in a cycle in which it is popped.

use std::collections::VecDeque;

/// Cycle-accurate model of `stream_fifo`.
#[derive(Clone, Debug)]
pub struct Fifo<T> {
    depth: usize,
    output: Option<T>,
    stored: VecDeque<T>,
}

impl<T> Fifo<T> {
    /// An empty queue, as after reset.
    ///
    /// # Panics
    /// When `depth` is below 2.
    #[must_use]
    pub fn new(depth: usize) -> Self {
        assert!(depth >= 2, "a queue holds two items at least");
        Self { depth, output: None, stored: VecDeque::with_capacity(depth) }
    }

    /// `in_ready` in this cycle.
    #[must_use]
    pub fn in_ready(&self) -> bool {
        self.stored.len() + usize::from(self.output.is_some()) < self.depth
    }

    /// What the output shows in this cycle; `None` while `out_valid` is low.
    #[must_use]
    pub fn out(&self) -> Option<&T> {
        self.output.as_ref()
    }

    /// The clock edge: `input` is the item shown at the input, taken if [`Fifo::in_ready`]. Returns the item that left.
    pub fn step(&mut self, input: Option<T>, out_ready: bool) -> Option<T> {
        let accepted = input.filter(|_| self.in_ready());
        let left = if out_ready { self.output.take() } else { None };
        if self.output.is_none() {
            self.output = self.stored.pop_front();
        }
        self.stored.extend(accepted);
        left
    }
}
