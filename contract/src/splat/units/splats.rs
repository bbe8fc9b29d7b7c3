//! Units that work on splats.

use crate::splat::Config;
use crate::splat::records::{EpsilonScale, ModelView, SetupSplat, Splat, Viewport};
use crate::unit;

/// Takes splats to camera space and leaves out those that cannot be seen.
#[unit(splat_transform, config: Config)]
pub struct Transform {
    /// Splats in world space.
    #[port("in")]
    input: In<Splat>,
    /// Splats in camera space.
    out: Out<Splat>,
    /// Model-view matrix.
    #[port("")]
    model_view: Input<ModelView>,
    /// Near plane.
    #[bits(config.geometry.width())]
    near_plane: Input<u32>,
}

/// Computes what rasterizing needs of a splat, and its bounds (thesis table 5.1).
#[unit(splat_setup, config: Config)]
#[when(!config.has_motion())]
pub struct Setup {
    /// Splats in camera space.
    #[port("in")]
    input: In<Splat>,
    /// Footprints with bounds.
    out: Out<SetupSplat>,
    /// From camera space to pixels and depths.
    #[port("")]
    viewport: Input<Viewport>,
    /// What epsilon is made of.
    #[port("")]
    epsilon: Input<EpsilonScale>,
    /// Near plane.
    #[when(config.eye_plane.is_on())]
    #[bits(config.geometry.width())]
    near_plane: Input<u32>,
    /// Radius of the screen filter (px).
    #[when(config.screen_filter.is_on())]
    #[bits(config.geometry.width())]
    filter_radius: Input<u32>,
}
