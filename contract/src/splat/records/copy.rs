//! Splats after setup and their copies for tiles.

use super::{ATTRIBUTES, DIAGONAL_BITS, Footprint, LOCAL_BITS, Moving, attribute_name};
use crate::record;
use crate::splat::Config;

/// An inclusive rectangle of the image's pixels.
#[record(config: Config)]
pub struct ImageRectangle {
    /// First column.
    #[bits(config.column_bits())]
    pub left: u16,
    /// Last column.
    #[bits(config.column_bits())]
    pub right: u16,
    /// First row.
    #[bits(config.row_bits())]
    pub top: u16,
    /// Last row.
    #[bits(config.row_bits())]
    pub bottom: u16,
}

/// Inclusive limits along the image's diagonals: with them a rectangle becomes an octagon.
///
/// A pixel's *sum* is its column plus its row, its *difference* its column plus the complement of its row: neither is negative. Columns
/// are those of pixels, however many samples they have.
#[record(config: Config)]
pub struct ImageDiagonals {
    /// Smallest sum.
    #[bits(config.diagonal_bits())]
    pub first_sum: u16,
    /// Largest sum.
    #[bits(config.diagonal_bits())]
    pub last_sum: u16,
    /// Smallest difference.
    #[bits(config.diagonal_bits())]
    pub first_difference: u16,
    /// Largest difference.
    #[bits(config.diagonal_bits())]
    pub last_difference: u16,
}

/// Inclusive limits along a tile's diagonals, of places counted from the tile's first pixel. No row of the copy is without a sample.
#[record(config: Config)]
pub struct TileDiagonals {
    /// Smallest sum.
    #[bits(DIAGONAL_BITS)]
    pub first_sum: u16,
    /// Largest sum.
    #[bits(DIAGONAL_BITS)]
    pub last_sum: u16,
    /// Smallest difference.
    #[bits(DIAGONAL_BITS)]
    pub first_difference: u16,
    /// Largest difference.
    #[bits(DIAGONAL_BITS)]
    pub last_difference: u16,
}

/// An inclusive rectangle of a tile's pixels.
#[record(config: Config)]
pub struct TileRectangle {
    /// First column.
    #[bits(LOCAL_BITS)]
    pub left: u16,
    /// Last column.
    #[bits(LOCAL_BITS)]
    pub right: u16,
    /// First row.
    #[bits(LOCAL_BITS)]
    pub top: u16,
    /// Last row.
    #[bits(LOCAL_BITS)]
    pub bottom: u16,
}

/// A splat after setup, with its bounds in the image.
#[record(config: Config)]
pub struct SetupSplat {
    /// Closes the frame.
    pub end: bool,
    /// Footprint, where nothing moves.
    #[when(!config.has_motion())]
    pub footprint: Footprint,
    /// Footprint and depth band of a splat that may move.
    #[when(config.has_motion())]
    pub moving: Moving,
    /// The bin of the exposure in which it is there.
    #[when(config.bin_bits() > 0)]
    #[bits(config.bin_bits())]
    pub bin: u8,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
    /// Bounds in the image.
    pub bounds: ImageRectangle,
    /// What they leave of its corners.
    pub diagonals: ImageDiagonals,
}

/// A splat's copy for one tile, with its bounds in the tile. The copies of a splat come one after the other.
#[record(config: Config)]
pub struct SplatCopy {
    /// Closes the frame.
    pub end: bool,
    /// It is the first of its splat.
    pub first: bool,
    /// Footprint, where nothing moves.
    #[when(!config.has_motion())]
    pub footprint: Footprint,
    /// Footprint and depth band of a splat that may move.
    #[when(config.has_motion())]
    pub moving: Moving,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
    /// Bounds in the tile.
    pub bounds: TileRectangle,
    /// What they leave of its corners.
    pub diagonals: TileDiagonals,
    /// Tile index: row above column.
    #[bits(config.tile_bits())]
    pub tile: u32,
}

/// What of a copy is its own: all else is its splat's, and waits where `splat` says.
#[record(config: Config)]
pub struct TileCopy {
    /// Closes the frame.
    pub end: bool,
    /// Bounds in the tile.
    pub bounds: TileRectangle,
    /// What they leave of its corners.
    pub diagonals: TileDiagonals,
    /// Tile index: row above column.
    #[bits(config.tile_bits())]
    pub tile: u32,
    /// Place of its splat's payload.
    #[bits(config.splat_bits())]
    pub splat: u16,
}

/// What the tile cache is told of a copy before it is put in order.
#[record(config: Config)]
pub struct ArrivedCopy {
    /// Closes the frame.
    pub end: bool,
    /// Tile index: row above column.
    #[bits(config.tile_bits())]
    pub tile: u32,
    /// Place of its splat's payload: no other copy for the tile has it before the tile cache has passed this one on.
    #[bits(config.splat_bits())]
    pub splat: u16,
}

/// A copy with the slot its tile lives in.
#[record(config: Config)]
pub struct PlacedCopy {
    /// Bounds in the tile.
    pub bounds: TileRectangle,
    /// What they leave of its corners.
    pub diagonals: TileDiagonals,
    /// Tile index: row above column.
    #[bits(config.tile_bits())]
    pub tile: u32,
    /// Place of its splat's payload.
    #[bits(config.splat_bits())]
    pub splat: u16,
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
}

/// A copy with its slot, and with its splat's payload again.
#[record(config: Config)]
pub struct CompleteCopy {
    /// Footprint, where nothing moves.
    #[when(!config.has_motion())]
    pub footprint: Footprint,
    /// Footprint and depth band of a splat that may move.
    #[when(config.has_motion())]
    pub moving: Moving,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
    /// Bounds in the tile.
    pub bounds: TileRectangle,
    /// What they leave of its corners.
    pub diagonals: TileDiagonals,
    /// Tile index: row above column.
    #[bits(config.tile_bits())]
    pub tile: u32,
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
}

/// What the heap orders: a copy's tile and where the rest of it lies.
#[record(config: Config)]
pub struct HeapEntry {
    /// Tile index.
    #[bits(config.tile_bits())]
    pub tile: u32,
    /// Place of the rest.
    #[bits(config.heap_levels)]
    pub pointer: u16,
}
