//! A sample in two parts, which wait in different memories.

use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{DEPTH_BITS, WEIGHT_BITS};
use pointcore_contract::splat::records::{
    ATTRIBUTES, PIXEL_BITS, SPAN, SamplePlace, WeightedSample, attribute_name, made_bits,
};

use crate::units::wires::Wires;

/// What decides when and where a sample issues.
#[record(config: Config)]
pub(super) struct Place {
    /// Closes its copy.
    last: bool,
    /// Lies inside the splat.
    inside: bool,
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    slot: u8,
    /// Pixel of the tile.
    #[bits(PIXEL_BITS)]
    pixel: u8,
}

/// What is blended with the pixel.
#[record(config: Config)]
pub(super) struct Contribution {
    /// Kernel weight.
    #[bits(WEIGHT_BITS)]
    weight: u16,
    /// Weighted depth.
    #[bits(WEIGHT_BITS + DEPTH_BITS)]
    weighted_depth: u64,
    /// Near end of the depth band.
    #[bits(DEPTH_BITS)]
    depth_low: u32,
    /// Far end of the depth band.
    #[bits(DEPTH_BITS)]
    depth_high: u32,
    /// Where splats may move, for how long its bin sees it.
    #[when(config.has_motion())]
    #[name(SPAN[i])]
    #[bits(config.bin_time_bits())]
    time: [u32; 2],
    /// Weighted continuous attributes, and cardinal ones as they are.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(made_bits(config, i, config.attribute.contribution_width()))]
    attributes: [u64; ATTRIBUTES],
}

/// A sample.
#[record(config: Config)]
pub(super) struct Queued {
    /// When and where.
    place: Place,
    /// What.
    contribution: Contribution,
}

impl From<WeightedSample<Wires>> for Queued<Wires> {
    fn from(sample: WeightedSample<Wires>) -> Self {
        let SamplePlace { last, inside, slot, pixel, weight } = sample.place;
        let WeightedSample { weighted_depth, depth_low, depth_high, time, attributes, .. } = sample;
        Self {
            place: Place { last, inside, slot, pixel },
            contribution: Contribution { weight, weighted_depth, depth_low, depth_high, time, attributes },
        }
    }
}
