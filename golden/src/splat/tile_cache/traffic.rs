//! Pixels on their way between slots, reconstruction buffer and output.

use super::bank;
use super::seeker::{Run, Seeker};
use crate::stream::{Fifo, Skid};
use pointcore_contract::splat::config::{RUNS_ASKED_MAX, TILE_SIZE, WRITE_QUEUE_DEPTH};
use pointcore_contract::splat::records::{DrainedPixel, Fill, Pixel, PixelRun, PlacedPixel, SlotPixel};
use pointcore_contract::splat::units::tile_cache::In;

/// Where pixels go.
#[derive(Clone, Copy, Debug)]
pub enum Aim {
    /// Nowhere.
    Nowhere,
    /// Out of a slot and into it.
    Slot(u8),
    /// To the output, if it has room.
    Output { has_room: bool },
}

/// The pixels under way.
#[derive(Clone, Debug)]
pub struct Traffic {
    /// Pixels to be asked for, and their tile.
    wanted: Seeker,
    wanted_tile: u32,
    /// Runs that were asked for, the oldest first, and how many pixels of that one have come.
    asked: Fifo<PixelRun>,
    came: u8,
    /// How many these runs are.
    awaited: u32,
    /// The pixel that is shown to a slot.
    pub fill: Option<Fill>,
    /// [`In::sample_writes`] of the cycle before.
    sample_writes: u32,
    /// Pixels to be read from the slot.
    leaving: Seeker,
    /// Pixels read from it that have not been written.
    owed: u32,
    /// Requests.
    pub read: Skid<PixelRun>,
    /// Pixels that go to memory.
    pub write: Fifo<PlacedPixel>,
}

impl Traffic {
    /// None.
    pub fn new() -> Self {
        Self {
            wanted: Seeker::default(),
            wanted_tile: 0,
            asked: Fifo::new(RUNS_ASKED_MAX as usize),
            came: 0,
            awaited: 0,
            fill: None,
            sample_writes: 0,
            leaving: Seeker::default(),
            owed: 0,
            read: Skid::default(),
            write: Fifo::new(WRITE_QUEUE_DEPTH as usize),
        }
    }

    /// Whether another tile's pixels may be asked for.
    pub const fn may_want(&self) -> bool {
        self.wanted.is_empty()
    }

    /// Whether all pixels that were wanted have come.
    pub const fn all_came(&self) -> bool {
        self.wanted.is_empty() && self.awaited == 0
    }

    /// Whether nothing is under way.
    pub const fn is_over(&self) -> bool {
        self.all_came() && self.fill.is_none() && self.leaving.is_empty() && self.owed == 0
    }

    /// Asks for pixels of a tile from now on.
    pub const fn want(&mut self, tile: u32, pixels: u64) {
        self.wanted.begin(pixels);
        self.wanted_tile = tile;
    }

    /// Reads pixels from the slot from now on.
    pub const fn let_leave(&mut self, pixels: u64) {
        self.leaving.begin(pixels);
    }

    /// Whether a fill that is shown is carried out.
    fn fills(&self) -> bool {
        self.fill.is_some_and(|fill| self.sample_writes & bank(fill.place.pixel) == 0)
    }

    /// The place of the pixel that comes from memory next.
    fn coming(&self) -> Option<PlacedPixel> {
        let run = self.asked.out()?;
        Some(PlacedPixel { tile: run.tile, pixel: run.pixel + self.came, value: Pixel::default() })
    }

    /// Whether a pixel is taken from memory.
    pub fn data_ready(&self, aim: Aim) -> bool {
        self.coming().is_some_and(|coming| match aim {
            Aim::Nowhere => false,
            Aim::Slot(_) => {
                // Its place must have been read before.
                let row = coming.pixel / TILE_SIZE as u8;
                let is_vacated = self.leaving.is_empty() || self.leaving.row().is_some_and(|leaving| row < leaving);
                is_vacated && (self.fill.is_none() || self.fills())
            }
            Aim::Output { has_room } => has_room,
        })
    }

    /// The pixel of a slot that is to be read.
    pub fn drain(&self, aim: Aim) -> Option<SlotPixel> {
        match (aim, self.leaving.pixel()) {
            (Aim::Slot(slot), Some(pixel)) if self.owed < WRITE_QUEUE_DEPTH => Some(SlotPixel { slot, pixel }),
            _ => None,
        }
    }

    /// One clock edge; what is drained is of the tile that `goes`. Returns the pixel that came to the output.
    pub fn clock(&mut self, aim: Aim, goes: Option<u32>, inputs: &In) -> Option<PlacedPixel> {
        let data = inputs.data.filter(|_| self.data_ready(aim));
        let coming = data.and_then(|value| self.coming().map(|place| PlacedPixel { value, ..place }));
        let ends_run = coming.is_some() && self.asked.out().is_some_and(|run| self.came + 1 == run.count);
        let asks = self.wanted.run().filter(|_| self.read.in_ready() && self.asked.in_ready());
        let asks = asks.map(|Run { pixel, count }| PixelRun { tile: self.wanted_tile, pixel, count });
        let drains = self.drain(aim).is_some_and(|drain| inputs.sample_reads & bank(drain.pixel) == 0);
        let writes = self.write.out().is_some() && inputs.write_ready;
        let placed = |DrainedPixel { pixel, value }| goes.map(|tile| PlacedPixel { tile, pixel, value });
        let drained = inputs.drained.and_then(placed);

        if self.fills() {
            self.fill = None;
        }
        if let (Aim::Slot(slot), Some(PlacedPixel { pixel, value, .. })) = (aim, coming) {
            self.fill = Some(Fill { place: SlotPixel { slot, pixel }, value });
        }
        if coming.is_some() {
            self.came = if ends_run { 0 } else { self.came + 1 };
        }
        self.wanted.clock(asks.map_or(0, |run| run.count));
        self.leaving.clock(u8::from(drains));
        self.awaited = self.awaited + u32::from(asks.is_some()) - u32::from(ends_run);
        self.owed = self.owed + u32::from(drains) - u32::from(writes);
        self.sample_writes = inputs.sample_writes;
        self.asked.step(asks, ends_run);
        self.read.step(asks, inputs.read_ready);
        self.write.step(drained, inputs.write_ready);
        coming.filter(|_| matches!(aim, Aim::Output { .. }))
    }
}
