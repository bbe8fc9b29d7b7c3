//! A slot's change from one tile to another.

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

impl Job {
    /// Whether it is about to ask for pixels, or writes the mask of the tile that goes.
    pub fn has_mask(self) -> bool {
        let asks = matches!(self.step, JobStep::Read | JobStep::Change);
        asks || (self.step == JobStep::Changed && self.goes.is_some())
    }
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
