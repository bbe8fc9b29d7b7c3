//! Tile cache and accumulator, which only make sense together, with what surrounds them: both as models, so that either's
//! hardware can be driven with what its model sees.

use std::collections::VecDeque;

use fastrand::Rng;
use pointcore_contract::splat::config::{DEPTH_BITS, TILE_PIXELS, WEIGHT_SUM_BITS};
use pointcore_contract::splat::motion::BIN_PARTS;
use pointcore_contract::splat::records::{
    ArrivedCopy, Pixel, PixelRun, PlacedCopy, SamplePlace, StoredPixel, TileCopy, WeightedSample, buffer_tile,
};
use pointcore_contract::splat::{AttributeFormat, Config};
use pointcore_contract::words;
use pointcore_golden::splat::{Accumulator, TileCache, accumulator, tile_cache};
use pointcore_golden::unit::Model;
use pointcore_tb::lockstep::{Flow, Stall, Stalls, Stimulus};

use super::scene::noise;
use super::{Device, scene};

/// Samples that may wait before the accumulator: enough for a slot to reach its limit of copies under way.
const SAMPLES_WAITING: usize = 2000;
/// Normalized depths of surfaces, and the distance within which samples blend.
const SURFACES: [u32; 4] = [0x40_0000, 0x80_0000, 0x9e_3779, 0xc0_0000];
const EPSILON: u32 = 0x1_0000;
/// More than half of `f16`'s largest number, for attributes.
const HALF_OF_LARGEST: f32 = 40_000.0;

/// What happened.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counts {
    /// Pixels read from memory, written to it, and of frames.
    pub reads: u32,
    pub writes: u32,
    pub pixels: u32,
    /// Pixels that came back from memory almost full.
    pub heavy: u32,
    /// Pixels with an attribute whose sum has overflowed, in `f16`.
    pub saturated: u32,
    /// The accumulator's events.
    pub accumulated: u32,
    pub hazards: u32,
    pub slot_waits: u32,
    /// Most copies under way at once.
    pub in_flight: u32,
}

/// The closed loop.
#[derive(Clone)]
pub struct Exchange {
    cache: TileCache,
    accumulator: Accumulator,
    /// Copies that come, that have come and are put in order, and that are in order.
    coming: VecDeque<TileCopy>,
    waiting: Vec<TileCopy>,
    copies: VecDeque<TileCopy>,
    /// A copy came in the cycle before.
    came: bool,
    samples: VecDeque<WeightedSample>,
    tiles: Vec<[Pixel; TILE_PIXELS as usize]>,
    beats: VecDeque<Pixel>,
    offers: [bool; 3],
    stalls: [Stalls; 7],
    config: Config,
    random: Rng,
    under_way: u32,
    /// The most copies that are put in order: of fewer than there are splats no two of a tile are of the same.
    window: usize,
    frames: usize,
    /// So far.
    pub counts: Counts,
}

/// Short frames, each of a few tiles: some leave while their last copies still come.
const SHORT_FRAMES: usize = 60;

/// Frames of copies: one of a single tile, one that wanders over the image, an empty one, one of random tiles, and short ones; or short
/// ones first, of which some leave while memories are still cleared.
fn copies(config: &Config, random: &mut Rng) -> VecDeque<TileCopy> {
    let (columns, rows) = (config.tile_columns(), config.height.div_ceil(8));
    let tile = |index: u32| ((index / columns % rows) << config.tile_column_bits()) | (index % columns);
    let short = (0..SHORT_FRAMES).map(|_| random.u32(0..24));
    let long = [1500, 600, 0, 300];
    let mut frames: Vec<_> = long.into_iter().chain(short).enumerate().collect();
    if random.bool() {
        frames.rotate_left(long.len());
    }
    let mut copies = VecDeque::new();
    for (frame, count) in frames {
        let corner = random.u32(0..columns * rows);
        for number in 0..=count {
            let mut copy: TileCopy = noise(config, random);
            copy.end = number == count;
            copy.splat = (number % (1 << config.splat_bits())) as u16;
            copy.tile = match frame {
                0 => tile(3),
                1 => tile(number / 4 + random.u32(0..3)),
                2 | 3 => tile(random.u32(0..columns * rows)),
                _ => tile(corner + random.u32(0..9)),
            };
            copies.push_back(copy);
        }
    }
    copies
}

/// When a sample is seen within a bin of the exposure: from a time to a later one, of which some are where a part of it ends, or next to that.
pub fn time(config: &Config, random: &mut Rng) -> [u32; 2] {
    let length: u32 = 1 << (config.bin_time_bits() - 1);
    let border = length / BIN_PARTS;
    let mut ends = [(); 2].map(|()| match random.u8(0..4) {
        0 => random.u32(0..=BIN_PARTS) * border,
        1 => (random.u32(0..BIN_PARTS) * border + 1).saturating_sub(random.u32(0..2) * 2),
        _ => random.u32(0..=length),
    });
    if random.bool() {
        // For a part of the bin at most: others leave gaps where it may be.
        ends[1] = (ends[0] + random.u32(0..=border)).min(length);
    }
    ends.sort_unstable();
    [length - ends[0], ends[1]]
}

impl Exchange {
    /// The loop before its first cycle; `seed` decides everything random in it.
    pub fn new(config: &Config, stall: Stall, seed: u64) -> Self {
        let mut random = Rng::with_seed(seed);
        let coming = copies(config, &mut random);
        Self {
            cache: TileCache::new(config),
            accumulator: Accumulator::new(config),
            frames: coming.iter().filter(|copy| copy.end).count(),
            coming,
            waiting: vec![],
            copies: VecDeque::new(),
            came: false,
            samples: VecDeque::new(),
            tiles: vec![[Pixel::default(); TILE_PIXELS as usize]; config.buffer_tiles()],
            beats: VecDeque::new(),
            offers: [false; 3],
            stalls: [(); 7].map(|()| Stalls::new(stall, random.fork())),
            config: config.clone(),
            random,
            under_way: 0,
            window: (1 << config.splat_bits()) - 1,
            counts: Counts::default(),
        }
    }

    /// Copies come, every second cycle at most, and one goes on: the first of some tile, and the end behind all others.
    fn order(&mut self, is_full: bool) -> Option<ArrivedCopy> {
        let first = self.random.usize(0..=self.waiting.len());
        if let Some(&TileCopy { tile, end, .. }) = self.waiting.get(first) {
            let place = if end { 0 } else { self.waiting.iter().position(|copy| copy.tile == tile).unwrap_or(0) };
            self.copies.push_back(self.waiting.remove(place));
        }
        let is_closed = self.waiting.last().is_some_and(|copy| copy.end);
        let has_room = self.waiting.len() + self.copies.len() < self.window;
        self.came = !self.came && !is_full && !is_closed && has_room && self.random.u8(0..4) > 0;
        let copy = if self.came { self.coming.pop_front() } else { None };
        self.waiting.extend(copy);
        copy.map(|TileCopy { end, tile, splat, .. }| ArrivedCopy { end, tile, splat })
    }

    /// Some samples of a copy on few pixels, of a few surfaces; the last one closes it.
    fn sample(&mut self, placed: &PlacedCopy) {
        let count = self.random.usize(1..6);
        let first = self.random.u8(..);
        for number in 1..=count {
            let random = &mut self.random;
            let mut sample: WeightedSample = noise(&self.config, random);
            let weight = sample.place.weight;
            let inside = random.u8(0..5) > 0;
            let pixel = first.wrapping_add(random.u8(0..3)) % TILE_PIXELS as u8;
            let last = number == count;
            sample.place = SamplePlace { last, inside, slot: placed.slot, pixel, weight };
            let surface = SURFACES[random.usize(0..SURFACES.len())];
            // The depth of some pixels is that of a surface, whatever they have blended.
            let (depth, [low, high]) = if pixel.is_multiple_of(4) || random.u8(0..3) == 0 {
                // The surface itself, and limits that differ from it in one bit each.
                (surface, [(); 2].map(|()| surface ^ 1 << random.u32(0..DEPTH_BITS)))
            } else {
                let depth = surface + random.u32(0..EPSILON / 2);
                (depth, [depth - EPSILON, depth + EPSILON])
            };
            if self.config.has_motion() && random.u8(0..8) > 0 {
                sample.time = time(&self.config, random);
            }
            sample.weighted_depth = u64::from(weight) * u64::from(depth);
            (sample.depth_low, sample.depth_high) = (low.min(high), low.max(high));
            for attribute in &mut sample.attributes[..self.config.continuous as usize] {
                // Half of them so large that sums overflow, to one side on a pixel; now and then any bits.
                let number = match random.u8(0..32) {
                    0 => continue,
                    1..=16 => HALF_OF_LARGEST * if pixel.is_multiple_of(2) { 1.0 } else { -1.0 },
                    _ => 4.0 * random.f32() - 2.0,
                };
                if let AttributeFormat::Float(format) = self.config.attribute {
                    *attribute = scene::encode(format, number);
                }
            }
            self.samples.push_back(sample);
        }
    }

    /// A pixel as memory keeps it: now and then so full that a blend would overflow it.
    fn kept(&mut self, mut pixel: Pixel) -> Pixel {
        let continuous = self.config.continuous as usize;
        let is_largest = |bits: &u64| bits & 0x7fff == 0x7bff;
        self.counts.saturated += u32::from(pixel.attributes[..continuous].iter().any(is_largest));
        if pixel.weight > 0 && self.random.u8(0..6) == 0 {
            let depth = pixel.depth / u64::from(pixel.weight);
            pixel.weight = (1 << WEIGHT_SUM_BITS) - self.random.u32(1..100_000);
            pixel.depth = u64::from(pixel.weight) * depth.min((1 << DEPTH_BITS) - 1);
            if let AttributeFormat::Fixed(fraction) = self.config.attribute {
                // The sums of nothing but −1.
                let sum = (u64::from(pixel.weight) << fraction.number().fraction).wrapping_neg();
                pixel.attributes[..continuous].fill(sum & (u64::MAX >> (64 - fraction.sum().width)));
            }
            self.counts.heavy += 1;
        }
        pixel
    }

    /// One cycle; returns what the two units saw in it.
    fn step(&mut self) -> (tile_cache::In, accumulator::In) {
        let (cache, accumulator) = (self.cache.outputs(), self.accumulator.outputs());
        let arrives = self.order(cache.full);
        let [copies, samples, data, out, read, write, pixel] = self.stalls.each_mut().map(|stalls| !stalls.stalled());
        // An offer once made stands until it is taken.
        let offers = &mut self.offers;
        offers[0] |= copies && !self.copies.is_empty();
        offers[1] |= samples && !self.samples.is_empty();
        offers[2] |= data && !self.beats.is_empty();
        let cache_in = tile_cache::In {
            input: self.copies.front().copied().filter(|_| offers[0]),
            arrives,
            out_ready: out && self.samples.len() < SAMPLES_WAITING,
            read_ready: read,
            data: self.beats.front().copied().filter(|_| offers[2]),
            write_ready: write,
            pixel_ready: pixel,
            number: 0,
            frame_sent: self.random.u8(..) == 0,
            retire: accumulator.retire,
            masks: accumulator.masks,
            sample_writes: accumulator.sample_writes,
            sample_reads: accumulator.sample_reads,
            drained: accumulator.drained,
        };
        let accumulator_in = accumulator::In {
            input: self.samples.front().copied().filter(|_| offers[1]),
            slot_ready: cache.slot_ready,
            change: cache.change,
            fill: cache.fill,
            drain: cache.drain,
        };
        if offers[0] && cache.in_ready {
            self.copies.pop_front();
            self.offers[0] = false;
        }
        if self.offers[1] && accumulator.in_ready {
            self.samples.pop_front();
            self.offers[1] = false;
        }
        if self.offers[2] && cache.data_ready {
            self.beats.pop_front();
            self.offers[2] = false;
        }
        self.move_pixels(&cache, &cache_in);
        let events = accumulator.events;
        self.counts.accumulated += u32::from(events.accumulate);
        self.counts.hazards += u32::from(events.hazard);
        self.counts.slot_waits += u32::from(events.slot_wait);
        self.under_way -= u32::from(accumulator.retire.is_some());
        self.cache.clock(&cache_in);
        self.accumulator.clock(&accumulator_in);
        (cache_in, accumulator_in)
    }

    /// Takes what the cache sends in this cycle.
    fn move_pixels(&mut self, cache: &tile_cache::Out, taken: &tile_cache::In) {
        if let Some(placed) = cache.out.filter(|_| taken.out_ready) {
            self.under_way += 1;
            self.counts.in_flight = self.counts.in_flight.max(self.under_way);
            self.sample(&placed);
        }
        if let Some(PixelRun { surface, tile, pixel, count }) = cache.read.filter(|_| taken.read_ready) {
            let run = usize::from(pixel)..usize::from(pixel + count);
            self.beats.extend(&self.tiles[buffer_tile(&self.config, surface, tile)][run]);
            self.counts.reads += u32::from(count);
        }
        if let Some(StoredPixel { surface, placed }) = cache.write.filter(|_| taken.write_ready) {
            self.tiles[buffer_tile(&self.config, surface, placed.tile)][usize::from(placed.pixel)] =
                self.kept(placed.value);
            self.counts.writes += 1;
        }
        if let Some(finished) = cache.pixel.filter(|_| taken.pixel_ready) {
            self.frames -= usize::from(finished.end);
            self.counts.pixels += u32::from(!finished.end);
        }
    }
}

/// The unit whose hardware is driven.
#[derive(Clone, Copy)]
pub enum Side {
    TileCache,
    Accumulator,
}

/// The loop as the stimulus of one of its units.
#[derive(Clone)]
pub struct Drive {
    /// The loop.
    pub exchange: Exchange,
    side: Side,
    places: Vec<usize>,
}

impl Drive {
    /// Drives `device`, which is the hardware of `side`.
    pub fn new(exchange: Exchange, side: Side, device: &Device) -> Self {
        Self { exchange, side, places: device.input_places() }
    }
}

impl Stimulus for Drive {
    fn drive(&mut self, _cycle: u64, _outputs: &[u64], inputs: &mut [u64]) -> Flow {
        if self.exchange.frames == 0 {
            return Flow::Done;
        }
        let (cache, accumulator) = self.exchange.step();
        let config = &self.exchange.config;
        let words = match self.side {
            Side::TileCache => words(config, cache),
            Side::Accumulator => words(config, accumulator),
        };
        // `rst` comes first.
        self.places[1..].iter().zip(words).for_each(|(&place, word)| inputs[place] = word);
        Flow::Continue
    }
}
