//! Samples of splats.

use super::{ATTRIBUTES, Band, PIXEL_BITS, SPAN, attribute_name, made_bits};
use crate::record;
use crate::splat::Config;
use crate::splat::config::{DEPTH_BITS, WEIGHT_BITS};

/// Where a sample lies and what it weighs.
#[record(config: Config)]
pub struct SamplePlace {
    /// Closes its copy.
    pub last: bool,
    /// Lies inside the splat; one outside is passed on only to say so.
    pub inside: bool,
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
    /// Pixel of the tile: row above column.
    #[bits(PIXEL_BITS)]
    pub pixel: u8,
    /// Kernel weight.
    #[bits(WEIGHT_BITS)]
    pub weight: u16,
}

/// A sample with its depth band and its splat's attributes.
#[record(config: Config)]
pub struct Sample {
    /// Place and weight.
    pub place: SamplePlace,
    /// Depth band.
    pub band: Band,
    /// Where splats may move, for how long its bin sees it.
    #[when(config.has_motion())]
    #[name(SPAN[i])]
    #[bits(config.bin_time_bits())]
    pub time: [u32; 2],
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
}

/// A sample with its contributions to the sums (eq. 5.10).
#[record(config: Config)]
pub struct WeightedSample {
    /// Place and weight.
    pub place: SamplePlace,
    /// Weighted depth.
    #[bits(WEIGHT_BITS + DEPTH_BITS)]
    pub weighted_depth: u64,
    /// Near end of the depth band.
    #[bits(DEPTH_BITS)]
    pub depth_low: u32,
    /// Far end of the depth band.
    #[bits(DEPTH_BITS)]
    pub depth_high: u32,
    /// Where splats may move, for how long its bin sees it.
    #[when(config.has_motion())]
    #[name(SPAN[i])]
    #[bits(config.bin_time_bits())]
    pub time: [u32; 2],
    /// Weighted continuous attributes, and cardinal ones as they are.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(made_bits(config, i, config.attribute.contribution_width()))]
    pub attributes: [u64; ATTRIBUTES],
}
