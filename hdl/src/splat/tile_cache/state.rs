//! The tile cache's registers.

use super::Depths;
use super::seeker::Seeker;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{SLOT_BANKS, SURFACE_BITS, TILE_PIXELS};
use pointcore_contract::splat::records::LOCAL_BITS;
use rtl::{Expr, Module, Reg, address_width};

/// Registers of the unit.
pub(super) struct State {
    pub depths: Depths,
    /// Memories are cleared after reset, word by word: those of the first surface, and then of the second.
    pub clearing: Reg,
    pub clearing_second: Reg,
    pub cleared: Reg,
    /// The surface that is drawn.
    pub surface: Reg,
    /// What memory holds of the tile that comes, and above that whether it holds a pixel.
    pub mask: Reg,
    /// The job of a slot that loses its tile, step by step: its next tile's mask is read, the slot is told, it shows what it held, and
    /// pixels move.
    pub looking: Reg,
    /// The inverse, for the mask.
    pub looks_not: Reg,
    /// The banks in which the slot is told.
    pub unchanged: Reg,
    pub changed: Reg,
    /// As `changed`, of a slot whose tile goes; and the inverse, for those who ask whether the masks' memory is written.
    pub keeps: Reg,
    pub keeps_none: Reg,
    pub moving: Reg,
    pub slot: Reg,
    /// A tile comes, and which.
    pub comes: Reg,
    pub tile: Reg,
    /// A tile goes, and which.
    pub goes: Reg,
    pub goes_tile: Reg,
    /// Pixels to be asked for, of which surface and tile, and whether they leave with their frame.
    pub wanted: Seeker,
    pub wanted_surface: Reg,
    pub wanted_tile: Reg,
    pub wanted_leaves: Reg,
    /// Runs that were asked for and have not come: for slots, and to leave.
    pub awaited_fills: Reg,
    pub awaited_leaving: Reg,
    /// How many pixels of the oldest have come.
    pub came: Reg,
    /// A pixel that came waits for its bank; and the inverse, for who takes the next.
    pub filling: Reg,
    pub fills_none: Reg,
    /// Banks that samples may write in this cycle.
    pub taken_banks: Reg,
    /// Pixels to be read from the slot, and how many were and are not written yet.
    pub leaving: Seeker,
    pub owed: Reg,
}

impl State {
    pub fn new(m: &mut Module, config: &Config, depths: Depths) -> Self {
        let tile_bits = config.tile_bits();
        Self {
            depths,
            clearing: m.reg_reset("clearing", 1, 1),
            clearing_second: m.reg_reset("clearing_second", 1, 1),
            cleared: m.reg_reset("cleared", SURFACE_BITS + config.place_bits(), 0),
            surface: m.reg_reset("surface", SURFACE_BITS, 0),
            mask: m.reg("mask", TILE_PIXELS + 1),
            looking: m.reg_reset("looking", 1, 0),
            looks_not: m.reg_reset("looks_not", 1, 1),
            unchanged: m.reg_reset("unchanged", SLOT_BANKS, 0),
            changed: m.reg_reset("changed", 1, 0),
            keeps: m.reg_reset("keeps", 1, 0),
            keeps_none: m.reg_reset("keeps_none", 1, 1),
            moving: m.reg_reset("moving", 1, 0),
            slot: m.reg("slot", config.slot_bits()),
            comes: m.reg("comes", 1),
            tile: m.reg("tile", tile_bits),
            goes: m.reg("goes", 1),
            goes_tile: m.reg("goes_tile", tile_bits),
            wanted: Seeker::new(m, "wanted"),
            wanted_surface: m.reg("wanted_surface", SURFACE_BITS),
            wanted_tile: m.reg("wanted_tile", tile_bits),
            wanted_leaves: m.reg_reset("wanted_leaves", 1, 0),
            awaited_fills: m.reg_reset("awaited_fills", address_width(depths.asked + 1), 0),
            awaited_leaving: m.reg_reset("awaited_leaving", address_width(depths.asked + 1), 0),
            came: m.reg_reset("came", LOCAL_BITS, 0),
            filling: m.reg_reset("filling", 1, 0),
            fills_none: m.reg_reset("fills_none", 1, 1),
            taken_banks: m.reg_reset("taken_banks", SLOT_BANKS, 0),
            leaving: Seeker::new(m, "leaving"),
            owed: m.reg_reset("owed", address_width(depths.written + 1), 0),
        }
    }

    /// No slot changes its tile.
    pub fn no_job(&self) -> Expr {
        !((self.looking | self.unchanged.any()) | (self.changed | self.moving))
    }

    /// The slot of the job waits for nothing that comes.
    pub fn all_came(&self) -> Expr {
        (self.wanted_leaves | self.wanted.is_empty()) & self.awaited_fills.is_zero()
    }

    /// Nothing that leaves is on its way from memory.
    pub fn all_left(&self) -> Expr {
        !(self.wanted_leaves & !self.wanted.is_empty()) & self.awaited_leaving.is_zero()
    }

    /// The tile that the job takes out of its slot.
    pub fn tile_that_goes(&self) -> (Expr, Expr) {
        (self.goes & !self.no_job(), *self.goes_tile)
    }
}

/// Whether a pixel's bank is one of these.
pub(super) fn is_in(banks: Expr, pixel: Expr) -> Expr {
    banks.shr_by(pixel.trunc(SLOT_BANKS.ilog2())).bit(0)
}
