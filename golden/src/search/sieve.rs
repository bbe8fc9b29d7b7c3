//! Sieve: takes out beats that the priority queues would look at for nothing.
//!
//! A beat is kept if a lane's squared distance is below its thread's squared radius after the last leaf, compared as unsigned
//! integers; equal is not nearer, NaN never is. `last` moves to the last beat kept of a leaf; of a leaf without any the thread is
//! told as skipped.

use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Candidates, Radius, Thread};
pub use pointcore_contract::search::units::sieve::{In, Out};

/// A beat with its thread's radius as of the cycle in which it was taken.
#[derive(Clone, Copy, Debug)]
struct Fetched {
    candidates: Candidates,
    radius2: u32,
}

/// A beat and whether a lane is nearer than its thread's radius.
#[derive(Clone, Copy, Debug)]
struct Judged {
    candidates: Candidates,
    survives: bool,
}

/// The sieve.
#[derive(Clone, Debug)]
pub struct Sieve {
    lanes: usize,
    radii2: Vec<u32>,
    candidates: Skid<Candidates>,
    /// The stage s1.
    fetched: Option<Fetched>,
    /// The stage s2.
    judged: Option<Judged>,
    /// The last beat kept, until it is known whether it closes its leaf.
    held: Option<Candidates>,
    kept: Fifo<Candidates>,
    skipped: Option<Thread>,
}

impl Sieve {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            lanes: config.lanes as usize,
            radii2: vec![0; config.threads as usize],
            candidates: Skid::default(),
            fetched: None,
            judged: None,
            held: None,
            kept: Fifo::new(config.sieve_depth() as usize),
            skipped: None,
        }
    }

    fn judge(&self, Fetched { candidates, radius2 }: Fetched) -> Judged {
        let survives = candidates.distances[..self.lanes].iter().any(|distance| *distance < radius2);
        Judged { candidates, survives }
    }

    /// Nothing can change what is held any more: it closes its leaf, or another beat of its leaf follows.
    fn is_settled(&self) -> bool {
        let is_followed = self.judged.is_some_and(|judged| judged.survives);
        self.held.is_some_and(|held| held.place.last || is_followed)
    }

    /// Moves a judged beat on, after what was held has left if it had to.
    fn sort(&mut self, judged: Judged) {
        let place = judged.candidates.place;
        if judged.survives {
            self.held = Some(judged.candidates);
        } else if place.last {
            match &mut self.held {
                Some(held) => held.place.last = true,
                None => self.skipped = Some(place.thread),
            }
        }
    }
}

impl Model for Sieve {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { candidates_ready: self.candidates.in_ready(), kept: self.kept.out().copied(), skipped: self.skipped }
    }

    fn clock(&mut self, inputs: &In) {
        self.skipped = None;
        let is_settled = self.is_settled();
        let has_room = self.kept.in_ready();
        let proceeds = !is_settled || has_room;
        let left = if is_settled && has_room { self.held.take() } else { None };
        self.kept.step(left, inputs.kept_ready);

        let decides = self.judged.is_none() || proceeds;
        let advances = self.fetched.is_none() || decides;
        if decides {
            if let Some(judged) = self.judged.take() {
                self.sort(judged);
            }
            self.judged = self.fetched.take().map(|fetched| self.judge(fetched));
        }
        if advances {
            self.fetched = self.candidates.out().map(|candidates| Fetched {
                candidates: *candidates,
                radius2: self.radii2[candidates.place.thread.index()],
            });
        }
        self.candidates.step(inputs.candidates, advances);

        if let Some(start) = inputs.start {
            self.radii2[start.thread.index()] = start.query.radius2;
        }
        if let Some(Radius { thread, radius2 }) = inputs.radius {
            self.radii2[thread.index()] = radius2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::for_each_seed;
    use pointcore_contract::search::records::{BeatPlace, Query, Start};
    use std::collections::VecDeque;

    const LANES: u32 = 2;
    const THREADS: u32 = 4;

    /// Four threads of radius² 100.
    fn unit() -> Sieve {
        let config = Config { lanes: LANES, threads: THREADS, ..Config::default() };
        let mut sieve = Sieve::new(&config);
        for thread in 0..4 {
            let start = Start { thread: Thread { thread }, query: Query { radius2: 100, ..Query::default() } };
            sieve.clock(&In { start: Some(start), ..In::default() });
        }
        sieve
    }

    fn beat(thread: u8, address: u32, last: bool, distances: [u32; LANES as usize]) -> Candidates {
        let place = BeatPlace { thread: Thread { thread }, address, last };
        let mut candidates = Candidates { place, ..Candidates::default() };
        candidates.distances[..distances.len()].copy_from_slice(&distances);
        candidates
    }

    /// Sends beats; returns thread, address and `last` of those kept, and the threads skipped.
    fn sift(sieve: &mut Sieve, beats: &[Candidates]) -> (Vec<(u8, u32, bool)>, Vec<u8>) {
        let mut beats: VecDeque<_> = beats.iter().copied().collect();
        let (mut kept, mut skipped) = (Vec::new(), Vec::new());
        for _ in 0..40 {
            let out = sieve.outputs();
            let inputs = In { candidates: beats.front().copied(), kept_ready: true, ..In::default() };
            if out.candidates_ready {
                beats.pop_front();
            }
            kept.extend(out.kept.map(|beat| (beat.place.thread.thread, beat.place.address, beat.place.last)));
            skipped.extend(out.skipped.map(|thread| thread.thread));
            sieve.clock(&inputs);
        }
        assert!(beats.is_empty());
        (kept, skipped)
    }

    #[test]
    fn beats_without_a_near_point_go_and_the_end_moves_to_the_last_kept() {
        let nan = u32::MAX;
        let leaf = [
            beat(1, 10, false, [100, nan]),
            beat(1, 11, false, [nan, 99]),
            beat(1, 12, false, [101, 100]),
            beat(1, 13, false, [0, 0]),
            beat(1, 14, true, [nan, nan]),
        ];
        assert_eq!(sift(&mut unit(), &leaf), (vec![(1, 11, false), (1, 13, true)], vec![]));
    }

    #[test]
    fn a_leaf_without_a_near_point_is_skipped_even_behind_one_that_is_kept() {
        let leaves = [
            beat(2, 5, true, [7, 7]),
            beat(3, 6, true, [100, 100]),
            beat(0, 7, false, [100, 100]),
            beat(0, 8, true, [100, 100]),
            beat(2, 9, true, [100, 7]),
        ];
        assert_eq!(sift(&mut unit(), &leaves), (vec![(2, 5, true), (2, 9, true)], vec![3, 0]));
    }

    #[test]
    fn a_new_radius_counts_from_the_cycle_after_it_is_known() {
        for (delay, expected) in [(0, vec![(1, 3, true)]), (1, vec![])] {
            let mut sieve = unit();
            let radius = Some(Radius { thread: Thread { thread: 1 }, radius2: 50 });
            // The beat is in the input queue after this cycle and is taken in the next.
            sieve.clock(&In {
                candidates: Some(beat(1, 3, true, [60, 60])),
                radius: radius.filter(|_| delay == 1),
                ..In::default()
            });
            sieve.clock(&In { radius: radius.filter(|_| delay == 0), ..In::default() });
            assert_eq!(sift(&mut sieve, &[]).0, expected);
        }
    }

    #[test]
    fn a_queue_that_takes_nothing_stops_the_sieve_only_when_something_must_be_kept() {
        let mut sieve = unit();
        let (mut kept, mut skipped) = (0, 0);
        for address in 0..40 {
            let near = if address < 10 { 7 } else { 100 };
            let accepted = sieve.outputs().candidates_ready;
            kept += u32::from(accepted && near == 7);
            skipped += u32::from(sieve.outputs().skipped.is_some());
            sieve.clock(&In { candidates: Some(beat(0, address, true, [near; 2])), ..In::default() });
        }
        assert_eq!(
            (kept, skipped),
            (THREADS + 5, 0),
            "a beat of each thread is kept, those behind wait: in s1, s2, held and in the input queue"
        );
    }

    /// Leaves of any length under random stalls: what is kept and skipped is what each leaf's distances say.
    #[test]
    fn every_leaf_ends_once() {
        for_each_seed("sieve", |random| {
            let mut sieve = unit();
            let mut input = VecDeque::new();
            let (mut expected_kept, mut expected_skipped) = (Vec::new(), Vec::new());
            for leaf in 0..500 {
                let (thread, beats) = (random.u8(0..4), random.u32(1..6));
                let leaf: Vec<_> = (0..beats)
                    .map(|index| {
                        beat(thread, leaf * 8 + index, index + 1 == beats, [(); 2].map(|()| random.u32(60..200)))
                    })
                    .collect();
                let mut kept: Vec<_> =
                    leaf.iter().filter(|beat| beat.distances[..2].iter().min() < Some(&100)).copied().collect();
                match kept.last_mut() {
                    Some(last) => last.place.last = true,
                    None => expected_skipped.push(Thread { thread }),
                }
                expected_kept.extend(kept);
                input.extend(leaf);
            }
            let (mut kept, mut skipped) = (Vec::new(), Vec::new());
            for cycle in 0..20_000 {
                let out = sieve.outputs();
                // Long pauses fill the sieve.
                let kept_ready = random.u8(0..4) > 0 && cycle / 64 % 2 == 0;
                let candidates = input.front().copied().filter(|_| random.u8(0..4) > 0);
                if candidates.is_some() && out.candidates_ready {
                    input.pop_front();
                }
                kept.extend(out.kept.filter(|_| kept_ready));
                skipped.extend(out.skipped);
                sieve.clock(&In { candidates, kept_ready, ..In::default() });
            }
            assert!(kept == expected_kept && skipped == expected_skipped);
            assert!(kept.len() > 500 && skipped.len() > 20, "{} kept, {} skipped", kept.len(), skipped.len());
        });
    }
}
