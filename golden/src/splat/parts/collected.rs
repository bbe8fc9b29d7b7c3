//! Two sides share one stream of records, of which some close a frame.
//!
//! They come from one side at a time: its turn lasts while something moves, and while its frame goes on. Once both sides have ended the
//! frame, its end leaves.

use super::shared::Shared;
use pointcore_contract::splat::records::{FinishedPixel, Fragment};

/// A record that may close a frame.
pub trait Closing: Copy + Default {
    /// Whether it does.
    fn is_end(&self) -> bool;

    /// The one that does, and has nothing else.
    fn end() -> Self;
}

impl Closing for FinishedPixel {
    fn is_end(&self) -> bool {
        self.end
    }

    fn end() -> Self {
        Self { end: true, ..Self::default() }
    }
}

impl Closing for Fragment {
    fn is_end(&self) -> bool {
        self.end
    }

    fn end() -> Self {
        Self { end: true, ..Self::default() }
    }
}

/// A collector of such records.
#[derive(Clone, Debug)]
pub struct Collected<R> {
    pub shared: Shared<R>,
    /// Sides whose frame has ended, until that of both has left.
    ended: [bool; 2],
    /// The end of both was pushed.
    closing: bool,
}

impl<R> Default for Collected<R> {
    fn default() -> Self {
        Self { shared: Shared::default(), ended: [false; 2], closing: false }
    }
}

impl<R: Closing> Collected<R> {
    /// The frame of the side whose turn it is goes on.
    pub const fn goes_on(&self) -> bool {
        !self.ended[self.shared.turn]
    }

    /// One clock edge, with what the sides offer.
    pub fn step(&mut self, offers: [Option<R>; 2], ready: bool) {
        let has_closed = self.closing && self.shared.out.out().is_none();
        let closes = self.ended == [true; 2] && !self.closing && self.shared.out.in_ready();
        let taken = self.shared.take(self.goes_on(), offers);
        for (side, _) in taken.iter().filter(|(_, record)| record.is_end()) {
            self.ended[*side] = true;
        }
        let mut record = taken.map(|(_, record)| record).filter(|record| !record.is_end());
        self.closing = closes || (self.closing && !has_closed);
        if has_closed {
            self.ended = [false; 2];
        }
        if closes {
            record = Some(R::end());
        }
        self.shared.out.step(record, ready);
    }
}
