//! Units for splats that move while the shutter is open (thesis chapter 4); not a part of the core yet.

use crate::splat::Config;
use crate::splat::records::{EpsilonScale, MovingPlace, MovingSample, MovingSplat, SetupMovingSplat, Viewport};
use crate::unit;

/// Computes what evaluation needs of a moving splat, and its bounds.
#[unit(splat_motion_setup, config: Config)]
pub struct MotionSetup {
    /// Moving splats in camera space.
    #[port("in")]
    input: In<MovingSplat>,
    /// Footprints with bounds.
    out: Out<SetupMovingSplat>,
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

/// Integrates a moving splat's kernel over each bin of the exposure (eq. 4.19).
#[unit(splat_motion_evaluation, config: Config)]
pub struct MotionEvaluation {
    /// Samples within bounds.
    #[port("in")]
    input: In<MovingPlace>,
    /// Samples, bin by bin.
    out: Out<MovingSample>,
    /// Depth is `depth_a` and what follows from the distance.
    #[bits(config.geometry.width())]
    depth_a: Input<u32>,
}
