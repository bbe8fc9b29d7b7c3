//! `splat_merge` against its model, in every cycle, and what leaves against what memory held.

use std::collections::{HashMap, VecDeque};

use pointcore_contract::splat::config::{MERGED_DEPTH_BITS, TILE_PIXELS, TILE_SIZE};
use pointcore_contract::splat::records::{Depth, DepthRun, Fragment, StoredDepth};
use pointcore_contract::splat::{Config, Feature, units};
use pointcore_contract::{Format, words};
use pointcore_golden::splat::Merge;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::merge;
use pointcore_tb::lockstep::{Flow, Stall, Stalls, Stimulus, StreamPorts, Streams, seeds};

use crate::splat::{Device, configs, moved, offer, scene};
use crate::support::cases;

const SEEDS: u64 = 6;
/// Surfaces one after the other, and tiles of each.
const SURFACES: usize = 12;
const TILES: usize = 12;
/// The depth that surfaces lie around: 0.5.
const MIDDLE: u32 = 0.5_f32.to_bits();

/// Depths in memory, by tile and pixel.
type Depths = HashMap<(u32, u32), u32>;

/// What lies in memory where nothing was written: near, far, as far as what comes, or next to that.
fn initial(config: &Config, tile: u32, pixel: u32) -> u32 {
    let bit = |place: u32| 1 << (place % MERGED_DEPTH_BITS);
    match (tile + pixel) % 5 {
        0 => 1.0_f32.to_bits(),
        1 => 0,
        2 => MIDDLE ^ bit(tile + pixel / 5),
        3 => depth(config, tile, pixel) ^ bit(tile / 3 + pixel),
        _ => depth(config, tile, pixel),
    }
}

/// A depth around the middle as a place has it, in the upper bits of an `f32`.
fn depth(config: &Config, tile: u32, pixel: u32) -> u32 {
    let low_bits = MERGED_DEPTH_BITS - config.geometry.width();
    (MIDDLE + (tile * TILE_PIXELS + pixel) % 7 * 0x1_0000) >> low_bits << low_bits
}

fn place(config: &Config, fragment: &Fragment) -> (u32, u32) {
    let [column, row] = [fragment.column, fragment.row].map(u32::from);
    let tile = ((row / TILE_SIZE) << config.tile_column_bits()) | (column / TILE_SIZE);
    (tile, row % TILE_SIZE * TILE_SIZE + column % TILE_SIZE)
}

/// Surfaces of tiles of which some pixels are missing, some of them empty.
fn surfaces(config: &Config) -> Vec<Fragment> {
    let mut random = scene::random();
    let low_bits = MERGED_DEPTH_BITS - config.geometry.width();
    let mut fragments = vec![];
    for surface in 0..SURFACES {
        let mut tiles: Vec<u32> = (0..1 << config.tile_bits()).collect();
        random.shuffle(&mut tiles);
        for tile in tiles.into_iter().take(if surface % 4 == 2 { 0 } else { TILES }) {
            let missing = random.u64(..) & random.u64(..) & random.u64(..);
            for pixel in (0..TILE_PIXELS).filter(|pixel| missing >> pixel & 1 == 0) {
                let noise: Fragment = scene::noise(config, &mut random);
                let near = depth(config, tile, pixel);
                let depth = match random.u8(0..4) {
                    0 => noise.depth << low_bits & 0x7fff_ffff,
                    1 => near ^ 1 << random.u32(low_bits..MERGED_DEPTH_BITS - 1),
                    _ => near - (surface as u32) * 0x1_0000,
                };
                let column_bits = config.tile_column_bits();
                fragments.push(Fragment {
                    end: false,
                    column: ((tile & ((1 << column_bits) - 1)) * TILE_SIZE + pixel % TILE_SIZE) as u16,
                    row: ((tile >> column_bits) * TILE_SIZE + pixel / TILE_SIZE) as u16,
                    depth: depth >> low_bits,
                    ..noise
                });
            }
        }
        fragments.push(Fragment { end: true, ..scene::noise(config, &mut random) });
    }
    fragments
}

/// What is to leave, by the definition: one fragment after the other against what memory holds.
fn visible(config: &Config, fragments: &[Fragment]) -> (Vec<Fragment>, Depths) {
    let low_bits = MERGED_DEPTH_BITS - config.geometry.width();
    let mut depths = Depths::new();
    let is_visible = |fragment: &&Fragment| {
        let (tile, pixel) = place(config, fragment);
        let stored = depths.entry((tile, pixel)).or_insert_with(|| initial(config, tile, pixel));
        let is_nearer = fragment.depth < *stored >> low_bits;
        if is_nearer && !fragment.end {
            *stored = fragment.depth << low_bits;
        }
        is_nearer || fragment.end
    };
    (fragments.iter().filter(is_visible).copied().collect(), depths)
}

/// Fragments come, and a memory answers.
#[derive(Clone)]
struct Around {
    config: Config,
    input: StreamPorts,
    out: StreamPorts,
    reads: StreamPorts,
    data: StreamPorts,
    writes: StreamPorts,
    fragments: VecDeque<Fragment>,
    depths: Depths,
    /// Depths that are to come, as they were when they were asked for.
    asked: VecDeque<Depth>,
    runs: usize,
    longest: u8,
    received: Vec<Fragment>,
    expected: usize,
    stalls: [Stalls; 5],
}

impl Around {
    fn new(config: &Config, device: &Device, fragments: &[Fragment], expected: usize, seed: u64) -> Self {
        let streams = Streams::of(device.library());
        let stream = |name| streams.get(name).expect("the unit has it").clone();
        let kinds = [
            [Stall::Never; 5],
            [Stall::Varied; 5],
            [Stall::Never, Stall::Never, Stall::Never, Stall::Bursts(200), Stall::Never],
            [Stall::Never, Stall::Never, Stall::Random(0.3), Stall::Never, Stall::Random(0.8)],
            [Stall::Bursts(40), Stall::Random(0.5), Stall::Bursts(40), Stall::Random(0.3), Stall::Bursts(40)],
            [Stall::Random(0.5); 5],
        ];
        let mut random = fastrand::Rng::with_seed(seed);
        Self {
            config: config.clone(),
            input: stream("in"),
            out: stream("out"),
            reads: stream("depth_read"),
            data: stream("depth_data"),
            writes: stream("depth_write"),
            fragments: fragments.iter().copied().collect(),
            depths: Depths::new(),
            asked: VecDeque::new(),
            runs: 0,
            longest: 0,
            received: vec![],
            expected,
            stalls: kinds[seed as usize % kinds.len()].map(|stall| Stalls::new(stall, random.fork())),
        }
    }
}

impl Stimulus for Around {
    fn drive(&mut self, _cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        self.received.extend(moved::<Fragment>(&self.config, &self.out, inputs, outputs));
        if let Some(StoredDepth { tile, pixel, value }) = moved(&self.config, &self.writes, inputs, outputs) {
            self.depths.insert((tile, pixel.into()), value.depth);
        }
        if let Some(DepthRun { tile, pixel, count }) = moved(&self.config, &self.reads, inputs, outputs) {
            let depths = (pixel..pixel + count).map(u32::from).map(|pixel| {
                let stored = self.depths.get(&(tile, pixel)).copied();
                Depth { depth: stored.unwrap_or_else(|| initial(&self.config, tile, pixel)) }
            });
            self.asked.extend(depths);
            self.runs += 1;
            self.longest = self.longest.max(count);
        }
        let [source, data, sink, reads, writes] = self.stalls.each_mut().map(Stalls::stalled);
        let is_free =
            |stream: &StreamPorts, inputs: &[u64]| !stream.offers(inputs, outputs) || stream.transfers(inputs, outputs);
        if is_free(&self.input, inputs) {
            let fragment = if source { None } else { self.fragments.pop_front() };
            offer(&self.input, inputs, fragment.map(|fragment| words(&self.config, fragment)));
        }
        if is_free(&self.data, inputs) {
            let depth = if data { None } else { self.asked.pop_front() };
            offer(&self.data, inputs, depth.map(|depth| words(&self.config, depth)));
        }
        for (stream, stalled) in [(&self.out, sink), (&self.reads, reads), (&self.writes, writes)] {
            inputs[stream.ready.expect("the stream has one")] = u64::from(!stalled);
        }
        if self.received.len() == self.expected { Flow::Done } else { Flow::Continue }
    }
}

#[test]
fn it_agrees_with_the_model_and_what_leaves_is_nearer_than_what_was_there() {
    let coarse = |config: &Config| Config { geometry: Format::BF16, rasterizer: None, ..config.clone() };
    let sizes = configs().into_iter().flat_map(|config| [config.clone(), coarse(&config)]).zip([8, 64, 16, 9, 200, 33]);
    for (config, merge_ahead) in cases(sizes) {
        let config = Config { merge: Feature::On, merge_ahead, ..config };
        let device = Device::new(&config, &merge::module(&config), &units::merge::UNIT);
        let fragments = surfaces(&config);
        let (expected, depths) = visible(&config, &fragments);
        let hidden = fragments.len() - expected.len();
        assert!(expected.len() > 1000 && hidden > 1000, "{} fragments are seen, {hidden} hidden", expected.len());
        for seed in seeds(SEEDS).expect("POINTCORE_SEED is a number") {
            let around = Around::new(&config, &device, &fragments, expected.len(), seed);
            let run = device.lockstep(Ported::new(&config, Merge::new(&config)), seed).run(around);
            let around = run.unwrap_or_else(|error| panic!("{error}")).stimulus;
            let mut received = around.received.iter().zip(&expected);
            assert!(received.all(|(left, right)| left.end && right.end || left == right), "seed {seed}");
            assert!(around.depths.iter().all(|(place, depth)| depths[place] == *depth), "seed {seed}");
            if seed == 0 {
                assert_eq!(u32::from(around.longest), TILE_SIZE, "a row is asked for at once");
                assert!(around.runs * 3 < fragments.len(), "{} runs", around.runs);
            }
        }
    }
}
