//! The tile cache's modes and registers.

use super::Depths;
use super::seeker::Seeker;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{SLOT_BANKS, TILE_PIXELS};
use pointcore_contract::splat::records::LOCAL_BITS;
use rtl::{Expr, Module, Reg, address_width};

/// What the unit is about.
#[derive(Clone, Copy)]
pub(super) enum Mode {
    /// Clears the memory of masks after reset.
    Clear,
    /// Places copies.
    Run,
    /// Waits until the frame's last samples are accumulated, and writes slots back.
    Wait,
    /// Sends the frame.
    Flush,
}

/// Registers of the unit.
pub(super) struct State {
    pub depths: Depths,
    pub mode: Reg,
    pub frame_ended: Reg,
    /// The place of the tile that is cleared, or whose mask is read to send the frame while `walking`: among those of the rasterizer.
    pub place: Reg,
    pub walking: Reg,
    /// The place whose mask the memory shows.
    pub read: Reg,
    pub read_place: Reg,
    /// The place whose mask is in `mask`.
    pub seen: Reg,
    pub seen_place: Reg,
    pub mask: Reg,
    /// The job of a slot that loses its tile, step by step: its next tile's mask is read, the slot is told, it shows what it held, and
    /// pixels move.
    pub looking: Reg,
    /// The banks in which the slot is told.
    pub unchanged: Reg,
    pub changed: Reg,
    pub moving: Reg,
    pub slot: Reg,
    /// A tile comes, and which.
    pub comes: Reg,
    pub tile: Reg,
    /// A tile goes, and which.
    pub goes: Reg,
    pub goes_tile: Reg,
    /// Pixels to be asked for, and of which tile.
    pub wanted: Seeker,
    pub wanted_tile: Reg,
    /// Runs that were asked for and have not come, and how many pixels of the oldest have.
    pub awaited: Reg,
    pub came: Reg,
    /// A pixel that came waits for its bank.
    pub filling: Reg,
    /// Banks that samples may write in this cycle.
    pub taken_banks: Reg,
    /// Pixels to be read from the slot, and how many were and are not written yet.
    pub leaving: Seeker,
    pub owed: Reg,
}

impl State {
    pub fn new(m: &mut Module, config: &Config, depths: Depths) -> Self {
        let (tile_bits, place_bits) = (config.tile_bits(), config.place_bits());
        Self {
            depths,
            mode: m.reg_reset("mode", address_width(Mode::Flush as u32 + 1), Mode::Clear as u128),
            frame_ended: m.reg_reset("frame_ended", 1, 0),
            place: m.reg_reset("place", place_bits, 0),
            walking: m.reg_reset("walking", 1, 0),
            read: m.reg_reset("place_read", 1, 0),
            read_place: m.reg("read_place", place_bits),
            seen: m.reg_reset("place_seen", 1, 0),
            seen_place: m.reg("seen_place", place_bits),
            mask: m.reg("mask", TILE_PIXELS),
            looking: m.reg_reset("looking", 1, 0),
            unchanged: m.reg_reset("unchanged", SLOT_BANKS, 0),
            changed: m.reg_reset("changed", 1, 0),
            moving: m.reg_reset("moving", 1, 0),
            slot: m.reg("slot", config.slot_bits()),
            comes: m.reg("comes", 1),
            tile: m.reg("tile", tile_bits),
            goes: m.reg("goes", 1),
            goes_tile: m.reg("goes_tile", tile_bits),
            wanted: Seeker::new(m, "wanted"),
            wanted_tile: m.reg("wanted_tile", tile_bits),
            awaited: m.reg_reset("awaited", address_width(depths.asked + 1), 0),
            came: m.reg_reset("came", LOCAL_BITS, 0),
            filling: m.reg_reset("filling", 1, 0),
            taken_banks: m.reg_reset("taken_banks", SLOT_BANKS, 0),
            leaving: Seeker::new(m, "leaving"),
            owed: m.reg_reset("owed", address_width(depths.written + 1), 0),
        }
    }

    pub fn is(&self, mode: Mode) -> Expr {
        self.mode.eq_lit(mode as u128)
    }

    /// No slot changes its tile.
    pub fn no_job(&self) -> Expr {
        !((self.looking | self.unchanged.any()) | (self.changed | self.moving))
    }

    /// All runs that were wanted were asked for and have come.
    pub fn all_came(&self) -> Expr {
        self.wanted.is_empty & self.awaited.is_zero()
    }
}

/// Whether a pixel's bank is one of these.
pub(super) fn is_in(banks: Expr, pixel: Expr) -> Expr {
    banks.shr_by(pixel.trunc(SLOT_BANKS.ilog2())).bit(0)
}
