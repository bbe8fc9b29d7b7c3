//! Runs the composed core: feeds splats, answers its memory port, collects fragments, stalling every stream at random.

use fastrand::Rng;
use pointcore_contract::splat::config::TILE_PIXELS;
use pointcore_contract::splat::records::{
    Fragment, PayloadWord, Pixel, Splat as SplatRecord, StoredPixel, UniformWrite, buffer_tile, uniform_formats,
};
use pointcore_contract::splat::{AttributeFormat, Config, UniformFormat};
use pointcore_contract::{Camera, Format, Rendering, Splat};
use pointcore_golden::float;
use pointcore_golden::splat::Latencies;
use pointcore_golden::splat::top::{In, Out, Top};
use pointcore_golden::unit::Model;
use std::collections::VecDeque;

/// Pipelines of plausible lengths.
pub const LATENCIES: Latencies = Latencies { transform: 17, setup: 60, rasterizer: 41, weighting: 5, normalizer: 23 };

/// Cycles without any transfer after which the core counts as stuck.
const PATIENCE: u32 = 100_000;

/// How often a stream pauses.
#[derive(Clone, Copy, Debug)]
pub enum Stalls {
    /// Never.
    None,
    /// At random, in stretches, by this seed.
    Random(u64),
}

/// A number in one of the core's formats.
pub fn encode(format: Format, number: f32) -> u32 {
    float::convert(Format::F32, format, u64::from(number.to_bits())) as u32
}

/// The number that a format's bits encode.
pub fn decode(format: Format, bits: u32) -> f64 {
    f64::from(f32::from_bits(float::convert(format, Format::F32, u64::from(bits)) as u32))
}

/// An attribute as the host sends it.
pub fn encode_attribute(format: AttributeFormat, number: f32) -> u32 {
    match format {
        AttributeFormat::Float(format) => encode(format, number),
        AttributeFormat::Fixed(fraction) => {
            let (width, one) = (fraction.width(), 0.5_f32.powi(1 - fraction.width() as i32));
            let number = (number * one).round().clamp(-one, one - 1.0) as i32;
            number as u32 & ((1 << width) - 1)
        }
    }
}

/// The number that an attribute's bits encode.
pub fn decode_attribute(format: AttributeFormat, bits: u32) -> f64 {
    match format {
        AttributeFormat::Float(format) => decode(format, bits),
        AttributeFormat::Fixed(fraction) => {
            let one = 1_i32 << (fraction.width() - 1);
            let number = bits as i32;
            f64::from(if number < one { number } else { number - 2 * one }) / f64::from(one)
        }
    }
}

/// A splat as the core receives it; the material is the only cardinal attribute.
pub fn record(config: &Config, splat: &Splat) -> SplatRecord {
    let geometry = |vector: [f32; 3]| vector.map(|number| encode(config.geometry, number));
    let continuous = splat.attributes.iter().map(|number| encode_attribute(config.attribute, *number));
    let mut attributes = [0; 14];
    let values = continuous.take(config.continuous as usize).chain([u32::from(splat.material)]);
    attributes.iter_mut().zip(values).for_each(|(place, value)| *place = value);
    let tangents = splat.tangents.map(geometry);
    SplatRecord { center: geometry(splat.center), tangents, attributes, ..SplatRecord::default() }
}

/// Values of the uniform registers, in their order.
pub fn uniforms(config: &Config, camera: &Camera, rendering: &Rendering) -> Vec<u32> {
    let radius = rendering.filter_radius_px.unwrap_or(1.0);
    let mut numbers: Vec<f64> = camera.model_view.into_iter().flatten().collect();
    numbers.extend([camera.scale_x, camera.scale_y, camera.center_x, camera.center_y]);
    numbers.extend([camera.depth_a, camera.depth_b, camera.near]);
    numbers.extend([rendering.epsilon_scale, rendering.epsilon_bias, radius, 1.0 / (radius * radius)]);
    let word = |(format, number): (UniformFormat, f64)| match format {
        UniformFormat::Float(format) => encode(format, number as f32),
        UniformFormat::Fixed(fixed) => (number * f64::from(1 << fixed.fraction)).round() as u32,
    };
    uniform_formats(config).zip(numbers).map(word).collect()
}

/// The reconstruction buffer's memory: answers reads of a port in order, each after the writes that came before it.
struct Memory {
    tiles: Vec<[Pixel; TILE_PIXELS as usize]>,
    beats: Vec<VecDeque<Pixel>>,
}

/// The memory of a rasterizer's payloads: likewise.
struct Payloads {
    /// By place and number.
    words: Vec<PayloadWord>,
    beats: VecDeque<PayloadWord>,
    /// Data, read, write.
    gates: [Gate; 3],
}

/// Whether a stream may move in this cycle; changes its mind rarely, so that queues fill and empty.
struct Gate {
    open: bool,
}

impl Gate {
    fn step(&mut self, random: &mut Option<Rng>) -> bool {
        if let Some(random) = random {
            self.open ^= random.u8(0..8) == 0;
        }
        self.open
    }
}

/// The core with everything around it.
pub struct Bench {
    config: Config,
    top: Top,
    memory: Memory,
    random: Option<Rng>,
    splat_gate: Gate,
    /// Of each port: data, read, write, fragment.
    gates: Vec<[Gate; 4]>,
    payloads: Vec<Payloads>,
    /// Cycles run.
    pub cycles: u64,
    /// Pixels written to memory.
    pub writes: u64,
}

impl Bench {
    pub fn new(config: &Config, latencies: &Latencies, stalls: Stalls) -> Self {
        let random = match stalls {
            Stalls::None => None,
            Stalls::Random(seed) => Some(Rng::with_seed(seed)),
        };
        let ports = 0..config.memory_ports;
        Self {
            config: config.clone(),
            top: Top::new(config, latencies),
            // Contents before the first write must not matter.
            memory: Memory {
                tiles: vec![[garbage(); 64]; config.buffer_tiles()],
                beats: ports.clone().map(|_| VecDeque::new()).collect(),
            },
            random,
            splat_gate: Gate { open: true },
            gates: ports.map(|_| [(); 4].map(|()| Gate { open: true })).collect(),
            payloads: (0..config.payload_ports())
                .map(|_| Payloads {
                    words: vec![PayloadWord::default(); (config.splats_held() * config.payload_beats) as usize],
                    beats: VecDeque::new(),
                    gates: [(); 3].map(|()| Gate { open: true }),
                })
                .collect(),
            cycles: 0,
            writes: 0,
        }
    }

    pub fn write_uniforms(&mut self, values: &[u32]) {
        for (address, &data) in (0..).zip(values) {
            self.top.clock(&In { uniform: Some(UniformWrite { address, data }), ..In::default() });
        }
    }

    /// Renders frames back to back: the splats of the next follow at once. Fragments are in scan order.
    pub fn render(&mut self, frames: &[Vec<SplatRecord>]) -> Vec<Vec<Fragment>> {
        let end = SplatRecord { end: true, ..SplatRecord::default() };
        let mut splats = frames.iter().flat_map(|frame| frame.iter().copied().chain([end])).peekable();
        let mut images = vec![Vec::new(); frames.len()];
        // Frames that each port has ended.
        let mut ended = vec![0; self.gates.len()];
        let mut patience = PATIENCE;
        while ended.iter().any(|ended| *ended < frames.len()) {
            let splat = self.splat_gate.step(&mut self.random);
            let out = self.top.outputs();
            let mut inputs = In { splat: if splat { splats.peek().copied() } else { None }, ..In::default() };
            for (port, gates) in self.gates.iter_mut().enumerate() {
                let [data, read, write, fragment] = gates.each_mut().map(|gate| gate.step(&mut self.random));
                inputs.read_ready[port] = read;
                inputs.data[port] = if data { self.memory.beats[port].front().copied() } else { None };
                inputs.write_ready[port] = write;
                inputs.fragment_ready[port] = fragment;
            }
            for (port, Payloads { beats, gates, .. }) in self.payloads.iter_mut().enumerate() {
                let [data, read, write] = gates.each_mut().map(|gate| gate.step(&mut self.random));
                inputs.payload_data[port] = if data { beats.front().copied() } else { None };
                inputs.payload_read_ready[port] = read;
                inputs.payload_write_ready[port] = write;
            }
            patience -= 1;
            if inputs.splat.is_some() && out.splat_ready {
                splats.next();
                patience = PATIENCE;
            }
            for (port, ended) in ended.iter_mut().enumerate() {
                if self.exchange(port, &inputs, &out) {
                    patience = PATIENCE;
                }
                if let Some(fragment) = out.fragment[port].filter(|_| inputs.fragment_ready[port]) {
                    patience = PATIENCE;
                    if fragment.end {
                        *ended += 1;
                    } else {
                        images[*ended].push(fragment);
                    }
                }
            }
            self.exchange_payloads(&inputs, &out);
            self.top.clock(&inputs);
            self.cycles += 1;
            assert!(patience > 0, "the core is stuck in cycle {}: {:?}", self.cycles, self.top.outputs());
        }
        // Tiles leave in an order that depends on stalls.
        images.iter_mut().for_each(|image| image.sort_by_key(|fragment| (fragment.row, fragment.column)));
        images
    }

    /// A port's cycle at the memory; whether pixels move.
    fn exchange(&mut self, port: usize, inputs: &In, out: &Out) -> bool {
        let Memory { tiles, beats } = &mut self.memory;
        let comes = inputs.data[port].is_some() && out.data_ready[port];
        if comes {
            beats[port].pop_front();
        }
        if let Some(read) = out.read[port].filter(|_| inputs.read_ready[port]) {
            let run = usize::from(read.pixel)..usize::from(read.pixel + read.count);
            beats[port].extend(&tiles[buffer_tile(&self.config, read.surface, read.tile)][run]);
        }
        let write = out.write[port].filter(|_| inputs.write_ready[port]);
        if let Some(StoredPixel { surface, placed }) = write {
            tiles[buffer_tile(&self.config, surface, placed.tile)][usize::from(placed.pixel)] = placed.value;
            self.writes += 1;
        }
        comes || write.is_some()
    }

    /// A cycle at the memories of payloads.
    fn exchange_payloads(&mut self, inputs: &In, out: &Out) {
        let count = self.config.payload_beats as usize;
        for (port, Payloads { words, beats, .. }) in self.payloads.iter_mut().enumerate() {
            if inputs.payload_data[port].is_some() && out.payload_data_ready[port] {
                beats.pop_front();
            }
            if let Some(read) = out.payload_read[port].filter(|_| inputs.payload_read_ready[port]) {
                beats.extend(&words[usize::from(read.splat) * count..][..count]);
            }
            if let Some(write) = out.payload_write[port].filter(|_| inputs.payload_write_ready[port]) {
                words[usize::from(write.splat) * count + usize::from(write.word)] = write.value;
            }
        }
    }
}

fn garbage() -> Pixel {
    Pixel { weight: 12_345, depth: 678_910, peak: 11, attributes: [0x1234; 14], ..Pixel::default() }
}
