//! Depth at the borders of bins, beside f64: a time is known to its last bit, and depth runs one way in time.

use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::motion::TIME_FRACTION_BITS;
use pointcore_contract::{Format, FragmentDepth};
use pointcore_golden::reference::motion::{MovingFootprint, Place};
use std::ops::RangeInclusive;

/// Roundings of distance, determinant and quotient, in units of half a last place of their terms.
const ROUNDINGS: f64 = 8.0;

/// What depth may be at a time as the record holds it, of a footprint whose numbers are exact, with the uniform `depth_a` and half a unit in the last
/// place of one; anything where rounding may have changed the distance's sign.
#[must_use]
pub fn range(
    footprint: &MovingFootprint,
    place: &Place,
    time: u32,
    [depth_a, unit]: [f64; 2],
    depth: FragmentDepth,
) -> RangeInclusive<f64> {
    let last = 0.5_f64.powi(DEPTH_BITS as i32);
    let met = footprint.meet(place);
    let terms: f64 = 1.0
        + [0, 1]
            .map(|i: usize| ((place.position[i] - footprint.center[i]) * footprint.determinant[i]).abs())
            .iter()
            .sum::<f64>();
    let (scale, of_scale) = match depth {
        FragmentDepth::Center => (footprint.depth_scale, footprint.depth_scale.abs()),
        FragmentDepth::Plane => {
            (footprint.depth_scale * met.determinant, footprint.depth_scale.abs() * (terms + met.determinant.abs()))
        }
    };
    let [constant, change] = footprint.distance;
    let step = 2.0 / f64::from(1 << TIME_FRACTION_BITS);
    let begin = step * f64::from(time) - 1.0;
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut sign = 0.0;
    for time in [begin - 4.0 * unit, begin + step + 4.0 * unit] {
        let distance = constant + time * change;
        let error = ROUNDINGS * unit * (constant.abs() + (time * change).abs());
        for distance in [distance - error, distance + error] {
            if distance == 0.0 || sign * distance < 0.0 {
                return 0.0..=1.0;
            }
            sign = distance.signum();
            let depth = depth_a + scale / distance;
            let error = ROUNDINGS * unit * (of_scale / distance.abs() + depth_a.abs());
            low = low.min(depth - error);
            high = high.max(depth + error);
        }
    }
    low.clamp(0.0, 1.0 - last) - last..=high.clamp(0.0, 1.0) + last
}

/// Half a unit in the last place of one.
#[must_use]
pub fn unit(format: Format) -> f64 {
    0.5_f64.powi(format.mantissa as i32 + 1)
}
