//! What a frame is rendered with besides camera and splats: its size, its samples, the kernel and the depth test's tolerance.

use serde::{Deserialize, Serialize};

/// Where the samples of a frame lie. A frame is a grid of samples, `width` columns by `height` rows; the picture is made of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Sampling {
    /// A sample a pixel, in its middle: sample `(c, r)` at `(c + ½, r + ½)`.
    #[default]
    Center,
    /// FLIPQUAD \[AMS03\]: a sample on each side of a pixel, each shared by two pixels, so that two samples a pixel look like four. Columns `2i` hold
    /// the left sides of pixels, columns `2i + 1` the top sides: in row `r`, and with `p = (i + r) mod 2`, the samples at
    /// `(i, r + ⅝ − p/4)` and `(i + ⅜ + p/4, r)`. The pattern is mirrored at every side, so both pixels find the sample in the same place.
    Flipquad,
}

impl Sampling {
    /// Columns of samples a column of pixels takes.
    #[must_use]
    pub const fn columns(self) -> u32 {
        match self {
            Self::Center => 1,
            Self::Flipquad => 2,
        }
    }
}

/// What a sample's depth is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FragmentDepth {
    /// Its splat's: the middle of the splat's depth range, the same for all its samples (eq. 5.9).
    #[default]
    Center,
    /// That of the splat's plane at the sample, within the splat's depth range.
    Plane,
}

/// Parameters of one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rendering {
    /// Samples a row.
    pub width: usize,
    /// Rows of samples.
    pub height: usize,
    /// Where they lie.
    pub sampling: Sampling,
    /// What their depths are.
    pub depth: FragmentDepth,
    /// `γ` of the kernel `exp(−γρ²)`, cut off at `ρ = 1`.
    pub kernel_gamma: f64,
    /// Radius of the screen-space filter (thesis 5.4.2), under which no splat shrinks; `None` switches it off.
    pub filter_radius_px: Option<f64>,
    /// `ε_Δz` of eq. 5.9: scales a splat's own depth range.
    pub epsilon_scale: f64,
    /// `ε_bias` of eq. 5.9, in depth units.
    pub epsilon_bias: f64,
}

impl Rendering {
    /// The kernel's usual steepness: `exp(−2)`, about 14 %, is left where it is cut off.
    pub const DEFAULT_KERNEL_GAMMA: f64 = 2.0;
    /// The thesis' screen filter: bounds reach one pixel at least.
    pub const DEFAULT_FILTER_RADIUS_PX: f64 = 1.0;
    /// The thesis' setting of `ε_Δz`.
    pub const DEFAULT_EPSILON_SCALE: f64 = 1.0;
}
