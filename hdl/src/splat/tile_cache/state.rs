//! The tile cache's modes and registers.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::PIXEL_BITS;
use rtl::{Expr, Module, Reg, address_width};

/// Bits of a number of pixels of a tile, all of them included; the top bit says that all are done.
pub(super) const COUNT_BITS: u32 = PIXEL_BITS + 1;

/// What the unit is about.
#[derive(Clone, Copy)]
pub(super) enum Mode {
    /// Clears the memory of touched tiles after reset.
    Clear,
    /// Places copies.
    Run,
    /// Waits until the frame's last samples are accumulated.
    Wait,
    /// Sends the frame: reads whether the next tile was touched.
    Look,
    /// Finds out where that tile is.
    Check,
    /// Sends the tile in a slot.
    FromSlot,
    /// Sends the tile in the reconstruction buffer.
    FromMemory,
    /// Sends the end of the frame.
    Close,
}

/// Registers of the unit.
pub(super) struct State {
    /// The pixel that moves of a tile begin with.
    pub first_pixel: u32,
    pub mode: Reg,
    pub frame_ended: Reg,
    /// The place of the tile that is cleared or sent, among those of the rasterizer.
    pub place: Reg,
    /// Whether that tile was touched is in the memory's output.
    pub code_read: Reg,
    /// The job of a tile that was missed: first a look, two cycles long, at whether the tile was touched, then the exchange.
    pub looking: Reg,
    pub looked: Reg,
    pub moving: Reg,
    pub slot: Reg,
    pub tile: Reg,
    pub read_valid: Reg,
    /// The slot holds a tile that has to be written back first.
    pub evict: Reg,
    pub evict_tile: Reg,
    /// The tile comes from the reconstruction buffer; otherwise it is new and starts with zeros.
    pub load: Reg,
    /// Pixels read from the slot, or from the reconstruction buffer when the frame is sent.
    pub drained: Reg,
    /// A pixel was read, and which.
    pub showing: Reg,
    pub shown_pixel: Reg,
    /// A pixel that was shown is held at the drain port, and which.
    pub holding: Reg,
    pub held_pixel: Reg,
    pub filled: Reg,
}

impl State {
    pub fn new(m: &mut Module, config: &Config, first_pixel: u32) -> Self {
        let tile_bits = config.tile_bits();
        Self {
            first_pixel,
            mode: m.reg_reset("mode", address_width(Mode::Close as u32 + 1), Mode::Clear as u128),
            frame_ended: m.reg_reset("frame_ended", 1, 0),
            place: m.reg_reset("place", config.place_bits(), 0),
            code_read: m.reg_reset("code_read", 1, 0),
            looking: m.reg_reset("looking", 1, 0),
            looked: m.reg_reset("looked", 1, 0),
            moving: m.reg_reset("moving", 1, 0),
            slot: m.reg("slot", config.slot_bits()),
            tile: m.reg("read_tile", tile_bits),
            read_valid: m.reg_reset("read_valid", 1, 0),
            evict: m.reg("evict", 1),
            evict_tile: m.reg("evict_tile", tile_bits),
            load: m.reg("load", 1),
            drained: m.reg("drained", COUNT_BITS),
            showing: m.reg_reset("showing", 1, 0),
            shown_pixel: m.reg("shown_pixel", PIXEL_BITS),
            holding: m.reg_reset("holding", 1, 0),
            held_pixel: m.reg("held_pixel", PIXEL_BITS),
            filled: m.reg("filled", COUNT_BITS),
        }
    }

    pub fn is(&self, mode: Mode) -> Expr {
        self.mode.eq_lit(mode as u128)
    }

    pub fn all_drained(&self) -> Expr {
        self.drained.msb()
    }

    /// Pixels that were read are on their way.
    pub fn holds_pixels(&self) -> Expr {
        self.showing | self.holding
    }

    /// No tile is on its way.
    pub fn no_job(&self) -> Expr {
        !((self.looking | self.looked) | self.moving)
    }
}
