//! `ρ²` in fixed point: exact integers from a sample's offset to `s` and `D`, of which 18 bits are squared and divided.
//!
//! docs/stability.md bounds what all of it together moves `ρ²` by; a test below holds the bound against f64.

#[cfg(test)]
mod tests;

use crate::number::Number;
use crate::splat::setup::fixed_footprint::magnitude;
use pointcore_contract::splat::records::Footprint;
use pointcore_contract::splat::{Coefficient, Feature};
use pointcore_contract::{Fixed, Format};

/// Fraction bits of a sample's place: eighths of a pixel.
const EIGHTHS: u32 = 3;
/// Bits of a quotient's operands beyond those of the quotient.
const GUARD_BITS: u32 = 6;

/// What `ρ²` hangs on besides footprint and place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Distance {
    /// Widths.
    pub coefficient: Coefficient,
    /// Bits of `ρ²`.
    pub kernel_bits: u32,
    /// Whether samples behind the eye are outside.
    pub eye_plane: Feature,
    /// Whether there is a screen filter.
    pub screen_filter: Feature,
}

impl Distance {
    /// Leading bits of `ρ²` at a place given in eighths of a pixel, as a number of `f32`: infinite outside.
    pub fn squared(&self, footprint: &Footprint, place: [u32; 2], filter_scale: u32) -> Number {
        let offset = [0, 1].map(|axis| self.offset(footprint.center[axis], place[axis]));
        let on_splat = self.on_splat(footprint, offset);
        let has_disc = self.screen_filter.is_on() && (footprint.sight.disc || !self.eye_plane.is_on());
        let in_disc = has_disc.then(|| self.in_disc(offset, filter_scale)).flatten();
        let least = on_splat.into_iter().chain(in_disc).min();
        least.map_or_else(
            || Number::new(Format::F32, Format::F32.infinity() as u32),
            |squared| Number::from_fixed(Format::F32, squared, self.kernel_bits, self.kernel_bits),
        )
    }

    /// From the centre to a sample.
    fn offset(&self, center: u32, eighths: u32) -> i64 {
        let Fixed { width, fraction, .. } = self.coefficient.center();
        (i64::from(eighths) << (fraction - EIGHTHS)) - signed(center, width)
    }

    /// Leading bits of `ρ²` on the splat's plane; `None` outside the splat.
    fn on_splat(&self, footprint: &Footprint, offset: [i64; 2]) -> Option<u64> {
        let n = self.coefficient.width();
        let [x, y] = offset.map(|offset| signed((offset >> footprint.shift) as u32, n));
        let [[ax, ay], [bx, by], [mx, my]] =
            [[footprint.ax, footprint.ay], [footprint.bx, footprint.by], [footprint.mx, footprint.my]]
                .map(|pair| pair.map(|number| signed(number, n)));
        let delta = signed(footprint.delta, self.coefficient.delta_width());

        let determinant = (delta << self.coefficient.place_fraction()) + x * mx + y * my;
        let sight = &footprint.sight;
        let [first, second] = [x * ay - y * ax, x * by - y * bx];
        let (across, determinant) = if sight.turned { (determinant, first) } else { (first, determinant) };
        let along = [across, second].map(magnitude);
        let length = magnitude(determinant);
        if self.eye_plane.is_on() {
            let range = i64::from(sight.far)..=i64::from(sight.near);
            let is_seen = range.contains(&(length >> self.coefficient.place_fraction()));
            if (determinant < 0) != sight.negative || !is_seen {
                return None;
            }
        }
        let length_bits = i64::BITS - length.leading_zeros();
        if length == 0 || along.iter().any(|part| part >> length_bits != 0) {
            return None;
        }
        let significant = |number: i64| -> u64 {
            let number = number as u64;
            let kept = Coefficient::SIGNIFICANT_BITS;
            if length_bits < kept { number << (kept - length_bits) } else { number >> (length_bits - kept) }
        };
        let squares = along.map(|part| significant(part).pow(2));
        let (numerator, denominator) = (squares[0] + squares[1], significant(length).pow(2));
        if numerator >= denominator {
            return None;
        }
        let dropped = 2 * Coefficient::SIGNIFICANT_BITS - (self.kernel_bits + GUARD_BITS);
        let quotient = ((numerator >> dropped) << self.kernel_bits) / (denominator >> dropped);
        Some(quotient.min((1 << self.kernel_bits) - 1))
    }

    /// Leading bits of the squared distance in units of the screen filter's radius; `None` outside its disc.
    fn in_disc(&self, offset: [i64; 2], filter_scale: u32) -> Option<u64> {
        let narrow = self.coefficient.filter_offset();
        let dropped = self.coefficient.place_fraction() - narrow.fraction;
        let end = 1_i64 << (narrow.width - 1);
        let sum: u64 =
            offset.iter().map(|&offset| (offset >> dropped).clamp(-end, end - 1).unsigned_abs().pow(2)).sum();
        let square = Coefficient::FILTER_SQUARE;
        let kept = sum >> (2 * narrow.fraction - square.fraction);
        if kept >> square.width != 0 {
            return None;
        }
        let scaled = kept * u64::from(filter_scale);
        let fraction = square.fraction + Coefficient::FILTER_SCALE.fraction;
        (scaled >> fraction == 0).then(|| scaled >> (fraction - self.kernel_bits))
    }
}

/// The number that the low bits of a word are in two's complement.
const fn signed(word: u32, width: u32) -> i64 {
    let unused = u32::BITS - width;
    ((word << unused) as i32 >> unused) as i64
}
