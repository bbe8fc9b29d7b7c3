//! Which tiles still get copies: of each the copy that came last is known until it has reached the head.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::SURFACES;
use pointcore_contract::splat::records::{ArrivedCopy, TileCopy};

use super::super::parts::share::Share;

/// A tile of a frame that is under way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SurfacePlace {
    /// The parity of the frame's number.
    pub surface: bool,
    /// The tile's place among those of its rasterizer.
    pub place: u32,
}

impl SurfacePlace {
    /// Its word in memories that have one for each.
    pub fn word(self, places: usize) -> usize {
        usize::from(self.surface) * places + self.place as usize
    }
}

/// The copy at the head, of which it is found out whether it is the last of its tile.
#[derive(Clone, Copy, Debug)]
struct LookedUp {
    at: SurfacePlace,
    splat: u16,
    last: Option<u16>,
}

/// Tiles with copies that have come and have not reached the head.
#[derive(Clone, Debug)]
pub struct Pending {
    share: Share,
    places: usize,
    /// By surface and place: the splat of the copy that came last.
    lasts: Vec<Option<u16>>,
    /// The copy that came in the cycle before, and its surface.
    arrived: Option<ArrivedCopy>,
    surface: bool,
    /// Frames that have come whole and are still drawn.
    pub whole: u32,
    looked_up: Option<LookedUp>,
    /// The one that was looked up in the cycle before.
    compared: Option<LookedUp>,
    /// A tile whose last copy has reached the head.
    clears: Option<SurfacePlace>,
}

impl Pending {
    /// None.
    pub fn new(config: &Config) -> Self {
        let places = 1 << config.place_bits();
        Self {
            share: Share::new(config),
            places,
            lasts: vec![None; SURFACES as usize * places],
            arrived: None,
            surface: false,
            whole: 0,
            looked_up: None,
            compared: None,
            clears: None,
        }
    }

    /// Nothing is known of a word after reset.
    pub fn clear(&mut self, word: usize) {
        self.lasts[word] = None;
    }

    /// Whether a word may be written in this cycle.
    pub const fn writes(&self) -> bool {
        self.arrived.is_some() || self.clears.is_some()
    }

    /// Whether the next copy is one for the second surface; while that is cleared none has come.
    pub fn turns_to_second(&self) -> bool {
        self.surface || self.arrived.is_some_and(|copy| copy.end)
    }

    /// Whether copies of a tile are still to come.
    pub fn has(&self, at: SurfacePlace) -> bool {
        self.lasts[at.word(self.places)].is_some()
    }

    /// One clock edge: a copy arrives, one of the frame on `surface` becomes the head, and of one the last copy is drawn.
    pub fn clock(&mut self, arrives: Option<ArrivedCopy>, head: Option<TileCopy>, surface: bool, switches: bool) {
        let arrived = self.arrived.take();
        let is_end = arrived.is_some_and(|copy| copy.end);
        let enters = arrived.filter(|copy| !copy.end).map(|ArrivedCopy { tile, splat, .. }| {
            (SurfacePlace { surface: self.surface, place: self.share.place(tile) }, splat)
        });
        let overtakes = |at: SurfacePlace| enters.is_some_and(|(place, _)| place == at);

        // A copy that came meanwhile is a later one.
        let reached = self.compared.take().filter(|head| head.last == Some(head.splat) && !overtakes(head.at));
        self.compared = self.looked_up.take().filter(|head| !overtakes(head.at));
        self.looked_up = head.filter(|head| !head.end).map(|TileCopy { tile, splat, .. }| {
            let at = SurfacePlace { surface, place: self.share.place(tile) };
            let last = self.lasts[at.word(self.places)].filter(|_| !overtakes(at));
            LookedUp { at, splat, last }
        });
        match (enters, self.clears) {
            (Some((at, splat)), clears) => {
                self.lasts[at.word(self.places)] = Some(splat);
                self.clears = clears.filter(|clears| *clears != at);
            }
            (None, Some(at)) => {
                self.lasts[at.word(self.places)] = None;
                self.clears = None;
            }
            (None, None) => {}
        }
        self.clears = reached.map(|head| head.at).or(self.clears);

        self.surface ^= is_end;
        self.whole = self.whole + u32::from(is_end) - u32::from(switches);
        self.arrived = arrives;
    }
}
