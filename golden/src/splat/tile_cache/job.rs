//! A slot's change from one tile to another, and the walk through the tiles of a finished frame.

use pointcore_contract::splat::records::Slot;

/// A slot loses its tile, and may get another.
#[derive(Clone, Copy, Debug)]
pub struct Job {
    /// The slot.
    pub slot: Slot,
    /// The tile that comes.
    pub comes: Option<u32>,
    /// The tile that goes.
    pub goes: Option<u32>,
    /// A bit for each bank in which the slot has not changed.
    pub unchanged: u32,
    /// How far it has come.
    pub step: JobStep,
}

/// The steps of a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JobStep {
    /// The mask of what memory holds of the tile that comes is read.
    Read,
    /// The slot is told of these pixels.
    Change,
    /// It shows which pixels it held.
    Changed,
    /// Pixels go and come.
    Move,
}

/// Tile codes under way while the frame's pixels are asked for.
#[derive(Clone, Copy, Debug)]
pub struct Walk {
    /// The one that is read next.
    pub next: Option<usize>,
    /// The one whose mask the memory shows.
    pub read: Option<usize>,
    /// The one whose mask is judged.
    pub seen: Option<usize>,
}

impl Walk {
    /// From the first code on.
    pub const FIRST: Self = Self { next: Some(0), read: None, seen: None };

    /// Whether all codes were judged.
    pub const fn is_over(&self) -> bool {
        self.next.is_none() && self.read.is_none() && self.seen.is_none()
    }

    /// The codes move on, of so many in all.
    pub fn advance(&self, codes: usize) -> Self {
        let next = self.next.map(|code| code + 1).filter(|code| *code < codes);
        Self { next, read: self.next, seen: self.read }
    }
}
