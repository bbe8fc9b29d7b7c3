//! Normalizer: divides a pixel's sums by its weight (eq. 5.13) and tells where in the image it lies.
//!
//! One reciprocal in the geometry format; attributes are converted to it and back.

use super::attribute::Arithmetic;
use super::parts::division::recip;
use crate::datapath::{Datapath, Token};
use crate::number::Number;
use crate::unit::Model;
use pointcore_contract::Format;
use pointcore_contract::splat::config::{DEPTH_BITS, DEPTH_SUM_BITS, TILE_SIZE, WEIGHT_BITS, WEIGHT_SUM_BITS};
use pointcore_contract::splat::records::{FinishedPixel, Fragment};
pub use pointcore_contract::splat::units::normalizer::{In, Out};
use pointcore_contract::splat::{Config, Division};

const SIZE: u32 = TILE_SIZE;

/// The normalizer.
#[derive(Clone, Debug)]
pub struct Normalizer {
    continuous: usize,
    geometry: Format,
    attribute: Arithmetic,
    division: Division,
    tile_column_bits: u32,
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
            datapath: Datapath::new(latency, 1),
        }
    }

    fn normalize(&self, finished: &FinishedPixel) -> Fragment {
        if finished.end {
            return Fragment { end: true, ..Fragment::default() };
        }
        let placed = &finished.placed;
        let sums = placed.value.attributes;
        let weight = u64::from(placed.value.weight);
        let r = recip(self.division, Number::from_fixed(self.geometry, weight, WEIGHT_SUM_BITS, WEIGHT_BITS));
        let depth = Number::from_fixed(self.geometry, placed.value.depth, DEPTH_SUM_BITS, WEIGHT_BITS + DEPTH_BITS) * r;
        let mut attributes = sums.map(|bits| bits as u32);
        for (attribute, sum) in attributes[..self.continuous].iter_mut().zip(sums) {
            *attribute = self.attribute.normalize(sum, r, self.geometry);
        }
        let [tile_column, tile_row] =
            [placed.tile & ((1 << self.tile_column_bits) - 1), placed.tile >> self.tile_column_bits];
        let pixel = u32::from(placed.pixel);
        Fragment {
            end: false,
            column: (tile_column * SIZE + pixel % SIZE) as u16,
            row: (tile_row * SIZE + pixel / SIZE) as u16,
            depth: depth.bits(),
            attributes,
        }
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
        let accepted = inputs.input.as_ref().filter(|_| self.datapath.in_ready()).map(|pixel| self.normalize(pixel));
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
        let value = Pixel { weight: 2 << WEIGHT_BITS, depth: 3 << (WEIGHT_BITS + DEPTH_BITS - 1), peak: 1, attributes };
        let placed = PlacedPixel { tile: 3 << 5 | 9, pixel: 2 << 3 | 5, value };
        let fragment = unit.normalize(&FinishedPixel { end: false, placed });
        assert_eq!((fragment.column, fragment.row, fragment.depth), (77, 26, 0.75_f32.to_bits()));
        assert_eq!(fragment.attributes[..2], [0x4100, 77]); // 2.5 in f16
    }
}
