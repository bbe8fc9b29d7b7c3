//! Depths in memory, with which fragments are merged (thesis 5.4.6), or by which samples of what moves are hidden.

use super::{PIXEL_BITS, RUN_BITS};
use crate::record;
use crate::splat::Config;
use crate::splat::config::{MERGED_DEPTH_BITS, TILE_PIXELS};

/// A depth in memory.
#[record(config: Config)]
pub struct Depth {
    /// An `f32`, no less than 0; the nearer, the smaller. Of a narrower geometry format it has the upper bits.
    #[bits(MERGED_DEPTH_BITS)]
    pub depth: u32,
}

/// Depths of pixels of a tile that follow each other in a row.
#[record(config: Config)]
pub struct DepthRun {
    /// Tile of the image.
    #[bits(config.image_tile_bits())]
    pub tile: u32,
    /// The first pixel of the tile.
    #[bits(PIXEL_BITS)]
    pub pixel: u8,
    /// How many there are, at least one.
    #[bits(RUN_BITS)]
    pub count: u8,
}

/// A depth on its way to memory.
#[record(config: Config)]
pub struct StoredDepth {
    /// Tile of the image.
    #[bits(config.image_tile_bits())]
    pub tile: u32,
    /// Pixel of the tile.
    #[bits(PIXEL_BITS)]
    pub pixel: u8,
    /// The depth.
    pub value: Depth,
}

/// A depth's place among those in memory, tile by tile.
#[must_use]
pub const fn depth_place(tile: u32, pixel: u32) -> u32 {
    tile * TILE_PIXELS + pixel
}
