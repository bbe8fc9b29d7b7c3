//! A disc that moves along a line, as viewing rays meet it.
//!
//! With center `u(τ) = u0 + τ·m` and constant tangents `a1`, `a2` in camera space the ray `d` meets it where
//! `u + s·a1 + t·a2 = λ·d`. With `n = a1 × a2` and `D = ⟨d, n⟩`
//!
//! ```text
//! s(τ) = −⟨d, u(τ) × a2⟩/D     t(τ) = ⟨d, u(τ) × a1⟩/D     λ(τ) = ⟨u(τ), n⟩/D
//! ```
//!
//! All three are linear in `τ`, for `D` does not depend on it. This is thesis eqs. 4.15 to 4.17 without an inverse, which motion in the splat's own
//! plane would make singular.

use super::distance::SquaredDistance;
use glam::DVec3;

/// What of a moving disc meets rays; of each pair, the first is that at `τ = 0`, the second its change in a unit of `τ`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MovingDisc {
    /// `−u × a2`.
    along_first: [DVec3; 2],
    /// `u × a1`.
    along_second: [DVec3; 2],
    /// `n`.
    normal: DVec3,
    /// `⟨u, n⟩`.
    volume: [f64; 2],
}

/// Where a ray meets a moving disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meeting {
    pub squared_distance: SquaredDistance,
    /// `λ`, the distance from the eye plane, at `τ = 0` and its change.
    pub distance: [f64; 2],
}

impl MovingDisc {
    pub(super) fn new(center: DVec3, motion: DVec3, [first, second]: [DVec3; 2]) -> Self {
        let normal = first.cross(second);
        Self {
            along_first: [second.cross(center), second.cross(motion)],
            along_second: [center.cross(first), motion.cross(first)],
            normal,
            volume: [center.dot(normal), motion.dot(normal)],
        }
    }

    /// `⟨u, n⟩` at `τ = 0` and its change: positive while the disc faces away from the eye.
    pub(super) const fn volume(&self) -> [f64; 2] {
        self.volume
    }

    /// Where the ray through `d`, whose third component is 1, meets it; `None` for a ray in a plane parallel to the disc's.
    pub(super) fn meet(&self, ray: DVec3) -> Option<Meeting> {
        let determinant = ray.dot(self.normal);
        if determinant == 0.0 {
            return None;
        }
        let [first, second] =
            [self.along_first, self.along_second].map(|forms| forms.map(|form| ray.dot(form) / determinant));
        Some(Meeting {
            squared_distance: SquaredDistance::of([first[0], second[0]], [first[1], second[1]]),
            distance: self.volume.map(|volume| volume / determinant),
        })
    }
}
