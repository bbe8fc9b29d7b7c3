//! Exact arithmetic: a splat's intersection with viewing rays, by another route than the hardware's.
//!
//! Every finite encoded number is an integer times a power of two, and so is every polynomial in such numbers. For the ray `λd` through a
//! sample, Cramer's rule on `u + s·a1 + t·a2 = λd` gives with `n = a1 × a2`
//!
//! ```text
//! s = −⟨d, u × a2⟩/⟨d, n⟩     t = ⟨d, u × a1⟩/⟨d, n⟩     λ = ⟨u, n⟩/⟨d, n⟩
//! ```
//!
//! so that whether a sample lies in the splat and before the eye is the sign of polynomials, found without rounding. Quotients and depths are
//! computed with [`PRECISION_BITS`] bits.

use super::case::Case;
use super::hit::{Depths, Hit, InRange};
use dashu_float::FBig;
use dashu_float::round::mode::Zero;
use pointcore_contract::splat::Feature;

/// Bits of what cannot be exact.
pub const PRECISION_BITS: usize = 256;

/// Numbers of unlimited precision.
type Real = FBig<Zero, 2>;

type Vector = [Real; 3];

/// The very value of a finite number.
fn exact(value: f64) -> Real {
    let real = Real::try_from(value).expect("only finite numbers have a truth");
    real.with_precision(0).value()
}

fn rounded(value: &Real) -> Real {
    value.clone().with_precision(PRECISION_BITS).value()
}

fn nearest(value: &Real) -> f64 {
    value.to_f64().value()
}

/// The quotient, infinite over zero.
fn quotient(numerator: &Real, denominator: &Real) -> f64 {
    let exists = *denominator != Real::ZERO;
    if exists { nearest(&(rounded(numerator) / rounded(denominator))) } else { f64::INFINITY }
}

fn cross([ax, ay, az]: &Vector, [bx, by, bz]: &Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn dot(a: &Vector, b: &Vector) -> Real {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// A splat in camera space whose numbers are all finite.
pub struct Exact {
    u: Vector,
    tangents: [Vector; 2],
    scale: Real,
    origin: [Real; 2],
    normal: Vector,
    /// `u × a2`, `u × a1`.
    crossed: [Vector; 2],
    /// `⟨u, n⟩`.
    facing: Real,
    filter: Feature,
    near: Real,
    /// `1 − depth_a` and `depth_b`.
    far: [Real; 2],
}

impl Exact {
    /// The splat of a case whose numbers are finite.
    #[must_use]
    pub fn new(case: &Case) -> Self {
        let numbers = case.numbers();
        let vector = |first: usize| [0, 1, 2].map(|i| exact(numbers[first + i]));
        let (u, a1, a2) = (vector(0), vector(3), vector(6));
        let normal = cross(&a1, &a2);
        Self {
            crossed: [cross(&u, &a2), cross(&u, &a1)],
            facing: dot(&u, &normal),
            normal,
            scale: exact(case.lens.scale),
            origin: case.lens.origin.map(exact),
            filter: case.filter,
            near: exact(case.lens.near),
            far: [Real::ONE - exact(case.lens.depth_a), exact(case.lens.depth_b)],
            u,
            tangents: [a1, a2],
        }
    }

    /// A pixel's ray `d`, as long as `scale`.
    fn ray(&self, pixel: [u32; 2]) -> Vector {
        let along = |axis: usize| exact(f64::from(pixel[axis]) + 0.5) - &self.origin[axis];
        [along(0), along(1), self.scale.clone()]
    }

    /// Where the ray through a pixel's sample goes.
    #[must_use]
    pub fn hit(&self, pixel: [u32; 2]) -> Hit {
        let ray = self.ray(pixel);
        let [s, t] = [0, 1].map(|i| dot(&ray, &self.crossed[i]));
        let determinant = dot(&ray, &self.normal);
        let range = self.range(&determinant);
        let in_front = range == InRange::Yes;
        let (numerator, denominator) = (&s * &s + &t * &t, &determinant * &determinant);
        let mut hit = Hit {
            is_inside: in_front && numerator < denominator,
            squared_distance: if in_front { quotient(&numerator, &denominator) } else { f64::INFINITY },
            range,
        };
        if self.filter.is_on() && self.is_center_shown() {
            let [x, y] = [0, 1].map(|axis| &self.scale * &self.u[axis] - &ray[axis] * &self.u[2]);
            let (numerator, denominator) = (&x * &x + &y * &y, &self.u[2] * &self.u[2]);
            hit.is_inside |= numerator < denominator;
            hit.squared_distance = hit.squared_distance.min(quotient(&numerator, &denominator));
        }
        hit
    }

    /// Where a ray with such a `⟨d, n⟩` meets the plane: `near < λ·scale` and `depth_a + depth_b/(λ·scale) ≤ 1`.
    fn range(&self, determinant: &Real) -> InRange {
        let zero = Real::ZERO;
        let (facing, determinant) = if self.facing < zero {
            (-self.facing.clone(), -determinant.clone())
        } else {
            (self.facing.clone(), determinant.clone())
        };
        if determinant <= zero || facing == zero {
            return InRange::Behind;
        }
        let reach = &facing * &self.scale;
        let is_within = &self.near * &determinant < reach && &self.far[1] * &determinant <= &self.far[0] * &reach;
        if is_within { InRange::Yes } else { InRange::No }
    }

    /// Whether the centre lies between near and far plane.
    #[must_use]
    pub fn is_center_shown(&self) -> bool {
        self.near < self.u[2] && self.far[1] <= &self.far[0] * &self.u[2]
    }

    /// `λ` in units of distance along the axis.
    #[must_use]
    pub fn distance(&self, pixel: [u32; 2]) -> f64 {
        quotient(&(&self.facing * &self.scale), &dot(&self.ray(pixel), &self.normal))
    }

    /// `⟨u, n⟩ > 0`.
    #[must_use]
    pub fn faces_away(&self) -> bool {
        self.facing > Real::ZERO
    }

    /// `α² + β² < 1`; the centre lies before the eye.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let [z, a, b] = [&self.u[2], &self.tangents[0][2], &self.tangents[1][2]];
        a * a + b * b < z * z
    }

    /// The plane through the eye and a pixel's column (axis 0) or row, at centre and tangents.
    fn along(&self, axis: usize, pixel: u32) -> Vector {
        let offset = &self.origin[axis] - exact(f64::from(pixel) + 0.5);
        [&self.u, &self.tangents[0], &self.tangents[1]].map(|v| &self.scale * &v[axis] + &offset * &v[2])
    }

    /// On which side of that plane the centre lies, and whether the splat, or the filter's disc, crosses it.
    #[must_use]
    pub fn crosses(&self, axis: usize, pixel: u32) -> (f64, bool) {
        let [center, a, b] = self.along(axis, pixel);
        let squared = &center * &center;
        let disc = self.filter.is_on() && squared < &self.u[2] * &self.u[2];
        let zero = Real::ZERO;
        let side = f64::from(u8::from(center > zero)) - f64::from(u8::from(center < zero));
        (side, disc || squared < &a * &a + &b * &b)
    }

    /// Depths of the centre, and of the range's middle.
    #[must_use]
    pub fn depths(&self, depth_a: f64, depth_b: f64) -> Depths {
        let [z, a, b] = [&self.u[2], &self.tangents[0][2], &self.tangents[1][2]].map(rounded);
        let r = rounded(&Real::ONE) / &z;
        let (alpha, beta) = (a * &r, b * &r);
        let q = &alpha * &alpha + &beta * &beta;
        let e = rounded(&Real::ONE) - &q;
        let b = exact(depth_b) * &r;
        let center = exact(depth_a) + &b;
        let middle = if e > Real::ZERO { nearest(&(&center + b * (q / e))) } else { f64::NAN };
        Depths { center: nearest(&center), middle }
    }
}
