//! The way of a sample over a moving splat, and the time for which it is covered.

use super::Frame;
use crate::compiler::{Value, name};
use crate::splat::parts::division::{recip, rsqrt, sqrt};
use crate::units::values::Values;
use pointcore_contract::splat::records::MovingFootprint;

/// The least squared speed that is one.
const STILL: f64 = 1.0 / (1_u64 << 60) as f64;

/// A line in the splat's plane: at `τ` the sample is `speed·τ + along` along it.
pub(super) struct Course {
    /// `D`.
    pub determinant: Value,
    pub squared_speed: Value,
    pub speed: Value,
    /// `1/speed`.
    pub slowness: Value,
    pub along: Value,
    /// Distance of line and centre, squared.
    pub across: Value,
    pub begin: Value,
    pub end: Value,
    pub inside: Value,
}

impl Course {
    /// Of the sample at these places along both axes, px, each with its fraction bits.
    pub fn new(frame: Frame, footprint: &MovingFootprint<Values>, places: [(Value, u32); 2]) -> Self {
        let Frame { config, program, format, zero, one } = frame;
        let number = |bits: Value| frame.number(bits);
        let offset = |axis: usize| {
            let (place, fraction) = places[axis];
            place.to_float(format, fraction) - number(footprint.center[axis])
        };
        let (x, y) = (offset(0), offset(1));
        let [of_x, of_y] = footprint.determinant.map(number);
        let determinant = one + x * of_x + y * of_y;
        let inverse = recip(config.division, determinant);
        let [s1, s2] = footprint.place.map(|form| {
            let [of_x, of_y] = form.map(number);
            (x * of_x + y * of_y) * inverse
        });
        let [g1, g2] = footprint.speed.map(|form| {
            let [center, of_x, of_y] = form.map(number);
            (center + x * of_x + y * of_y) * inverse
        });

        let least = frame.constant(STILL);
        let squared = g1 * g1 + g2 * g2;
        let still = squared.lt(least);
        let squared_speed = squared.max(least);
        let slowness = rsqrt(config.division, squared_speed);
        let speed = squared_speed * slowness;
        let u1 = still.mux(one, g1 * slowness);
        let u2 = still.mux(zero, g2 * slowness);
        let along = s1 * u1 + s2 * u2 - speed * number(footprint.time);
        let beside = s1 * u2 - s2 * u1;
        let across = beside * beside;
        let chord = one - across;
        let half = sqrt(config.division, program, format, chord);

        let [life_begin, life_end] = footprint.life.map(number);
        let mut begin = ((-half - along) * slowness).max(life_begin);
        let mut end = ((half - along) * slowness).min(life_end);
        if config.eye_plane.is_on() {
            let [from, to, offset] = footprint.planes.map(number);
            begin = begin.max(determinant * from - offset);
            end = end.min(determinant * to - offset);
        }
        let inside = zero.lt(chord) & begin.lt(end) & zero.lt(determinant);
        let _ = inside.named("covered");
        name!(x, y, determinant, speed, along, across, chord);
        Self { determinant, squared_speed, speed, slowness, along, across, begin, end, inside }
    }
}
