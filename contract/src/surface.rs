//! A surface splat as the host hands it to a renderer (thesis 5.4): an elliptical disc in world space with attributes.

use std::ops::Range;

/// Where the world-space surface normal lies in [`Splat::attributes`].
pub const NORMAL: Range<usize> = 0..3;
/// Where the linear RGB color, each component in `0..=1`, lies in [`Splat::attributes`].
pub const COLOR: Range<usize> = 3..6;
/// Number of continuous attributes of a splat.
pub const CONTINUOUS_ATTRIBUTES: usize = 6;

/// An elliptical disc in world space. Its points are `center + s·tangents[0] + t·tangents[1]` with `s² + t² < 1`, and
/// its kernel weight there is `exp(−γ(s² + t²))`: the tangents' lengths are the radii at which the kernel is cut off.
#[derive(Clone, Debug, PartialEq)]
pub struct Splat {
    /// Center **u**.
    pub center: [f32; 3],
    /// Tangent vectors **a**⁽¹⁾, **a**⁽²⁾; their cross product points out of the surface.
    pub tangents: [[f32; 3]; 2],
    /// Continuous attributes: [`NORMAL`], then [`COLOR`].
    pub attributes: [f32; CONTINUOUS_ATTRIBUTES],
    /// The cardinal attribute, never blended: an index into the scene's materials.
    pub material: u16,
}
