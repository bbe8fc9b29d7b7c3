//! What is around the renderer: a host that sends frame after frame and memory behind it, each stream at its own pace,
//! with resets in between.

use super::frames::{Frame, HardCases, Lens, frames};
use super::pace::Paces;
use super::surroundings::{Idle, Pending, Surroundings, Watch, resets};
use crate::memory::MemorySettings;
use crate::splat::depth_memory::{DepthMemory, Depths};
use crate::splat::memory::ReconstructionBuffer;
use crate::splat::payload_memory::PayloadMemory;
use fastrand::Rng;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::UniformWrite;
use pointcore_contract::{read, write};
use pointcore_golden::splat::top::{In, Out};
use pointcore_tb::lockstep::{Flow, Stimulus};
use std::sync::Arc;

/// Streams that can be held back, and their places among the paces: those that there are once, then those of each port to the
/// reconstruction buffer, of each port to payloads, and of each to depths.
const SPLAT: usize = 0;
const UNIFORM: usize = 1;
/// The place of pixels from memory, at the first port.
pub const DATA: usize = 2;
/// That of reads.
pub const READ: usize = 3;
/// That of pixels to memory.
pub const WRITE: usize = 4;
const FRAGMENT: usize = 5;
/// Streams of a port.
const OF_PORT: usize = 4;
/// Streams of a port to payloads: words from there, reads, words to there.
const OF_PAYLOADS: usize = 3;
/// Streams of a port to depths, likewise.
const OF_DEPTHS: usize = 3;

/// How many streams can be held back.
#[must_use]
pub fn streams(config: &Config) -> usize {
    depth_streams(config) + OF_DEPTHS * config.merge_ports() as usize
}

/// The place of the first stream of depths.
fn depth_streams(config: &Config) -> usize {
    payload_streams(config) + OF_PAYLOADS * config.payload_ports() as usize
}

/// The place of the first stream of payloads.
const fn payload_streams(config: &Config) -> usize {
    DATA + OF_PORT * config.memory_ports as usize
}

/// How much there is of everything, at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// Frames one after the other.
    pub frames: usize,
    /// Splats of a frame; four times as many where they are small.
    pub splats: u32,
    /// Cycles that memory takes to answer.
    pub latency_cycles: u64,
    /// Cycles within which a reset comes, if one does.
    pub reset_cycles: u64,
}

/// The host and its memory before a run, or in the midst of it.
#[derive(Clone)]
pub struct Renderer {
    config: Config,
    frames: Arc<[Frame]>,
    paces: Paces,
    idle: Option<Idle>,
    watch: Watch,
    latency: u64,
    /// Cycles in which the core is reset.
    resets: Vec<u64>,
    buffer: ReconstructionBuffer,
    payloads: PayloadMemory,
    depths: DepthMemory,
    inputs: In,
    /// The frame that is being sent, and how many of its records have been.
    sending: usize,
    sent: usize,
    /// Uniform registers of that frame that have been written.
    written: usize,
    /// Frames whose end has come, by port to memory.
    ended: Vec<usize>,
}

/// What a host plays.
pub struct Script {
    /// Frames, one after the other.
    pub frames: Vec<Frame>,
    /// When streams are held back.
    pub paces: Paces,
    /// Cycles that memory takes to answer.
    pub latency: u64,
    /// Cycles in which the core is reset, the last one first.
    pub resets: Vec<u64>,
}

impl Script {
    /// A random one.
    #[must_use]
    pub fn random(config: &Config, most: Bounds, lens: Lens, hard: Option<HardCases>, random: &mut Rng) -> Self {
        let count = random.usize(1..=most.frames);
        let frames = frames(config, count, most.splats, lens, hard, random);
        let paces = Paces::random(random, streams(config));
        let latency = if random.bool() { random.u64(1..20) } else { random.u64(1..=most.latency_cycles) };
        Self { frames, paces, latency, resets: resets(most.reset_cycles, random) }
    }
}

/// An empty buffer, an empty memory of payloads, and depths of all kinds, which answer after a latency.
fn memories(config: &Config, latency_cycles: u64) -> (ReconstructionBuffer, PayloadMemory, DepthMemory) {
    let settings = MemorySettings { latency_cycles, ..ReconstructionBuffer::SETTINGS };
    // Spread evenly: the multiples of the golden section.
    let depth = |column: u32, row: u32| {
        let spread = (row * config.width + column).wrapping_mul(0x9e37_79b9);
        Some(spread as f32 / u32::MAX as f32)
    };
    let depths = config.merge.is_on().then(|| Depths::new(config, depth));
    (
        ReconstructionBuffer::new(config, settings),
        PayloadMemory::new(config, settings),
        DepthMemory::new(config, settings, depths.as_ref()),
    )
}

impl Renderer {
    /// The host of a core, out of reset; silence for so many cycles means that it is stuck. What streams that offer nothing
    /// show is filled, or left as it is.
    #[must_use]
    pub fn new(config: &Config, script: Script, idle: Option<Idle>, quiet_cycles: u64) -> Self {
        let Script { frames, paces, latency, resets } = script;
        let (buffer, payloads, depths) = memories(config, latency);
        Self {
            config: config.clone(),
            frames: frames.into(),
            watch: Watch::new(quiet_cycles + latency + paces.longest()),
            paces,
            idle,
            latency,
            resets,
            buffer,
            payloads,
            depths,
            inputs: In::default(),
            sending: 0,
            sent: 0,
            written: 0,
            ended: vec![0; config.memory_ports as usize],
        }
    }

    /// Begins again with the first frame that has not ended, on a core that has forgotten everything.
    fn restart(&mut self) {
        (self.buffer, self.payloads, self.depths) = memories(&self.config, self.latency);
        let ended = self.ended();
        self.ended.fill(ended);
        (self.sending, self.sent, self.written) = (ended, 0, 0);
    }

    /// Frames whose end has come through all ports.
    fn ended(&self) -> usize {
        self.ended.iter().copied().min().unwrap_or(0)
    }

    /// Takes what moved in the cycle before.
    fn account(&mut self, cycle: u64, outputs: &Out) {
        let inputs = &self.inputs;
        let splat = inputs.splat.is_some() && outputs.splat_ready;
        if splat {
            self.sent += 1;
            if self.sent == self.frames[self.sending].records.len() {
                (self.sending, self.sent) = (self.sending + 1, 0);
                // Where uniforms are kept, they have been written; else they are, once the frames before have ended.
                let is_new_view = self.frames.get(self.sending).is_some_and(|frame| frame.is_new_view);
                self.written = if is_new_view { 0 } else { self.written };
            }
        }
        let uniform = self.inputs.uniform.is_some();
        let ports = (0..self.ended.len()).filter(|port| self.account_port(*port, cycle, outputs)).count();
        let payloads = (0..self.payloads.ports()).filter(|port| self.account_payloads(*port, cycle, outputs)).count();
        let depths = (0..self.depths.ports()).filter(|port| self.account_depths(*port, cycle, outputs)).count();
        if splat || uniform || ports + payloads + depths > 0 {
            self.watch.moved(cycle);
        }
    }

    /// The same at a port to memory; whether something moved.
    fn account_port(&mut self, port: usize, cycle: u64, outputs: &Out) -> bool {
        let inputs = &self.inputs;
        let read = outputs.read[port].filter(|_| inputs.read_ready[port]);
        let data = inputs.data[port].is_some() && outputs.data_ready[port];
        let pixel = outputs.write[port].filter(|_| inputs.write_ready[port]);
        let fragment = outputs.fragment[port].filter(|_| inputs.fragment_ready[port]);
        if let Some(read) = read {
            self.buffer.request(port, read, cycle);
        }
        if data {
            self.buffer.take(port);
        }
        if let Some(pixel) = &pixel {
            self.buffer.write(port, pixel, cycle);
        }
        self.ended[port] += usize::from(fragment.is_some_and(|fragment| fragment.end));
        data || read.is_some() || pixel.is_some() || fragment.is_some()
    }

    /// The same at a port to payloads.
    fn account_payloads(&mut self, port: usize, cycle: u64, outputs: &Out) -> bool {
        let inputs = &self.inputs;
        let read = outputs.payload_read[port].filter(|_| inputs.payload_read_ready[port]);
        let data = inputs.payload_data[port].is_some() && outputs.payload_data_ready[port];
        let word = outputs.payload_write[port].filter(|_| inputs.payload_write_ready[port]);
        if let Some(read) = read {
            self.payloads.request(port, read, cycle);
        }
        if data {
            self.payloads.take(port);
        }
        if let Some(word) = &word {
            self.payloads.write(port, word, cycle);
        }
        data || read.is_some() || word.is_some()
    }

    /// The same at a port to depths.
    fn account_depths(&mut self, port: usize, cycle: u64, outputs: &Out) -> bool {
        let inputs = &self.inputs;
        let read = outputs.depth_read[port].filter(|_| inputs.depth_read_ready[port]);
        let data = inputs.depth_data[port].is_some() && outputs.depth_data_ready[port];
        let depth = outputs.depth_write[port].filter(|_| inputs.depth_write_ready[port]);
        if let Some(read) = read {
            self.depths.request(port, read, cycle);
        }
        if data {
            self.depths.take(port);
        }
        if let Some(depth) = &depth {
            self.depths.write(port, depth, cycle);
        }
        data || read.is_some() || depth.is_some()
    }

    /// Sets what is offered and what is taken; an offer once made stands.
    fn offer(&mut self, cycle: u64, outputs: &Out) {
        self.buffer.advance(cycle);
        self.payloads.advance(cycle);
        self.depths.advance(cycle);
        let idle: Vec<bool> = (0..streams(&self.config)).map(|stream| self.paces.idle(stream, cycle)).collect();
        let frame = self.frames.get(self.sending);
        let uniforms = frame.map_or(&[][..], |frame| &frame.uniforms);
        // Registers are written while no frame is under way.
        let may_write = self.ended() == self.sending && self.sent == 0 && !idle[UNIFORM];
        let data = uniforms.get(self.written).filter(|_| may_write && self.inputs.splat.is_none());
        self.inputs.uniform = data.map(|&data| UniformWrite { address: self.written as u8, data: data as u32 });
        let are_written = self.written == uniforms.len();
        self.written += usize::from(data.is_some());
        if self.inputs.splat.is_none() || outputs.splat_ready {
            let record = frame.and_then(|frame| frame.records.get(self.sent)).copied();
            self.inputs.splat = record.filter(|_| are_written && !idle[SPLAT]);
        }
        for (port, idle) in (0..self.ended.len()).zip(idle[DATA..].chunks(OF_PORT)) {
            let is_idle = |stream: usize| idle[stream - DATA];
            if self.inputs.data[port].is_none() || outputs.data_ready[port] {
                self.inputs.data[port] = self.buffer.offer(port, cycle).filter(|_| !is_idle(DATA));
            }
            self.inputs.read_ready[port] = !is_idle(READ);
            self.inputs.write_ready[port] = !is_idle(WRITE);
            self.inputs.fragment_ready[port] = !is_idle(FRAGMENT);
        }
        let [payloads, depths] = [payload_streams(&self.config), depth_streams(&self.config)];
        for (port, idle) in idle[payloads..depths].chunks(OF_PAYLOADS).enumerate() {
            if self.inputs.payload_data[port].is_none() || outputs.payload_data_ready[port] {
                self.inputs.payload_data[port] = self.payloads.offer(port, cycle).filter(|_| !idle[0]);
            }
            self.inputs.payload_read_ready[port] = !idle[1];
            self.inputs.payload_write_ready[port] = !idle[2];
        }
        for (port, idle) in idle[depths..].chunks(OF_DEPTHS).enumerate() {
            if self.inputs.depth_data[port].is_none() || outputs.depth_data_ready[port] {
                self.inputs.depth_data[port] = self.depths.offer(port, cycle).filter(|_| !idle[0]);
            }
            self.inputs.depth_read_ready[port] = !idle[1];
            self.inputs.depth_write_ready[port] = !idle[2];
        }
    }
}

impl Stimulus for Renderer {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let outputs: Out = read(&self.config, outputs);
        if inputs[0] == 1 {
            // What was offered to a core in reset was not taken, and need not be offered again.
            self.inputs = In::default();
        } else if cycle > 0 {
            self.account(cycle - 1, &outputs);
        }
        if self.watch.is_over(cycle, self.ended() == self.frames.len()) {
            return Flow::Done;
        }
        let is_reset = self.resets.pop_if(|next| *next <= cycle).is_some();
        if is_reset {
            self.restart();
        } else {
            self.offer(cycle, &outputs);
        }
        // The reset comes first.
        inputs[0] = u64::from(is_reset);
        write(&self.config, self.inputs, &mut inputs[1..]);
        if let Some(idle) = &mut self.idle {
            idle.fill(inputs);
        }
        Flow::Continue
    }
}

impl Surroundings for Renderer {
    fn stuck(&self) -> Option<u64> {
        self.watch.stuck()
    }

    fn pending(&self) -> Pending {
        let ended = self.ended();
        Pending { done: ended, expected: self.frames.len(), what: "frames" }
    }

    fn without_watch(mut self) -> Self {
        self.watch = Watch::new(u64::MAX);
        self
    }
}
