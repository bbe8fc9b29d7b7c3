//! When a moving splat is seen.

use super::{Frame, Moving};
use crate::compiler::{Value, name};
use crate::units::datapath::dot;

/// A splat's life.
pub(super) struct Life {
    pub begin: Value,
    pub end: Value,
    /// The origin of time.
    pub origin: Value,
    /// How much nearer and farther than its centre the splat's points lie.
    pub reach: Value,
    /// Distance of the far plane.
    pub far: Value,
    pub alive: Value,
}

impl Life {
    pub fn new(frame: &Frame, moving: &Moving) -> Self {
        let Moving { center, tangents: [a1, a2], motion, part: [part_begin, part_end] } = *moving;
        let cross = |i: usize, j: usize| a1[i] * a2[j] - a1[j] * a2[i];
        let normal = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let reach = frame.sqrt(a1[2] * a1[2] + a2[2] * a2[2]);
        let far = frame.depth_b * frame.recip(frame.one - frame.depth_a);
        let turning = dot(&motion, &normal);
        let turns = -dot(&center, &normal) * frame.recip(turning);
        let inverse = frame.recip(motion[2]);
        let near = frame.near_plane;
        let nears = (near - reach - center[2]) * inverse;
        let fars = (far + reach - center[2]) * inverse;
        let inner = (near - center[2]) * inverse;

        let away = frame.sign(turning);
        let approaching = frame.sign(motion[2]);
        let begins = away.mux(part_begin.max(turns), part_begin);
        let ends = away.mux(part_end, part_end.min(turns));
        let begin = begins.max(approaching.mux(fars, nears));
        let end = ends.min(approaching.mux(nears, fars));
        let first = approaching.mux(begin, begin.max(inner));
        let last = approaching.mux(end.min(inner), end);
        let origin = (first + last) * frame.constant(0.5);
        let alive = begin.lt(end) & first.lt(last);
        name!(reach, far, origin, alive);
        Self { begin, end, origin, reach, far, alive }
    }
}
