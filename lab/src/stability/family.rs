//! Kinds of hard cases.

use serde::Serialize;

/// What makes a case hard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Family {
    /// Nothing: ellipses of aspect up to four, turned anyhow, a few pixels wide. The severity does not matter.
    Ordinary,
    /// Tangents nearly parallel.
    Parallel,
    /// One tangent or both as good as zero.
    Vanishing,
    /// Tangents whose lengths differ by up to a million.
    Ratio,
    /// The eye nearly in the splat's plane.
    EdgeOn,
    /// The centre at the eye plane, or behind it.
    Behind,
    /// The splat's rim at the eye plane: an ellipse becomes a parabola, then a hyperbola.
    Crossing,
    /// The splat's rim at the near plane.
    NearPlane,
    /// Up to billions of times the size of the screen.
    Huge,
    /// Down to a billionth of a pixel.
    Tiny,
    /// Far off the axis and out of the view, the rim in it.
    OffAxis,
    /// Near the far plane of ever deeper views, where depths run together.
    Depth,
    /// Ordinary, but measured in units of 1e-30 to 1e30.
    Magnitude,
    /// Infinities, NaNs, subnormals, zeros of both signs, largest numbers, in ever more fields.
    Odd,
    /// Fields of random bits.
    Noise,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 15] = [
        Self::Ordinary,
        Self::Parallel,
        Self::Vanishing,
        Self::Ratio,
        Self::EdgeOn,
        Self::Behind,
        Self::Crossing,
        Self::NearPlane,
        Self::Huge,
        Self::Tiny,
        Self::OffAxis,
        Self::Depth,
        Self::Magnitude,
        Self::Odd,
        Self::Noise,
    ];

    /// Its name in files and keys.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ordinary => "ordinary",
            Self::Parallel => "parallel",
            Self::Vanishing => "vanishing",
            Self::Ratio => "ratio",
            Self::EdgeOn => "edge_on",
            Self::Behind => "behind",
            Self::Crossing => "crossing",
            Self::NearPlane => "near_plane",
            Self::Huge => "huge",
            Self::Tiny => "tiny",
            Self::OffAxis => "off_axis",
            Self::Depth => "depth",
            Self::Magnitude => "magnitude",
            Self::Odd => "odd",
            Self::Noise => "noise",
        }
    }
}
