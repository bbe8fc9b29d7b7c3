//! Output: counts iterations; what is done leaves, and so does what has had as many iterations as it may.

use crate::stream::HalfBuffer;
use crate::unit::Model;
use pointcore_contract::process::config::Config;
use pointcore_contract::process::queries::{Again, Numbered, Outcome, Update};
use pointcore_contract::process::records::Thread;
pub use pointcore_contract::process::stages::output::{In, Out};

/// The output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Numbers of the queries by thread.
    numbers: Vec<u32>,
    /// Iterations that are complete, by thread.
    counts: Vec<u16>,
    /// A thread with a new query, whose count is not zero yet: not in a cycle in which another's is written.
    begun: Option<Thread>,
    /// What is kept of the thread of `finished` has been read.
    has_read: bool,
    update: HalfBuffer<Update>,
    result: HalfBuffer<Outcome>,
    released: Option<Thread>,
}

impl Output {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let threads = config.threads as usize;
        Self {
            numbers: vec![0; threads],
            counts: vec![0; threads],
            begun: None,
            has_read: false,
            update: HalfBuffer::default(),
            result: HalfBuffer::default(),
            released: None,
        }
    }

    fn finished_ready(&self) -> bool {
        self.has_read && self.update.in_ready() && self.result.in_ready()
    }
}

impl Model for Output {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            finished_ready: self.finished_ready(),
            update: self.update.out().copied(),
            result: self.result.out().copied(),
            released: self.released,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let (mut update, mut result) = (None, None);
        self.released = None;
        let takes = self.finished_ready();
        if let Some(finished) = inputs.finished.filter(|_| takes) {
            let thread = finished.thread;
            let count = &mut self.counts[usize::from(thread.thread)];
            let iterations = count.wrapping_add(1);
            let capped = !finished.done && iterations == inputs.iterations_max;
            if finished.done || capped {
                let number = self.numbers[usize::from(thread.thread)];
                result = Some(Outcome { number, iterations, capped, outputs: finished.outputs });
                self.released = Some(thread);
            } else {
                *count = iterations;
                let again = Again { thread, search: finished.search };
                update = Some(Update { again, change: finished.change, count: iterations });
            }
        }
        if update.is_none()
            && let Some(thread) = self.begun.take()
        {
            self.counts[usize::from(thread.thread)] = 0;
        }
        self.has_read = inputs.finished.is_some() && !takes;
        self.update.step(update, inputs.update_ready);
        self.result.step(result, inputs.result_ready);
        if let Some(Numbered { thread, number }) = inputs.numbered {
            self.numbers[usize::from(thread.thread)] = number;
            self.begun = Some(thread);
        }
    }
}
