//! Weighting unit: what a sample contributes to its pixel's sums (eq. 5.10).
//!
//! The weighted depth is an exact integer product, and so is a weighted attribute in fixed point; one in floating point is multiplied by
//! the weight rounded to its format. Cardinal ones pass.

use super::attribute::Arithmetic;
use crate::datapath::{Datapath, Token};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Sample, WeightedSample};
pub use pointcore_contract::splat::units::weighting::{In, Out};

/// The weighting unit.
#[derive(Clone, Debug)]
pub struct Weighting {
    continuous: usize,
    attribute: Arithmetic,
    datapath: Datapath<WeightedSample>,
}

impl Weighting {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            continuous: config.continuous as usize,
            attribute: Arithmetic(config.attribute),
            datapath: Datapath::new(latency, 1),
        }
    }

    /// A sample with its contributions.
    #[must_use]
    pub fn weigh(&self, sample: &Sample) -> WeightedSample {
        let Sample { place, band, time, attributes } = *sample;
        let mut contributions = attributes.map(u64::from);
        for (contribution, attribute) in contributions[..self.continuous].iter_mut().zip(attributes) {
            *contribution = self.attribute.weigh(place.weight, attribute);
        }
        let weighted_depth = u64::from(place.weight) * u64::from(band.depth);
        WeightedSample {
            place,
            weighted_depth,
            depth_low: band.low,
            depth_high: band.high,
            time,
            attributes: contributions,
        }
    }
}

impl Model for Weighting {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.datapath.in_ready(), out: self.datapath.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let accepted = inputs.input.as_ref().filter(|_| self.datapath.in_ready()).map(|sample| self.weigh(sample));
        self.datapath.step(accepted.map(Token::Kept), inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::records::{Band, SamplePlace};

    #[test]
    fn weighs_what_is_blended() {
        let unit = Weighting::new(&Config { continuous: 1, cardinal: 1, ..Config::default() }, 1);
        let mut attributes = [0; 14];
        attributes[..2].copy_from_slice(&[0xc200, 77]); // −3.0 in f16
        let place = SamplePlace { weight: 1 << 15, inside: true, ..SamplePlace::default() };
        let weighted =
            unit.weigh(&Sample { place, band: Band { depth: 11, low: 10, high: 12 }, attributes, ..Sample::default() });
        assert_eq!((weighted.weighted_depth, weighted.depth_low, weighted.depth_high), (11 << 15, 10, 12));
        assert_eq!(weighted.attributes[..2], [0xbe00, 77]); // −1.5 in f16
    }
}
