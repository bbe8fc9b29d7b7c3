//! Pixels on their way between slots, reconstruction buffer and output.

use super::bank;
use super::seeker::{Run, Seeker};
use crate::stream::{Fifo, Skid};
use pointcore_contract::splat::config::{RUNS_ASKED_MAX, TILE_SIZE, WRITE_QUEUE_DEPTH};
use pointcore_contract::splat::records::{DrainedPixel, Fill, Pixel, PixelRun, PlacedPixel, SlotPixel, StoredPixel};
use pointcore_contract::splat::units::tile_cache::In;

/// A run that was asked for.
#[derive(Clone, Copy, Debug)]
struct Asked {
    run: PixelRun,
    /// It leaves with its frame.
    leaves: bool,
}

/// Runs that were asked for and have not come.
#[derive(Clone, Copy, Debug, Default)]
struct Awaited {
    fills: u32,
    leaving: u32,
}

/// Where pixels may go in this cycle.
#[derive(Clone, Copy, Debug)]
pub struct Aim {
    /// Out of this slot and into it.
    pub slot: Option<u8>,
    /// To the output.
    pub has_room: bool,
}

/// The pixels under way.
#[derive(Clone, Debug)]
pub struct Traffic {
    /// Pixels to be asked for, their surface and tile, and whether they leave with their frame.
    wanted: Seeker,
    wanted_surface: bool,
    wanted_tile: u32,
    wanted_leaves: bool,
    /// Runs that were asked for, the oldest first, and how many pixels of that one have come.
    asked: Fifo<Asked>,
    came: u8,
    awaited: Awaited,
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
    pub write: Fifo<StoredPixel>,
}

impl Traffic {
    /// None.
    pub fn new() -> Self {
        Self {
            wanted: Seeker::default(),
            wanted_surface: false,
            wanted_tile: 0,
            wanted_leaves: false,
            asked: Fifo::new(RUNS_ASKED_MAX as usize),
            came: 0,
            awaited: Awaited::default(),
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

    /// Whether all pixels that leave have come.
    pub const fn all_left(&self) -> bool {
        (!self.wanted_leaves || self.wanted.is_empty()) && self.awaited.leaving == 0
    }

    /// Whether nothing is under way between slot and memory.
    pub const fn is_over(&self) -> bool {
        let all_came = (self.wanted_leaves || self.wanted.is_empty()) && self.awaited.fills == 0;
        all_came && self.fill.is_none() && self.leaving.is_empty() && self.owed == 0
    }

    /// Asks for pixels of a tile from now on.
    pub const fn want(&mut self, surface: bool, tile: u32, pixels: u64, leaves: bool) {
        self.wanted.begin(pixels);
        (self.wanted_surface, self.wanted_tile, self.wanted_leaves) = (surface, tile, leaves);
    }

    /// Reads pixels from the slot from now on.
    pub const fn let_leave(&mut self, pixels: u64) {
        self.leaving.begin(pixels);
    }

    /// Whether a fill that is shown is carried out.
    fn fills(&self) -> bool {
        self.fill.is_some_and(|fill| self.sample_writes & bank(fill.place.pixel) == 0)
    }

    /// The place of the pixel that comes from memory next, and whether it leaves.
    fn coming(&self) -> Option<(PlacedPixel, bool)> {
        let Asked { run, leaves } = self.asked.out()?;
        Some((PlacedPixel { tile: run.tile, pixel: run.pixel + self.came, value: Pixel::default() }, *leaves))
    }

    /// Whether a pixel is taken from memory.
    pub fn data_ready(&self, aim: Aim) -> bool {
        self.coming().is_some_and(|(coming, leaves)| {
            if leaves {
                return aim.has_room;
            }
            // Its place must have been read before.
            let row = coming.pixel / TILE_SIZE as u8;
            let is_vacated = self.leaving.is_empty() || self.leaving.row().is_some_and(|leaving| row < leaving);
            aim.slot.is_some() && is_vacated && (self.fill.is_none() || self.fills())
        })
    }

    /// The pixel of a slot that is to be read.
    pub fn drain(&self, aim: Aim) -> Option<SlotPixel> {
        let (slot, pixel) = (aim.slot?, self.leaving.pixel()?);
        (self.owed < WRITE_QUEUE_DEPTH).then_some(SlotPixel { slot, pixel })
    }

    /// One clock edge; what is drained is of the tile that `goes`, and of the surface that is drawn. Returns the pixel that came and
    /// leaves.
    pub fn clock(&mut self, aim: Aim, goes: Option<(bool, u32)>, inputs: &In) -> Option<PlacedPixel> {
        let data = inputs.data.filter(|_| self.data_ready(aim));
        let coming =
            data.and_then(|value| self.coming().map(|(place, leaves)| (PlacedPixel { value, ..place }, leaves)));
        let ends_run = coming.is_some() && self.asked.out().is_some_and(|asked| self.came + 1 == asked.run.count);
        let asks = self.wanted.run().filter(|_| self.read.in_ready() && self.asked.in_ready());
        let (surface, tile) = (self.wanted_surface, self.wanted_tile);
        let asks = asks.map(|Run { pixel, count }| PixelRun { surface, tile, pixel, count });
        let drains = self.drain(aim).is_some_and(|drain| inputs.sample_reads & bank(drain.pixel) == 0);
        let writes = self.write.out().is_some() && inputs.write_ready;
        let placed = |DrainedPixel { pixel, value }| {
            goes.map(|(surface, tile)| StoredPixel { surface, placed: PlacedPixel { tile, pixel, value } })
        };
        let drained = inputs.drained.and_then(placed);

        if self.fills() {
            self.fill = None;
        }
        if let (Some(slot), Some((PlacedPixel { pixel, value, .. }, false))) = (aim.slot, coming) {
            self.fill = Some(Fill { place: SlotPixel { slot, pixel }, value });
        }
        if coming.is_some() {
            self.came = if ends_run { 0 } else { self.came + 1 };
        }
        self.wanted.clock(asks.map_or(0, |run| run.count));
        self.leaving.clock(u8::from(drains));
        let [asks_leaving, ends_leaving] =
            [asks.is_some() && self.wanted_leaves, coming.is_some_and(|(_, leaves)| leaves && ends_run)];
        self.awaited.fills += u32::from(asks.is_some() && !asks_leaving);
        self.awaited.fills -= u32::from(ends_run && !ends_leaving);
        self.awaited.leaving += u32::from(asks_leaving);
        self.awaited.leaving -= u32::from(ends_leaving);
        self.owed = self.owed + u32::from(drains) - u32::from(writes);
        self.sample_writes = inputs.sample_writes;
        self.asked.step(asks.map(|run| Asked { run, leaves: self.wanted_leaves }), ends_run);
        self.read.step(asks, inputs.read_ready);
        self.write.step(drained, inputs.write_ready);
        coming.and_then(|(placed, leaves)| leaves.then_some(placed))
    }
}
