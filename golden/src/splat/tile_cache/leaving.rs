//! The frame that leaves: its tiles one by one, as soon as no copy of them is to come.

use super::pending::SurfacePlace;
use super::{In, TileCache};
use crate::splat::parts::share::Share;
use crate::stream::Fifo;
use pointcore_contract::splat::config::GONE_TILES;
use pointcore_contract::splat::records::FinishedPixel;

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
    /// The place that is looked at next, among all of the image; none is left where all were.
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

    /// The mask of the tile that is looked at is known.
    pub const fn is_seen(&self) -> bool {
        matches!(self.looked_at, Some((_, Look::Seen { .. })))
    }

    /// The tile that is looked at may leave, as soon as its pixels may be asked for.
    pub const fn may_send(&self) -> bool {
        matches!(self.looked_at, Some((_, Look::Seen { may_leave: true, .. })))
    }

    /// The next tile is looked at: one that was written back meanwhile, or the next of all. Returns whether it is one of those.
    pub fn look(&mut self, share: Share) -> bool {
        let gone = self.gone.out().copied();
        let place = gone.or_else(|| {
            let next = self.next?;
            self.next = share.following(next);
            Some(next)
        });
        self.looked_at = place.map(|place| (place, Look::Read));
        gone.is_some()
    }
}

/// What the frame that leaves sees of a cycle, as the registers were before it.
pub(super) struct Seen {
    /// Memories of masks and of copies are read for others.
    pub reads_taken: bool,
    /// The pixels of the tile that is looked at are asked for.
    pub sends: bool,
    /// All that were asked for have come.
    pub all_left: bool,
    /// The tile that is looked at is in a slot, or on its way.
    pub is_held: bool,
    /// The surface that is drawn.
    pub drawn: bool,
    /// All of the frame that leaves is.
    pub is_given: bool,
    /// The last copy for it has come.
    pub is_whole: bool,
}

impl TileCache {
    /// A cycle of the frame that leaves. Returns whether the next tile comes out of `gone`, and the pixel that closes the frame.
    pub(super) fn leave(&mut self, seen: &Seen, inputs: &In) -> (bool, Option<FinishedPixel>) {
        let places = self.places();
        let waited = self.leaving.waits;
        self.leaving.waits &= !inputs.frame_sent;
        let Some(surface) = self.leaving.surface else {
            if seen.is_whole && !waited {
                self.leaving.begin(seen.drawn);
            }
            return (false, None);
        };
        let (mut pops, mut close) = (false, None);
        match self.leaving.looked_at {
            None if seen.is_given && self.leaving.is_over() && seen.all_left && self.pixel.in_ready() => {
                self.leaving.close(!self.is_alone);
                close = Some(FinishedPixel { end: true, ..FinishedPixel::default() });
            }
            None => pops = self.leaving.look(self.share),
            Some((place, Look::Read)) => {
                if !seen.reads_taken {
                    let at = SurfacePlace { surface, place };
                    let mask = self.stored[at.word(places)];
                    self.leaving.looked_at = Some((place, Look::Shown { mask, is_pending: self.pending.has(at) }));
                }
            }
            Some((place, Look::Shown { mask, is_pending })) => {
                let stays = is_pending || (seen.is_held && surface == seen.drawn);
                self.leaving.looked_at = Some((place, Look::Seen { mask, may_leave: mask != 0 && !stays }));
            }
            Some((place, Look::Seen { mask, may_leave })) => {
                if seen.sends {
                    let tile = self.share.tile(inputs.number.into(), place);
                    self.traffic.want(surface, tile, mask, true);
                    self.stored[SurfacePlace { surface, place }.word(places)] = 0;
                    pops = self.leaving.look(self.share);
                } else if !may_leave {
                    pops = self.leaving.look(self.share);
                }
            }
        }
        (pops, close)
    }
}
