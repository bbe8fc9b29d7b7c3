//! Splats that move while the shutter is open. The exposure is the time `τ` from −1 to 1.

use super::{ATTRIBUTES, AXES, PIXEL_BITS, attribute_name, made_bits};
use crate::record;
use crate::splat::Config;
use crate::splat::config::{DEPTH_BITS, DEPTH_SUM_BITS, WEIGHT_BITS, WEIGHT_SUM_BITS};
use crate::splat::motion::{BIN_PARTS, SHARE_BITS, SHUTTER, TIME_BINS_MAX, TIME_BITS};

/// The motion of a splat along a line, on which it is where [`Splat::center`](super::Splat::center) says at `τ = 0`.
#[record(config: Config)]
pub struct Motion {
    /// The way of its center in a unit of `τ`.
    #[name(format!("motion_{}", AXES[i]))]
    #[bits(config.geometry.width())]
    pub way: [u32; 3],
    /// Begin and end of the part of the exposure for which it is there.
    #[name(["part_begin", "part_end"][i])]
    #[bits(config.geometry.width())]
    pub part: [u32; 2],
}

/// What evaluation needs of a moving splat, in the geometry format. Forms are linear in a sample's offset `(x, y)` from the center, px.
#[record(config: Config)]
pub struct MovingFootprint {
    /// Projected center at the origin of time (px), the origin of what follows.
    #[name(format!("center_{}", AXES[i]))]
    #[bits(config.geometry.width())]
    pub center: [u32; 2],
    /// The origin of time: a `τ` at which the center lies beyond the near plane.
    #[name("origin_time")]
    #[bits(config.geometry.width())]
    pub time: u32,
    /// `D` is one, plus these times the offset.
    #[name(format!("determinant_{}", AXES[i]))]
    #[bits(config.geometry.width())]
    pub determinant: [u32; 2],
    /// Place along either tangent at the origin of time, times `D`: these times the offset.
    #[name(format!("place{}_{}", i + 1, AXES[j]))]
    #[bits(config.geometry.width())]
    pub place: [[u32; 2]; 2],
    /// Change of that in a unit of `τ`: at the center, and with the offset.
    #[name(format!("speed{}_{}", i + 1, ["center", "x", "y"][j]))]
    #[bits(config.geometry.width())]
    pub speed: [[u32; 3]; 2],
    /// What divides the depth: at `τ = 0`, and its change.
    #[name(["distance", "distance_change"][i])]
    #[bits(config.geometry.width())]
    pub distance: [u32; 2],
    /// What is divided, times `D` where each sample has its own depth.
    #[bits(config.geometry.width())]
    pub depth_scale: u32,
    /// Begin and end of the time for which it is seen.
    #[name(["life_begin", "life_end"][i])]
    #[bits(config.geometry.width())]
    pub life: [u32; 2],
    /// A sample is between near and far plane from the first times `D`, less the third, to the second times `D`, less the third.
    #[when(config.eye_plane.is_on())]
    #[name(["planes_begin", "planes_end", "planes_offset"][i])]
    #[bits(config.geometry.width())]
    pub planes: [u32; 3],
}

/// What the rasterizer needs of a splat that may move.
#[record(config: Config)]
pub struct Moving {
    /// What evaluation needs.
    pub footprint: MovingFootprint,
    /// How far to either side of a depth its band reaches (eq. 5.9).
    #[bits(DEPTH_BITS)]
    pub epsilon: u32,
}

/// A sample within a moving splat's bounds.
#[record(config: Config)]
pub struct MovingPlace {
    /// Closes its copy.
    pub last: bool,
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
    /// Column of the image.
    #[bits(config.column_bits())]
    pub column: u16,
    /// Row of the image.
    #[bits(config.row_bits())]
    pub row: u16,
    /// The bin of the exposure, an odd one or not: of that times are counted.
    #[when(config.bin_bits() > 0)]
    pub odd_bin: bool,
    /// The splat.
    pub footprint: MovingFootprint,
}

/// What a moving splat does to a sample in its bin of the exposure.
#[record(config: Config)]
pub struct MovingSample {
    /// Closes its copy.
    pub last: bool,
    /// The splat covers it for a part of the exposure; one that is never covered is passed on only to say so.
    pub inside: bool,
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    pub slot: u8,
    /// Pixel of the tile: row above column.
    #[bits(PIXEL_BITS)]
    pub pixel: u8,
    /// Begin and end of the time for which it is covered, counted from the bin's end and from its begin as a [`SPAN`] has them.
    #[name(SPAN[i])]
    #[bits(config.bin_time_bits())]
    pub time: [u32; 2],
    /// Depth at begin and end.
    #[bits(DEPTH_BITS)]
    pub depth: [u32; 2],
    /// The integral of the kernel over that time; that of one over the exposure is one.
    #[bits(SHARE_BITS)]
    pub share: u32,
}

/// Names of the two numbers that say for how long a bin sees something: what is left of the bin at the earliest time at which it does, and what
/// has passed of it at the latest. Of two such spans the larger of both is their hull; of what was never seen both are zero.
pub const SPAN: [&str; 2] = ["early", "late"];

/// What a bin of the exposure holds besides its nearest surface: the sums of all else that is seen, and when it sees what.
#[record(config: Config)]
pub struct Bin {
    /// From when to when the nearest surface is seen.
    #[name(format!("nearest_{}", SPAN[i]))]
    #[bits(config.bin_time_bits())]
    pub nearest: [u32; 2],
    /// In which of the bin's parts it is, the first in the lowest bit.
    #[bits(BIN_PARTS)]
    pub nearest_parts: u16,
    /// From when to when anything is.
    #[name(format!("any_{}", SPAN[i]))]
    #[bits(config.bin_time_bits())]
    pub any: [u32; 2],
    /// In which of the bin's parts anything is.
    #[bits(BIN_PARTS)]
    pub any_parts: u16,
    /// Sum of the other weights.
    #[name("rest_weight")]
    #[bits(WEIGHT_SUM_BITS)]
    pub weight: u32,
    /// Sum of the other weighted depths.
    #[name("rest_depth")]
    #[bits(DEPTH_SUM_BITS)]
    pub depth: u64,
    /// The largest single weight of the others, with cardinal attributes only.
    #[when(config.cardinal > 0)]
    #[name("rest_peak")]
    #[bits(WEIGHT_BITS)]
    pub peak: u16,
    /// Sums of the others' weighted continuous attributes, and the cardinal ones of the largest weight.
    #[count(config.attributes())]
    #[name(format!("rest_{}", attribute_name(config, i)))]
    #[bits(made_bits(config, i, config.attribute.sum_width()))]
    pub attributes: [u64; ATTRIBUTES],
}

/// What is seen of a bin of the exposure, nearest surface and all else.
#[record(config: Config)]
pub struct Seen {
    /// The bin.
    #[when(config.bin_bits() > 0)]
    #[bits(config.bin_bits())]
    pub bin: u8,
    /// The exposure's share for which the nearest surface is seen.
    #[name("share")]
    #[bits(TIME_BITS)]
    pub share: u32,
    /// That for which only the rest is.
    #[name("rest_share")]
    #[bits(TIME_BITS)]
    pub rest_share: u32,
    /// Depth of the rest in the geometry format.
    #[name("rest_depth")]
    #[bits(config.geometry.width())]
    pub depth: u32,
    /// Attributes of the rest.
    #[count(config.attributes())]
    #[name(format!("rest_{}", attribute_name(config, i)))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
}

/// How much each bin of the exposure counts: 1 each where the shutter is a box.
#[record(config: Config)]
pub struct Shutter {
    /// Bin by bin, as [`SHUTTER`] has it.
    #[count(config.time_bins)]
    #[name(format!("shutter_{i}"))]
    #[bits(SHUTTER.width)]
    pub weight: [u32; TIME_BINS_MAX],
}
