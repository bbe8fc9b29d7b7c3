//! Payloads: what the copies of a splat have in common is kept in one place while they are put in order.
//!
//! Copies leave it behind before the reorder stage and get it back behind the tile cache, in any order, a word a cycle.

mod chip;
mod memory;
mod places;
#[cfg(test)]
mod tests;
mod words;

use crate::stream::Skid;
use crate::unit::Model;
use chip::Chip;
use memory::Memory;
use places::{Closed, Places};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{CompleteCopy, Payload, PlacedCopy, SplatCopy, TileCopy};
pub use pointcore_contract::splat::units::payloads::{In, Out};

/// A copy that comes in, and the payload of the splat that it begins.
#[derive(Clone, Copy, Debug)]
struct Arriving {
    copy: TileCopy,
    payload: Option<Payload>,
}

/// Where payloads are kept.
#[derive(Clone, Debug)]
enum Store {
    Chip(Chip),
    Memory(Box<Memory>),
}

/// The unit.
#[derive(Clone, Debug)]
pub struct Payloads {
    /// Words of a payload.
    beats: u32,
    places: Places,
    store: Store,
    /// Where the splat lies that began last.
    place: u16,
    /// That splat, while its copies are coming.
    open: Option<Closed>,
    /// The copy at the input needs no place.
    passes: bool,
    next: Skid<PlacedCopy>,
    /// The copy whose payload is read.
    current: Option<PlacedCopy>,
    /// Its word that the memory on the chip shows.
    beat: u32,
    /// One that is complete and waits for `out`, where words come in several beats.
    complete: Option<CompleteCopy>,
    out: Option<CompleteCopy>,
}

impl Payloads {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let store = if config.has_payloads_in_memory() {
            Store::Memory(Box::new(Memory::new(config)))
        } else {
            Store::Chip(Chip::new(config))
        };
        Self {
            beats: config.payload_beats,
            places: Places::new(config),
            store,
            place: 0,
            open: None,
            passes: false,
            next: Skid::default(),
            current: None,
            beat: 0,
            complete: None,
            out: None,
        }
    }

    fn in_ready(&self) -> bool {
        let (has_room, has_payload_room) = match &self.store {
            Store::Chip(chip) => (chip.has_room(), true),
            Store::Memory(memory) => (memory.has_room(), memory.has_payload_room()),
        };
        let may_begin = has_payload_room && self.places.free().is_some();
        has_room && self.places.may_close() && (may_begin || self.passes)
    }

    /// What is taken, with its place.
    fn take(&mut self, input: SplatCopy) -> Arriving {
        let SplatCopy { end, first, footprint, moving, attributes, bounds, diagonals, tile } = input;
        let begins = first && !end;
        if begins {
            self.place = self.places.free().expect("a first copy is not taken without a place");
            self.open = Some(Closed { place: self.place, copies: 1 });
        } else if let Some(open) = &mut self.open {
            open.copies += 1;
        }
        let copy = if end {
            TileCopy { end, ..TileCopy::default() }
        } else {
            TileCopy { end, bounds, diagonals, tile, splat: self.place }
        };
        Arriving { copy, payload: begins.then_some(Payload { footprint, moving, attributes }) }
    }

    /// The way in: returns the splat that is closed, and whether another took the free place.
    fn arrive(&mut self, inputs: &In) -> (Option<Closed>, bool) {
        let taken = inputs.input.filter(|_| self.in_ready());
        let begins_or_ends = inputs.input.is_some_and(|copy| copy.first || copy.end);
        self.passes = taken.is_none() && inputs.input.is_some_and(|copy| !copy.first || copy.end);
        let closed = if begins_or_ends && self.places.may_close() { self.open.take() } else { None };
        let arriving = taken.map(|copy| self.take(copy));
        match &mut self.store {
            Store::Chip(chip) => chip.step(arriving, inputs.copy_ready),
            Store::Memory(memory) => memory.arrive(arriving, inputs.copy_ready, inputs.write_ready),
        }
        (closed, arriving.is_some_and(|arriving| arriving.payload.is_some()))
    }

    fn shown(&self) -> Option<TileCopy> {
        match &self.store {
            Store::Chip(chip) => chip.shown(),
            Store::Memory(memory) => memory.shown(),
        }
    }

    /// The payload of the current copy, if all of it has been read.
    fn payload(&self, current: &PlacedCopy) -> Option<Payload> {
        match &self.store {
            Store::Chip(chip) => (self.beat + 1 == self.beats).then(|| chip.payload(current.splat)),
            Store::Memory(memory) => memory.payload(),
        }
    }

    /// The way out: returns the place that a copy has been read from.
    fn leave(&mut self, inputs: &In) -> Option<u16> {
        let takes = self.out.is_none() || inputs.out_ready;
        let completes = self.beats > 1;
        let has_room = if completes { self.complete.is_none() } else { takes };
        let read = self.current.filter(|_| has_room).and_then(|current| Some((current, self.payload(&current)?)));
        let copy = read.map(|(current, payload)| complete(current, payload));
        if takes {
            self.out = if completes { self.complete.take() } else { copy };
        }
        if completes && has_room {
            self.complete = copy;
        }
        if let Store::Memory(memory) = &mut self.store {
            memory.leave(self.current.is_some(), has_room, inputs.data);
        }
        let advances = self.current.is_none() || read.is_some();
        if advances {
            self.current = self.next.out().copied();
            self.beat = 0;
        } else if self.beat + 1 < self.beats {
            self.beat += 1;
        }
        self.next.step(inputs.placed, advances);
        read.map(|(read, _)| read.splat)
    }
}

fn complete(placed: PlacedCopy, payload: Payload) -> CompleteCopy {
    let PlacedCopy { bounds, diagonals, tile, splat: _, slot } = placed;
    let Payload { footprint, moving, attributes } = payload;
    CompleteCopy { footprint, moving, attributes, bounds, diagonals, tile, slot }
}

impl Model for Payloads {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let mut out = Out {
            in_ready: self.in_ready(),
            copy: self.shown(),
            placed_ready: self.next.in_ready(),
            out: self.out,
            ..Out::default()
        };
        if let Store::Memory(memory) = &self.store {
            (out.write, out.data_ready, out.read) = (memory.write(), memory.data_ready(), memory.read);
        }
        out
    }

    fn clock(&mut self, inputs: &In) {
        let left = self.leave(inputs);
        let (closed, begun) = self.arrive(inputs);
        self.places.step(closed, begun, left);
    }
}
