//! Payloads: what the copies of a splat have in common is kept in one place while they are put in order.
//!
//! Copies leave it behind before the reorder stage and get it back behind the tile cache, in any order, a word a cycle.

mod places;
#[cfg(test)]
mod tests;

use crate::stream::Skid;
use crate::unit::Model;
use places::{Closed, Places};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Attributes, CompleteCopy, Footprint, PlacedCopy, SplatCopy, TileCopy};
pub use pointcore_contract::splat::units::payloads::{In, Out};

/// The copy that arrived last.
#[derive(Clone, Copy, Debug)]
struct Arrived {
    copy: TileCopy,
    /// Words of its payload that are written.
    written: u32,
}

/// The unit.
#[derive(Clone, Debug)]
pub struct Payloads {
    /// Words of a payload.
    beats: u32,
    places: Places,
    payloads: Vec<(Footprint, Attributes)>,
    /// Where the splat lies that began last.
    place: u16,
    /// That splat, while its copies are coming.
    open: Option<Closed>,
    /// The copy at the input needs no place.
    passes: bool,
    arrived: Option<Arrived>,
    next: Skid<PlacedCopy>,
    /// The copy whose payload is read.
    current: Option<PlacedCopy>,
    /// Its word that the memory shows.
    beat: u32,
    out: Option<CompleteCopy>,
}

impl Payloads {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            beats: config.payload_beats,
            places: Places::new(config),
            payloads: vec![Default::default(); config.splats_held() as usize],
            place: 0,
            open: None,
            passes: false,
            arrived: None,
            next: Skid::default(),
            current: None,
            beat: 0,
            out: None,
        }
    }

    fn in_ready(&self) -> bool {
        self.arrived.is_none() && self.places.may_close() && (self.places.free().is_some() || self.passes)
    }

    /// What is taken becomes the copy at hand; returns whether it took the free place.
    fn take(&mut self, input: SplatCopy) -> bool {
        let SplatCopy { end, first, footprint, attributes, bounds, diagonals, tile } = input;
        let begins = first && !end;
        if begins {
            self.place = self.places.free().expect("a first copy is not taken without a place");
            self.payloads[usize::from(self.place)] = (footprint, attributes);
            self.open = Some(Closed { place: self.place, copies: 1 });
        } else if let Some(open) = &mut self.open {
            open.copies += 1;
        }
        let copy = if end {
            TileCopy { end, ..TileCopy::default() }
        } else {
            TileCopy { end, bounds, diagonals, tile, splat: self.place }
        };
        self.arrived = Some(Arrived { copy, written: if begins { 1 } else { self.beats } });
        begins
    }

    /// The way in: returns the splat that is closed, and whether another took the free place.
    fn arrive(&mut self, inputs: &In) -> (Option<Closed>, bool) {
        let taken = inputs.input.filter(|_| self.in_ready());
        let begins_or_ends = inputs.input.is_some_and(|copy| copy.first || copy.end);
        self.passes = taken.is_none() && inputs.input.is_some_and(|copy| !copy.first || copy.end);
        let closed = if begins_or_ends && self.places.may_close() { self.open.take() } else { None };

        let shown = self.shown().is_some();
        if let Some(arrived) = &mut self.arrived {
            arrived.written = self.beats.min(arrived.written + 1);
            if shown && inputs.copy_ready {
                self.arrived = None;
            }
        }
        (closed, taken.is_some_and(|copy| self.take(copy)))
    }

    fn shown(&self) -> Option<TileCopy> {
        self.arrived.filter(|arrived| arrived.written + 1 >= self.beats).map(|arrived| arrived.copy)
    }

    /// The way out: returns the place that a copy has been read from.
    fn leave(&mut self, inputs: &In) -> Option<u16> {
        let is_read = self.beat + 1 == self.beats;
        let has_room = self.out.is_none() || inputs.out_ready;
        let read = self.current.filter(|_| is_read && has_room);
        if has_room {
            self.out = read.map(|read| self.complete(&read));
        }
        let advances = self.current.is_none() || read.is_some();
        if advances {
            self.current = self.next.out().copied();
            self.beat = 0;
        } else if !is_read {
            self.beat += 1;
        }
        self.next.step(inputs.placed, advances);
        read.map(|read| read.splat)
    }

    fn complete(&self, placed: &PlacedCopy) -> CompleteCopy {
        let PlacedCopy { bounds, diagonals, tile, splat, slot } = *placed;
        let (footprint, attributes) = self.payloads[usize::from(splat)];
        CompleteCopy { footprint, attributes, bounds, diagonals, tile, slot }
    }
}

impl Model for Payloads {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.in_ready(), copy: self.shown(), placed_ready: self.next.in_ready(), out: self.out }
    }

    fn clock(&mut self, inputs: &In) {
        let left = self.leave(inputs);
        let (closed, begun) = self.arrive(inputs);
        self.places.step(closed, begun, left);
    }
}
