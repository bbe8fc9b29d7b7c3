//! `splat_occlusion` against its model, in every cycle, and what leaves against what memory holds.

use std::collections::VecDeque;

use pointcore_contract::splat::config::{DEPTH_BITS, TILE_PIXELS, TILE_SIZE};
use pointcore_contract::splat::records::{Band, Depth, DepthRun, Sample, SamplePlace, SlotTile};
use pointcore_contract::splat::{Config, Feature, units};
use pointcore_contract::words;
use pointcore_golden::splat::Occlusion;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::occlusion;
use pointcore_tb::lockstep::{Flow, Stall, Stalls, Stimulus, StreamPorts, Streams, seeds};

use crate::splat::{Device, moved, moving_configs, offer, scene};
use crate::support::cases;

const SEEDS: u64 = 6;
/// Tiles that get a slot, one after the other.
const TILES: usize = 200;

/// What memory holds: any number that an `f32` can be, many of them around what samples have.
fn depth(tile: u32, pixel: u32) -> u32 {
    let spread = (tile * TILE_PIXELS + pixel).wrapping_mul(0x9e37_79b9);
    match spread % 8 {
        0 => f32::INFINITY.to_bits(),
        1 => spread,
        2 => 1.0_f32.to_bits() - (spread >> 29),
        3 => (f32::from_bits(spread >> 5) * 1e-3).to_bits(),
        4 => (2.0_f32.powi(-((spread >> 27) as i32)) * 0.75).to_bits(),
        _ => (spread as f32 / u32::MAX as f32).to_bits(),
    }
}

/// The largest integer that a depth in memory is not below, of [`DEPTH_BITS`] digits.
fn digits(depth: u32) -> u32 {
    let most = (1 << DEPTH_BITS) - 1;
    if depth < 1.0_f32.to_bits() {
        (f64::from(f32::from_bits(depth)) * f64::from(1 << DEPTH_BITS)) as u32
    } else {
        most
    }
}

/// What reaches the unit: slots that get tiles, and samples.
#[derive(Clone, Copy)]
enum Event {
    /// Once so many samples have left.
    Placed(SlotTile, usize),
    Sample(Sample),
}

/// Slots get tiles, of which samples come, those of several slots in turn, and what is to leave.
fn events(config: &Config, random: &mut fastrand::Rng) -> (Vec<Event>, Vec<Sample>) {
    let mut slots: Vec<(VecDeque<Sample>, usize)> = vec![(VecDeque::new(), 0); config.tile_slots as usize];
    let (mut events, mut left, mut tiles) = (vec![], vec![], 0);
    while tiles < TILES || slots.iter().any(|(samples, _)| !samples.is_empty()) {
        let slot = random.usize(..slots.len());
        let (samples, end) = &mut slots[slot];
        if let Some(sample) = samples.pop_front() {
            events.push(Event::Sample(sample));
            // The band says in which tile it lies.
            let SamplePlace { inside, last, .. } = sample.place;
            let tile = sample.band.depth;
            let is_hidden = inside && digits(depth(tile, sample.place.pixel.into())) < sample.band.low;
            if last || !is_hidden {
                let place = SamplePlace { inside: inside && !is_hidden, ..sample.place };
                left.push(Sample { place, ..sample });
            }
            *end = left.len();
        } else if tiles < TILES {
            tiles += 1;
            let tile = random.u32(..1 << config.tile_bits());
            events.push(Event::Placed(SlotTile { slot: slot as u8, tile }, *end));
            let image_tile = tile >> config.bin_bits();
            let count = random.usize(1..60);
            samples.extend((0..count).map(|index| {
                let noise: Sample = scene::noise(config, random);
                let pixel = random.u32(..TILE_PIXELS);
                let near = digits(depth(image_tile, pixel));
                let low = match random.u8(..4) {
                    0 => near,
                    1 => near.saturating_sub(1 << random.u32(..DEPTH_BITS)),
                    2 => (near + (1 << random.u32(..DEPTH_BITS))).min((1 << DEPTH_BITS) - 1),
                    _ => noise.band.low,
                };
                let last = index + 1 == count || random.u8(..8) == 0;
                let place = SamplePlace {
                    last,
                    inside: random.u8(..4) > 0,
                    slot: slot as u8,
                    pixel: pixel as u8,
                    ..noise.place
                };
                Sample { place, band: Band { depth: image_tile, low, ..noise.band }, ..noise }
            }));
        }
    }
    (events, left)
}

/// What happens in its order, and a memory that answers.
#[derive(Clone)]
struct Around {
    config: Config,
    input: StreamPorts,
    out: StreamPorts,
    reads: StreamPorts,
    data: StreamPorts,
    /// Where a slot's tile is told: whether one is, which slot, which tile.
    placed: [usize; 3],
    events: VecDeque<Event>,
    /// Depths that are to come.
    asked: VecDeque<Depth>,
    received: Vec<Sample>,
    expected: usize,
    stalls: [Stalls; 4],
}

impl Around {
    fn new(config: &Config, device: &Device, (events, expected): (&[Event], usize), seed: u64) -> Self {
        let library = device.library();
        let streams = Streams::of(library);
        let stream = |name| streams.get(name).expect("the unit has it").clone();
        let place = |name: &str| library.inputs().iter().position(|port| port.name == name);
        let kinds = [
            [Stall::Never; 4],
            [Stall::Varied; 4],
            [Stall::Never, Stall::Never, Stall::Bursts(200), Stall::Never],
            [Stall::Never, Stall::Random(0.8), Stall::Never, Stall::Random(0.3)],
            [Stall::Bursts(40), Stall::Bursts(40), Stall::Random(0.5), Stall::Bursts(40)],
            [Stall::Random(0.5); 4],
        ];
        let mut random = fastrand::Rng::with_seed(seed);
        Self {
            config: config.clone(),
            input: stream("in"),
            out: stream("out"),
            reads: stream("depth_read"),
            data: stream("depth_data"),
            placed: ["placed_valid", "placed_slot", "placed_tile"].map(|name| place(name).expect("the unit has it")),
            events: events.iter().copied().collect(),
            asked: VecDeque::new(),
            received: vec![],
            expected,
            stalls: kinds[seed as usize % kinds.len()].map(|stall| Stalls::new(stall, random.fork())),
        }
    }
}

impl Stimulus for Around {
    fn drive(&mut self, _cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        self.received.extend(moved::<Sample>(&self.config, &self.out, inputs, outputs));
        if let Some(DepthRun { tile, pixel, count }) = moved(&self.config, &self.reads, inputs, outputs) {
            assert_eq!((u32::from(pixel) % TILE_SIZE, u32::from(count)), (0, TILE_SIZE), "a row is asked for at once");
            let depths = (pixel..pixel + count).map(|pixel| Depth { depth: depth(tile, pixel.into()) });
            self.asked.extend(depths);
        }
        let [source, sink, data, reads] = self.stalls.each_mut().map(Stalls::stalled);
        let is_free =
            |stream: &StreamPorts, inputs: &[u64]| !stream.offers(inputs, outputs) || stream.transfers(inputs, outputs);
        let takes_sample = is_free(&self.input, inputs);
        inputs[self.placed[0]] = 0;
        if let Some(&Event::Placed(SlotTile { slot, tile }, left)) = self.events.front()
            && takes_sample
            && self.received.len() >= left
        {
            let values = [1, u64::from(slot), u64::from(tile)];
            self.placed.iter().zip(values).for_each(|(&place, value)| inputs[place] = value);
            self.events.pop_front();
            offer(&self.input, inputs, None);
        } else if takes_sample {
            let sample = match self.events.front() {
                Some(&Event::Sample(sample)) if !source => Some(sample),
                _ => None,
            };
            if sample.is_some() {
                self.events.pop_front();
            }
            offer(&self.input, inputs, sample.map(|sample| words(&self.config, sample)));
        }
        if is_free(&self.data, inputs) {
            let depth = if data { None } else { self.asked.pop_front() };
            offer(&self.data, inputs, depth.map(|depth| words(&self.config, depth)));
        }
        for (stream, stalled) in [(&self.out, sink), (&self.reads, reads)] {
            inputs[stream.ready.expect("the stream has one")] = u64::from(!stalled);
        }
        if self.received.len() == self.expected { Flow::Done } else { Flow::Continue }
    }
}

#[test]
fn it_agrees_with_the_model_and_what_leaves_is_not_behind_what_is_in_memory() {
    for config in cases(moving_configs()) {
        let config = Config { merge: Feature::On, ..config };
        let device = Device::new(&config, &occlusion::module(&config), &units::occlusion::UNIT);
        for seed in seeds(SEEDS).expect("POINTCORE_SEED is a number") {
            let (events, expected) = events(&config, &mut fastrand::Rng::with_seed(seed));
            let samples = events.iter().filter(|event| matches!(event, Event::Sample(_))).count();
            assert!(expected.len() > 1000 && samples - expected.len() > 500, "{} of {samples}", expected.len());
            let around = Around::new(&config, &device, (&events, expected.len()), seed);
            let run = device.lockstep(Ported::new(&config, Occlusion::new(&config)), seed).run(around);
            let received = run.unwrap_or_else(|error| panic!("{error}")).stimulus.received;
            assert!(received == expected, "seed {seed}");
        }
    }
}
