//! What is true of a splat, as numbers.

/// Where a viewing ray meets a splat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// `ρ² < 1`, between near and far plane.
    pub is_inside: bool,
    /// `ρ²`; infinite elsewhere.
    pub squared_distance: f64,
    /// How the ray meets the splat's plane.
    pub range: InRange,
}

/// Where a viewing ray meets a splat's plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InRange {
    /// Between near and far plane.
    Yes,
    /// Before the eye, but not between them.
    No,
    /// Behind the eye.
    Behind,
}

/// Depths of a splat before clamping and truncation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depths {
    /// Of its centre.
    pub center: f64,
    /// The middle of its range, if it lies before the eye as a whole.
    pub middle: f64,
}
