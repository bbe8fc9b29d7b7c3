//! What passes between the tile cache and the slots in the accumulator.

use super::{PIXEL_BITS, Pixel};
use crate::record;
use crate::splat::Config;
use crate::splat::config::{SLOT_BANKS, TILE_PIXELS};

/// A slot's number alone.
#[record(config: Config)]
pub struct Slot {
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
}

/// A slot with the tile that it gets.
#[record(config: Config)]
pub struct SlotTile {
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
    /// Tile index.
    #[bits(config.tile_bits())]
    pub tile: u32,
}

/// A pixel of a slot.
#[record(config: Config)]
pub struct SlotPixel {
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
    /// Pixel of the tile.
    #[bits(PIXEL_BITS)]
    pub pixel: u8,
}

/// A write to a slot.
#[record(config: Config)]
pub struct Fill {
    /// Where.
    pub place: SlotPixel,
    /// What.
    pub value: Pixel,
}

/// A pixel that was read from a slot.
#[record(config: Config)]
pub struct DrainedPixel {
    /// Pixel of the tile.
    #[bits(PIXEL_BITS)]
    pub pixel: u8,
    /// What it holds.
    pub value: Pixel,
}

/// A slot gets another tile.
#[record(config: Config)]
pub struct SlotChange {
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
    /// A bit for each bank in which that is to be carried out.
    #[bits(SLOT_BANKS)]
    pub banks: u8,
    /// A bit for each pixel that will be filled.
    #[bits(TILE_PIXELS)]
    pub held: u64,
}

/// What a slot held of its tile.
#[record(config: Config)]
pub struct SlotMasks {
    /// A bit for each pixel that was filled or that a sample came to.
    #[bits(TILE_PIXELS)]
    pub written: u64,
    /// A bit for each pixel that a sample came to.
    #[bits(TILE_PIXELS)]
    pub dirty: u64,
}
