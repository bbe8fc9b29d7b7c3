//! Priority queues: the nearest neighbors of every thread so far, in order (thesis figure 6.9).
//!
//! A row a thread, of which one at a time is worked on. A row's last entry is its farthest neighbor or, while there are fewer
//! than k, a placeholder at the query's radius; when k is smaller than a row, sentinels of distance 0 fill its front.
//!
//! Four stages: a beat's lanes are compared with the radius of the thread's last leaf, one after the other is chosen, its row
//! comes from memory, and it is inserted if it is still nearer than the farthest neighbor.
//!
//! Distances are compared as unsigned integers. Of points at equal distance the first to come stays, and stays in front.

mod stages;
#[cfg(test)]
mod tests;

use crate::stream::Skid;
use crate::unit::Model;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Candidates, LANES_MAX, QueryResult, Radius, Start, Thread};
use pointcore_contract::search::units::QueueEvents;
pub use pointcore_contract::search::units::queue::{In, Out};
use stages::{Arrival, Entry, Insertion, Item, Search, Work};

#[derive(Clone, Copy, Debug)]
enum Readout {
    Idle,
    Fetch(Thread),
    /// The entry that is shown.
    Send(usize),
}

/// The priority queues.
#[derive(Clone, Debug)]
pub struct Queue {
    lanes: usize,
    /// Entries of a row.
    neighbors: usize,
    searches: Vec<Search>,
    rows: Vec<Entry>,
    /// The row that was read from memory last.
    read: Vec<Entry>,
    /// The thread whose row is worked on.
    owner: Option<Thread>,
    working: Vec<Entry>,
    /// The squared radii of the threads' last leaves.
    limits: Vec<u32>,
    candidates: Skid<Arrival>,
    work: Option<Work>,
    item: Option<Item>,
    insertion: Option<Insertion>,
    /// The farthest neighbor of the working row as it was a cycle ago, unless that was another row: stage e.
    farthest: Option<Radius>,
    finish: Skid<Thread>,
    readout: Readout,
    sent: Vec<Entry>,
    sent_number: u32,
    radius: Option<Radius>,
    released: Option<Thread>,
    events: QueueEvents,
}

impl Queue {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let (threads, neighbors) = (config.threads as usize, config.neighbors as usize);
        let row = vec![Entry::default(); neighbors];
        Self {
            lanes: config.lanes as usize,
            neighbors,
            searches: vec![Search::default(); threads],
            rows: vec![Entry::default(); threads * neighbors],
            read: row.clone(),
            owner: None,
            working: row.clone(),
            limits: vec![0; threads],
            candidates: Skid::default(),
            work: None,
            item: None,
            insertion: None,
            farthest: None,
            finish: Skid::default(),
            readout: Readout::Idle,
            sent: row,
            sent_number: 0,
            radius: None,
            released: None,
            events: QueueEvents::default(),
        }
    }

    fn row(&self, thread: Thread) -> std::ops::Range<usize> {
        let first = thread.index() * self.neighbors;
        first..first + self.neighbors
    }

    /// The thread whose row returns to memory in this cycle.
    fn written_back(&self) -> Option<Thread> {
        self.owner.filter(|_| self.item.is_some_and(|item| item.row.is_some()))
    }

    /// The thread whose row will be the working row when what is in stage c has passed.
    fn next_owner(&self) -> Option<Thread> {
        self.item.map(|item| item.thread).or(self.owner)
    }

    /// The entry shown closes its query.
    fn is_last(&self, entry: usize) -> bool {
        !self.sent.get(entry + 1).is_some_and(|next| next.found)
    }

    fn result(&self) -> Option<QueryResult> {
        let Readout::Send(entry) = self.readout else { return None };
        let Entry { found, index, distance2 } = self.sent[entry];
        Some(QueryResult { number: self.sent_number, last: self.is_last(entry), found, index, distance2 })
    }

    /// Takes the row of a finished thread to the send registers.
    fn fetch_row(&mut self, thread: Thread) {
        let search = &self.searches[thread.index()];
        if search.fresh {
            search.fill(&mut self.sent);
        } else if self.owner == Some(thread) {
            self.sent.copy_from_slice(&self.working);
        } else {
            self.sent.copy_from_slice(&self.read);
        }
        self.sent_number = search.number;
        self.readout = Readout::Send(self.neighbors - search.k);
        self.released = Some(thread);
    }

    /// Makes the row of an item's thread the working row.
    fn take_up(&mut self, thread: Thread, search: Search) {
        if let Some(owner) = self.written_back() {
            let row = self.row(owner);
            self.rows[row].copy_from_slice(&self.working);
        }
        if search.fresh {
            search.fill(&mut self.working);
        } else {
            self.working.copy_from_slice(&self.read);
        }
        self.owner = Some(thread);
    }

    fn last_distance(&self) -> u32 {
        self.working[self.neighbors - 1].distance2
    }

    /// Inserts a neighbor if it is nearer than the farthest.
    fn insert(&mut self, entry: Entry) -> bool {
        let place = self.working.partition_point(|other| other.distance2 <= entry.distance2);
        let is_nearer = place < self.neighbors;
        if is_nearer {
            self.working.copy_within(place..self.neighbors - 1, place + 1);
            self.working[place] = entry;
        }
        is_nearer
    }

    /// Stage d.
    fn finish_insertion(&mut self) {
        let Some(Insertion { thread, last, neighbor }) = self.insertion.take() else { return };
        self.events.insert = neighbor.is_some_and(|neighbor| self.insert(neighbor));
        self.radius = last.then(|| Radius { thread, radius2: self.last_distance() });
    }

    /// Stage c.
    fn pass_item(&mut self) {
        let Some(Item { thread, row, last, neighbor }) = self.item else { return };
        if let Some(search) = row {
            self.take_up(thread, search);
        }
        self.item = None;
        self.insertion = Some(Insertion { thread, last, neighbor });
    }

    /// Stage b: the lowest lane of a beat goes on; returns what is left of it.
    fn choose(&mut self, mut work: Work, farthest: Option<Radius>) -> Option<Work> {
        let Candidates { place, distances } = work.candidates;
        let lanes = self.lanes;
        let chosen = work.pending[..lanes].iter().position(|pending| *pending);
        let neighbor = chosen.map(|lane| {
            work.pending[lane] = false;
            let index = place.address << lanes.ilog2() | lane as u32;
            Entry { found: true, index, distance2: distances[lane] }
        });
        let stays = work.pending[..lanes].contains(&true);
        let row = work.reads.then(|| {
            self.read_row(place.thread);
            self.searches[place.thread.index()].take_up()
        });
        self.item = Some(Item { thread: place.thread, row, last: place.last && !stays, neighbor });
        work.reads = false;
        if let Some(farthest) = farthest.filter(|farthest| farthest.thread == place.thread) {
            work.narrow(farthest.radius2);
        }
        self.events.beat = !stays;
        self.events.insert_wait = stays;
        stays.then_some(work)
    }

    fn read_row(&mut self, thread: Thread) {
        let row = self.row(thread);
        self.read.copy_from_slice(&self.rows[row]);
    }
}

impl Model for Queue {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            candidates_ready: self.candidates.in_ready(),
            radius: self.radius,
            finish_ready: self.finish.in_ready(),
            released: self.released,
            result: self.result(),
            events: self.events,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let shown_radius = self.radius.take();
        self.released = None;
        self.events = QueueEvents::default();
        let written_back = self.written_back();
        let is_idle = matches!(self.readout, Readout::Idle);
        let finished = self.finish.out().copied().filter(|thread| is_idle && Some(*thread) != written_back);

        match self.readout {
            Readout::Idle => {}
            Readout::Fetch(thread) => self.fetch_row(thread),
            Readout::Send(entry) if inputs.result_ready => {
                self.readout = if self.is_last(entry) { Readout::Idle } else { Readout::Send(entry + 1) };
            }
            Readout::Send(_) => {}
        }
        self.finish_insertion();
        // What a beat reads and whose row it displaces is judged by the stages as they were.
        let next_owner = self.next_owner();
        let reads = self.item.is_some_and(|item| item.row.is_some());
        let is_current = !reads && self.work.is_none_or(|work| !work.reads);
        let farthest = self.farthest.filter(|_| is_current);
        self.farthest = self.owner.filter(|_| !reads).map(|thread| Radius { thread, radius2: self.last_distance() });
        self.pass_item();
        let waits = is_idle && self.finish.out().is_some() && self.work.is_some_and(|work| work.reads);
        let before = self.work.map(|work| work.candidates.place.thread);
        if !waits {
            self.work = self.work.and_then(|work| self.choose(work, farthest));
        }

        // The row that the beat before drives out is not in memory yet.
        let is_driven_out = |thread| before.is_some_and(|before| before != thread) && next_owner == Some(thread);
        let is_free = self.work.is_none();
        let taken =
            self.candidates.out().copied().filter(|next| is_free && !is_driven_out(next.candidates.place.thread));
        if let Some(Arrival { candidates, limit }) = taken {
            let thread = candidates.place.thread;
            let begins = before.is_none() && self.searches[thread.index()].fresh;
            let reads = begins || before.or(next_owner) != Some(thread);
            let mut work = Work { candidates, reads, pending: [true; LANES_MAX] };
            work.narrow(limit);
            if let Some(farthest) = farthest.filter(|farthest| farthest.thread == thread && !reads) {
                work.narrow(farthest.radius2);
            }
            self.work = Some(work);
        }
        if let Some(thread) = finished {
            self.read_row(thread);
            self.readout = Readout::Fetch(thread);
        }
        let limit = |candidates: &Candidates| self.limits[candidates.place.thread.index()];
        let arrival = inputs.candidates.map(|candidates| Arrival { candidates, limit: limit(&candidates) });
        self.candidates.step(arrival, taken.is_some());
        self.finish.step(inputs.finish, finished.is_some());

        if let Some(Radius { thread, radius2 }) = shown_radius {
            self.limits[thread.index()] = radius2;
        }
        if let Some(Start { thread, query }) = inputs.start {
            self.limits[thread.index()] = query.radius2;
            let (k, number, radius2) = (usize::from(query.k), query.number, query.radius2);
            self.searches[thread.index()] = Search { fresh: true, k, number, radius2 };
        }
    }
}
