//! Thread control: gives queries to threads and tells each thread what to do next (thesis 6.4, listing 6.2).
//!
//! A thread that has reached a leaf goes on popping while fewer than `leaves_in_flight` of its leaves are under way, else when
//! the next of them is done. It finishes when its stack is empty and no leaf is under way.

use crate::stream::Skid;
use crate::unit::Model;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Descent, Start, Thread};
pub use pointcore_contract::search::units::threads::{In, Out};

/// The root of the tree.
const ROOT: u32 = 1;

#[derive(Clone, Copy, Debug, Default)]
struct State {
    busy: bool,
    /// Leaves under way.
    outstanding: u8,
    /// As many leaves are under way as may be.
    waiting: bool,
    /// The stack is empty for good.
    exhausted: bool,
    wants_pop: bool,
    wants_finish: bool,
}

impl State {
    /// Of a thread's leaves one may be reached and two end in one cycle.
    fn note_leaves(&mut self, reached: bool, ended: u8, leaves_in_flight: u8) {
        self.outstanding = self.outstanding + u8::from(reached) - ended;
        if self.waiting && ended > 0 {
            self.waiting = false;
            self.wants_pop = true;
        }
        if reached && self.outstanding < leaves_in_flight {
            self.wants_pop = true;
        } else if reached {
            self.waiting = true;
        }
    }
}

/// The thread control.
#[derive(Clone, Debug)]
pub struct Threads {
    leaves_in_flight: u8,
    states: Vec<State>,
    popping: Turns,
    finishing: Turns,
    start: Option<Start>,
    descend: Skid<Descent>,
    event_thread_wait: bool,
}

impl Threads {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            leaves_in_flight: config.leaves_in_flight as u8,
            states: vec![State::default(); config.threads as usize],
            popping: Turns::default(),
            finishing: Turns::default(),
            start: None,
            descend: Skid::default(),
            event_thread_wait: false,
        }
    }

    fn free_thread(&self) -> Option<Thread> {
        self.states.iter().position(|state| !state.busy).map(|index| Thread { thread: index as u8 })
    }

    fn query_ready(&self) -> bool {
        self.free_thread().is_some() && self.descend.in_ready() && self.start.is_none()
    }

    /// Pulses change the threads' states all at once.
    fn note_progress(&mut self, inputs: &In) {
        for (index, state) in self.states.iter_mut().enumerate() {
            let is_of = |pulse: Option<Thread>| pulse.is_some_and(|thread| thread.index() == index);
            let leaves_ended = u8::from(is_of(inputs.leaf_done)) + u8::from(is_of(inputs.skipped));
            state.note_leaves(is_of(inputs.reached), leaves_ended, self.leaves_in_flight);
            state.exhausted |= is_of(inputs.empty);
            if is_of(inputs.empty) || leaves_ended > 0 {
                state.wants_finish |= state.exhausted && state.outstanding == 0;
            }
            if is_of(inputs.released) {
                *state = State::default();
            }
        }
    }
}

/// Wishes of one kind, granted in turn.
#[derive(Clone, Debug, Default)]
struct Turns {
    /// Who comes first.
    next: usize,
    /// Who has been chosen and is shown.
    chosen: Option<Thread>,
}

impl Turns {
    /// Chooses the next one when the one before is taken.
    fn step(&mut self, ready: bool, states: &mut [State], wish: impl Fn(&mut State) -> &mut bool) {
        if ready || self.chosen.is_none() {
            self.chosen = self.grant(states, wish);
        }
    }

    /// Grants the first wish from `next` on, cyclically.
    fn grant(&mut self, states: &mut [State], wish: impl Fn(&mut State) -> &mut bool) -> Option<Thread> {
        let (before, after) = (0..self.next, self.next..states.len());
        let index = after.chain(before).find(|index| *wish(&mut states[*index]))?;
        *wish(&mut states[index]) = false;
        self.next = (index + 1) % states.len();
        Some(Thread { thread: index as u8 })
    }
}

impl Model for Threads {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            query_ready: self.query_ready(),
            start: self.start,
            descend: self.descend.out().copied(),
            pop: self.popping.chosen,
            finish: self.finishing.chosen,
            event_thread_wait: self.event_thread_wait,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let free = self.free_thread();
        let query = inputs.query.filter(|_| self.query_ready());
        self.event_thread_wait = inputs.query.is_some() && free.is_none();

        // Wishes are granted as they stand before this cycle's pulses.
        self.popping.step(inputs.pop_ready, &mut self.states, |state| &mut state.wants_pop);
        self.finishing.step(inputs.finish_ready, &mut self.states, |state| &mut state.wants_finish);
        self.note_progress(inputs);

        let descent = self.start.map(|start| Descent { thread: start.thread, node: ROOT });
        self.descend.step(descent, inputs.descend_ready);
        self.start = free.zip(query).map(|(thread, query)| Start { thread, query });
        if let Some(start) = self.start {
            self.states[start.thread.index()].busy = true;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::search::records::Query;

    const READY: In = In {
        query: None,
        descend_ready: true,
        pop_ready: true,
        finish_ready: true,
        reached: None,
        leaf_done: None,
        skipped: None,
        empty: None,
        released: None,
    };
    const FIRST: Option<Thread> = Some(Thread { thread: 0 });

    fn unit(threads: u32, leaves_in_flight: u32) -> Threads {
        Threads::new(&Config { threads, leaves_in_flight, ..Config::default() })
    }

    /// Clocks one cycle with `inputs`, then idle ones; returns whether thread 0 popped and finished within them.
    fn after(threads: &mut Threads, inputs: In) -> (bool, bool) {
        threads.clock(&inputs);
        let (mut popped, mut finished) = (false, false);
        for _ in 0..4 {
            let out = threads.outputs();
            popped |= out.pop == FIRST;
            finished |= out.finish == FIRST;
            threads.clock(&READY);
        }
        (popped, finished)
    }

    #[test]
    fn queries_start_in_the_lowest_free_thread() {
        let mut threads = unit(3, 1);
        let mut started = Vec::new();
        for number in 0..12 {
            let query = Some(Query { number, ..Query::default() });
            let released = (number == 8).then_some(Thread { thread: 1 });
            threads.clock(&In { query, released, ..READY });
            started.extend(threads.outputs().start.map(|start| (start.query.number, start.thread.thread)));
        }
        assert_eq!(started, [(0, 0), (2, 1), (4, 2), (9, 1)]);
        assert!(threads.outputs().event_thread_wait);
    }

    #[test]
    fn a_thread_goes_on_until_its_leaves_in_flight_are_many() {
        let mut threads = unit(2, 2);
        threads.clock(&In { query: Some(Query::default()), ..READY });
        assert_eq!(after(&mut threads, In { reached: FIRST, ..READY }), (true, false));
        assert_eq!(after(&mut threads, In { reached: FIRST, ..READY }), (false, false), "two leaves are under way");
        assert_eq!(after(&mut threads, In { leaf_done: FIRST, ..READY }), (true, false));
        assert_eq!(after(&mut threads, In { empty: FIRST, ..READY }), (false, false), "a leaf is under way");
        assert_eq!(after(&mut threads, In { leaf_done: FIRST, ..READY }), (false, true));
        assert!(threads.states[0].busy, "until it is released");
        assert_eq!(after(&mut threads, In { released: FIRST, ..READY }), (false, false));
        assert!(!threads.states[0].busy);
    }

    #[test]
    fn a_leaf_done_as_the_next_is_reached_leaves_their_number_as_it_was() {
        let mut threads = unit(1, 2);
        threads.clock(&In { query: Some(Query::default()), ..READY });
        assert_eq!(after(&mut threads, In { reached: FIRST, ..READY }), (true, false));
        assert_eq!(after(&mut threads, In { reached: FIRST, leaf_done: FIRST, ..READY }), (true, false));
        assert_eq!(after(&mut threads, In { reached: FIRST, ..READY }), (false, false));
    }

    #[test]
    fn a_skipped_leaf_ends_as_one_that_is_done() {
        let mut threads = unit(1, 1);
        threads.clock(&In { query: Some(Query::default()), ..READY });
        assert_eq!(after(&mut threads, In { reached: FIRST, ..READY }), (false, false));
        assert_eq!(after(&mut threads, In { skipped: FIRST, ..READY }), (true, false));
        assert_eq!(after(&mut threads, In { reached: FIRST, ..READY }), (false, false));
        assert_eq!(after(&mut threads, In { skipped: FIRST, empty: FIRST, ..READY }), (true, true));
    }

    #[test]
    fn two_leaves_of_a_thread_may_end_in_one_cycle() {
        let mut threads = unit(1, 3);
        threads.clock(&In { query: Some(Query::default()), ..READY });
        assert_eq!(after(&mut threads, In { reached: FIRST, ..READY }), (true, false));
        assert_eq!(after(&mut threads, In { reached: FIRST, ..READY }), (true, false));
        assert_eq!(after(&mut threads, In { empty: FIRST, ..READY }), (false, false));
        assert_eq!(after(&mut threads, In { leaf_done: FIRST, skipped: FIRST, ..READY }), (false, true));
    }

    #[test]
    fn wishes_are_granted_in_turn() {
        let mut states = [State { wants_pop: true, ..State::default() }; 3];
        let mut turns = Turns { next: 1, chosen: None };
        let mut granted = Vec::new();
        for _ in 0..6 {
            granted.extend(turns.grant(&mut states, |state| &mut state.wants_pop).map(|thread| thread.thread));
            states[2].wants_pop = true;
        }
        assert_eq!(granted, [1, 2, 0, 2, 2, 2]);
    }
}
