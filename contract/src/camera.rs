//! The viewing transformation that both cores' hosts hand to the hardware: model-view, perspective and viewport.

/// A pinhole camera. Camera space has x to the right, y down and z forward, so it is right-handed like the world, and
/// pixel rows grow downwards. Pixel `(i, j)` is sampled at `(i + ½, j + ½)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Rows of the rigid map from world to camera space; the last column translates.
    pub model_view: [[f64; 4]; 3],
    /// `x_px = scale_x · X/Z + center_x`.
    pub scale_x: f64,
    /// `y_px = scale_y · Y/Z + center_y`.
    pub scale_y: f64,
    /// The optical axis' pixel abscissa.
    pub center_x: f64,
    /// The optical axis' pixel ordinate.
    pub center_y: f64,
    /// `depth = depth_a + depth_b / Z`: 0 at the near plane, 1 at the far plane.
    pub depth_a: f64,
    /// See [`Camera::depth_a`]; negative, since depth grows with distance.
    pub depth_b: f64,
    /// Distance of the near plane from the eye.
    pub near: f64,
}
