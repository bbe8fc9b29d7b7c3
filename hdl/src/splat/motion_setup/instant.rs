//! A moving splat at an instant, in pixels and distances about its projected centre.

use super::{Frame, Moving};
use crate::compiler::Value;
use crate::splat::setup::axes::clearance;

/// What the image shows.
pub(super) struct Instant {
    /// Reciprocal distance of the centre.
    pub r: Value,
    pub center: [Value; 2],
    pub a: [Value; 2],
    pub b: [Value; 2],
    pub m: [Value; 2],
    pub alpha: Value,
    pub beta: Value,
    pub mu: Value,
    /// `α² + β²`.
    pub squared: Value,
    /// `1/(1 − α² − β²)`.
    pub reciprocal: Value,
    /// All of the splat lies before the eye.
    pub whole: Value,
}

impl Instant {
    pub fn new(frame: &Frame, moving: &Moving, time: Value) -> Self {
        let Moving { center, tangents: [first, second], motion, .. } = *moving;
        let w = [0, 1, 2].map(|axis: usize| center[axis] + time * motion[axis]);
        let r = frame.recip(w[2]);
        let [alpha, beta, mu] = [first, second, motion].map(|vector| vector[2] * r);
        let Frame { scale, origin, .. } = *frame;
        let v = [w[0] * r, w[1] * r];
        let image = |vector: [Value; 3], lean: Value| {
            [0, 1].map(|axis: usize| scale[axis] * (vector[axis] * r - v[axis] * lean))
        };
        let squared = alpha * alpha + beta * beta;
        let e = frame.one - squared;
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
            reciprocal: frame.recip(e),
            whole: frame.constant(clearance(frame.format)).lt(e),
        }
    }
}
