//! What of a moving splat a sample needs, as setup of hardware has it (docs/units/splat/motion_setup.md), in f64.
//!
//! With the origin of time `τ₀`, the center `u = u(τ₀)` and `r = 1/u_z` every vector has an image `(scale_x(w_x·r − v_x·w_z·r), …, w_z·r)`,
//! `v = u·r`: the tangents `(A, α)` and `(B, β)`, the motion `(M, μ)`. In these terms the viewing ray through `c + (x, y)` is `(x, y, 1)`, and the center
//! `(0, 0, 1)`, so the forms of [`disc`](super::disc) lose what cancels. All of them are divided by `Δ = A_x·B_y − B_x·A_y`.

use super::distance::SquaredDistance;
use super::interval::Interval;
use super::kernel::{Moving, Way};
use super::{MovingSplat, Place};
use crate::number::Number;
use crate::reference::projection::{Bounds, CROSSING_CLEARANCE, Culled};
use pointcore_contract::splat::records;
use pointcore_contract::{Camera, Format, FragmentDepth, Rendering};

/// A change of the distance by less than this part of it in a unit of `τ` is taken for one by so much, where near and far plane are met.
const LEAST_CHANGE: f64 = 1.0 / (1 << 20) as f64;

/// What of a moving splat a sample needs; as [`records::MovingFootprint`].
#[derive(Clone, Debug, PartialEq)]
pub struct MovingFootprint {
    /// Projected center at the origin of time, px.
    pub center: [f64; 2],
    /// The origin of time `τ₀`: the middle of the time for which the center lies beyond the near plane.
    pub time: f64,
    /// `m_x/Δ`, `m_y/Δ`.
    pub determinant: [f64; 2],
    /// `(B_y, −B_x)/Δ` and `(−A_y, A_x)/Δ`.
    pub place: [[f64; 2]; 2],
    /// Change of both places times `D`: at the center, and by the pixel.
    pub speed: [[f64; 3]; 2],
    /// What depth is divided by, at `τ = 0`, and its change.
    pub distance: [f64; 2],
    /// What is divided.
    pub depth_scale: f64,
    /// While some of it is seen.
    pub life: Interval,
    /// Where near and far plane are met: from the first times `D`, less the third, to the second times `D`, less the third.
    pub planes: [f64; 3],
    /// The samples it may reach.
    pub bounds: Bounds,
}

/// What the footprint is to a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Met {
    /// `D`.
    pub determinant: f64,
    /// Place on the splat at the origin of time, in kernel radii.
    pub place: [f64; 2],
    /// Its change in a unit of `τ`.
    pub speed: [f64; 2],
    /// While the sample may be covered: life, less what lies beyond near and far plane.
    pub life: Option<Interval>,
}

impl MovingFootprint {
    /// Of a moving splat.
    ///
    /// # Errors
    /// As [`Kernel::new`](super::Kernel::new), and [`Culled::OutsideDepth`] where the center never lies beyond the near plane.
    pub fn new(moving: &MovingSplat, camera: &Camera, rendering: &Rendering) -> Result<Self, Culled> {
        Self::of(&Moving::new(moving, camera, rendering)?, camera, rendering)
    }

    /// Of a splat in camera space.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn along(way: &Way, camera: &Camera, rendering: &Rendering) -> Result<Self, Culled> {
        Self::of(&Moving::along(way, camera, rendering)?, camera, rendering)
    }

    fn of(shape: &Moving, camera: &Camera, rendering: &Rendering) -> Result<Self, Culled> {
        let bounds = shape.bounds(camera, rendering)?;
        let Moving { center: at_zero, motion, tangents: [first, second], life, .. } = *shape;
        let origin = life.where_positive(at_zero.z - camera.near, motion.z).ok_or(Culled::OutsideDepth)?.middle();
        let u = at_zero + origin * motion;
        let r = 1.0 / u.z;
        let scale = [camera.scale_x, camera.scale_y];
        let image = |w: glam::DVec3| {
            let [x, y] = [0, 1].map(|axis: usize| scale[axis] * (w[axis] * r - u[axis] * r * w.z * r));
            [x, y, w.z * r]
        };
        let ([a_x, a_y, alpha], [b_x, b_y, beta], [m_x, m_y, mu]) = (image(first), image(second), image(motion));
        let per_area = 1.0 / (a_x * b_y - b_x * a_y);
        let normal = [beta * a_y - alpha * b_y, alpha * b_x - beta * a_x].map(|part| part * per_area);
        let change = m_x * normal[0] + m_y * normal[1] + mu;
        let moved = |[x, y, z]: [f64; 3], sign: f64| {
            [m_y * x - m_x * y, mu * y - m_y * z, m_x * z - mu * x].map(|part| sign * per_area * part)
        };
        let slant = 1.0 - alpha * alpha - beta * beta;
        let of_center = if slant > CROSSING_CLEARANCE { 1.0 / slant } else { 1.0 };
        let of_depth = if rendering.depth == FragmentDepth::Center { (mu, of_center) } else { (change, 1.0) };
        Ok(Self {
            center: [scale[0] * u.x * r + camera.center_x, scale[1] * u.y * r + camera.center_y],
            time: origin,
            determinant: normal,
            place: [[b_y, -b_x].map(|part| part * per_area), [-a_y, a_x].map(|part| part * per_area)],
            speed: [moved([b_x, b_y, beta], 1.0), moved([a_x, a_y, alpha], -1.0)],
            distance: [1.0 - origin * of_depth.0, of_depth.0],
            depth_scale: camera.depth_b * r * of_depth.1,
            life,
            planes: Self::planes(shape, change, origin, u.z, camera),
            bounds,
        })
    }

    /// `λ = u_z(1 + (τ − τ₀)ν)/D` lies between near and far plane; what all of the splat does all the time needs no limit.
    fn planes(shape: &Moving, change: f64, origin: f64, distance: f64, camera: &Camera) -> [f64; 3] {
        let (a, b) = (camera.depth_a, camera.depth_b);
        let [near, far] = [-b / a, b / (1.0 - a)];
        let reach = shape.tangents[0].z.hypot(shape.tangents[1].z);
        let ends = [shape.life.begin, shape.life.end].map(|time| shape.center.z + time * shape.motion.z);
        let is_beyond_near = ends[0].min(ends[1]) - reach >= near;
        let is_before_far = ends[0].max(ends[1]) + reach <= far;
        let change = change.abs().max(LEAST_CHANGE).copysign(change);
        let limit = |limit: f64| limit / (distance * change);
        let none = f64::INFINITY.copysign(change);
        let near = if is_beyond_near { -none } else { limit(near) };
        let far = if is_before_far { none } else { limit(far) };
        let [begin, end] = if change > 0.0 { [near, far] } else { [far, near] };
        [begin, end, 1.0 / change - origin]
    }

    /// What it is to the sample at a place.
    #[must_use]
    pub fn meet(&self, place: &Place) -> Met {
        let [x, y] = [0, 1].map(|axis| place.position[axis] - self.center[axis]);
        let determinant = 1.0 + x * self.determinant[0] + y * self.determinant[1];
        let [begin, end, offset] = self.planes;
        let [begin, end] = [determinant * begin - offset, determinant * end - offset];
        let life = Interval::new(self.life.begin.max(begin), self.life.end.min(end)).filter(|_| determinant > 0.0);
        Met {
            determinant,
            place: self.place.map(|form| (x * form[0] + y * form[1]) / determinant),
            speed: self.speed.map(|form| (form[0] + x * form[1] + y * form[2]) / determinant),
            life,
        }
    }

    /// Depth at a time for a sample with that `D`.
    #[must_use]
    pub fn depth(&self, time: f64, determinant: f64, camera: &Camera, rendering: &Rendering) -> f64 {
        let scale = if rendering.depth == FragmentDepth::Plane { determinant } else { 1.0 };
        camera.depth_a + scale * self.depth_scale / (self.distance[0] + time * self.distance[1])
    }

    /// Rounded to a format.
    #[must_use]
    pub fn encoded(&self, format: Format) -> records::MovingFootprint {
        let number = |value: f64| Number::new(Format::F32, (value as f32).to_bits()).convert(format).bits();
        let Interval { begin, end } = self.life;
        records::MovingFootprint {
            center: self.center.map(number),
            time: number(self.time),
            determinant: self.determinant.map(number),
            place: self.place.map(|form| form.map(number)),
            speed: self.speed.map(|form| form.map(number)),
            distance: self.distance.map(number),
            depth_scale: number(self.depth_scale),
            life: [begin, end].map(number),
            planes: self.planes.map(number),
        }
    }

    /// The numbers of a record, bounds aside.
    #[must_use]
    pub fn decoded(record: &records::MovingFootprint, format: Format, bounds: Bounds) -> Self {
        let value = |bits: u32| f64::from(Number::new(format, bits).value());
        let [begin, end] = record.life.map(value);
        Self {
            center: record.center.map(value),
            time: value(record.time),
            determinant: record.determinant.map(value),
            place: record.place.map(|form| form.map(value)),
            speed: record.speed.map(|form| form.map(value)),
            distance: record.distance.map(value),
            depth_scale: value(record.depth_scale),
            life: Interval { begin, end },
            planes: record.planes.map(value),
            bounds,
        }
    }
}

impl Met {
    /// `ρ²(τ)`; the origin of time is `τ₀`.
    #[must_use]
    pub fn squared_distance(&self, origin: f64) -> SquaredDistance {
        SquaredDistance::of([0, 1].map(|k| self.place[k] - origin * self.speed[k]), self.speed)
    }
}
