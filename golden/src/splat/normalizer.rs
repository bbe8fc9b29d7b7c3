//! Normalizer: divides a pixel's sums by its weight (eq. 5.13) and tells where in the image it lies.
//!
//! One reciprocal in the geometry format; attributes are converted to it and back.

use super::attribute::Arithmetic;
use super::parts::cover::Cover;
use super::parts::division::recip;
use crate::datapath::{Datapath, Token};
use crate::number::Number;
use crate::unit::Model;
use pointcore_contract::Format;
use pointcore_contract::splat::config::{DEPTH_BITS, DEPTH_SUM_BITS, TILE_SIZE, WEIGHT_BITS, WEIGHT_SUM_BITS};
use pointcore_contract::splat::motion::{SHUTTER, TIME_BITS, TIME_FRACTION_BITS};
use pointcore_contract::splat::records::{
    Attributes, Bin, Contributions, FinishedPixel, Fragment, Pixel, Seen, Shutter,
};
pub use pointcore_contract::splat::units::normalizer::{In, Out};
use pointcore_contract::splat::{Config, Division};

const SIZE: u32 = TILE_SIZE;
/// Cycles that a bin takes, in which its nearest surface and the rest are divided.
const SURFACES_A_BIN: u32 = 2;

/// The normalizer.
#[derive(Clone, Debug)]
pub struct Normalizer {
    continuous: usize,
    geometry: Format,
    attribute: Arithmetic,
    division: Division,
    tile_column_bits: u32,
    bin_bits: u32,
    /// Bins of the exposure, none where nothing moves.
    bins: u32,
    datapath: Datapath<Fragment>,
}

impl Normalizer {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            continuous: config.continuous as usize,
            geometry: config.geometry,
            attribute: Arithmetic(config.attribute),
            division: config.division,
            tile_column_bits: config.tile_column_bits(),
            bin_bits: config.bin_bits(),
            bins: config.time_bins,
            datapath: Datapath::new(latency, if config.has_motion() { SURFACES_A_BIN } else { 1 }),
        }
    }

    fn normalize(&self, finished: &FinishedPixel, shutter: &Shutter) -> Fragment {
        if finished.end {
            return Fragment { end: true, ..Fragment::default() };
        }
        let placed = &finished.placed;
        let Pixel { weight, depth, attributes, ref bin, .. } = placed.value;
        let [tile_column, tile_row] =
            [placed.tile & ((1 << self.tile_column_bits) - 1), placed.tile >> self.tile_column_bits];
        let pixel = u32::from(placed.pixel);
        let (column, number) = (tile_column >> self.bin_bits, tile_column & ((1 << self.bin_bits) - 1));
        let column = column * SIZE + pixel % SIZE;
        let (depth, attributes) = self.surface(weight, depth, attributes);
        let seen = if self.bins > 0 {
            Seen { bin: number as u8, ..self.seen(bin, shutter.weight[number as usize]) }
        } else {
            Seen::default()
        };
        Fragment {
            end: false,
            column: column as u16,
            row: (tile_row * SIZE + pixel / SIZE) as u16,
            depth: depth.bits(),
            attributes,
            seen,
        }
    }

    /// Depth and attributes of sums of this weight.
    fn surface(&self, weight: u32, depth: u64, sums: Contributions) -> (Number, Attributes) {
        let r = recip(self.division, Number::from_fixed(self.geometry, weight.into(), WEIGHT_SUM_BITS, WEIGHT_BITS));
        let depth = Number::from_fixed(self.geometry, depth, DEPTH_SUM_BITS, WEIGHT_BITS + DEPTH_BITS) * r;
        let mut attributes = sums.map(|bits| bits as u32);
        for (attribute, sum) in attributes[..self.continuous].iter_mut().zip(sums) {
            *attribute = self.attribute.normalize(sum, r, self.geometry);
        }
        (depth, attributes)
    }

    /// What a bin that counts so much sees: for how long the nearest surface, and for how long the rest besides.
    fn seen(&self, bin: &Bin, counts: u32) -> Seen {
        let length = (1 << TIME_FRACTION_BITS) / self.bins;
        let seen = [(bin.nearest, bin.nearest_parts), (bin.any, bin.any_parts)];
        let [nearest, any] = seen.map(|(span, parts)| Cover { span, parts }.time(length));
        let share = |time: u32| {
            let counted = (u64::from(time) * u64::from(counts)) >> SHUTTER.fraction;
            counted.min((1 << TIME_BITS) - 1) as u32
        };
        let (depth, attributes) = self.surface(bin.weight, bin.depth, bin.attributes);
        let rest_share = share(any.saturating_sub(nearest));
        Seen { share: share(nearest), rest_share, depth: depth.bits(), attributes, ..Seen::default() }
    }
}

impl Model for Normalizer {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.datapath.in_ready(), out: self.datapath.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let accepted = inputs.input.as_ref().filter(|_| self.datapath.in_ready());
        let accepted = accepted.map(|pixel| self.normalize(pixel, &inputs.shutter));
        self.datapath.step(accepted.map(Token::Kept), inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::records::{Pixel, PlacedPixel};

    #[test]
    fn divides_by_the_weight() {
        let unit = Normalizer::new(&Config { continuous: 1, cardinal: 1, ..Config::default() }, 1);
        let mut attributes = [0; 14];
        attributes[..2].copy_from_slice(&[0x4500, 77]); // 5.0 in f16
        // A weight of 2 and a depth of ¾.
        let value = Pixel {
            weight: 2 << WEIGHT_BITS,
            depth: 3 << (WEIGHT_BITS + DEPTH_BITS - 1),
            peak: 1,
            attributes,
            ..Pixel::default()
        };
        let placed = PlacedPixel { tile: 3 << 5 | 9, pixel: 2 << 3 | 5, value };
        let fragment = unit.normalize(&FinishedPixel { end: false, placed }, &Shutter::default());
        assert_eq!((fragment.column, fragment.row, fragment.depth), (77, 26, 0.75_f32.to_bits()));
        assert_eq!(fragment.attributes[..2], [0x4100, 77]); // 2.5 in f16
    }
}
