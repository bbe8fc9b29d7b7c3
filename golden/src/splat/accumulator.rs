//! Accumulator: depth test and sums of every sample on its pixel, in the slots of the tile cache (eqs. 5.8, 5.11, 5.12).
//!
//! Weights and depths are summed as exact integers, attributes as their [format](super::attribute) has it, stored operand first. A blend
//! whose weight sum would overflow changes nothing. A sample waits while an earlier one of the same pixel is under way, so that the
//! sums depend on the order of samples alone. A pixel that nothing was written to since its tile came is zeros.

use super::attribute::Arithmetic;
use super::depth_test;
use super::parts::cover::Cover;
use super::tile_cache::bank;
use crate::stream::Fifo;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{SAMPLE_QUEUE_DEPTH, TILE_PIXELS, WEIGHT_SUM_BITS};
use pointcore_contract::splat::records::{
    Bin, DrainedPixel, Fill, Pixel, SamplePlace, Slot, SlotChange, SlotMasks, SlotPixel, WeightedSample,
};
use pointcore_contract::splat::units::AccumulatorEvents;
pub use pointcore_contract::splat::units::accumulator::{In, Out};
use std::collections::VecDeque;

const WEIGHT_SUM_MAX: u32 = (1 << WEIGHT_SUM_BITS) - 1;

/// A sample under way.
#[derive(Clone, Copy, Debug)]
struct Stage {
    /// The pixel, if the sample lies inside its splat.
    place: Option<SlotPixel>,
    retire: Option<Slot>,
    /// The pixel's new value, if it changes.
    result: Option<Pixel>,
}

/// The accumulator.
#[derive(Clone, Debug)]
pub struct Accumulator {
    continuous: usize,
    attribute: Arithmetic,
    has_motion: bool,
    /// A bin's, where splats may move.
    bin_length: u32,
    input: Fifo<WeightedSample>,
    /// The sample that issues next.
    head: Option<WeightedSample>,
    /// [`In::slot_ready`] of the cycle before.
    slot_ready: u64,
    /// The pixels of all slots, and which of them count.
    pixels: Vec<Pixel>,
    held: Vec<SlotMasks>,
    /// What the slot that changed last held before.
    masks: SlotMasks,
    /// Front: the sample issued last. As many as a sum takes, and one that writes.
    stages: VecDeque<Option<Stage>>,
    retire: Option<Slot>,
    /// The pixels that were read for the tile cache in the cycle before, and in the one before that.
    read: Option<DrainedPixel>,
    drained: Option<DrainedPixel>,
    events: AccumulatorEvents,
}

impl Accumulator {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            continuous: config.continuous as usize,
            attribute: Arithmetic(config.attribute),
            has_motion: config.has_motion(),
            bin_length: 1 << (config.bin_time_bits() - 1),
            input: Fifo::new(SAMPLE_QUEUE_DEPTH as usize),
            head: None,
            slot_ready: 0,
            pixels: vec![Pixel::default(); (config.tile_slots * TILE_PIXELS) as usize],
            held: vec![SlotMasks::default(); config.tile_slots as usize],
            masks: SlotMasks::default(),
            stages: vec![None; config.accumulate_stages as usize + 1].into(),
            retire: None,
            read: None,
            drained: None,
            events: AccumulatorEvents::default(),
        }
    }

    /// The bank that the sample at the head may read, unless it waits for its slot.
    fn reads(&self) -> u32 {
        let place = self.head.as_ref().map(|sample| &sample.place);
        let place = place.filter(|place| place.inside && self.slot_ready >> place.slot & 1 == 1);
        place.map_or(0, |place| bank(place.pixel))
    }

    /// Whether the sample at the head waits, and for what.
    fn stall(&self, sample: &WeightedSample) -> AccumulatorEvents {
        let place = &sample.place;
        let pixel = SlotPixel { slot: place.slot, pixel: place.pixel };
        let slot_wait = place.inside && self.slot_ready >> place.slot & 1 == 0;
        let meets = || self.stages.iter().flatten().any(|stage| stage.place == Some(pixel));
        let hazard = place.inside && !slot_wait && meets();
        AccumulatorEvents { accumulate: place.inside && !slot_wait && !hazard, hazard, slot_wait }
    }

    fn start(&mut self, sample: &WeightedSample) -> Stage {
        let SamplePlace { inside, last, slot, pixel, .. } = sample.place;
        let place = inside.then_some(SlotPixel { slot, pixel });
        let result = place.and_then(|place| {
            let held = &mut self.held[usize::from(slot)];
            let is_written = held.written >> pixel & 1 == 1;
            held.written |= 1 << pixel;
            held.dirty |= 1 << pixel;
            let stored = if is_written { self.pixels[index(place)] } else { Pixel::default() };
            self.accumulate(&stored, sample)
        });
        Stage { place, retire: last.then_some(Slot { slot }), result }
    }

    /// The bank that the sample in a stage may write.
    fn writes(stage: Option<&Option<Stage>>) -> u32 {
        let place = stage.and_then(|stage| stage.as_ref()?.place);
        place.map_or(0, |place| bank(place.pixel))
    }

    /// The pixel with the sample in it; `None` if it does not change.
    #[must_use]
    pub fn accumulate(&self, stored: &Pixel, sample: &WeightedSample) -> Option<Pixel> {
        let WeightedSample { depth_low, depth_high, .. } = *sample;
        let limits = depth_test::In { weight: stored.weight, depth: stored.depth, depth_low, depth_high };
        let outcome = depth_test::test(&limits);
        let alone = self.alone(sample);
        let surface = match outcome {
            depth_test::Out { fail: true, .. } => None,
            depth_test::Out { pass: true, .. } => Some(alone),
            _ => Some(self.merged(stored, &alone)?),
        };
        if !self.has_motion {
            return surface;
        }
        // What is hidden joins the rest, and what was nearest until now, unless it is hidden for all of its time.
        let Bin { nearest, nearest_parts, any, any_parts, .. } = stored.bin;
        let [before, any] = [(nearest, nearest_parts), (any, any_parts)].map(|(span, parts)| Cover { span, parts });
        let own = Cover::of(sample.time, self.bin_length);
        let rest = rest(&stored.bin);
        let (seen, joins) = match outcome {
            depth_test::Out { fail: true, .. } => (before, (!own.is_within(before)).then_some(alone)),
            depth_test::Out { pass: true, .. } => (own, (!before.is_within(own)).then_some(*stored)),
            _ => (before.with(own), None),
        };
        let Pixel { weight, depth, peak, attributes, .. } =
            joins.and_then(|joins| self.merged(&rest, &joins)).unwrap_or(rest);
        let any = any.with(own);
        let (nearest, nearest_parts, any, any_parts) = (seen.span, seen.parts, any.span, any.parts);
        let bin = Bin { nearest, nearest_parts, any, any_parts, weight, depth, peak, attributes };
        Some(Pixel { bin, ..surface.unwrap_or(*stored) })
    }

    /// The sums of a sample alone.
    fn alone(&self, sample: &WeightedSample) -> Pixel {
        let mut attributes = sample.attributes;
        for sum in &mut attributes[..self.continuous] {
            *sum = self.attribute.alone(*sum);
        }
        let weight = sample.place.weight;
        Pixel { weight: weight.into(), depth: sample.weighted_depth, peak: weight, attributes, ..Pixel::default() }
    }

    /// Both sums in one; `None` if the weight does not fit.
    fn merged(&self, stored: &Pixel, other: &Pixel) -> Option<Pixel> {
        let weight = stored.weight + other.weight;
        if weight > WEIGHT_SUM_MAX {
            return None;
        }
        let stronger = stored.peak < other.peak;
        let mut attributes = other.attributes;
        for (index, (new, old)) in attributes.iter_mut().zip(stored.attributes).enumerate() {
            if index < self.continuous {
                *new = self.attribute.add(old, *new);
            } else if !stronger {
                *new = old;
            }
        }
        let peak = stored.peak.max(other.peak);
        Some(Pixel { weight, depth: stored.depth + other.depth, peak, attributes, ..Pixel::default() })
    }
}

/// The sums of all else.
fn rest(bin: &Bin) -> Pixel {
    let Bin { weight, depth, peak, attributes, .. } = *bin;
    Pixel { weight, depth, peak, attributes, ..Pixel::default() }
}

fn index(place: SlotPixel) -> usize {
    usize::from(place.slot) * TILE_PIXELS as usize + usize::from(place.pixel)
}

impl Model for Accumulator {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            in_ready: self.input.in_ready(),
            retire: self.retire,
            masks: self.masks,
            sample_writes: Self::writes(self.stages.iter().rev().nth(1)),
            sample_reads: self.reads(),
            drained: self.drained,
            events: self.events,
        }
    }

    fn clock(&mut self, inputs: &In) {
        self.events = AccumulatorEvents::default();
        let mut issued = false;
        let mut started = None;
        let reads = self.reads();
        if let Some(sample) = self.head {
            self.events = self.stall(&sample);
            issued = !self.events.hazard && !self.events.slot_wait;
            started = issued.then(|| self.start(&sample));
        }
        self.exchange(inputs, reads);

        let finished = self.stages.pop_back().flatten();
        self.stages.push_front(started);
        self.retire = finished.and_then(|stage| stage.retire);
        if let Some(Stage { place: Some(place), result: Some(result), .. }) = finished {
            self.pixels[index(place)] = result;
        }
        self.slot_ready = inputs.slot_ready;
        let taken = issued || self.head.is_none();
        if taken {
            self.head = self.input.out().copied();
        }
        self.input.step(inputs.input, taken);
    }
}

impl Accumulator {
    /// What the tile cache asks of the slots, in banks that samples do not read or write.
    fn exchange(&mut self, inputs: &In, reads: u32) {
        self.drained = self.read;
        let drain = inputs.drain.filter(|drain| reads & bank(drain.pixel) == 0);
        self.read = drain.map(|place| DrainedPixel { pixel: place.pixel, value: self.pixels[index(place)] });
        let writes = Self::writes(self.stages.back());
        if let Some(Fill { place, value }) = inputs.fill.filter(|fill| writes & bank(fill.place.pixel) == 0) {
            self.pixels[index(place)] = value;
        }
        if let Some(SlotChange { slot, banks, held }) = inputs.change {
            let free = u32::from(banks) & !reads;
            let changes = (0..TILE_PIXELS as u8).filter(|pixel| free & bank(*pixel) != 0);
            let changes: u64 = changes.fold(0, |pixels, pixel| pixels | 1 << pixel);
            let choose = |old: u64, new: u64| old & !changes | new & changes;
            let slot = &mut self.held[usize::from(slot)];
            self.masks.written = choose(self.masks.written, slot.written);
            self.masks.dirty = choose(self.masks.dirty, slot.dirty);
            *slot = SlotMasks { written: choose(slot.written, held), dirty: choose(slot.dirty, 0) };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sample whose ε-band reaches 100 to either side.
    fn sample(pixel: u8, weight: u16, depth: u32) -> WeightedSample {
        let place = SamplePlace { last: true, inside: true, slot: 1, pixel, weight };
        let weighted_depth = u64::from(weight) * u64::from(depth);
        let mut attributes = [0; 14];
        attributes[0] = 0x3c00; // 1.0 in f16
        attributes[1] = u64::from(weight);
        WeightedSample {
            place,
            weighted_depth,
            depth_low: depth - 100,
            depth_high: depth + 100,
            attributes,
            ..WeightedSample::default()
        }
    }

    /// Feeds the samples as fast as they are taken, with slot 1 ready from a cycle on; returns the unit and when copies retired.
    fn run(config: &Config, samples: &[WeightedSample], ready_from: u32) -> (Accumulator, Vec<u32>, AccumulatorEvents) {
        let mut unit = Accumulator::new(config);
        let mut samples = samples.iter().copied();
        let mut input = samples.next();
        let (mut retired, mut seen) = (Vec::new(), AccumulatorEvents::default());
        for cycle in 0..200 {
            let out = unit.outputs();
            retired.extend(out.retire.map(|_| cycle));
            seen.hazard |= out.events.hazard;
            seen.slot_wait |= out.events.slot_wait;
            unit.clock(&In { input, slot_ready: u64::from(cycle >= ready_from) << 1, ..In::default() });
            if out.in_ready {
                input = samples.next();
            }
        }
        (unit, retired, seen)
    }

    fn config() -> Config {
        Config { continuous: 1, cardinal: 1, accumulate_stages: 5, ..Config::default() }
    }

    #[test]
    fn other_pixels_follow_at_once_and_the_same_pixel_waits() {
        let (_, retired, seen) = run(&config(), &[sample(1, 5, 1000), sample(2, 5, 1000)], 0);
        // Two cycles to the queue's output, one to the head, issue, E + 1 stages, then the register.
        assert_eq!(retired, [10, 11]);
        assert!(!seen.hazard && !seen.slot_wait);
        let (_, retired, seen) = run(&config(), &[sample(1, 5, 1000), sample(1, 5, 1000)], 0);
        assert_eq!(retired, [10, 17], "issued in the cycle after stage E + 1 wrote");
        assert!(seen.hazard && !seen.slot_wait);
        let (_, retired, seen) = run(&config(), &[sample(1, 5, 1000)], 50);
        assert_eq!(retired, [58], "issued in the cycle after the slot was seen to be ready");
        assert!(seen.slot_wait);
    }

    #[test]
    fn pixels_are_blended_replaced_and_kept() {
        let pixel = |samples: &[WeightedSample]| {
            let unit = run(&config(), samples, 0).0;
            let Pixel { weight, depth, peak, attributes, .. } = unit.pixels[index(SlotPixel { slot: 1, pixel: 9 })];
            (weight, depth, peak, attributes[0], attributes[1])
        };
        let base = [sample(9, 10, 1000), sample(9, 20, 1050)];
        let blended = (30, 31_000, 20, 0x4000, 20);
        assert_eq!(pixel(&base), blended);
        assert_eq!(pixel(&[base[0], base[1], sample(9, 7, 9000)]), blended, "hidden");
        assert_eq!(pixel(&[base[0], base[1], sample(9, 7, 1000)]), (37, 38_000, 20, 0x4200, 20), "a smaller weight");
        assert_eq!(pixel(&[base[1], sample(9, 7, 500)]), (7, 3500, 7, 0x3c00, 7), "nearer");
    }

    #[test]
    fn a_full_weight_sum_takes_no_more() {
        let unit = Accumulator::new(&config());
        let stored =
            Pixel { weight: WEIGHT_SUM_MAX - 5, depth: u64::from(WEIGHT_SUM_MAX - 5) * 1000, ..Pixel::default() };
        assert_eq!(unit.accumulate(&stored, &sample(0, 5, 1000)).map(|pixel| pixel.weight), Some(WEIGHT_SUM_MAX));
        assert_eq!(unit.accumulate(&stored, &sample(0, 6, 1000)), None);
    }

    #[test]
    fn a_full_attribute_sum_stays_the_largest_number() {
        let unit = Accumulator::new(&config());
        for (sign, largest) in [(0, 0x7bff), (0x8000, 0xfbff)] {
            let mut sample = sample(0, 5, 1000);
            sample.attributes[0] = sign | 0x7800; // 32,768 in f16
            let twice = [sample; 2]
                .iter()
                .fold(Pixel::default(), |pixel, sample| unit.accumulate(&pixel, sample).expect("it blends"));
            assert_eq!(twice.attributes[0], largest);
            assert_eq!(unit.accumulate(&twice, &sample).map(|pixel| pixel.attributes[0]), Some(largest));
            sample.attributes[0] ^= 0x8000;
            let less = unit.accumulate(&twice, &sample).map(|pixel| pixel.attributes[0]);
            assert_eq!(less, Some(sign | 0x77fe), "and can be lowered");
        }
    }
}
