//! Splats that move while the shutter is open. The exposure is the time `τ` from −1 to 1.

use super::{ATTRIBUTES, AXES, ImageRectangle, PIXEL_BITS, Splat, attribute_name};
use crate::record;
use crate::splat::Config;
use crate::splat::config::DEPTH_BITS;
use crate::splat::motion::{SHARE_BITS, TIME_BINS, TIME_BITS, TIMES};

/// A splat in camera space that moves along a line.
#[record(config: Config)]
pub struct MovingSplat {
    /// Where it is at `τ = 0`.
    pub splat: Splat,
    /// The way of its center in a unit of `τ`.
    #[name(format!("motion_{}", AXES[i]))]
    #[bits(config.geometry.width())]
    pub motion: [u32; 3],
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

/// A moving splat after setup, with its bounds in the image over all of its life.
#[record(config: Config)]
pub struct SetupMovingSplat {
    /// Closes the frame.
    pub end: bool,
    /// What evaluation needs.
    pub footprint: MovingFootprint,
    /// How far to either side of a depth its band reaches (eq. 5.9).
    #[bits(DEPTH_BITS)]
    pub epsilon: u32,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
    /// The hull of its bounds at begin and end.
    pub bounds: ImageRectangle,
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
    /// The splat.
    pub footprint: MovingFootprint,
}

/// What a moving splat does to a sample, bin by bin.
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
    /// The borders of bins, taken into the time for which the sample is covered: from the first to the last. Where two that follow each other are
    /// the same, the bin between them sees nothing.
    #[bits(TIME_BITS)]
    pub time: [u32; TIMES],
    /// Depth at each of these times.
    #[bits(DEPTH_BITS)]
    pub depth: [u32; TIMES],
    /// The integral of the kernel over each bin; that of one over the exposure is one.
    #[bits(SHARE_BITS)]
    pub share: [u32; TIME_BINS],
}
