//! The way of a sample over a moving splat: a straight line, for its place along either tangent is linear in time, even in perspective.

use super::MotionEvaluation;
use crate::number::Number;
use crate::splat::parts::division::{recip, rsqrt, sqrt};
use crate::splat::parts::place;
use pointcore_contract::splat::records::MovingFootprint;

/// A smaller squared speed than this power of ½ is none.
const STILL: i64 = 60;

/// A sample's way: at `τ` it is `speed·τ + along` along the line and `across` beside the splat's centre, in kernel radii.
pub(super) struct Course {
    /// `D`.
    pub determinant: Number,
    /// Squared, 2^−60 at least.
    pub squared_speed: Number,
    pub speed: Number,
    /// `1/speed`.
    pub slowness: Number,
    /// At `τ = 0`.
    pub along: Number,
    /// Squared.
    pub across: Number,
    /// When the sample is covered, if it is inside.
    pub begin: Number,
    pub end: Number,
    pub is_inside: bool,
}

impl Course {
    /// Of the sample in a column and a row.
    pub fn new(unit: &MotionEvaluation, footprint: &MovingFootprint, sample: [u32; 2]) -> Self {
        let MotionEvaluation { geometry, sampling, division, .. } = *unit;
        let number = |bits: u32| unit.number(bits);
        let (zero, one) = (number(0), number(0).of(1.0));
        let position = place::position(geometry, sampling, sample);
        let [x, y] = [0, 1].map(|axis: usize| position[axis] - number(footprint.center[axis]));
        let [of_x, of_y] = footprint.determinant.map(number);
        let determinant = one + x * of_x + y * of_y;
        let inverse = recip(division, determinant);
        let [s1, s2] = footprint.place.map(|form| {
            let [of_x, of_y] = form.map(number);
            (x * of_x + y * of_y) * inverse
        });
        let [g1, g2] = footprint.speed.map(|form| {
            let [center, of_x, of_y] = form.map(number);
            (center + x * of_x + y * of_y) * inverse
        });

        let squared = g1 * g1 + g2 * g2;
        let least = one.raised(-STILL);
        let squared_speed = squared.max(least);
        let slowness = rsqrt(division, squared_speed);
        let speed = squared_speed * slowness;
        let [u1, u2] = if squared.is_below(least) { [one, zero] } else { [g1 * slowness, g2 * slowness] };
        let along = s1 * u1 + s2 * u2 - speed * number(footprint.time);
        let beside = s1 * u2 - s2 * u1;
        let across = beside * beside;
        let chord = one - across;
        let half = sqrt(division, chord);

        let [life_begin, life_end] = footprint.life.map(number);
        let mut begin = ((half.negated() - along) * slowness).max(life_begin);
        let mut end = ((half - along) * slowness).min(life_end);
        if unit.has_planes {
            let [from, to, offset] = footprint.planes.map(number);
            begin = begin.max(determinant * from - offset);
            end = end.min(determinant * to - offset);
        }
        let is_inside = zero.is_below(chord) && begin.is_below(end) && zero.is_below(determinant);
        Self { determinant, squared_speed, speed, slowness, along, across, begin, end, is_inside }
    }
}
