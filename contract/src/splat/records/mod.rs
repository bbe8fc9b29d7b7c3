//! The records that flow through the renderer.
//!
//! Geometry fields are values of [`Config::geometry`], those of footprints of [`Config::raster_format`], of which every format fits a
//! `u32`; attributes are values of [`Config::attribute`], whose products and sums may be wider; depths, weights and coordinates are
//! unsigned integers. A record with `end` set closes the frame and carries nothing else.

mod copy;
mod depth;
mod footprint;
mod motion;
mod payload;
mod pixel;
mod sample;
mod slot;
mod uniforms;

pub use copy::{
    ArrivedCopy, CompleteCopy, HeapEntry, ImageDiagonals, ImageRectangle, PlacedCopy, SetupSplat, SplatCopy, TileCopy,
    TileDiagonals, TileRectangle,
};
pub use depth::{Depth, DepthRun, StoredDepth, depth_place};
pub use footprint::{Band, DepthPlane, Footprint, Sight};
pub use motion::{Bin, Motion, Moving, MovingFootprint, MovingPlace, MovingSample, SPAN, Seen, Shutter};
pub use payload::{
    PART_BITS, Payload, PayloadPlace, PayloadWord, StoredWord, payload_bytes, payload_parts, payload_word_bits,
};
pub use pixel::{FinishedPixel, Fragment, Pixel, PixelRun, PlacedPixel, StoredPixel, buffer_tile, pixel_bytes};
pub use sample::{Sample, SamplePlace, WeightedSample};
pub use slot::{DrainedPixel, Fill, Slot, SlotChange, SlotMasks, SlotPixel, SlotTile};
pub use uniforms::{
    EpsilonScale, ModelView, UNIFORM_ADDRESS_BITS, UniformWrite, Uniforms, Viewport, late_uniforms, uniform_formats,
};

use super::config::{ATTRIBUTES_MAX, Config, RUN_PIXELS_MAX, TILE_PIXELS, TILE_SIZE, index_bits};
use crate::record;

/// Names of a point's coordinates.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// The most attributes a splat has.
pub const ATTRIBUTES: usize = ATTRIBUTES_MAX as usize;

/// Attributes of a splat: first the continuous ones, then the cardinal ones, then unused places.
pub type Attributes = [u32; ATTRIBUTES];

/// What is made of a splat's attributes, in the same places: of continuous ones, contributions or sums.
pub type Contributions = [u64; ATTRIBUTES];

/// Bits of a pixel's column or row within its tile.
pub const LOCAL_BITS: u32 = index_bits(TILE_SIZE);
/// Bits of a pixel's sum or difference of column and row within its tile.
pub const DIAGONAL_BITS: u32 = LOCAL_BITS + 1;
/// Bits of a pixel's index within its tile, row above column.
pub const PIXEL_BITS: u32 = index_bits(TILE_PIXELS);
/// Bits of a number of pixels in a run.
pub const RUN_BITS: u32 = index_bits(RUN_PIXELS_MAX + 1);

/// The name of an attribute by its place.
#[must_use]
pub fn attribute_name(config: &Config, place: usize) -> String {
    let continuous = config.continuous as usize;
    if place < continuous { format!("attribute_{place}") } else { format!("cardinal_{}", place - continuous) }
}

/// Bits of what is made of an attribute: cardinal ones stay as they are.
#[must_use]
pub fn made_bits(config: &Config, place: usize, continuous_width: u32) -> u32 {
    if place < config.continuous as usize { continuous_width } else { config.attribute.width() }
}

/// A splat, in world space as the host sends it and in camera space as the transform unit passes it on.
#[record(config: Config)]
pub struct Splat {
    /// Closes the frame.
    pub end: bool,
    /// Center.
    #[name(format!("center_{}", AXES[i]))]
    #[bits(config.geometry.width())]
    pub center: [u32; 3],
    /// Tangents, whose ends lie at rho = 1.
    #[name(format!("tangent{}_{}", i + 1, AXES[j]))]
    #[bits(config.geometry.width())]
    pub tangents: [[u32; 3]; 2],
    /// How it moves.
    #[when(config.has_motion())]
    pub motion: Motion,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
}
