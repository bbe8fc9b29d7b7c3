//! `Datapath`: when results of a compiled arithmetic pipeline become visible, cycle by cycle.
//!
//! The arithmetic itself is the caller's: it computes a token's result when the token is accepted and hands it over; the
//! model delays it. A pipeline has `latency` stages that step in every cycle, and never holds a token back: behind it
//! stands a queue with a place for each token that may be under way. A token may enter while there is a credit, which it
//! takes along and gives back when it leaves the queue or is dropped in front of it. A phase counter of
//! `initiation_interval` states starts at 0 after reset; a token enters in phase 0 only. Where results are always taken,
//! there is neither queue nor credit.
//!
//! ```
//! use pointcore_golden::datapath::{Datapath, Token};
//!
//! let mut datapath = Datapath::new(2, 1);
//! let input = 20;
//! assert!(datapath.in_ready());
//! datapath.step(Some(Token::Kept(input + 1)), true);
//! for _ in 0..3 {
//!     assert_eq!(datapath.out(), None);
//!     datapath.step(None, true);
//! }
//! assert_eq!(datapath.out(), Some(&21));
//! ```

use crate::stream::Fifo;
use std::collections::VecDeque;

/// Cycles from a token's acceptance to the first in which its credit can be taken again, besides the pipeline's: two in
/// the queue, one in which it leaves, one on the credit's way back.
const ROUND_CYCLES: u32 = 4;
/// Fewest places of a queue.
const PLACES_MIN: u32 = 2;

/// A token that a pipeline takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token<T> {
    /// Its result.
    Kept(T),
    /// Its keep condition is false.
    Dropped,
}

impl<T> From<Option<T>> for Token<T> {
    /// A result, if it is kept.
    fn from(result: Option<T>) -> Self {
        result.map_or(Self::Dropped, Self::Kept)
    }
}

/// What stands behind a pipeline.
#[derive(Clone, Debug)]
enum End<T> {
    Queue {
        queue: Fifo<T>,
        /// Tokens that may still enter.
        credits: u32,
        /// Credits on their way back.
        returning: u32,
    },
    /// The result that is shown, for one cycle.
    Shown(Option<T>),
}

/// Timing of a pipeline whose tokens carry results of type `T`.
#[derive(Clone, Debug)]
pub struct Datapath<T> {
    /// Front: the token accepted last. Always `latency` long; `None` is a bubble.
    stages: VecDeque<Option<Token<T>>>,
    end: End<T>,
    phase: u32,
    initiation_interval: u32,
}

/// Tokens that may be under way in a pipeline with a queue, from their acceptance until they are taken.
///
/// # Panics
/// If the initiation interval is 0.
#[must_use]
pub fn tokens(latency: u32, initiation_interval: u32) -> u32 {
    assert!(initiation_interval >= 1, "a pipeline has an initiation interval");
    // A result may wait an interval but a cycle for the phase in which a pipeline behind takes it.
    let round = latency + ROUND_CYCLES + (initiation_interval - 1);
    round.div_ceil(initiation_interval).max(PLACES_MIN)
}

impl<T> Datapath<T> {
    /// An empty pipeline with a queue behind it, as after reset. Both numbers come from the manifest the generator writes.
    ///
    /// # Panics
    /// When `latency` or `initiation_interval` is 0.
    #[must_use]
    pub fn new(latency: u32, initiation_interval: u32) -> Self {
        let credits = tokens(latency, initiation_interval);
        let end = End::Queue { queue: Fifo::new(credits as usize), credits, returning: 0 };
        Self::before(end, latency, initiation_interval)
    }

    /// The same where results are always taken in the cycle in which they are shown.
    ///
    /// # Panics
    /// When `latency` or `initiation_interval` is 0.
    #[must_use]
    pub fn always_taken(latency: u32, initiation_interval: u32) -> Self {
        Self::before(End::Shown(None), latency, initiation_interval)
    }

    fn before(end: End<T>, latency: u32, initiation_interval: u32) -> Self {
        assert!(latency >= 1 && initiation_interval >= 1, "a pipeline has a stage and an initiation interval");
        Self { stages: (0..latency).map(|_| None).collect(), end, phase: 0, initiation_interval }
    }

    /// `in_ready` in this cycle.
    #[must_use]
    pub fn in_ready(&self) -> bool {
        let has_credit = match self.end {
            End::Queue { credits, .. } => credits > 0,
            End::Shown(_) => true,
        };
        has_credit && self.phase == 0
    }

    /// What `out` shows in this cycle; `None` while `out_valid` is low.
    #[must_use]
    pub fn out(&self) -> Option<&T> {
        match &self.end {
            End::Queue { queue, .. } => queue.out(),
            End::Shown(result) => result.as_ref(),
        }
    }

    /// One clock edge. `accepted` is the token transferred on `in` in this cycle. Returns the result that left on `out`.
    ///
    /// # Panics
    /// When a token is handed over while [`in_ready`](Self::in_ready) is false, or a result is not taken that always is.
    pub fn step(&mut self, accepted: Option<Token<T>>, out_ready: bool) -> Option<T> {
        assert!(accepted.is_none() || self.in_ready(), "a token can only be accepted while in_ready is high");
        let enters = accepted.is_some();
        self.stages.push_front(accepted);
        self.phase = (self.phase + 1) % self.initiation_interval;
        let (result, dropped) = match self.stages.pop_back().flatten() {
            Some(Token::Kept(result)) => (Some(result), false),
            Some(Token::Dropped) => (None, true),
            None => (None, false),
        };
        match &mut self.end {
            End::Queue { queue, credits, returning } => {
                assert!(result.is_none() || queue.in_ready(), "there is a place for each token under way");
                let left = queue.step(result, out_ready);
                *credits = *credits + *returning - u32::from(enters);
                *returning = u32::from(left.is_some()) + u32::from(dropped);
                left
            }
            End::Shown(shown) => {
                assert!(shown.is_none() || out_ready, "results are always taken");
                std::mem::replace(shown, result)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Offers a token in every cycle; returns the cycles of the first acceptances and of the first departures.
    fn run(mut datapath: Datapath<u32>, delay: u32, cycles: u32) -> (Vec<u32>, Vec<u32>) {
        let (mut entered, mut left) = (Vec::new(), Vec::new());
        for cycle in 0..cycles {
            let token = datapath.in_ready().then_some(cycle);
            entered.extend(token);
            if let Some(token) = datapath.step(token.map(Token::Kept), true) {
                assert_eq!(token + delay, cycle);
                left.push(cycle);
            }
        }
        (entered, left)
    }

    #[test]
    fn flows_at_the_initiation_interval() {
        let flow = run(Datapath::new(3, 1), 3 + 2, 40);
        assert_eq!(flow, ((0..40).collect(), (5..40).collect()));
        for (latency, interval) in [(4, 3), (1, 8), (9, 2), (20, 7)] {
            let (entered, left) = run(Datapath::new(latency, interval), latency + 2, 100);
            let every = |first: u32| (first..100).step_by(interval as usize).collect::<Vec<_>>();
            assert_eq!((entered, left), (every(0), every(latency + 2)), "{latency} {interval}");
        }
    }

    #[test]
    fn results_that_are_taken_in_one_phase_alone_keep_the_interval() {
        for (latency, interval) in [(28, 8), (34, 8), (36, 8), (9, 2), (20, 7)] {
            for phase in 0..interval {
                let mut datapath = Datapath::new(latency, interval);
                let entered = (0..100 * interval).filter(|cycle| {
                    let enters = datapath.in_ready();
                    datapath.step(enters.then_some(Token::Kept(())), cycle % interval == phase);
                    enters
                });
                assert_eq!(entered.count(), 100, "{latency} {interval}: taken in phase {phase}");
            }
        }
    }

    #[test]
    fn what_is_always_taken_is_shown_behind_the_last_stage() {
        assert_eq!(run(Datapath::always_taken(4, 3), 4 + 1, 12), (vec![0, 3, 6, 9], vec![5, 8, 11]));
    }

    #[test]
    fn a_blocked_output_lets_in_as_many_as_there_are_places_and_loses_nothing() {
        let mut datapath = Datapath::new(2, 1);
        let mut sent = 0;
        for _ in 0..20 {
            let token = datapath.in_ready().then_some(sent);
            sent += u32::from(token.is_some());
            assert_eq!(datapath.step(token.map(Token::Kept), false), None);
        }
        assert_eq!(sent, 6);
        let received: Vec<u32> = (0..20).filter_map(|_| datapath.step(None, true)).collect();
        assert_eq!(received, (0..6).collect::<Vec<_>>());
        assert!(datapath.in_ready());
    }

    #[test]
    fn a_token_that_is_dropped_gives_its_credit_back_though_nothing_leaves() {
        let mut datapath = Datapath::<u32>::new(2, 1);
        for cycle in 0..30 {
            assert!(datapath.in_ready(), "cycle {cycle}");
            assert_eq!(datapath.step(Some(Token::from(None)), false), None);
        }
    }

    #[test]
    #[should_panic(expected = "while in_ready is high")]
    fn a_token_out_of_phase_is_refused() {
        let mut datapath = Datapath::new(1, 2);
        datapath.step(Some(Token::Kept(1)), true);
        datapath.step(Some(Token::Kept(2)), true);
    }

    #[test]
    #[should_panic(expected = "always taken")]
    fn a_result_that_is_shown_for_one_cycle_is_taken_in_it() {
        let mut datapath = Datapath::always_taken(1, 1);
        datapath.step(Some(Token::Kept(1)), true);
        (0..2).for_each(|_| _ = datapath.step(None, false));
    }
}
