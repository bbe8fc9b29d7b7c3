//! `splat_lane` against its model, in every cycle, with a memory around it.

use std::collections::VecDeque;

use pointcore_contract::splat::config::{PayloadStore, TILE_PIXELS};
use pointcore_contract::splat::records::{Depth, PayloadWord, Pixel, PixelRun, SplatCopy, StoredPixel, buffer_tile};
use pointcore_contract::splat::{Config, Feature, units};
use pointcore_contract::{read, words};
use pointcore_golden::splat::lane::{In, Lane};
use pointcore_golden::splat::{Latencies, Share};
use pointcore_golden::unit::{Model, Ported};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::lane;
use pointcore_tb::lockstep::{Flow, Stall, Stalls, Stimulus, seeds};

use crate::splat::{Device, RUNS, configs, moving_configs, scene, stalls};
use crate::support::cases;

const SPLATS: usize = 1200;

/// The model with its copies and its memory: what it sees, the hardware sees.
#[derive(Clone)]
struct Loop {
    config: Config,
    lane: Lane,
    number: u8,
    copies: VecDeque<SplatCopy>,
    /// Frames that have not left.
    frames: usize,
    tiles: Vec<[Pixel; TILE_PIXELS as usize]>,
    beats: VecDeque<Pixel>,
    /// Words of payloads by place and number, and those that were asked for.
    words: Vec<PayloadWord>,
    payloads: VecDeque<PayloadWord>,
    /// Depths that were asked for.
    depths: VecDeque<Depth>,
    offers: [bool; 4],
    stalls: [Stalls; 10],
    places: Vec<usize>,
    random: fastrand::Rng,
    /// Pixels that were read, written and finished.
    counts: [usize; 3],
}

/// The depth in memory of a pixel: that of nothing, or any.
fn depth(tile: u32, pixel: u8) -> Depth {
    let spread = (tile * TILE_PIXELS + u32::from(pixel)).wrapping_mul(0x9e37_79b9);
    let depth = if spread.is_multiple_of(4) { f32::INFINITY } else { spread as f32 / u32::MAX as f32 };
    Depth { depth: depth.to_bits() }
}

impl Loop {
    fn new(config: &Config, (lane, number): (Lane, u8), device: &Device, (stall, seed): (Stall, u64)) -> Self {
        let share = Share::new(config);
        let mut begun = false;
        let here = |mut copy: SplatCopy| {
            begun &= !copy.first;
            let is_here = copy.end || share.rasterizer(copy.tile) == u32::from(number);
            copy.first = is_here && !begun;
            begun |= is_here;
            is_here.then_some(copy)
        };
        let mut random = fastrand::Rng::with_seed(seed);
        let copies = scene::touch(config, &scene::copies(config, SPLATS), 2, &mut random);
        let copies: VecDeque<_> = copies.into_iter().filter_map(here).collect();
        Self {
            config: config.clone(),
            lane,
            number,
            frames: copies.iter().filter(|copy| copy.end).count(),
            copies,
            tiles: vec![[Pixel::default(); TILE_PIXELS as usize]; config.buffer_tiles()],
            beats: VecDeque::new(),
            words: vec![PayloadWord::default(); (config.splats_held() * config.payload_beats) as usize],
            payloads: VecDeque::new(),
            depths: VecDeque::new(),
            offers: [false; 4],
            stalls: [(); 10].map(|()| Stalls::new(stall, random.fork())),
            places: device.input_places(),
            random,
            counts: [0; 3],
        }
    }

    /// What the lane's ports see in a cycle.
    fn step(&mut self) -> Vec<u64> {
        let out = self.lane.outputs();
        let [
            copies,
            data,
            read_ready,
            write_ready,
            pixel_ready,
            payload_data,
            payload_read_ready,
            payload_write_ready,
            depth_data,
            depth_read_ready,
        ] = self.stalls.each_mut().map(|stalls| !stalls.stalled());
        // An offer once made stands until it is taken.
        self.offers[0] |= copies && !self.copies.is_empty();
        self.offers[1] |= data && !self.beats.is_empty();
        self.offers[2] |= payload_data && !self.payloads.is_empty();
        self.offers[3] |= depth_data && !self.depths.is_empty();
        let inputs = In {
            input: self.copies.front().copied().filter(|_| self.offers[0]),
            read_ready,
            data: self.beats.front().copied().filter(|_| self.offers[1]),
            write_ready,
            pixel_ready,
            number: self.number,
            frame_sent: self.random.u8(..) == 0,
            filter_scale: scene::registers(&self.config).filter_scale,
            depth_a: scene::registers(&self.config).viewport.depth_a,
            payload_data: self.payloads.front().copied().filter(|_| self.offers[2]),
            payload_read_ready,
            payload_write_ready,
            depth_read_ready,
            depth_data: self.depths.front().copied().filter(|_| self.offers[3]),
        };
        if self.offers[0] && out.in_ready {
            self.copies.pop_front();
            self.offers[0] = false;
        }
        if self.offers[1] && out.data_ready {
            self.beats.pop_front();
            self.offers[1] = false;
            self.counts[0] += 1;
        }
        if let Some(read) = out.read.filter(|_| read_ready) {
            let PixelRun { surface, tile, pixel, count } = read;
            self.beats.extend(
                &self.tiles[buffer_tile(&self.config, surface, tile)][usize::from(pixel)..][..usize::from(count)],
            );
        }
        if let Some(StoredPixel { surface, placed }) = out.write.filter(|_| write_ready) {
            self.tiles[buffer_tile(&self.config, surface, placed.tile)][usize::from(placed.pixel)] = placed.value;
            self.counts[1] += 1;
        }
        let count = self.config.payload_beats as usize;
        if self.offers[2] && out.payload_data_ready {
            self.payloads.pop_front();
            self.offers[2] = false;
        }
        if let Some(read) = out.payload_read.filter(|_| payload_read_ready) {
            self.payloads.extend(&self.words[usize::from(read.splat) * count..][..count]);
        }
        if let Some(write) = out.payload_write.filter(|_| payload_write_ready) {
            self.words[usize::from(write.splat) * count + usize::from(write.word)] = write.value;
        }
        if self.offers[3] && out.depth_data_ready {
            self.depths.pop_front();
            self.offers[3] = false;
        }
        if let Some(run) = out.depth_read.filter(|_| depth_read_ready) {
            self.depths.extend((0..run.count).map(|pixel| depth(run.tile, run.pixel + pixel)));
        }
        if let Some(finished) = out.pixel.filter(|_| pixel_ready) {
            self.frames -= usize::from(finished.end);
            self.counts[2] += usize::from(!finished.end);
        }
        // The model sees what the ports carry.
        let seen = words(&self.config, inputs);
        self.lane.clock(&read(&self.config, &seen));
        seen
    }
}

impl Stimulus for Loop {
    fn drive(&mut self, _cycle: u64, _outputs: &[u64], inputs: &mut [u64]) -> Flow {
        if self.frames == 0 {
            return Flow::Done;
        }
        let seen = self.step();
        // `rst` comes first.
        self.places[1..].iter().zip(seen).for_each(|(&place, word)| inputs[place] = word);
        Flow::Continue
    }
}

#[test]
fn it_agrees_with_the_model() {
    let [bare, _, mixed] = configs();
    let in_memory = Config { payload: PayloadStore::Memory, payload_beats: 4, payload_ahead: 5, ..mixed.clone() };
    let [moving, ..] = moving_configs();
    let moving = Config { merge: Feature::On, ..moving };
    for (config, number) in cases([(bare, 0), (Config { rasterizers: 4, ..mixed }, 2), (in_memory, 0), (moving, 0)]) {
        let hardware = lane::lane(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let latency = |unit: &str| hardware.manifests[unit].latency;
        let [rasterizer, weighting] = ["rasterizer", "weighting"].map(latency);
        let latencies = Latencies { transform: 0, setup: 0, rasterizer, weighting, normalizer: 0 };
        let device = Device::new(&config, &hardware.module, &units::lane::UNIT);
        let model = Lane::new(&config, &latencies);
        for seed in seeds(RUNS).unwrap() {
            let stimulus = Loop::new(&config, (model.clone(), number), &device, (stalls(seed), seed));
            let run = device.lockstep(Ported::new(&config, model.clone()), seed).run(stimulus);
            let run = run.unwrap_or_else(|error| panic!("{error}"));
            let [read, written, finished] = run.stimulus.counts;
            assert!(read > 500 && written > 500 && finished > 300, "seed {seed}: {read}, {written}, {finished}");
        }
    }
}
