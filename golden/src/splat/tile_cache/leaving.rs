//! The frame that leaves: its tiles one by one, as soon as no copy of them is to come.

use crate::stream::Fifo;
use pointcore_contract::splat::config::GONE_TILES;

/// A tile that is looked at: which of its pixels memory holds, and whether it may leave.
#[derive(Clone, Copy, Debug)]
pub enum Look {
    /// Memory is asked.
    Read,
    /// It shows what it holds, and whether copies are to come.
    Shown { mask: u64, is_pending: bool },
    /// It is judged.
    Seen { mask: u64, may_leave: bool },
}

/// The frame that leaves.
#[derive(Clone, Debug)]
pub struct Leaving {
    /// Which, if one does.
    pub surface: Option<bool>,
    /// All of it is drawn, and in memory.
    pub given: bool,
    /// The place that is looked at next, among all; none is left where all were.
    next: Option<u32>,
    /// Places of tiles that were written back meanwhile.
    pub gone: Fifo<u32>,
    /// The place that is looked at.
    pub looked_at: Option<(u32, Look)>,
    /// The frame has left; that of other rasterizers may not have.
    pub waits: bool,
}

impl Leaving {
    /// None.
    pub fn new() -> Self {
        Self {
            surface: None,
            given: false,
            next: None,
            gone: Fifo::new(GONE_TILES as usize),
            looked_at: None,
            waits: false,
        }
    }

    /// A frame begins to leave.
    pub const fn begin(&mut self, surface: bool) {
        self.surface = Some(surface);
        self.next = Some(0);
    }

    /// All tiles were looked at.
    pub fn is_over(&self) -> bool {
        self.next.is_none() && self.looked_at.is_none() && self.gone.out().is_none()
    }

    /// The frame has left.
    pub fn close(&mut self, waits: bool) {
        (self.surface, self.given, self.waits) = (None, false, waits);
    }

    /// The next tile is looked at: one that was written back meanwhile, or the next of all. Returns whether it is one of those.
    pub fn look(&mut self, places: usize) -> bool {
        let gone = self.gone.out().copied();
        let place = gone.or_else(|| {
            let next = self.next?;
            self.next = Some(next + 1).filter(|next| (*next as usize) < places);
            Some(next)
        });
        self.looked_at = place.map(|place| (place, Look::Read));
        gone.is_some()
    }
}
