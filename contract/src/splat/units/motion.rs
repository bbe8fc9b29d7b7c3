//! Units for splats that move while the shutter is open (thesis chapter 4); not a part of the core yet.

use crate::splat::Config;
use crate::splat::records::{MovingPlace, MovingSample};
use crate::unit;

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
