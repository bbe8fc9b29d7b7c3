//! What a frame is rendered with besides camera and splats: its size, the kernel and the depth test's tolerance.

/// Parameters of one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rendering {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
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
