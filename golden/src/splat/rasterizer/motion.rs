//! Rasterizer of splats that move while the shutter is open: one sample after the other is integrated over a bin of the exposure (thesis chapter 4).
//!
//! Samples of the octagon, evaluated by [motion evaluation](crate::splat::motion_evaluation); what a splat does not cover is left out, but for a
//! copy's last. ε and attributes wait in a queue beside the evaluation.

use super::{In, Out, Scanner};
use crate::datapath;
use crate::splat::{MotionEvaluation, motion_evaluation};
use crate::stream::Fifo;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{DEPTH_BITS, WEIGHT_BITS};
use pointcore_contract::splat::motion::SHARE_BITS;
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
    events: RasterizerEvents,
}

impl MotionRasterizer {
    /// The unit with an evaluation of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            config: config.clone(),
            scanner: Scanner::new(config),
            copies: Fifo::new(datapath::tokens(latency, config.sample_interval) as usize + 1),
            evaluation: MotionEvaluation::new(config, latency),
            events: RasterizerEvents::default(),
        }
    }

    fn in_ready(&self) -> bool {
        self.evaluation.in_ready() && self.scanner.is_idle()
    }

    /// What a bin sees of a sample; `None` if that is nothing, and nothing hangs on it.
    #[must_use]
    pub fn sample(config: &Config, sample: &MovingSample, copy: (u32, Attributes)) -> Option<Sample> {
        let (epsilon, attributes) = copy;
        let MovingSample { last, inside, slot, pixel, time, depth: [begin, end], share } = *sample;
        // What a bin sees weighs as much as if that were all of the exposure.
        let weight = (share >> (SHARE_BITS - WEIGHT_BITS - config.bin_bits())).min(WEIGHT_MAX);
        let inside = inside && weight > 0;
        let [near, far] = [begin.min(end), begin.max(end)];
        (inside || last).then(|| Sample {
            place: SamplePlace { last, inside, slot, pixel, weight: weight as u16 },
            band: Band {
                depth: (begin + end) / 2,
                low: near.saturating_sub(epsilon),
                high: (far + epsilon).min(DEPTH_MAX),
            },
            time,
            attributes,
        })
    }

    /// What is shown of the sample that leaves the evaluation.
    fn shown(&self) -> Option<Sample> {
        let sample = self.evaluation.out()?;
        Self::sample(&self.config, sample, self.copies.out().copied().unwrap_or_default())
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

        let advances = self.evaluation.in_ready();
        let taken = inputs.input.filter(|_| self.in_ready());
        let place = self.scanner.current().map(|scan| {
            let [column, row] = scan.place(&self.config).map(|place| place as u16);
            MovingPlace {
                last: scan.is_last(),
                slot: scan.copy.slot,
                column,
                row,
                odd_bin: scan.bin(&self.config) % 2 == 1,
                footprint: scan.copy.moving.footprint,
            }
        });
        self.evaluation.clock(&motion_evaluation::In { input: place, out_ready: passes, depth_a: inputs.depth_a });
        self.events = self.scanner.clock(advances, taken);
        let copy = taken.map(|copy| (copy.moving.epsilon, copy.attributes));
        self.copies.step(copy, inputs.out_ready && shown.is_some_and(|sample| sample.place.last));
    }
}
