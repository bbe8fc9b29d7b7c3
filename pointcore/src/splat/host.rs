//! The host around the renderer: writes uniforms, sends splats, plays the reconstruction buffer, collects fragments, counts.

use super::encode::EncodedFrame;
use super::memory::ReconstructionBuffer;
use crate::generated::Progress;
use pointcore_contract::Direction;
use pointcore_contract::splat::ports::{self, EVENTS, UNIFORM_ADDRESS_BITS, UNIFORMS};
use pointcore_contract::splat::{Config, Port, records};
use pointcore_tb::lockstep::{Flow, Stalls, Stimulus};
use std::ops::Range;

/// Latency of the reconstruction buffer in cycles: a DRAM behind a controller.
const MEMORY_LATENCY_CYCLES: u64 = 24;
/// The bits of a uniform register's address.
const UNIFORM_ADDRESS_MASK: u64 = (1 << UNIFORM_ADDRESS_BITS) - 1;
/// Cycles between two reports of progress.
const PROGRESS_INTERVAL_CYCLES: u64 = 1024;

/// Places of a stream's ports among the words of a cycle. `valid` and `fields` are on one side, `ready` on the other.
#[derive(Clone)]
struct StreamPlaces {
    valid: usize,
    ready: usize,
    fields: Range<usize>,
}

/// Places of ports, as indices into the inputs or the outputs.
struct Places {
    names: [Vec<String>; 2],
}

impl Places {
    fn new(ports: &[Port]) -> Self {
        let side = |direction| {
            let side = ports.iter().filter(|port| port.direction == direction);
            side.map(|port| port.name.clone()).collect()
        };
        Self { names: [side(Direction::Input), side(Direction::Output)] }
    }

    fn find(&self, direction: Direction, name: &str) -> usize {
        let names = &self.names[usize::from(direction == Direction::Output)];
        names.iter().position(|port| port == name).expect("the host names ports of the core's own list")
    }

    /// A stream whose items travel in `direction`, seen from the core.
    fn stream(&self, direction: Direction, name: &str, fields: usize) -> StreamPlaces {
        let back = if direction == Direction::Input { Direction::Output } else { Direction::Input };
        let valid = self.find(direction, &format!("{name}_valid"));
        let ready = self.find(back, &format!("{name}_ready"));
        // The fields follow `valid`: `ready` points the other way.
        StreamPlaces { valid, ready, fields: valid + 1..valid + 1 + fields }
    }
}

/// What a run counted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SplatCounters {
    /// Cycles from the first splat offered to the last end fragment.
    pub cycles: u64,
    /// Cycles of each of [`EVENTS`].
    pub events: [u64; EVENTS.len()],
    /// Pixels read from the reconstruction buffer.
    pub pixels_read: u64,
    /// Pixels written to it.
    pub pixels_written: u64,
}

/// The host as a stimulus: it sees the outputs of the cycle before.
#[derive(Clone)]
pub struct SplatHost<'a> {
    frame: &'a EncodedFrame,
    stalls: Stalls,
    progress: Progress<'a>,
    uniform: [usize; 3],
    splat: StreamPlaces,
    read: StreamPlaces,
    data: StreamPlaces,
    write: StreamPlaces,
    fragment: StreamPlaces,
    events: Range<usize>,
    sent: usize,
    /// End records whose end fragment has not come yet.
    open_frames: usize,
    buffer: ReconstructionBuffer,
    /// Fragments as they came, field by field; end fragments are not among them.
    pub fragments: Vec<u64>,
    /// Counts so far.
    pub counters: SplatCounters,
}

impl<'a> SplatHost<'a> {
    /// A host that sends `frame` once and waits for as many end fragments as it has end records; `stalls` says when it holds
    /// back.
    #[must_use]
    pub fn new(config: &Config, frame: &'a EncodedFrame, stalls: Stalls, progress: Progress<'a>) -> Self {
        let places = Places::new(&ports::top(config));
        let input = |name: &str| places.find(Direction::Input, name);
        let pixel_words = records::pixel(config).len();
        let events = places.find(Direction::Output, EVENTS[0]);
        let tiles = 1 << config.tile_bits();
        Self {
            frame,
            stalls,
            progress,
            uniform: [input("uniform_valid"), input("uniform_address"), input("uniform_data")],
            splat: places.stream(Direction::Input, "splat", frame.record_words),
            read: places.stream(Direction::Output, "read", 1),
            data: places.stream(Direction::Input, "data", pixel_words),
            write: places.stream(Direction::Output, "write", 2 + pixel_words),
            fragment: places.stream(Direction::Output, "fragment", records::fragment(config).len()),
            events: events..events + EVENTS.len(),
            sent: 0,
            open_frames: frame.records.chunks_exact(frame.record_words).filter(|record| record[0] == 1).count(),
            buffer: ReconstructionBuffer::new(tiles, pixel_words, MEMORY_LATENCY_CYCLES),
            fragments: Vec::new(),
            counters: SplatCounters::default(),
        }
    }

    /// Accounts for what moved in the cycle before; true when the last end fragment came.
    fn account(&mut self, cycle: u64, inputs: &[u64], outputs: &[u64]) -> bool {
        if inputs[self.splat.valid] & outputs[self.splat.ready] == 1 {
            self.sent += 1;
        }
        if outputs[self.read.valid] & inputs[self.read.ready] == 1 {
            self.buffer.request(outputs[self.read.fields.start], cycle);
        }
        if inputs[self.data.valid] & outputs[self.data.ready] == 1 {
            self.buffer.take();
        }
        if outputs[self.write.valid] & inputs[self.write.ready] == 1 {
            let fields = &outputs[self.write.fields.clone()];
            self.buffer.write(fields[0], fields[1], &fields[2..]);
        }
        for (count, event) in self.counters.events.iter_mut().zip(&outputs[self.events.clone()]) {
            *count += event;
        }
        if outputs[self.fragment.valid] & inputs[self.fragment.ready] == 0 {
            return false;
        }
        let fields = &outputs[self.fragment.fields.clone()];
        if fields[0] == 1 {
            self.open_frames -= 1;
        } else {
            self.fragments.extend(&fields[1..]);
        }
        self.open_frames == 0
    }

    /// Offers the next record, unless the stalls hold it back; an offer once made stands.
    fn offer_splat(&mut self, inputs: &mut [u64], was_taken: bool) {
        let offered = inputs[self.splat.valid] == 1 && !was_taken;
        if !offered {
            let start = self.sent * self.frame.record_words;
            let record = self.frame.records.get(start..start + self.frame.record_words);
            let record = record.filter(|_| !self.stalls.stalled());
            inputs[self.splat.valid] = record.is_some().into();
            if let Some(record) = record {
                inputs[self.splat.fields.clone()].copy_from_slice(record);
            }
        }
    }

    fn offer_data(&mut self, cycle: u64, inputs: &mut [u64], was_taken: bool) {
        let offered = inputs[self.data.valid] == 1 && !was_taken;
        if !offered {
            let pixel = self.buffer.offer(cycle).filter(|_| !self.stalls.stalled());
            inputs[self.data.valid] = pixel.is_some().into();
            if let Some(pixel) = pixel {
                inputs[self.data.fields.clone()].copy_from_slice(pixel);
            }
        }
    }
}

impl Stimulus for SplatHost<'_> {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let first_splat_cycle = UNIFORMS.len() as u64;
        let splat_taken = inputs[self.splat.valid] & outputs[self.splat.ready] == 1;
        let data_taken = inputs[self.data.valid] & outputs[self.data.ready] == 1;
        if cycle > 0 && self.account(cycle, inputs, outputs) {
            self.counters.cycles = cycle - first_splat_cycle;
            self.counters.pixels_read = self.buffer.pixels_read;
            self.counters.pixels_written = self.buffer.pixels_written;
            return Flow::Done;
        }
        if cycle.is_multiple_of(PROGRESS_INTERVAL_CYCLES) {
            (self.progress)(cycle, self.sent as f64 / self.frame.count() as f64);
        }
        if cycle >= first_splat_cycle {
            self.offer_splat(inputs, splat_taken);
            self.offer_data(cycle, inputs, data_taken);
        }
        let uniform = self.frame.uniforms.get(cycle as usize);
        let words = [uniform.is_some().into(), cycle & UNIFORM_ADDRESS_MASK, uniform.copied().unwrap_or(0)];
        for (port, word) in self.uniform.into_iter().zip(words) {
            inputs[port] = word;
        }
        for ready in [self.read.ready, self.write.ready, self.fragment.ready] {
            inputs[ready] = (!self.stalls.stalled()).into();
        }
        Flow::Continue
    }
}
