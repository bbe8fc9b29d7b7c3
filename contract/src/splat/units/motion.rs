//! Units for splats that move while the shutter is open (thesis chapter 4).

use crate::splat::Config;
use crate::splat::records::{EpsilonScale, MovingPlace, MovingSample, SetupSplat, Splat, Viewport};
use crate::unit;

/// Computes what evaluation needs of a moving splat, and its bounds.
#[unit(splat_motion_setup, config: Config)]
#[when(config.has_motion())]
pub struct MotionSetup {
    /// Moving splats in camera space.
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
    #[bits(config.geometry.width())]
    near_plane: Input<u32>,
}

/// Integrates a moving splat's kernel over its bin of the exposure (eq. 4.19).
#[unit(splat_motion_evaluation, config: Config)]
#[when(config.has_motion())]
pub struct MotionEvaluation {
    /// Samples within bounds.
    #[port("in")]
    input: In<MovingPlace>,
    /// Samples.
    out: Out<MovingSample>,
    /// Depth is `depth_a` and what follows from the distance.
    #[bits(config.geometry.width())]
    depth_a: Input<u32>,
}
