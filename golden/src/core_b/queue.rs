//! Priority queues: the nearest neighbors of every thread so far, in order (thesis figure 6.9).
//!
//! A row a thread, of which one at a time is worked on. A row's last entry is its farthest neighbor or, while there are fewer
//! than k, a placeholder at the query's radius; when k is smaller than a row, sentinels of distance 0 fill its front.
//!
//! Distances are compared as unsigned integers. Of points at equal distance the first to come stays, and stays in front.

mod ports;
#[cfg(test)]
mod tests;

pub use ports::{In, Out};

use super::records::{Candidates, LANES_MAX, QueryResult, Radius, Shape, Start, Thread};
use crate::stream::Skid;
use crate::unit::Model;
use pointcore_spec::core_b::Config;

/// A place in a row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Entry {
    found: bool,
    index: u32,
    distance2: u32,
}

/// What a row is made for.
#[derive(Clone, Copy, Debug, Default)]
struct Search {
    /// The thread's row holds nothing of this search.
    fresh: bool,
    k: usize,
    number: u32,
    radius2: u32,
}

impl Search {
    /// The row before the first candidate.
    fn fill(&self, row: &mut [Entry]) {
        let (sentinels, placeholders) = row.split_at_mut(row.len() - self.k);
        sentinels.fill(Entry::default());
        placeholders.fill(Entry { distance2: self.radius2, ..Entry::default() });
    }
}

/// The beat that is worked on.
#[derive(Clone, Copy, Debug)]
struct Work {
    candidates: Candidates,
    first: bool,
    pending: [bool; LANES_MAX],
}

#[derive(Clone, Copy, Debug)]
enum Readout {
    Idle,
    Fetch(Thread),
    /// The entry that is shown.
    Send(usize),
}

/// What the unit did in the last cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Events {
    /// A beat was done.
    pub beat: bool,
    /// A neighbor was inserted.
    pub insert: bool,
    /// A beat stayed for one more insertion.
    pub insert_wait: bool,
}

/// The priority queues.
#[derive(Clone, Debug)]
pub struct Queue {
    shape: Shape,
    /// Entries of a row.
    neighbors: usize,
    searches: Vec<Search>,
    rows: Vec<Entry>,
    /// The row that was read from memory last.
    read: Vec<Entry>,
    /// The thread whose row is worked on.
    owner: Option<Thread>,
    working: Vec<Entry>,
    work: Option<Work>,
    candidates: Skid<Candidates>,
    finish: Skid<Thread>,
    readout: Readout,
    sent: Vec<Entry>,
    sent_number: u32,
    radius: Option<Radius>,
    released: Option<Thread>,
    events: Events,
}

impl Queue {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let (threads, neighbors) = (config.threads as usize, config.neighbors as usize);
        let row = vec![Entry::default(); neighbors];
        Self {
            shape: Shape::new(config),
            neighbors,
            searches: vec![Search::default(); threads],
            rows: vec![Entry::default(); threads * neighbors],
            read: row.clone(),
            owner: None,
            working: row.clone(),
            work: None,
            candidates: Skid::default(),
            finish: Skid::default(),
            readout: Readout::Idle,
            sent: row,
            sent_number: 0,
            radius: None,
            released: None,
            events: Events::default(),
        }
    }

    fn row(&self, thread: Thread) -> std::ops::Range<usize> {
        let first = thread.index() * self.neighbors;
        first..first + self.neighbors
    }

    /// The thread whose row returns to memory in this cycle.
    fn written_back(&self) -> Option<Thread> {
        let work = self.work.as_ref().filter(|work| work.first)?;
        self.owner.filter(|owner| *owner != work.candidates.place.thread)
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

    /// Makes the row of a new beat's thread the working row.
    fn take_up(&mut self, thread: Thread) {
        if let Some(owner) = self.written_back() {
            let row = self.row(owner);
            self.rows[row].copy_from_slice(&self.working);
        }
        let search = &mut self.searches[thread.index()];
        if std::mem::take(&mut search.fresh) {
            search.fill(&mut self.working);
        } else if self.owner != Some(thread) {
            self.working.copy_from_slice(&self.read);
        }
        self.owner = Some(thread);
    }

    fn farthest(&self) -> u32 {
        self.working[self.neighbors - 1].distance2
    }

    fn insert(&mut self, entry: Entry) {
        let place = self.working.partition_point(|other| other.distance2 <= entry.distance2);
        self.working.copy_within(place..self.neighbors - 1, place + 1);
        self.working[place] = entry;
    }

    /// One insertion of a beat; returns what is left of it.
    fn work_on(&mut self, mut work: Work) -> Option<Work> {
        let place = work.candidates.place;
        if work.first {
            self.take_up(place.thread);
            work.first = false;
        }
        let farthest = self.farthest();
        let distances = work.candidates.distances;
        for (pending, distance) in work.pending.iter_mut().zip(distances) {
            *pending &= distance < farthest;
        }
        let nearest_lane = work.pending[..self.shape.lanes].iter().position(|pending| *pending);
        if let Some(lane) = nearest_lane {
            let index = place.address << self.shape.lanes.ilog2() | lane as u32;
            self.insert(Entry { found: true, index, distance2: distances[lane] });
            work.pending[lane] = false;
        }
        let stays = work.pending[..self.shape.lanes].contains(&true);
        self.events = Events { beat: !stays, insert: nearest_lane.is_some(), insert_wait: stays };
        if !stays && place.last {
            self.radius = Some(Radius { thread: place.thread, radius2: self.farthest() });
        }
        stays.then_some(work)
    }

    fn read_row(&mut self, thread: Thread) {
        let row = self.row(thread);
        self.read.copy_from_slice(&self.rows[row]);
    }
}

impl Model for Queue {
    type Shape = Shape;
    type In = In;
    type Out = Out;

    fn shape(&self) -> Shape {
        self.shape
    }

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
        self.radius = None;
        self.released = None;
        self.events = Events::default();
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
        self.work = self.work.and_then(|work| self.work_on(work));

        let is_free = self.work.is_none() && finished.is_none();
        let next = self.candidates.out().copied();
        let taken = next.filter(|next| is_free && Some(next.place.thread) != written_back);
        if let Some(candidates) = taken {
            self.read_row(candidates.place.thread);
            self.work = Some(Work { candidates, first: true, pending: [true; LANES_MAX] });
        }
        if let Some(thread) = finished {
            self.read_row(thread);
            self.readout = Readout::Fetch(thread);
        }
        self.candidates.step(inputs.candidates, taken.is_some());
        self.finish.step(inputs.finish, finished.is_some());

        if let Some(Start { thread, query }) = inputs.start {
            let (k, number, radius2) = (usize::from(query.k), query.number, query.radius2);
            self.searches[thread.index()] = Search { fresh: true, k, number, radius2 };
        }
    }
}
