//! Pixels of the reconstruction buffer and what becomes of them.

use super::{ATTRIBUTES, Bin, PIXEL_BITS, RUN_BITS, Seen, attribute_name, made_bits};
use crate::splat::Config;
use crate::splat::config::{DEPTH_SUM_BITS, WEIGHT_BITS, WEIGHT_SUM_BITS};
use crate::{record, width};

/// A pixel of the reconstruction buffer.
#[record(config: Config)]
pub struct Pixel {
    /// Sum of weights.
    #[bits(WEIGHT_SUM_BITS)]
    pub weight: u32,
    /// Sum of weighted depths.
    #[bits(DEPTH_SUM_BITS)]
    pub depth: u64,
    /// The largest single weight, with cardinal attributes only.
    #[when(config.cardinal > 0)]
    #[bits(WEIGHT_BITS)]
    pub peak: u16,
    /// Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(made_bits(config, i, config.attribute.sum_width()))]
    pub attributes: [u64; ATTRIBUTES],
    /// Where splats may move, what lies behind: the sums above are those of the nearest surface in a bin of the exposure.
    #[when(config.has_motion())]
    pub bin: Bin,
}

/// Bytes a pixel takes in the reconstruction buffer.
#[must_use]
pub fn pixel_bytes(config: &Config) -> u32 {
    width::<Pixel>(config).div_ceil(u8::BITS)
}

/// A tile's place among those of the reconstruction buffer: surfaces one behind the other.
#[must_use]
pub fn buffer_tile(config: &Config, surface: bool, tile: u32) -> usize {
    usize::from(surface) << config.tile_bits() | tile as usize
}

/// A pixel with its place in a frame.
#[record(config: Config)]
pub struct PlacedPixel {
    /// Tile index.
    #[bits(config.tile_bits())]
    pub tile: u32,
    /// Pixel of the tile.
    #[bits(PIXEL_BITS)]
    pub pixel: u8,
    /// What the pixel holds.
    pub value: Pixel,
}

/// A pixel that goes to the reconstruction buffer.
#[record(config: Config)]
pub struct StoredPixel {
    /// The frame is one of those with odd numbers: two have a place in the buffer.
    pub surface: bool,
    /// Pixel and place.
    pub placed: PlacedPixel,
}

/// Pixels of a tile that follow each other in a row.
#[record(config: Config)]
pub struct PixelRun {
    /// The frame is one of those with odd numbers.
    pub surface: bool,
    /// Tile index.
    #[bits(config.tile_bits())]
    pub tile: u32,
    /// The first pixel of the tile.
    #[bits(PIXEL_BITS)]
    pub pixel: u8,
    /// How many there are, at least one.
    #[bits(RUN_BITS)]
    pub count: u8,
}

/// A pixel on its way to normalization.
#[record(config: Config)]
pub struct FinishedPixel {
    /// Closes the frame.
    pub end: bool,
    /// Pixel and place.
    pub placed: PlacedPixel,
}

/// A normalized pixel (eq. 5.13).
#[record(config: Config)]
pub struct Fragment {
    /// Closes the frame.
    pub end: bool,
    /// Column of the image.
    #[bits(config.column_bits())]
    pub column: u16,
    /// Row of the image.
    #[bits(config.row_bits())]
    pub row: u16,
    /// Depth in the geometry format.
    #[bits(config.geometry.width())]
    pub depth: u32,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
    /// Where splats may move, for how long this is seen, and what besides.
    #[when(config.has_motion())]
    pub seen: Seen,
}
