//! A projected splat's bounds and its weight at a pixel's sample, by backward or by forward mapping.

use super::projection::{Bounds, Culled, Projection};
use super::sampling;
use pointcore_contract::{FragmentDepth, Rendering, Sampling};

/// How a splat's kernel reaches the screen (thesis 3.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mapping {
    /// Each viewing ray is intersected with the splat's plane: exact in perspective, with the screen filter
    /// approximated by a minimum of distances (thesis 5.4.2). This is what the hardware computes.
    Backward,
    /// The kernel is mapped by the projection's Jacobian at the center, and convolved exactly with a Gaussian screen
    /// filter (eqs. 3.15 to 3.19).
    Forward,
}

/// Where and how strongly a splat is seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Footprint {
    /// The samples to look at.
    pub bounds: Bounds,
    center: [f64; 2],
    sampling: Sampling,
    kernel_gamma: f64,
    shape: Shape,
}

#[derive(Clone, Debug, PartialEq)]
enum Shape {
    Backward {
        projection: Box<Projection>,
        filter_radius_px: Option<f64>,
    },
    /// `ρ² = xx·x'² + 2·xy·x'y' + yy·y'²`.
    Forward {
        xx: f64,
        xy: f64,
        yy: f64,
        amplitude: f64,
    },
}

impl Footprint {
    /// The footprint of a splat.
    ///
    /// # Errors
    /// No sample of the viewport lies in the splat's bounds.
    pub fn new(projection: &Projection, rendering: &Rendering, mapping: Mapping) -> Result<Self, Culled> {
        let (bounds, shape) = match mapping {
            Mapping::Backward => backward(projection, rendering)?,
            Mapping::Forward => forward(projection, rendering)?,
        };
        let (sampling, kernel_gamma) = (rendering.sampling, rendering.kernel_gamma);
        Ok(Self { bounds, center: projection.center, sampling, kernel_gamma, shape })
    }

    /// Kernel weight at the sample in a column and a row; `None` outside the splat.
    #[must_use]
    pub fn weight(&self, column: usize, row: usize) -> Option<f64> {
        self.weight_at(self.squared_distance(column, row))
    }

    /// `ρ²` at the sample in a column and a row; below one inside the splat.
    #[must_use]
    pub fn squared_distance(&self, column: usize, row: usize) -> f64 {
        let [sample_x, sample_y] = sampling::position(self.sampling, column, row);
        let (x, y) = (sample_x - self.center[0], sample_y - self.center[1]);
        match &self.shape {
            Shape::Backward { projection, filter_radius_px } => {
                let on_splat = squared_distance_on_splat(projection, x, y);
                let filter_radius_px = filter_radius_px.filter(|_| projection.is_centered);
                let on_screen = filter_radius_px.map_or(f64::INFINITY, |radius| (x * x + y * y) / (radius * radius));
                on_splat.min(on_screen)
            }
            Shape::Forward { xx, xy, yy, .. } => xx * x * x + 2.0 * xy * x * y + yy * y * y,
        }
    }

    /// How near a sample at `ρ²` comes to another outcome: to the edge of its splat, or within that to near or far plane.
    #[must_use]
    pub fn edge(&self, column: usize, row: usize, squared_distance: f64) -> f64 {
        let edge = (squared_distance - 1.0).abs();
        let Shape::Backward { projection, .. } = &self.shape else { return edge };
        let [x, y] = sampling::position(self.sampling, column, row);
        edge.min(projection.margin(x - self.center[0], y - self.center[1]).abs())
    }

    /// Depth of the sample in a column and a row.
    #[must_use]
    pub fn depth(&self, projection: &Projection, rendering: &Rendering, column: usize, row: usize) -> f64 {
        match rendering.depth {
            FragmentDepth::Center => projection.depth,
            FragmentDepth::Plane => {
                let [x, y] = sampling::position(self.sampling, column, row);
                projection.plane_depth(x - self.center[0], y - self.center[1])
            }
        }
    }

    /// Kernel weight at `ρ²`; `None` outside the splat.
    #[must_use]
    pub fn weight_at(&self, squared_distance: f64) -> Option<f64> {
        let amplitude = match &self.shape {
            Shape::Backward { .. } => 1.0,
            Shape::Forward { amplitude, .. } => *amplitude,
        };
        (squared_distance < 1.0).then(|| amplitude * (-self.kernel_gamma * squared_distance).exp())
    }
}

/// `ρ²` where the viewing ray through `c + (x, y)` meets the splat's plane between near and far plane, else infinity.
///
/// Solving `x = (s·A_x + t·B_x)/w`, `y` alike, for `(s, t)` by Cramer's rule has the determinant
/// `D = Δ + x(β·A_y − α·B_y) + y(α·B_x − β·A_x)`, where `Δ = A_x·B_y − B_x·A_y`, and gives `w = Δ/D`: the hit lies in
/// front of the eye iff `D` and `Δ` have one sign.
fn squared_distance_on_splat(projection: &Projection, x: f64, y: f64) -> f64 {
    if projection.margin(x, y) < 0.0 {
        return f64::INFINITY;
    }
    if let Some(squared) = projection.squared_in_camera_space(x, y) {
        return squared;
    }
    let ([ax, bx], [ay, by]) = (projection.gradient_x, projection.gradient_y);
    let [alpha, beta] = projection.slant;
    let delta = ax * by - bx * ay;
    let determinant = delta + x * (beta * ay - alpha * by) + y * (alpha * bx - beta * ax);
    if determinant * delta > 0.0 {
        let (s1, s2) = (x * ay - y * ax, x * by - y * bx);
        (s1 * s1 + s2 * s2) / (determinant * determinant)
    } else {
        f64::INFINITY
    }
}

/// The corners `[x, y]` of the rectangle around all that is seen of a splat and its filter, px; `None` where it reaches the eye plane and may be
/// seen anywhere.
pub(super) fn extent(projection: &Projection, filter_radius_px: f64) -> Option<[[f64; 2]; 2]> {
    if projection.crosses_eye_plane() || projection.is_center_before_near() {
        return None;
    }
    let [alpha, beta] = projection.slant;
    let e = projection.eye_clearance();
    let filter = filter_radius_px;
    let along = |center: f64, [a, b]: [f64; 2]| {
        let middle = -(a * alpha + b * beta) / e;
        let half = (middle * middle + (a * a + b * b) / e).sqrt();
        let low = if projection.is_centered { (middle - half).min(-filter) } else { middle - half };
        let high = if projection.is_centered { (middle + half).max(filter) } else { middle + half };
        (center + low, center + high)
    };
    let (low_x, high_x) = along(projection.center[0], projection.gradient_x);
    let (low_y, high_y) = along(projection.center[1], projection.gradient_y);
    Some([[low_x, low_y], [high_x, high_y]])
}

fn backward(projection: &Projection, rendering: &Rendering) -> Result<(Bounds, Shape), Culled> {
    let bounds = match extent(projection, rendering.filter_radius_px.unwrap_or(0.0)) {
        Some([low, high]) => Bounds::of_samples(low, high, rendering)?,
        None => Bounds::viewport(rendering),
    };
    Ok((bounds, Shape::Backward { projection: Box::new(*projection), filter_radius_px: rendering.filter_radius_px }))
}

/// `A_x … B_y` form the Jacobian `J` of eq. 3.15 at the center. A screen filter of weight `exp(−γ·dist²/radius²)` has
/// in units of `1/(2γ)` the variance `radius²·I`, the kernel has `J·Jᵀ`, and their convolution the sum `V`
/// (eq. 3.19): `ρ² = x'ᵀ·V⁻¹·x'`, with an amplitude of `sqrt(|J·Jᵀ| / |V|)` that keeps the kernel's volume.
fn forward(projection: &Projection, rendering: &Rendering) -> Result<(Bounds, Shape), Culled> {
    if !projection.is_centered {
        return Err(Culled::OutsideDepth);
    }
    let ([ax, bx], [ay, by]) = (projection.gradient_x, projection.gradient_y);
    let filter_variance = rendering.filter_radius_px.unwrap_or(0.0).powi(2);
    let (vxx, vxy, vyy) = (ax * ax + bx * bx + filter_variance, ax * ay + bx * by, ay * ay + by * by + filter_variance);
    let jacobian = ax * by - bx * ay;
    let determinant = vxx * vyy - vxy * vxy;
    // A splat seen edge-on has no area on the screen, hence no weight.
    if jacobian == 0.0 || determinant <= 0.0 {
        return Err(Culled::OutsideViewport);
    }
    let ([cx, cy], hx, hy) = (projection.center, vxx.sqrt(), vyy.sqrt());
    let bounds = Bounds::of_samples([cx - hx, cy - hy], [cx + hx, cy + hy], rendering)?;
    let amplitude = jacobian.abs() / determinant.sqrt();
    Ok((bounds, Shape::Forward { xx: vyy / determinant, xy: -vxy / determinant, yy: vxx / determinant, amplitude }))
}
