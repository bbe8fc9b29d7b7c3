//! Stack recursion: pops paths until one leads nearer than the thread's radius (thesis 6.6.2).
//!
//! A path is taken if its squared distance is below the thread's squared radius, compared as unsigned integers; equal is not
//! nearer. Three stages: a pop, its path, the comparison; a thread whose path is too far goes back to the first.

use crate::stream::Skid;
use crate::unit::Model;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Descent, Path, Radius, Thread};
pub use pointcore_contract::search::units::recursion::{In, Out};

/// A thread with its last path, `None` when its stack was empty, and its radius as of the cycle in which the path came.
#[derive(Clone, Copy, Debug)]
struct Popped {
    thread: Thread,
    path: Option<Path>,
    radius2: u32,
}

/// The stack recursion.
#[derive(Clone, Debug)]
pub struct Recursion {
    radii2: Vec<u32>,
    input: Skid<Thread>,
    /// The stages r0, r1 and r2.
    popping: Option<Thread>,
    waiting: Option<Thread>,
    popped: Option<Popped>,
    resume: Skid<Descent>,
    empty: Option<Thread>,
    event_pop: bool,
}

impl Recursion {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            radii2: vec![0; config.threads as usize],
            input: Skid::default(),
            popping: None,
            waiting: None,
            popped: None,
            resume: Skid::default(),
            empty: None,
            event_pop: false,
        }
    }

    fn advances(&self) -> bool {
        self.popped.is_none() || self.resume.in_ready()
    }
}

impl Model for Recursion {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            in_ready: self.input.in_ready(),
            pop: self.popping.filter(|_| self.advances()),
            resume: self.resume.out().copied(),
            empty: self.empty,
            event_pop: self.event_pop,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let advances = self.advances();
        let (mut resumed, mut back) = (None, None);
        self.empty = None;
        self.event_pop = false;
        if let Some(Popped { thread, path, radius2 }) = self.popped.filter(|_| advances) {
            self.event_pop = path.is_some();
            match path {
                None => self.empty = Some(thread),
                Some(path) if path.distance2 < radius2 => resumed = Some(Descent { thread, node: path.node }),
                Some(_) => back = Some(thread),
            }
        }
        let takes_input = advances && back.is_none();
        if advances {
            let radius2 = |thread: Thread| self.radii2[thread.index()];
            let path = (!inputs.top_empty).then_some(inputs.top);
            self.popped = self.waiting.map(|thread| Popped { thread, path, radius2: radius2(thread) });
            self.waiting = self.popping;
            self.popping = back.or(self.input.out().copied());
        }
        self.input.step(inputs.input, takes_input);
        self.resume.step(resumed, inputs.resume_ready);

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
    use crate::search::stack::{self, Stack};
    use pointcore_contract::search::records::{Push, Query, Start};

    /// The unit with the stacks it pops from.
    struct Bench {
        recursion: Recursion,
        stack: Stack,
    }

    impl Bench {
        fn new(radius2: u32, threads: u8) -> Self {
            let config = Config { threads: u32::from(threads), ..Config::default() };
            let mut bench = Self { recursion: Recursion::new(&config), stack: Stack::new(&config) };
            for thread in 0..threads {
                let start = Start { thread: Thread { thread }, query: Query { radius2, ..Query::default() } };
                bench.recursion.clock(&In { start: Some(start), ..In::default() });
            }
            bench
        }

        fn push(&mut self, thread: u8, node: u32, distance2: u32) {
            let push = Push { thread: Thread { thread }, path: Path { node, distance2 } };
            self.stack.clock(&stack::In { push: Some(push), pop: None });
        }

        fn clock(&mut self, inputs: In) -> Out {
            let out = self.recursion.outputs();
            let stack::Out { top_empty, top } = self.stack.outputs();
            self.recursion.clock(&In { top_empty, top, ..inputs });
            self.stack.clock(&stack::In { push: None, pop: out.pop });
            out
        }
    }

    #[test]
    fn pops_until_a_path_is_nearer_than_the_radius() {
        let mut bench = Bench::new(10, 1);
        for (node, distance2) in [(2, 9), (3, 10), (4, 11), (5, 0)] {
            bench.push(0, node, distance2);
        }
        let (mut resumed, mut empty, mut pops) = (Vec::new(), 0, 0);
        for cycle in 0..48 {
            let input = (cycle % 12 == 0).then(Thread::default);
            let out = bench.clock(In { input, resume_ready: true, ..In::default() });
            resumed.extend(out.resume.map(|descent| descent.node));
            empty += u32::from(out.empty.is_some());
            pops += u32::from(out.event_pop);
        }
        assert_eq!((resumed, empty, pops), (vec![5, 2], 2, 4));
    }

    #[test]
    fn a_new_radius_counts_from_the_next_cycle_on() {
        for (delay, expected) in [(1, Some(7)), (2, None)] {
            let mut bench = Bench::new(10, 1);
            bench.push(0, 7, 9);
            let mut resumed = None;
            // The thread is in the input queue after cycle 0, in r0 after cycle 1 and in r1 after cycle 2; cycle 3 reads its radius.
            for cycle in 0..10 {
                let radius = (cycle == 4 - delay).then_some(Radius { radius2: 5, ..Radius::default() });
                let input = (cycle == 0).then(Thread::default);
                resumed = bench.clock(In { input, radius, resume_ready: true, ..In::default() }).resume.or(resumed);
            }
            assert_eq!(resumed.map(|descent| descent.node), expected);
        }
    }

    #[test]
    fn paths_that_are_not_taken_stop_the_stages_and_lose_nothing() {
        let mut bench = Bench::new(10, 8);
        for thread in 0..8 {
            bench.push(thread, u32::from(thread) + 20, 1);
        }
        let (mut next, mut resumed) = (0, Vec::new());
        for cycle in 0..60 {
            let input = (next < 8).then_some(Thread { thread: next });
            let resume_ready = cycle >= 30;
            let out = bench.clock(In { input, resume_ready, ..In::default() });
            next += u8::from(out.in_ready && next < 8);
            resumed.extend(out.resume.filter(|_| resume_ready).map(|descent| descent.node));
            assert!(cycle != 29 || next == 7, "two in each queue and one in each stage, not {next}");
        }
        assert_eq!(resumed, [20, 21, 22, 23, 24, 25, 26, 27]);
    }
}
