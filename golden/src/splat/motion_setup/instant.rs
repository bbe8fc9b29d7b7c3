//! A moving splat at an instant, as the image shows it.

use super::{MotionSetup, MotionUniforms, Moving};
use crate::number::Number;
use pointcore_contract::Format;

/// `e` up to this power of ½ counts as crossing the eye plane, in a format as precise as `f32`, and in others.
const CLEARANCE: [i64; 2] = [12, 5];

/// Tangents and motion in pixels and distances, about the projected centre.
pub(super) struct Instant {
    /// Reciprocal distance of the centre.
    pub r: Number,
    pub center: [Number; 2],
    pub a: [Number; 2],
    pub b: [Number; 2],
    pub m: [Number; 2],
    pub alpha: Number,
    pub beta: Number,
    pub mu: Number,
    /// `α² + β²`.
    pub squared: Number,
    /// `1/(1 − α² − β²)`.
    pub reciprocal: Number,
    /// All of the splat lies before the eye.
    pub is_whole: bool,
}

impl Instant {
    pub fn of(unit: &MotionSetup, moving: &Moving, time: Number, uniforms: &MotionUniforms) -> Self {
        let Moving { center, tangents: [first, second], motion, .. } = *moving;
        let w = [0, 1, 2].map(|axis: usize| center[axis] + time * motion[axis]);
        let r = unit.recip(w[2]);
        let [alpha, beta, mu] = [first, second, motion].map(|vector| vector[2] * r);
        let scale = uniforms.viewport.scale.map(|bits| unit.number(bits));
        let origin = uniforms.viewport.origin.map(|bits| unit.number(bits));
        let v = [w[0] * r, w[1] * r];
        let image = |vector: [Number; 3], lean: Number| {
            [0, 1].map(|axis: usize| scale[axis] * (vector[axis] * r - v[axis] * lean))
        };
        let squared = alpha * alpha + beta * beta;
        let e = unit.one() - squared;
        let is_fine = r.format().mantissa >= Format::F32.mantissa;
        let clearance = unit.one().raised(-CLEARANCE[usize::from(!is_fine)]);
        Self {
            r,
            center: [0, 1].map(|axis| scale[axis] * v[axis] + origin[axis]),
            a: image(first, alpha),
            b: image(second, beta),
            m: image(motion, mu),
            alpha,
            beta,
            mu,
            squared,
            reciprocal: unit.recip(e),
            is_whole: clearance.is_below(e),
        }
    }
}
