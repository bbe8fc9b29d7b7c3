//! What is true of a splat, as numbers.

/// Where a viewing ray meets a splat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// `ρ² < 1`, before the eye.
    pub is_inside: bool,
    /// `ρ²`; infinite behind the eye.
    pub squared_distance: f64,
}

/// Depths of a splat before clamping and truncation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depths {
    /// Of its centre.
    pub center: f64,
    /// The middle of its range, if it lies before the eye as a whole.
    pub middle: f64,
}
