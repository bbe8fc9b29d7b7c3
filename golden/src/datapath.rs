//! `Datapath`: when results of a compiled arithmetic pipeline become visible, cycle by cycle.
//!
//! The arithmetic itself is the caller's: it computes a token's result when the token is accepted and hands it over; the
//! model delays it. A pipeline has `latency` stages that step together, and a queue of [`QUEUE_ENTRIES`] behind them; it
//! steps whenever the queue, as it was at the start of the cycle, has room. A phase counter of `initiation_interval`
//! states starts at 0 after reset and steps with the pipeline; a token enters in phase 0 only.
//!
//! ```
//! use pointcore_golden::datapath::Datapath;
//!
//! let mut datapath = Datapath::new(2, 1);
//! let input = 20;
//! assert!(datapath.in_ready());
//! datapath.step(Some(input + 1), true);
//! for _ in 0..2 {
//!     assert_eq!(datapath.out(), None);
//!     datapath.step(None, true);
//! }
//! assert_eq!(datapath.out(), Some(&21));
//! ```

use std::collections::VecDeque;

/// Entries of the output queue: the fewest that let `in_ready` depend on registers only at full rate.
pub const QUEUE_ENTRIES: usize = 2;

/// Timing of a pipeline whose tokens carry results of type `T`.
#[derive(Clone, Debug)]
pub struct Datapath<T> {
    /// Front: the token accepted last. Always `latency` long; `None` is a bubble.
    stages: VecDeque<Option<T>>,
    queue: VecDeque<T>,
    phase: u32,
    initiation_interval: u32,
}

impl<T> Datapath<T> {
    /// An empty pipeline, as after reset. Both numbers come from the manifest the generator writes.
    ///
    /// # Panics
    /// When `latency` or `initiation_interval` is 0.
    #[must_use]
    pub fn new(latency: u32, initiation_interval: u32) -> Self {
        assert!(latency >= 1 && initiation_interval >= 1, "a pipeline has a stage and an initiation interval");
        Self {
            stages: (0..latency).map(|_| None).collect(),
            queue: VecDeque::with_capacity(QUEUE_ENTRIES),
            phase: 0,
            initiation_interval,
        }
    }

    /// `in_ready` in this cycle.
    #[must_use]
    pub fn in_ready(&self) -> bool {
        self.advances() && self.phase == 0
    }

    /// What `out` shows in this cycle; `None` while `out_valid` is low.
    #[must_use]
    pub fn out(&self) -> Option<&T> {
        self.queue.front()
    }

    /// Whether no token is on its way, neither in the pipeline nor in the queue.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.queue.is_empty() && self.stages.iter().all(Option::is_none)
    }

    /// One clock edge. `accepted` is the result of the token transferred on `in` in this cycle, or `None` when there was
    /// no transfer or the token's keep condition is false: a dropped token travels as a bubble. Returns the result that
    /// left on `out`.
    ///
    /// # Panics
    /// When a token is handed over while [`in_ready`](Self::in_ready) is false.
    pub fn step(&mut self, accepted: Option<T>, out_ready: bool) -> Option<T> {
        assert!(accepted.is_none() || self.in_ready(), "a token can only be accepted while in_ready is high");
        let advances = self.advances();
        let left = if out_ready { self.queue.pop_front() } else { None };
        if advances {
            self.queue.extend(self.stages.pop_back().flatten());
            self.stages.push_front(accepted);
            self.phase = (self.phase + 1) % self.initiation_interval;
        }
        left
    }

    fn advances(&self) -> bool {
        self.queue.len() < QUEUE_ENTRIES
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Offers a token in every cycle; returns the cycles of the first acceptances and of the first departures.
    fn run(latency: u32, initiation_interval: u32, cycles: u32) -> (Vec<u32>, Vec<u32>) {
        let mut datapath = Datapath::new(latency, initiation_interval);
        let (mut entered, mut left) = (Vec::new(), Vec::new());
        for cycle in 0..cycles {
            let token = datapath.in_ready().then_some(cycle);
            entered.extend(token);
            if let Some(token) = datapath.step(token, true) {
                assert_eq!(token + latency + 1, cycle, "latency stages, then the queue");
                left.push(cycle);
            }
        }
        (entered, left)
    }

    #[test]
    fn flows_at_the_initiation_interval() {
        assert_eq!(run(3, 1, 8), (vec![0, 1, 2, 3, 4, 5, 6, 7], vec![4, 5, 6, 7]));
        assert_eq!(run(4, 3, 12), (vec![0, 3, 6, 9], vec![5, 8, 11]));
    }

    #[test]
    fn a_blocked_output_stops_the_pipeline_and_loses_nothing() {
        let mut datapath = Datapath::new(2, 1);
        let mut sent = 0;
        for _ in 0..20 {
            let token = datapath.in_ready().then_some(sent);
            sent += u32::from(token.is_some());
            assert_eq!(datapath.step(token, false), None);
        }
        assert_eq!(sent, 4, "two stages and two queue entries");
        let received: Vec<u32> = (0..20).filter_map(|_| datapath.step(None, true)).collect();
        assert_eq!(received, [0, 1, 2, 3]);
        assert!(datapath.is_empty());
    }

    #[test]
    #[should_panic(expected = "while in_ready is high")]
    fn a_token_out_of_phase_is_refused() {
        let mut datapath = Datapath::new(1, 2);
        datapath.step(Some(1), true);
        datapath.step(Some(2), true);
    }
}
