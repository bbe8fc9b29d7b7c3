//! When a moving splat is seen: while it faces the eye, some of it lies between near and far plane, and it is there at all.

use super::{Dropped, MotionSetup, MotionUniforms, Moving};
use crate::number::Number;

/// A splat's life.
pub(super) struct Life {
    pub begin: Number,
    pub end: Number,
    /// The middle of the time for which the centre lies beyond the near plane.
    pub origin: Number,
    /// How much nearer and farther than its centre the splat's points lie.
    pub reach: Number,
    /// Distance of the far plane.
    pub far: Number,
    /// Why there is none.
    pub dropped: Option<Dropped>,
}

fn dot(a: [Number; 3], b: [Number; 3]) -> Number {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Life {
    pub fn of(unit: &MotionSetup, moving: &Moving, uniforms: &MotionUniforms) -> Self {
        let number = |bits: u32| unit.number(bits);
        let Moving { center, tangents: [a1, a2], motion, part: [part_begin, part_end] } = *moving;
        let normal = [a1[1] * a2[2] - a1[2] * a2[1], a1[2] * a2[0] - a1[0] * a2[2], a1[0] * a2[1] - a1[1] * a2[0]];
        let reach = unit.sqrt(a1[2] * a1[2] + a2[2] * a2[2]);
        let near = number(uniforms.near_plane);
        let far = number(uniforms.viewport.depth_b) * unit.recip(unit.one() - number(uniforms.viewport.depth_a));
        let turning = dot(motion, normal);
        let turns = dot(center, normal).negated() * unit.recip(turning);
        let inverse = unit.recip(motion[2]);
        let nears = (near - reach - center[2]) * inverse;
        let fars = (far + reach - center[2]) * inverse;
        let inner = (near - center[2]) * inverse;

        let is_approaching = motion[2].is_negative();
        let (begins, ends) =
            if turning.is_negative() { (part_begin.max(turns), part_end) } else { (part_begin, part_end.min(turns)) };
        let (enters, leaves) = if is_approaching { (fars, nears) } else { (nears, fars) };
        let (begin, end) = (begins.max(enters), ends.min(leaves));
        let (first, last) = if is_approaching { (begin, end.min(inner)) } else { (begin.max(inner), end) };
        let origin = (first + last) * begin.of(0.5);
        let is_alive = begin.is_below(end) && first.is_below(last);
        let middle = (part_begin + part_end) * begin.of(0.5);
        let is_beyond_far = far.is_below(center[2] + middle * motion[2] - reach);
        let reason = match () {
            () if !begins.is_below(ends) => Dropped::Facing,
            () if is_beyond_far => Dropped::Far,
            () => Dropped::Near,
        };
        Self { begin, end, origin, reach, far, dropped: (!is_alive).then_some(reason) }
    }
}
