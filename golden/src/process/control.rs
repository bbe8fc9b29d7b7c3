//! Control: threads from their query to their result, and the neighbors of each.
//!
//! A thread is in one queue at a time, so that queues as long as there are threads never overflow.

use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::process::config::Config;
use pointcore_contract::process::queries::{Found, Listed, Start};
use pointcore_contract::process::records::{Gather, NeighborPlace, Thread};
pub use pointcore_contract::process::stages::control::{In, Out};

/// A thread's neighbors that are gathered, one a cycle.
#[derive(Clone, Copy, Debug)]
struct Turn {
    thread: Thread,
    /// The neighbor that is next.
    rank: usize,
    /// Its last one.
    last: usize,
    farthest: bool,
    none: bool,
}

/// The control.
#[derive(Clone, Debug)]
pub struct Control {
    threads: u8,
    neighbors: usize,
    has_init: bool,
    has_farthest: bool,
    /// Threads that have had a query.
    issued: u8,
    busy: u8,
    /// Threads that have a query no more.
    free: Fifo<Thread>,
    start: Option<Start>,
    /// A thread with a new query, on its way to the queue of those that want neighbors.
    entering: Option<Thread>,
    want: Fifo<Thread>,
    found: Skid<Found>,
    /// Neighbors by thread.
    lists: Vec<u32>,
    /// Numbers of neighbors by thread.
    counts: Vec<usize>,
    /// Neighbors found of the search that comes in.
    rank: usize,
    listed: Option<Listed>,
    /// Threads before `init`.
    ready: Fifo<Thread>,
    /// Threads before `kernel`.
    run: Fifo<Thread>,
    turn: Option<Turn>,
    /// The last turn was that of a farthest neighbor.
    was_farthest: bool,
    /// What is read from the lists.
    read: Option<Gather>,
    gather: Skid<Gather>,
    event_query_wait: bool,
}

impl Control {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let threads = config.threads as usize;
        let queue = || Fifo::new(threads.max(2));
        Self {
            threads: config.threads as u8,
            neighbors: config.neighbors as usize,
            has_init: config.has_init(),
            has_farthest: config.has_farthest(),
            issued: 0,
            busy: 0,
            free: queue(),
            start: None,
            entering: None,
            want: queue(),
            found: Skid::default(),
            lists: vec![0; threads * config.neighbors as usize],
            counts: vec![0; threads],
            rank: 0,
            listed: None,
            ready: queue(),
            run: queue(),
            turn: None,
            was_farthest: false,
            read: None,
            gather: Skid::default(),
            event_query_wait: false,
        }
    }

    fn free_thread(&self) -> Option<Thread> {
        if self.issued < self.threads { Some(Thread { thread: self.issued }) } else { self.free.out().copied() }
    }

    fn query_ready(&self) -> bool {
        self.free_thread().is_some() && self.entering.is_none()
    }

    /// A query goes to a thread that has not had one, else to the one that has been free for longest.
    fn take_query(&mut self, inputs: &In) {
        let thread = self.free_thread();
        let query = inputs.query.filter(|_| self.query_ready());
        self.event_query_wait = inputs.query.is_some() && thread.is_none();
        let is_issued = self.issued < self.threads;
        self.free.step(inputs.released, query.is_some() && !is_issued);
        self.issued += u8::from(query.is_some() && is_issued);
        self.busy += u8::from(query.is_some());
        self.busy -= u8::from(inputs.released.is_some());

        let searched = inputs.again.filter(|again| again.search).map(|again| again.thread);
        let enters = self.entering.filter(|_| searched.is_none());
        self.want.step(searched.or(enters), inputs.want_ready);
        if enters.is_some() {
            self.entering = None;
        }
        self.start = thread.zip(query).map(|(thread, query)| Start { thread, query });
        if let Some(start) = self.start {
            self.entering = Some(start.thread);
        }
    }

    /// A neighbor found enters its list; returns the thread whose neighbors are complete.
    fn take_found(&mut self, inputs: &In, stays: bool) -> Option<Thread> {
        let found = self.found.out().copied().filter(|_| !stays);
        self.found.step(inputs.found, found.is_some());
        self.listed = None;
        let Found { thread, last, found, index } = found?;
        let place = usize::from(thread.thread) * self.neighbors + self.rank;
        if found {
            self.lists[place] = index;
        }
        if !last {
            self.rank += 1;
            return None;
        }
        let neighbors = if found { self.rank + 1 } else { 0 };
        self.counts[usize::from(thread.thread)] = neighbors;
        self.listed = Some(Listed { thread, neighbors: neighbors as u8 });
        self.rank = 0;
        Some(thread)
    }

    /// Neighbors are gathered thread after thread; returns whose turn is next, of the queues before `init` and `kernel`.
    fn take_turn(&mut self, inputs: &In) -> (bool, bool) {
        let advances = self.read.is_none() || self.gather.in_ready();
        let read = if advances { self.read.take() } else { None };
        self.gather.step(read, inputs.gather_ready);
        if advances && let Some(turn) = &mut self.turn {
            let Turn { thread, rank, last, farthest, none } = *turn;
            let index = self.lists[usize::from(thread.thread) * self.neighbors + rank];
            let place = NeighborPlace { thread, farthest, none, last: rank == last && !farthest };
            self.read = Some(Gather { place, index: if none { 0 } else { index } });
            turn.rank += 1;
            if rank == last {
                self.turn = None;
            }
        }
        if self.turn.is_some() {
            return (false, false);
        }
        let ready = self.ready.out().filter(|_| self.has_farthest).copied();
        let run = self.run.out().copied();
        let farthest = ready.is_some() && !(self.was_farthest && run.is_some());
        let chosen = if farthest { ready } else { run };
        let Some(thread) = chosen else { return (false, false) };
        let neighbors = self.counts[usize::from(thread.thread)];
        let last = neighbors.saturating_sub(1);
        let rank = if farthest { last } else { 0 };
        self.turn = Some(Turn { thread, rank, last, farthest, none: neighbors == 0 });
        self.was_farthest = farthest;
        (farthest, !farthest)
    }
}

impl Model for Control {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            query_ready: self.query_ready(),
            start: self.start,
            want: self.want.out().copied(),
            found_ready: self.found.in_ready(),
            listed: self.listed,
            prepare: self.ready.out().filter(|_| !self.has_farthest).copied(),
            gather: self.gather.out().copied(),
            idle: self.busy == 0,
            event_query_wait: self.event_query_wait,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let (starts_init, starts_kernel) = self.take_turn(inputs);
        self.take_query(inputs);
        let kept = inputs.again.filter(|again| !again.search).map(|again| again.thread);
        let ready = kept.or(self.take_found(inputs, kept.is_some()));
        if self.has_init {
            self.ready.step(ready, if self.has_farthest { starts_init } else { inputs.prepare_ready });
            self.run.step(inputs.prepared, starts_kernel);
        } else {
            self.run.step(ready, starts_kernel);
        }
    }
}
