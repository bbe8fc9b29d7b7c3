//! The host around the renderer: writes uniforms, sends splats, plays its memories, collects fragments, counts.

use super::depth_memory::DepthMemory;
use super::encode::EncodedFrame;
use super::memory::ReconstructionBuffer;
use super::payload_memory::PayloadMemory;
use crate::generated::Progress;
use crate::memory::{MemorySettings, Traffic};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Fragment, UniformWrite};
use pointcore_contract::splat::units::Events;
use pointcore_contract::{read, words, write};
use pointcore_golden::splat::top::{In, Out};
use pointcore_tb::lockstep::{Flow, Stalls, Stimulus};

/// Cycles between two reports of progress.
const PROGRESS_INTERVAL_CYCLES: u64 = 1024;

/// Cycles of each of the core's [`Events`], of all its rasterizers together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EventCounts {
    /// The rasterizer evaluated a sample.
    pub sample: u64,
    /// The rasterizer had no copy to work on.
    pub starved: u64,
    /// The rasterizer's pipeline was held by what follows it.
    pub blocked: u64,
    /// The accumulator took a sample.
    pub accumulate: u64,
    /// The accumulator waited for an earlier sample of the same pixel.
    pub hazard: u64,
    /// The accumulator waited for its tile to arrive in the cache.
    pub slot_wait: u64,
    /// Fragments that something nearer in memory hid, or samples of what moves.
    pub hidden: u64,
}

impl EventCounts {
    /// Counts what happened in a cycle.
    fn add(&mut self, events: &Events) {
        let Events { sample, starved, blocked, accumulate, hazard, slot_wait, hidden } = *events;
        self.sample += u64::from(sample);
        self.starved += u64::from(starved);
        self.blocked += u64::from(blocked);
        self.accumulate += u64::from(accumulate);
        self.hazard += u64::from(hazard);
        self.slot_wait += u64::from(slot_wait);
        self.hidden += u64::from(hidden);
    }
}

/// What a run counted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SplatCounters {
    /// Cycles from the first splat offered to the last end fragment.
    pub cycles: u64,
    /// Cycles of each event.
    pub events: EventCounts,
    /// Pixels that passed between core and reconstruction buffer.
    pub buffer: Traffic,
    /// Words that passed between core and the memory of payloads.
    pub payloads: Traffic,
    /// Depths that passed between core and the memory that fragments are tested against, or samples of what moves.
    pub depths: Traffic,
}

/// The host as a stimulus: it sees the outputs of the cycle before.
#[derive(Clone)]
pub struct SplatHost<'a> {
    config: &'a Config,
    frame: &'a EncodedFrame,
    /// Values of the uniform registers by address.
    uniforms: Vec<u64>,
    stalls: Stalls,
    progress: Progress<'a>,
    stop_after: Option<u64>,
    inputs: In,
    sent: usize,
    /// Frames that are sent, by their end records.
    frames: usize,
    /// By port: frames of which it has brought the end fragment.
    ended: Vec<usize>,
    buffer: ReconstructionBuffer,
    payloads: PayloadMemory,
    depths: DepthMemory,
    /// Fragments as they came; end fragments are not among them.
    pub fragments: Vec<Fragment>,
    /// Counts so far.
    pub counters: SplatCounters,
}

impl<'a> SplatHost<'a> {
    /// A host that sends `frame` once and waits for as many end fragments as it has end records; `stalls` says when it holds
    /// back, `memory` how reconstruction buffer, payloads and depths answer, each from a memory of its own.
    #[must_use]
    pub fn new(
        config: &'a Config,
        frame: &'a EncodedFrame,
        memory: MemorySettings,
        stalls: Stalls,
        progress: Progress<'a>,
    ) -> Self {
        Self {
            config,
            frame,
            uniforms: words(config, frame.uniforms),
            stalls,
            progress,
            stop_after: None,
            inputs: In::default(),
            sent: 0,
            frames: frame.records.iter().filter(|record| record.end).count(),
            ended: vec![0; config.memory_ports as usize],
            buffer: ReconstructionBuffer::new(config, memory),
            payloads: PayloadMemory::new(config, memory),
            depths: DepthMemory::new(config, memory, frame.depths.as_ref()),
            fragments: Vec::new(),
            counters: SplatCounters::default(),
        }
    }

    /// Cuts the run off after so many cycles.
    #[must_use]
    pub const fn stop_after(mut self, cycles: Option<u64>) -> Self {
        self.stop_after = cycles;
        self
    }

    /// The inputs of the present cycle.
    #[must_use]
    pub const fn inputs(&self) -> &In {
        &self.inputs
    }

    /// Sets the inputs of `cycle`, seeing the outputs of the cycle before.
    pub fn drive(&mut self, cycle: u64, outputs: &Out) -> Flow {
        if self.stop_after == Some(cycle) {
            return Flow::Done;
        }
        let first_splat_cycle = self.uniforms.len() as u64;
        if cycle > 0 && self.account(cycle, outputs) {
            self.counters.cycles = cycle - first_splat_cycle;
            self.counters.buffer = self.buffer.traffic();
            self.counters.payloads = self.payloads.traffic();
            self.counters.depths = self.depths.traffic();
            return Flow::Done;
        }
        if cycle.is_multiple_of(PROGRESS_INTERVAL_CYCLES) {
            (self.progress)(cycle, self.sent as f64 / self.frame.records.len() as f64);
        }
        self.buffer.advance(cycle);
        self.payloads.advance(cycle);
        self.depths.advance(cycle);
        let uniform = self.uniforms.get(cycle as usize);
        self.inputs.uniform = uniform.map(|&data| UniformWrite { address: cycle as u8, data: data as u32 });
        if cycle >= first_splat_cycle {
            self.offer(cycle, outputs);
        }
        for port in 0..self.ended.len() {
            self.inputs.read_ready[port] = !self.stalls.stalled();
            self.inputs.write_ready[port] = !self.stalls.stalled() && self.buffer.is_writable(cycle);
            self.inputs.fragment_ready[port] = !self.stalls.stalled();
        }
        for port in 0..self.payloads.ports() {
            self.inputs.payload_read_ready[port] = !self.stalls.stalled();
            self.inputs.payload_write_ready[port] = !self.stalls.stalled() && self.payloads.is_writable(cycle);
        }
        for port in 0..self.depths.ports() {
            self.inputs.depth_read_ready[port] = !self.stalls.stalled();
            self.inputs.depth_write_ready[port] = !self.stalls.stalled() && self.depths.is_writable(cycle);
        }
        Flow::Continue
    }

    /// Accounts for what moved in the cycle before; true when the last end fragment came.
    fn account(&mut self, cycle: u64, outputs: &Out) -> bool {
        self.sent += usize::from(self.inputs.splat.is_some() && outputs.splat_ready);
        self.counters.events.add(&outputs.events);
        for (port, ended) in self.ended.iter_mut().enumerate() {
            if let Some(read) = outputs.read[port].filter(|_| self.inputs.read_ready[port]) {
                self.buffer.request(port, read, cycle);
            }
            if self.inputs.data[port].is_some() && outputs.data_ready[port] {
                self.buffer.take(port);
            }
            if let Some(write) = outputs.write[port].as_ref().filter(|_| self.inputs.write_ready[port]) {
                self.buffer.write(port, write, cycle - 1);
            }
            if let Some(fragment) = outputs.fragment[port].filter(|_| self.inputs.fragment_ready[port]) {
                if fragment.end {
                    *ended += 1;
                } else {
                    self.fragments.push(fragment);
                }
            }
        }
        for port in 0..self.payloads.ports() {
            if let Some(read) = outputs.payload_read[port].filter(|_| self.inputs.payload_read_ready[port]) {
                self.payloads.request(port, read, cycle);
            }
            if self.inputs.payload_data[port].is_some() && outputs.payload_data_ready[port] {
                self.payloads.take(port);
            }
            if let Some(write) = outputs.payload_write[port].filter(|_| self.inputs.payload_write_ready[port]) {
                self.payloads.write(port, &write, cycle - 1);
            }
        }
        for port in 0..self.depths.ports() {
            if let Some(read) = outputs.depth_read[port].filter(|_| self.inputs.depth_read_ready[port]) {
                self.depths.request(port, read, cycle);
            }
            if self.inputs.depth_data[port].is_some() && outputs.depth_data_ready[port] {
                self.depths.take(port);
            }
            if let Some(write) = outputs.depth_write[port].filter(|_| self.inputs.depth_write_ready[port]) {
                self.depths.write(port, &write, cycle - 1);
            }
        }
        self.ended.iter().all(|ended| *ended == self.frames)
    }

    /// Offers the next record and what memories show, unless the stalls hold them back; an offer once made stands.
    fn offer(&mut self, cycle: u64, outputs: &Out) {
        if self.inputs.splat.is_none() || outputs.splat_ready {
            let record = self.frame.records.get(self.sent).copied();
            self.inputs.splat = record.filter(|_| !self.stalls.stalled());
        }
        for port in 0..self.ended.len() {
            if self.inputs.data[port].is_none() || outputs.data_ready[port] {
                self.inputs.data[port] = self.buffer.offer(port, cycle).filter(|_| !self.stalls.stalled());
            }
        }
        for port in 0..self.payloads.ports() {
            if self.inputs.payload_data[port].is_none() || outputs.payload_data_ready[port] {
                self.inputs.payload_data[port] = self.payloads.offer(port, cycle).filter(|_| !self.stalls.stalled());
            }
        }
        for port in 0..self.depths.ports() {
            if self.inputs.depth_data[port].is_none() || outputs.depth_data_ready[port] {
                self.inputs.depth_data[port] = self.depths.offer(port, cycle).filter(|_| !self.stalls.stalled());
            }
        }
    }
}

/// The host at the core's ports, a word each.
impl Stimulus for SplatHost<'_> {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let flow = SplatHost::drive(self, cycle, &read(self.config, outputs));
        // The reset comes first.
        write(self.config, self.inputs, &mut inputs[1..]);
        flow
    }
}
