//! Footprints in fixed point: what setup makes of a splat's coefficients for a rasterizer that computes with integers.
//!
//! Two's complement. `A`, `B`, `Δ` and `m` share one power of two, since `ρ²` does not depend on it; offsets have another, `shift`, by which
//! the farthest sample within the bounds comes to `n` bits. Rounded to the nearest, ties away from zero; only what rounds up to one
//! saturates. A coefficient that is no number, a centre thousands of pixels away, and a `Δ` that is rounding make all coefficients
//! zero, so that no sample is covered.

use super::sight::Limits;
use crate::number::Number;
use pointcore_contract::Fixed;
use pointcore_contract::splat::Coefficient;
use pointcore_contract::splat::records::Footprint;
use std::ops::Range;

/// Biased exponent of numbers from one half to one.
const HALF: i64 = 126;
/// Biased exponent of infinities and NaNs.
const NOT_FINITE: u64 = 255;

/// The numbers of a footprint, in the geometry format.
#[derive(Clone, Copy, Debug)]
pub struct Projection {
    /// Projected center (px).
    pub center: [Number; 2],
    /// `A_x`, `A_y`.
    pub a: [Number; 2],
    /// `B_x`, `B_y`.
    pub b: [Number; 2],
    /// `Δ`; `None` of a splat seen edge-on.
    pub delta: Option<Number>,
    /// `m_x`, `m_y`.
    pub m: [Number; 2],
    /// What of it is seen.
    pub limits: Limits,
}

/// A footprint without its depth, for pixels in these columns and rows.
#[must_use]
pub fn footprint(coefficient: Coefficient, projection: &Projection, pixels: [Range<u64>; 2]) -> Footprint {
    let place = coefficient.center();
    let limit = HALF as u64 + u64::from(Coefficient::CENTER_INTEGER_BITS);
    let is_placed = projection.center.iter().all(|center| center.exponent_field() < limit);
    let farthest = -1_i64 << (place.width - 1);
    let center = projection.center.map(|center| if is_placed { rounded(center, 0, place) } else { farthest });

    let edges = [0, 1].map(|axis: usize| {
        let Range { start, end } = &pixels[axis];
        [start, end].map(|&edge| ((edge as i64) << place.fraction) - center[axis])
    });
    let reach = edges.iter().flatten().fold(0, |reach, &edge| reach | magnitude(edge));
    let reach_bits = i64::BITS - reach.leading_zeros();
    let shift = reach_bits.saturating_sub(coefficient.width() - 1);

    let zeros = Footprint {
        center: center.map(|center| truncated(center, place.width)),
        shift: shift as u8,
        sight: projection.limits.sight([0; 2]),
        ..Footprint::default()
    };
    let Some(delta) = projection.delta.filter(|_| is_placed) else { return zeros };
    let lengths = [projection.a, projection.b, projection.m];
    let all = lengths.iter().flatten().chain([&delta]);
    if all.into_iter().any(|number| number.exponent_field() == NOT_FINITE) {
        return zeros;
    }
    let longer = i64::from(shift + coefficient.delta_width() - coefficient.width());
    let exponent = lengths.iter().flatten().map(|length| length.exponent_field() as i64);
    let exponent = exponent.chain([delta.exponent_field() as i64 - longer]).fold(0, i64::max);

    let width = coefficient.width();
    let [a, b, m] = lengths.map(|pair| pair.map(|length| fraction(length, HALF - exponent, width)));
    let delta_width = coefficient.delta_width();
    let delta = fraction(delta, HALF - exponent - longer, delta_width);
    if delta.unsigned_abs() < coefficient.delta_least().into() {
        return zeros;
    }
    let [[ax, ay], [bx, by], [mx, my]] = [a, b, m].map(|pair| pair.map(|length| truncated(length, width)));
    // In units of `Δ`, and as many bits with no sign.
    let units =
        |limit: Number| limit.abs().raised(HALF - exponent - longer).to_fixed(delta_width, delta_width - 1) as u32;
    let [near, far] = projection.limits.planes;
    let near = near.map_or(u32::MAX >> (u32::BITS - delta_width), units);
    let sight = projection.limits.sight([near, far.map_or(0, units)]);
    Footprint { ax, bx, ay, by, delta: truncated(delta, delta_width), mx, my, sight, ..zeros }
}

/// Bits that tell how far a number reaches: its own, or inverted ones if it is negative.
pub(in crate::splat) const fn magnitude(number: i64) -> i64 {
    if number < 0 { !number } else { number }
}

/// `number · 2^scale` of a magnitude below one as a signed fraction.
fn fraction(number: Number, scale: i64, width: u32) -> i64 {
    let fraction = width - 1;
    let shape = Fixed { width, fraction, signed: pointcore_contract::Signedness::Signed };
    rounded(number, scale, shape)
}

/// `number · 2^scale` in units of a fixed-point format that has the range for it, but for a number that rounds up to its end.
fn rounded(number: Number, scale: i64, format: Fixed) -> i64 {
    // Twice as fine: the last bit says which way to round.
    let places = i64::from(number.scale()) + scale + i64::from(format.fraction) + 1;
    let significand = number.significand();
    let halves = match places {
        0.. => significand << places,
        _ => significand.checked_shr(places.unsigned_abs() as u32).unwrap_or(0),
    };
    let units = halves.div_ceil(2) as i64;
    let largest = (1 << (format.width - 1)) - 1;
    if number.is_negative() { -units } else { units.min(largest) }
}

/// The low bits of a number in two's complement.
const fn truncated(number: i64, width: u32) -> u32 {
    (number as u64 & (u64::MAX >> (u64::BITS - width))) as u32
}
