//! What the queues' stages hold: a search and its row, a beat, a candidate at each stage.

use pointcore_contract::search::records::{Candidates, LANES_MAX, Thread};

/// A place in a row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Entry {
    pub found: bool,
    pub index: u32,
    pub distance2: u32,
}

/// What a row is made for.
#[derive(Clone, Copy, Debug, Default)]
pub struct Search {
    /// The thread's row holds nothing of this search.
    pub fresh: bool,
    pub k: usize,
    pub number: u32,
    pub radius2: u32,
}

impl Search {
    /// The search as its row is read; it is fresh no longer.
    pub fn take_up(&mut self) -> Self {
        let before = *self;
        self.fresh = false;
        before
    }

    /// The row before the first candidate.
    pub fn fill(&self, row: &mut [Entry]) {
        let (sentinels, placeholders) = row.split_at_mut(row.len() - self.k);
        sentinels.fill(Entry::default());
        placeholders.fill(Entry { distance2: self.radius2, ..Entry::default() });
    }
}

/// A beat on its way to stage b; the next one is stage a.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    pub candidates: Candidates,
    /// Only what is nearer counts.
    pub limit: u32,
}

/// The beat that chooses its candidates: stage b.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    pub candidates: Candidates,
    /// The thread's row has to be read from memory.
    pub reads: bool,
    /// Lanes to be chosen.
    pub pending: [bool; LANES_MAX],
}

impl Work {
    /// Lanes that are not nearer than this are not to be chosen.
    pub fn narrow(&mut self, radius2: u32) {
        for (pending, distance) in self.pending.iter_mut().zip(self.candidates.distances) {
            *pending &= distance < radius2;
        }
    }
}

/// A candidate on its way to its row: stage c.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    pub thread: Thread,
    /// The search whose row is read from memory, if the working row is another's.
    pub row: Option<Search>,
    /// Of a leaf.
    pub last: bool,
    pub neighbor: Option<Entry>,
}

/// A candidate at its row, the working row: stage d.
#[derive(Clone, Copy, Debug)]
pub struct Insertion {
    pub thread: Thread,
    pub last: bool,
    pub neighbor: Option<Entry>,
}
