//! Rasterizer of splats that move while the shutter is open: one sample after the other is integrated over the exposure, and each bin that it
//! falls into becomes a sample of its own (thesis chapter 4).
//!
//! Samples of the octagon, evaluated in as many cycles as there are bins by [motion evaluation](crate::splat::motion_evaluation); bins that a splat does
//! not cover are left out, but for a copy's last. ε and attributes wait in a queue beside the evaluation.

use super::{In, Out, Scanner};
use crate::splat::{MotionEvaluation, motion_evaluation};
use crate::stream::Fifo;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{COPY_QUEUE_DEPTH, DEPTH_BITS, WEIGHT_BITS};
use pointcore_contract::splat::motion::{SHARE_BITS, TIME_FRACTION_BITS};
use pointcore_contract::splat::records::{Attributes, Band, MovingPlace, MovingSample, Sample, SamplePlace};
use pointcore_contract::splat::units::RasterizerEvents;

const DEPTH_MAX: u32 = (1 << DEPTH_BITS) - 1;
const WEIGHT_MAX: u32 = (1 << WEIGHT_BITS) - 1;

/// The rasterizer.
#[derive(Clone, Debug)]
pub struct MotionRasterizer {
    config: Config,
    scanner: Scanner,
    /// Half the depth bands of the copies under way, and their attributes.
    copies: Fifo<(u32, Attributes)>,
    evaluation: MotionEvaluation,
    /// The bin of the sample that leaves the evaluation.
    bin: usize,
    events: RasterizerEvents,
}

impl MotionRasterizer {
    /// The unit with an evaluation of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            config: config.clone(),
            scanner: Scanner::new(config),
            copies: Fifo::new(COPY_QUEUE_DEPTH as usize),
            evaluation: MotionEvaluation::new(config, latency),
            bin: 0,
            events: RasterizerEvents::default(),
        }
    }

    fn in_ready(&self) -> bool {
        self.evaluation.in_ready() && self.scanner.is_idle() && self.copies.in_ready()
    }

    /// What a sample's bin sees of it; `None` if that is nothing, and nothing hangs on it.
    #[must_use]
    pub fn bin(config: &Config, sample: &MovingSample, bin: usize, copy: (u32, Attributes)) -> Option<Sample> {
        let (epsilon, attributes) = copy;
        // What a bin sees weighs as much as if that were all of the exposure.
        let weight = (sample.share[bin] >> (SHARE_BITS - WEIGHT_BITS - config.bin_bits())).min(WEIGHT_MAX);
        let inside = sample.inside && weight > 0;
        let last = sample.last && bin + 1 == config.time_bins as usize;
        let depth = (sample.depth[bin] + sample.depth[bin + 1]) / 2;
        let length = 1 << (TIME_FRACTION_BITS - config.bin_bits());
        let [begin, end] = [bin as u32 * length, (bin as u32 + 1) * length];
        let since = |from: u32, to: u32| to.wrapping_sub(from) & (2 * length - 1);
        (inside || last).then(|| Sample {
            place: SamplePlace {
                last,
                inside,
                slot: sample.slot,
                pixel: sample.pixel + bin as u8,
                weight: weight as u16,
            },
            band: Band { depth, low: depth.saturating_sub(epsilon), high: (depth + epsilon).min(DEPTH_MAX) },
            time: [since(sample.time[bin], end), since(begin, sample.time[bin + 1])],
            attributes,
        })
    }

    /// What is shown of the sample that leaves the evaluation.
    fn shown(&self) -> Option<Sample> {
        let sample = self.evaluation.out()?;
        Self::bin(&self.config, sample, self.bin, self.copies.out().copied().unwrap_or_default())
    }
}

impl Model for MotionRasterizer {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.in_ready(), out: self.shown(), events: self.events }
    }

    fn clock(&mut self, inputs: &In) {
        let shown = self.shown();
        let passes = self.evaluation.out().is_some() && (shown.is_none() || inputs.out_ready);
        let is_last_bin = self.bin + 1 == self.config.time_bins as usize;

        let advances = self.evaluation.in_ready();
        let taken = inputs.input.filter(|_| self.in_ready());
        let place = self.scanner.current().map(|scan| {
            let [column, row] = scan.place(&self.config).map(|place| place as u16);
            MovingPlace {
                last: scan.is_last(),
                slot: scan.copy.slot,
                column,
                row,
                footprint: scan.copy.moving.footprint,
            }
        });
        self.evaluation.clock(&motion_evaluation::In {
            input: place,
            out_ready: passes && is_last_bin,
            depth_a: inputs.depth_a,
        });
        self.events = self.scanner.clock(advances, taken);
        if passes {
            self.bin = if is_last_bin { 0 } else { self.bin + 1 };
        }
        let copy = taken.map(|copy| (copy.moving.epsilon, copy.attributes));
        self.copies.step(copy, inputs.out_ready && shown.is_some_and(|sample| sample.place.last));
    }
}
