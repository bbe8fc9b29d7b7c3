//! What the rasterizer needs of a splat.

use super::AXES;
use crate::record;
use crate::splat::Config;
use crate::splat::config::DEPTH_BITS;
use crate::splat::raster::Coefficient;

/// A splat's depth, or a sample's, and the ends of its ε-band (eq. 5.8, 5.9).
#[record(config: Config)]
pub struct Band {
    /// Depth.
    #[bits(DEPTH_BITS)]
    pub depth: u32,
    /// What is nearer hides the splat.
    #[name("depth_low")]
    #[bits(DEPTH_BITS)]
    pub low: u32,
    /// What is farther is hidden by the splat.
    #[name("depth_high")]
    #[bits(DEPTH_BITS)]
    pub high: u32,
}

/// Depth over a splat's plane, in the rasterizer's format.
#[record(config: Config)]
pub struct DepthPlane {
    /// At the splat's centre.
    #[name("depth_center")]
    #[bits(config.raster_format().coefficient_width())]
    pub center: u32,
    /// Change over a pixel in x and in y.
    #[name(format!("depth_{}", AXES[i]))]
    #[bits(config.raster_format().coefficient_width())]
    pub slope: [u32; 2],
    /// Near and far end of the splat's range.
    #[name(["depth_near", "depth_far"][i])]
    #[bits(config.raster_format().coefficient_width())]
    pub range: [u32; 2],
    /// Half the epsilon band (eq. 5.9).
    #[bits(config.raster_format().coefficient_width())]
    pub epsilon: u32,
}

/// Which samples of a splat are seen, by `D`, which is `u_z·Δ` over a sample's distance.
#[record(config: Config)]
pub struct Sight {
    /// `D` is negative before the eye.
    #[name("sight_negative")]
    pub negative: bool,
    /// The magnitude of `D` at the near plane; all ones where no sample lies before it.
    #[name("sight_near")]
    #[bits(config.raster_format().limit_width())]
    pub near: u32,
    /// The magnitude of `D` at the far plane; zero where no sample lies behind it.
    #[name("sight_far")]
    #[bits(config.raster_format().limit_width())]
    pub far: u32,
    /// The origin is the vanishing point of a tangent: `s1` and `D` have changed places.
    #[name("sight_turned")]
    pub turned: bool,
    /// The origin is the splat's centre, and lies between near and far plane: the filter's disc is drawn.
    #[when(config.screen_filter.is_on())]
    #[name("sight_disc")]
    pub disc: bool,
}

/// What the rasterizer needs of a splat, recentred at its projected centre.
#[record(config: Config)]
pub struct Footprint {
    /// Projected center (px), the origin of what follows.
    #[name(format!("center_{}", AXES[i]))]
    #[bits(config.raster_format().center_width())]
    pub center: [u32; 2],
    /// `A` in x.
    #[bits(config.raster_format().coefficient_width())]
    pub ax: u32,
    /// `B` in x.
    #[bits(config.raster_format().coefficient_width())]
    pub bx: u32,
    /// `A` in y.
    #[bits(config.raster_format().coefficient_width())]
    pub ay: u32,
    /// `B` in y.
    #[bits(config.raster_format().coefficient_width())]
    pub by: u32,
    /// The determinant of `A` and `B`.
    #[bits(config.raster_format().delta_width())]
    pub delta: u32,
    /// `m` in x.
    #[bits(config.raster_format().coefficient_width())]
    pub mx: u32,
    /// `m` in y.
    #[bits(config.raster_format().coefficient_width())]
    pub my: u32,
    /// In fixed point, places by which offsets from the centre are shifted.
    #[when(config.raster_format().fixed().is_some())]
    #[bits(Coefficient::SHIFT_BITS)]
    pub shift: u8,
    /// What is seen of it, where that is asked sample by sample.
    #[when(config.eye_plane.is_on())]
    pub sight: Sight,
    /// Depth band, where all samples share it.
    #[when(!config.has_depth_plane())]
    pub band: Band,
    /// Depth plane, where each sample has its own.
    #[when(config.has_depth_plane())]
    pub plane: DepthPlane,
}
