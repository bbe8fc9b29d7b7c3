//! Transform and rasterization setup of one splat (thesis tables 5.1 and 5.2), in a form recentred on the splat.
//!
//! With camera-space center `u`, tangents `a1`, `a2` and `r = 1/u_z`, a point `u + s·a1 + t·a2` of the splat has
//!
//! ```text
//! w(s, t) = Z/u_z      = 1 + s·α + t·β                  α = a1_z·r, β = a2_z·r
//! x' = x_px − c_x      = (s·A_x + t·B_x) / w(s, t)      A_x = scale_x(a1_x·r − v_x·α), v_x = u_x·r
//! ```
//!
//! and likewise in y, with `c` the projected center. The thesis works with the rows `t_i` of `PS`; dividing them by
//! `u_z` and moving the origin to `c` gives the same bounds and intersections from small differences instead of large
//! coordinates, which is what lets a narrow number format carry them.
//!
//! The line `x' = const` touches the unit circle in `(s, t)` iff `x'² = (A_x − x'α)² + (B_x − x'β)²`. With
//! `e = 1 − α² − β²` its two solutions are `p ± h`, `p = −(A_x·α + B_x·β)/e` and `h² = p² + (A_x² + B_x²)/e`.
//! They bound the splat iff `w > 0` on all of it, i.e. `e > 0`. Near zero `e` says nothing in a narrow number format and
//! the bounds exceed any viewport, so a splat counts as crossing the eye plane up to [`CROSSING_CLEARANCE`].
//!
//! Depth is `depth_a + depth_b·r/w`. With `m = sqrt(α² + β²)`, `w` ranges over `1 ± m`, so `1/w` ranges over
//! `(1 ± m)/e`, whose middle is `1 + m²/e` and whose half width is `m/e`.
//!
//! A splat that crosses the eye plane has no such bounds: it may cover any pixel and reaches from the near plane
//! backwards, so its bounds are the viewport. Where the depth range begins before the near plane its middle says nothing
//! about what is seen: such a splat's depth is its center's, and its half depth range is that of a splat with `m/e = 1`, but
//! no more than 1, since depths lie in `0..=1`; with a center before the near plane these are 0 and 1.
//!
//! Near and far plane cut a splat sample by sample. A center before the near plane is no origin for what lies beyond: such a splat
//! meets viewing rays in camera space, by Cramer's rule.

use super::sampling;
use glam::DVec3;
use pointcore_contract::{Camera, Rendering, Splat};
use std::ops::Range;

/// The largest `e` of a splat that counts as crossing the eye plane.
pub const CROSSING_CLEARANCE: f64 = 1.0 / 4096.0;

/// The largest half depth range.
const HALF_DEPTH_MAX: f64 = 1.0;

/// Why a splat is not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Culled {
    /// The eye is behind the splat's plane: `⟨u, a1 × a2⟩ > 0`.
    BackFacing,
    /// All of it lies before the near plane or behind the far plane.
    OutsideDepth,
    /// The bounds hold no sample.
    OutsideViewport,
}

/// The samples that may lie inside a splat. Neither range is empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// Columns of samples.
    pub columns: Range<usize>,
    /// Rows of samples.
    pub rows: Range<usize>,
}

impl Bounds {
    /// The samples of the viewport, of whole pixels, that lie in the closed rectangle `low..=high`, given in pixels as `[x, y]`.
    pub(super) fn of_samples(low: [f64; 2], high: [f64; 2], rendering: &Rendering) -> Result<Self, Culled> {
        let (nearest, farthest) = sampling::reach(rendering.sampling);
        let axis = |axis: usize, samples: usize, size: usize| {
            // A float-to-integer cast saturates, which is the clipping to the viewport at zero.
            let start = (low[axis] - farthest).ceil() as usize;
            let end = ((high[axis] - nearest).floor() + 1.0) as usize;
            start.saturating_mul(samples)..end.saturating_mul(samples).min(size)
        };
        let columns = rendering.sampling.columns() as usize;
        let bounds = Self { columns: axis(0, columns, rendering.width), rows: axis(1, 1, rendering.height) };
        if bounds.columns.is_empty() || bounds.rows.is_empty() { Err(Culled::OutsideViewport) } else { Ok(bounds) }
    }

    /// The whole viewport.
    pub(super) fn viewport(rendering: &Rendering) -> Self {
        Self { columns: 0..rendering.width, rows: 0..rendering.height }
    }
}

/// A splat after transformation and setup.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// The origin `c`, px: the projected center, or where the camera's axis is if the center lies before the near plane.
    pub center: [f64; 2],
    /// `(A_x, B_x)`, px.
    pub gradient_x: [f64; 2],
    /// `(A_y, B_y)`, px.
    pub gradient_y: [f64; 2],
    /// `(α, β)`: the tangents' depth relative to the center's.
    pub slant: [f64; 2],
    /// Depth `z_s` that the ternary test and the accumulation use: the middle of the splat's depth range.
    pub depth: f64,
    /// Half the splat's depth range, `h_z` of eq. 5.9.
    pub half_depth: f64,
    /// Depth at the center.
    center_depth: f64,
    /// Change of depth for a change of `1/w` from the center's.
    depth_scale: f64,
    /// The splat's depth range; the whole of it where the splat begins before the near plane.
    depth_range: [f64; 2],
    /// Whether all of it lies beyond the near plane, and before the far one.
    is_within: [bool; 2],
    /// The center lies between both.
    pub is_centered: bool,
    /// What meets viewing rays, of a splat whose center lies before the near plane.
    plane: Option<Plane>,
}

/// A splat in camera space as viewing rays meet it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plane {
    /// The camera's scale, and its depths.
    scale: [f64; 2],
    depth: [f64; 2],
    /// `a1 × a2`, `a2 × u`, `u × a1`.
    forms: [DVec3; 3],
    /// `⟨u, a1 × a2⟩`.
    volume: f64,
}

impl Plane {
    /// Of the ray through `(x, y)` px from the axis, `ρ²` and depth.
    fn hit(&self, x: f64, y: f64) -> (f64, f64) {
        let [x, y] = [x / self.scale[0], y / self.scale[1]];
        let [of_u, of_a1, of_a2] = self.forms.map(|form| form.dot(DVec3::new(x, y, 1.0)));
        let inverse = of_u / self.volume;
        let squared = (of_a1 * of_a1 + of_a2 * of_a2) / (of_u * of_u);
        (if inverse > 0.0 { squared } else { f64::INFINITY }, self.depth[0] + self.depth[1] * inverse)
    }
}

/// Center and tangents of a splat in camera space.
pub(super) fn in_camera_space(splat: &Splat, camera: &Camera) -> (DVec3, [DVec3; 2]) {
    let rotate = |v: DVec3| DVec3::from_array(camera.model_view.map(|row| DVec3::from_slice(&row).dot(v)));
    let translation = DVec3::from_array(camera.model_view.map(|row| row[3]));
    let tangents = splat.tangents.map(|tangent| rotate(DVec3::from_array(tangent.map(f64::from))));
    (rotate(DVec3::from_array(splat.center.map(f64::from))) + translation, tangents)
}

impl Projection {
    /// Transforms a splat into camera space, culls it and sets it up.
    ///
    /// # Errors
    /// The splat faces away from the eye or lies outside the depth range.
    pub fn new(splat: &Splat, camera: &Camera) -> Result<Self, Culled> {
        let (u, tangents) = in_camera_space(splat, camera);
        let [a1, a2] = tangents;
        if u.dot(a1.cross(a2)) > 0.0 {
            return Err(Culled::BackFacing);
        }
        let projection = Self::set_up(u, tangents, camera);
        let reach = a1.z.hypot(a2.z);
        let begins_behind_far = u.z > reach && camera.depth_a + camera.depth_b / (u.z - reach) > 1.0;
        if u.z + reach <= camera.near || (begins_behind_far && !projection.is_centered) {
            return Err(Culled::OutsideDepth);
        }
        Ok(projection)
    }

    /// Sets up a splat of this center and these tangents in camera space, whatever side of it is seen and wherever it lies.
    pub(super) fn set_up(u: DVec3, [a1, a2]: [DVec3; 2], camera: &Camera) -> Self {
        let r = 1.0 / u.z;
        let center_depth = camera.depth_a + camera.depth_b * r;
        let is_beyond_near = u.z > camera.near;
        let is_centered = is_beyond_near && (0.0..=1.0).contains(&center_depth);
        let (vx, vy) = (u.x * r, u.y * r);
        let (alpha, beta) = (a1.z * r, a2.z * r);
        let gradient =
            |scale: f64, v: f64, a1: f64, a2: f64| [scale * (a1 * r - v * alpha), scale * (a2 * r - v * beta)];
        let squared_slant = alpha * alpha + beta * beta;
        let e = 1.0 - squared_slant;
        let depth_scale = camera.depth_b * r;
        let range = (center_depth + depth_scale * squared_slant / e, depth_scale.abs() * squared_slant.sqrt() / e);
        let beyond_near = e > CROSSING_CLEARANCE && range.0 - range.1 >= 0.0;
        let before_far = e > CROSSING_CLEARANCE && range.0 + range.1 <= 1.0;
        let (depth, half_depth) = match (beyond_near, is_beyond_near) {
            (true, _) => range,
            (_, true) => (center_depth, depth_scale.abs().min(HALF_DEPTH_MAX)),
            _ => (0.0, HALF_DEPTH_MAX),
        };
        let plane = Plane {
            scale: [camera.scale_x, camera.scale_y],
            depth: [camera.depth_a, camera.depth_b],
            forms: [a1.cross(a2), a2.cross(u), u.cross(a1)],
            volume: u.dot(a1.cross(a2)),
        };
        let depth_range = if beyond_near { [depth - half_depth, depth + half_depth] } else { [0.0, 1.0] };
        Self {
            center: if is_beyond_near {
                [camera.scale_x * vx + camera.center_x, camera.scale_y * vy + camera.center_y]
            } else {
                [camera.center_x, camera.center_y]
            },
            gradient_x: gradient(camera.scale_x, vx, a1.x, a2.x),
            gradient_y: gradient(camera.scale_y, vy, a1.y, a2.y),
            slant: [alpha, beta],
            depth,
            half_depth,
            center_depth,
            depth_scale,
            depth_range,
            is_within: [beyond_near, before_far],
            is_centered,
            plane: (!is_beyond_near).then_some(plane),
        }
    }

    /// Depth of the splat's plane where the viewing ray through `c + (x, y)` meets it, within the splat's range: `1/w = D/Δ` there, which is
    /// linear on the screen. A splat seen edge-on has its center's.
    #[must_use]
    pub(super) fn plane_depth(&self, x: f64, y: f64) -> f64 {
        let [near, far] = self.depth_range;
        self.unlimited_depth(x, y).max(near).min(far)
    }

    /// The same beyond the range, too.
    fn unlimited_depth(&self, x: f64, y: f64) -> f64 {
        if let Some(plane) = &self.plane {
            return plane.hit(x, y).1;
        }
        let ([ax, bx], [ay, by], [alpha, beta]) = (self.gradient_x, self.gradient_y, self.slant);
        let delta = ax * by - bx * ay;
        let slope = (x * (beta * ay - alpha * by) + y * (alpha * bx - beta * ax)) / delta;
        self.center_depth + self.depth_scale * if delta == 0.0 { 0.0 } else { slope }
    }

    /// How far the splat's plane lies from a limit where the viewing ray through `c + (x, y)` meets it in depth; positive between near and far plane, infinite where no part of the splat lies beyond.
    pub(super) fn margin(&self, x: f64, y: f64) -> f64 {
        let depth = self.unlimited_depth(x, y);
        let [beyond_near, before_far] = self.is_within;
        let near = if beyond_near { f64::INFINITY } else { depth };
        near.min(if before_far { f64::INFINITY } else { 1.0 - depth })
    }

    /// `ρ²` where the viewing ray through `c + (x, y)` meets a splat whose center lies before the near plane.
    pub(super) fn squared_in_camera_space(&self, x: f64, y: f64) -> Option<f64> {
        self.plane.as_ref().map(|plane| plane.hit(x, y).0)
    }

    /// Whether the center lies before the near plane: the origin is another, and there are no bounds.
    pub(super) fn is_center_before_near(&self) -> bool {
        self.plane.is_some()
    }

    /// `e`: positive if the splat lies wholly in front of the eye plane.
    pub(super) fn eye_clearance(&self) -> f64 {
        let [alpha, beta] = self.slant;
        1.0 - alpha * alpha - beta * beta
    }

    /// Whether part of the splat lies behind the eye plane, or too close to it to tell.
    #[must_use]
    pub fn crosses_eye_plane(&self) -> bool {
        self.eye_clearance() <= CROSSING_CLEARANCE
    }
}
