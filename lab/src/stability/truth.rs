//! The truth about a case. Decisions are exact: f64 arithmetic with a bound on its own error decides what it can, and [`Exact`] the rest.

use super::case::Case;
use super::exact::Exact;
use super::hit::{Depths, Hit, InRange};
use super::rounding::Bounded;
use pointcore_contract::splat::{Division, Feature};
use std::cell::OnceCell;
use std::ops::RangeInclusive;

/// An f64 depth or distance with a smaller error than this stands for the true one: by far less than any bound of the hardware.
const NEGLIGIBLE: f64 = 1.0 / (1_u64 << 38) as f64;

/// How close to near or far plane, as a share of the distance, is a matter of rounding.
const PLANE_RIM: f64 = 1.0 / 64.0;

/// On which side of a rectangle a line lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// At lower pixels.
    Below,
    /// At higher ones.
    Above,
}

type Vector = [Bounded; 3];

fn cross([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn dot(a: Vector, b: Vector) -> Bounded {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A splat in camera space whose numbers are all finite.
pub struct Truth {
    case: Case,
    numbers: [f64; 9],
    u: Vector,
    tangents: [Vector; 2],
    normal: Vector,
    crossed: [Vector; 2],
    facing: Bounded,
    exact: OnceCell<Exact>,
}

impl Truth {
    /// `None` if a number is not finite.
    #[must_use]
    pub fn new(case: &Case) -> Option<Self> {
        let numbers = case.numbers();
        if numbers.iter().any(|number| !number.is_finite()) {
            return None;
        }
        let vector = |first: usize| [0, 1, 2].map(|i| Bounded::in_f64(numbers[first + i]));
        let (u, a1, a2) = (vector(0), vector(3), vector(6));
        let normal = cross(a1, a2);
        Some(Self {
            case: *case,
            numbers,
            crossed: [cross(u, a2), cross(u, a1)],
            facing: dot(u, normal),
            normal,
            u,
            tangents: [a1, a2],
            exact: OnceCell::new(),
        })
    }

    /// The same in exact arithmetic.
    pub fn exact(&self) -> &Exact {
        self.exact.get_or_init(|| Exact::new(&self.case))
    }

    fn offset(&self, axis: usize, pixel: u32) -> f64 {
        // Both are multiples of a small power of two: the difference is exact.
        f64::from(pixel) + 0.5 - self.case.lens.origin[axis]
    }

    fn ray(&self, pixel: [u32; 2]) -> Vector {
        [self.offset(0, pixel[0]), self.offset(1, pixel[1]), self.case.lens.scale].map(Bounded::in_f64)
    }

    /// Where the ray through a pixel's sample goes; `ρ²` to within `tolerance`, on which side of one exactly.
    #[must_use]
    pub fn hit(&self, pixel: [u32; 2], tolerance: f64) -> Hit {
        self.quick_hit(pixel, tolerance).unwrap_or_else(|| self.exact().hit(pixel))
    }

    /// The hit, if f64 leaves no doubt about it.
    #[must_use]
    pub fn quick_hit(&self, pixel: [u32; 2], tolerance: f64) -> Option<Hit> {
        let ray = self.ray(pixel);
        let determinant = dot(ray, self.normal);
        let range = self.range(determinant)?;
        let mut squared = (range == InRange::Yes).then(|| {
            let [s, t] = [0, 1].map(|i| dot(ray, self.crossed[i]));
            (s * s + t * t) / (determinant * determinant)
        });
        if self.case.filter == Feature::On && self.is_center_shown()? {
            let scale = ray[2];
            let [x, y] = [0, 1].map(|axis| scale * self.u[axis] - ray[axis] * self.u[2]);
            let disc = (x * x + y * y) / (self.u[2] * self.u[2]);
            // Only where it is plain which of the two is less.
            squared = Some(match squared {
                Some(splat) if (splat - disc).sign()? < 0.0 => splat,
                _ => disc,
            });
        }
        let Some(squared) = squared else {
            return Some(Hit { is_inside: false, squared_distance: f64::INFINITY, range });
        };
        let is_tolerable = squared.error <= tolerance;
        is_tolerable.then_some(Hit { is_inside: !squared.is_above(1.0)?, squared_distance: squared.value, range })
    }

    /// Where the plane is met, if f64 leaves no doubt.
    fn range(&self, determinant: Bounded) -> Option<InRange> {
        if determinant.sign()? != self.facing.sign()? {
            return Some(InRange::Behind);
        }
        let lens = &self.case.lens;
        let (reach, determinant) = (self.facing.abs() * Bounded::in_f64(lens.scale), determinant.abs());
        let beyond_near = (reach - Bounded::in_f64(lens.near) * determinant).sign()? > 0.0;
        let [slack, scale] = [1.0 - lens.depth_a, lens.depth_b].map(Bounded::in_f64);
        let before_far = (slack * reach - scale * determinant).sign()? > 0.0;
        Some(if beyond_near && before_far { InRange::Yes } else { InRange::No })
    }

    /// Whether the centre lies between near and far plane, if f64 leaves no doubt.
    fn is_center_shown(&self) -> Option<bool> {
        let lens = &self.case.lens;
        let [slack, scale] = [1.0 - lens.depth_a, lens.depth_b].map(Bounded::in_f64);
        let before_far = (slack * self.u[2] - scale).sign()? > 0.0;
        Some(self.numbers[2] > lens.near && before_far)
    }

    /// Whether the sample comes so close to near or far plane, as a share of its distance, that which side it is on is a matter of rounding.
    #[must_use]
    pub fn is_at_plane(&self, pixel: [u32; 2]) -> bool {
        let (lens, distance) = (&self.case.lens, self.distance(pixel));
        let far = lens.depth_b / (1.0 - lens.depth_a);
        [lens.near, far].iter().any(|plane| (distance / plane - 1.0).abs() < PLANE_RIM)
    }

    /// Distance along the axis at which a pixel's ray meets the splat's plane; negative behind the eye.
    #[must_use]
    pub fn distance(&self, pixel: [u32; 2]) -> f64 {
        let distance = self.facing * Bounded::in_f64(self.case.lens.scale) / dot(self.ray(pixel), self.normal);
        let is_negligible = distance.error <= distance.value.abs() * NEGLIGIBLE;
        if is_negligible { distance.value } else { self.exact().distance(pixel) }
    }

    /// Whether the splat turns its back to the eye.
    #[must_use]
    pub fn faces_away(&self) -> bool {
        self.facing.sign().map_or_else(|| self.exact().faces_away(), |sign| sign > 0.0)
    }

    /// Whether every point of the splat lies before the eye plane.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let [z, a, b] = [self.u[2], self.tangents[0][2], self.tangents[1][2]];
        let clearance = z * z - (a * a + b * b);
        self.numbers[2] > 0.0 && clearance.sign().map_or_else(|| self.exact().is_whole(), |sign| sign > 0.0)
    }

    /// Whether the open splat, all of it before the eye, or the filter's disc reaches to or beyond the line through the samples of a column
    /// (axis 0) or row, which lies on `side` of its rectangle.
    #[must_use]
    pub fn reaches(&self, axis: usize, pixel: u32, side: Side) -> bool {
        let (center, crosses) = self.quick_crosses(axis, pixel).unwrap_or_else(|| self.exact().crosses(axis, pixel));
        let is_wrong = match side {
            Side::Below => center <= 0.0,
            Side::Above => center >= 0.0,
        };
        is_wrong || crosses
    }

    /// As [`Exact::crosses`], if f64 leaves no doubt.
    fn quick_crosses(&self, axis: usize, pixel: u32) -> Option<(f64, bool)> {
        let (scale, offset) = (Bounded::in_f64(self.case.lens.scale), Bounded::in_f64(-self.offset(axis, pixel)));
        let [center, a, b] = [self.u, self.tangents[0], self.tangents[1]].map(|v| scale * v[axis] + offset * v[2]);
        let squared = center * center;
        let disc = self.case.filter == Feature::On && (squared - self.u[2] * self.u[2]).sign()? < 0.0;
        Some((center.sign()?, disc || (squared - (a * a + b * b)).sign()? < 0.0))
    }

    /// Depths of the centre, and of the range's middle; the centre lies before the eye.
    #[must_use]
    pub fn depths(&self) -> Depths {
        let [depth_a, depth_b] = [self.case.lens.depth_a, self.case.lens.depth_b];
        let quick = || {
            let r = self.u[2].recip(Division::Rounded);
            let (alpha, beta) = (self.tangents[0][2] * r, self.tangents[1][2] * r);
            let q = alpha * alpha + beta * beta;
            let e = Bounded::in_f64(1.0) - q;
            let b = Bounded::in_f64(depth_b) * r;
            let center = Bounded::in_f64(depth_a) + b;
            let middle = (e.sign()? > 0.0).then(|| center + b * (q / e));
            let is_negligible = [Some(center), middle].into_iter().flatten().all(|depth| depth.error <= NEGLIGIBLE);
            is_negligible
                .then(|| Depths { center: center.value, middle: middle.map_or(f64::NAN, |middle| middle.value) })
        };
        quick().unwrap_or_else(|| self.exact().depths(depth_a, depth_b))
    }

    /// Where on the line through the samples of a column (axis 0) or row some may lie inside: an estimate, one pixel more at both ends.
    #[must_use]
    pub fn chord(&self, axis: usize, pixel: u32) -> Option<RangeInclusive<i64>> {
        let (other, scale) = (1 - axis, self.case.lens.scale);
        let offset = -self.offset(axis, pixel);
        let [u, a, b] = [0, 3, 6].map(|first| &self.numbers[first..first + 3]);
        let along = |v: &[f64]| scale * v[axis] + offset * v[2];
        let [f, fa, fb] = [along(u), along(a), along(b)];
        let squared = fa * fa + fb * fb;
        let rest = 1.0 - f * f / squared;
        if squared == 0.0 || rest.is_nan() || rest < 0.0 {
            return None;
        }
        let half = (rest / squared).sqrt();
        let ends = [half, -half].map(|half| {
            let (s, t) = (-f * fa / squared - half * fb, -f * fb / squared + half * fa);
            let at = |i: usize| u[i] + s * a[i] + t * b[i];
            scale * at(other) / at(2) + self.case.lens.origin[other] - 0.5
        });
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        (low.is_finite() && high.is_finite()).then(|| (low.floor() as i64)..=(high.ceil() as i64))
    }
}
