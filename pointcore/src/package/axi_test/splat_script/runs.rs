//! Frames of the renderer: whole ones, disturbed ones, and such as are aborted.

use super::super::bench::depth_at;
use super::super::control::Control;
use super::super::operations::{Channel, Pauses, Refusal};
use super::super::registers::{ABORT, BUSY, DONE, RESET, START, WAITING, clear, refuse_while_busy};
use super::super::script::{Script, words};
use super::frames::{EMPTY, Frame};
use crate::splat::depth_memory::Depths;
use pointcore_contract::bus::registers::{CONTROL, ErrorCounter, INTERRUPT_ENABLE, STATUS};
use pointcore_contract::bus::{Layout, Register};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Fragment, LOCAL_BITS, Splat, Uniforms, late_uniforms};
use pointcore_contract::{Field, fields, words as values};

/// Where the buffer lies in each frame.
const BASES: [u32; 2] = [0x5a96_7000, 0xa569_8000];
/// Where payloads lie in each frame.
const PAYLOAD_BASES: [u32; 2] = [0x3c96_9000, 0xc369_6000];
/// Where depths lie in each frame.
const DEPTH_BASES: [u32; 2] = [0x1e4b_5000, 0xe1b4_a000];
/// Frames of a run: with one camera and another, and with another screen filter.
const AHEAD: [usize; 6] = [0, 1, 0, 2, 1, 1];
/// Cycles in which what is under way comes to rest, or to wherever it is held.
const SETTLE_CYCLES: u32 = 600;
/// Cycles in which a core has cleared its directory of tiles, beyond one a tile.
const CLEAR_CYCLES: u32 = 100;
/// Cycles that a splat takes to be set up, where those before it are not in the way for long.
const SPLAT_CYCLES: u32 = 100;
/// Cycles of the longest run.
const LONG_RUN_CYCLES: u32 = 70_000;
/// A channel hardly moves.
const HARDLY: u8 = 248;
/// Nothing but holds a channel back.
const ALWAYS: u8 = 255;

/// The tile of a fragment, or none for the end; each bin of the exposure has its own.
fn tile(fragment: &Fragment) -> Option<(u16, u16, u8)> {
    let &Fragment { end, row, column, seen, .. } = fragment;
    (!end).then_some((row >> LOCAL_BITS, column >> LOCAL_BITS, seen.bin))
}

/// A host with its core.
pub struct Host<'a> {
    pub control: Control<'a>,
    config: &'a Config,
    frames: &'a [Frame],
    /// The frame in force.
    now: usize,
}

impl<'a> Host<'a> {
    pub fn new(script: &'a mut Script, config: &'a Config, map: &'a [Register], frames: &'a [Frame]) -> Self {
        Self { control: Control { script, map }, config, frames, now: 0 }
    }

    /// Writes what a frame needs, in any order.
    pub fn enter(&mut self, frame: usize) {
        self.control.set("buffer_base", BASES[frame]);
        if self.config.has_payloads_in_memory() {
            self.control.set("payload_base", PAYLOAD_BASES[frame]);
        }
        if self.config.merge.is_on() {
            self.control.set("depth_base", DEPTH_BASES[frame]);
        }
        self.control.script.write(INTERRUPT_ENABLE, 1);
        self.look(frame);
    }

    /// Writes a frame's uniforms, in any order.
    fn look(&mut self, frame: usize) {
        self.now = frame;
        let mut uniforms = self.uniforms();
        self.control.script.random.shuffle(&mut uniforms);
        for (field, value) in uniforms {
            self.control.set(&field.name, value as u32);
        }
    }

    /// The uniforms of the frame in force.
    fn uniforms(&self) -> Vec<(Field, u64)> {
        let uniforms = fields::<Uniforms>(self.config).into_iter();
        uniforms.zip(values(self.config, self.frames[self.now].sent.uniforms)).collect()
    }

    /// The packet of a splat, with noise where it holds nothing.
    fn packet(&mut self, index: usize) -> Vec<u32> {
        let layout = Layout::record::<Splat>(self.config);
        let splat = values(self.config, self.frames[self.now].sent.records[index]);
        self.control.script.packet(&layout, &splat, self.config.bus.stream_bits)
    }

    fn send(&mut self, index: usize) {
        let packet = self.packet(index);
        self.control.script.send(&packet, self.config.bus.stream_bits);
    }

    fn count(&self) -> usize {
        self.frames[self.now].sent.records.len()
    }

    fn send_all(&mut self) {
        (0..self.count()).for_each(|index| self.send(index));
    }

    /// Places a frame's memories, with nothing in them but depths.
    fn place(&mut self, frame: usize) {
        self.control.script.place_buffer(BASES[frame]);
        if self.config.has_payloads_in_memory() {
            self.control.script.place_payloads(PAYLOAD_BASES[frame]);
        }
        if self.config.merge.is_on() {
            self.control.script.place_depths(DEPTH_BASES[frame]);
        }
    }

    /// Expects all fragments, and an empty buffer.
    fn expect(&mut self) {
        self.expect_all(&[self.now]);
        self.place(self.now);
    }

    /// Expects the fragments of frames that follow each other, from depths as they are placed.
    fn expect_all(&mut self, frames: &[usize]) {
        let layout = Layout::record::<Fragment>(self.config);
        let bytes = layout.packet_bytes(self.config.bus.stream_bits);
        let packet = |fragment: &Fragment| words(&layout.encode(&values(self.config, *fragment), bytes));
        // Those of a tile come in their order, tiles in any.
        let mut answers = vec![];
        let mut depths = Depths::of_places(self.config, depth_at);
        for frame in frames {
            let all = &self.frames[*frame].fragments;
            let mut fragments =
                if self.config.tests_fragments() { depths.merge(self.config, all) } else { all.clone() };
            // Tiles of several rasterizers come interleaved.
            fragments.sort_by_key(|fragment| (fragment.end, tile(fragment)));
            for fragments in fragments.chunk_by(|one, other| tile(one) == tile(other)) {
                let packets: Vec<u32> = fragments.iter().flat_map(packet).collect();
                answers.push((self.control.script.data(&packets), fragments.len() as u32));
            }
        }
        self.control.script.expect(&answers);
    }

    fn settle(&mut self) {
        self.control.script.wait(SETTLE_CYCLES);
    }

    /// A whole frame.
    pub fn run(&mut self, pauses: Pauses) {
        self.control.script.pauses(pauses);
        self.run_all();
    }

    /// A whole frame in which one channel hardly moves, and what is before it fills.
    pub fn run_narrow(&mut self, channel: Channel) {
        self.control.script.pauses(Pauses::None);
        self.control.script.share(channel, HARDLY);
        self.run_all();
    }

    /// A whole frame, whose splats wait for its start.
    fn run_all(&mut self) {
        self.send_all();
        self.settle();
        self.control.script.check_quiet(0);
        self.expect();
        self.control.start();
        self.control.script.wait_received(0);
        self.control.finish(self.count());
    }

    /// A frame whose end no interrupt tells.
    pub fn run_silently(&mut self) {
        self.control.script.pauses(Pauses::Some);
        self.control.script.write(INTERRUPT_ENABLE, 0);
        self.expect();
        self.control.start();
        self.control.script.wait_low(WAITING);
        self.control.script.read(STATUS, BUSY);
        self.send_all();
        self.control.script.wait_received(0);
        self.control.script.wait_low(BUSY);
        self.control.script.interrupt(0);
        self.control.script.errors(DONE);
        for level in [1, 0] {
            self.control.script.write(INTERRUPT_ENABLE, level);
            self.control.script.wait(2);
            self.control.script.interrupt(level);
        }
        self.control.script.write(INTERRUPT_ENABLE, 1);
    }

    /// Frames that follow each other in a run, each started and looked at anew while the one before is drawn: it ends no sooner than
    /// that, however fast the hardware is.
    pub fn run_ahead(&mut self) {
        let first = self.now;
        for pauses in [Pauses::None, Pauses::Some] {
            self.control.script.pauses(pauses);
            self.expect_all(&AHEAD);
            self.place(first);
            let mut count = 0;
            for (place, frame) in AHEAD.into_iter().enumerate() {
                self.look(frame);
                if place == 0 {
                    self.control.start();
                } else {
                    self.control.script.start_ahead();
                    self.send_end(AHEAD[place - 1]);
                }
                self.control.script.wait_low(WAITING);
                self.now = frame;
                (0..self.count() - 1).for_each(|index| self.send(index));
                count += self.count();
            }
            self.send_end(AHEAD[AHEAD.len() - 1]);
            self.control.script.wait_received(0);
            self.control.finish(count);
        }
        self.look(first);
    }

    /// A frame that cannot leave, and one without splats behind it, for which a register that is read late is written anew: only where one
    /// bit is another it waits until the first has left.
    pub fn run_late(&mut self) {
        self.control.script.pauses(Pauses::None);
        let now = self.now;
        let uniforms = self.uniforms();
        let late = late_uniforms(self.config);
        for &place in &late {
            let (Field { name, width, .. }, value) = &uniforms[place];
            // Of each register a bit or more, of one alone all.
            for bit in [None].into_iter().chain((0..*width).step_by(late.len()).map(Some)) {
                self.control.script.share(Channel::Receive, ALWAYS);
                self.expect_all(&[now, EMPTY]);
                self.place(now);
                self.control.start();
                self.control.script.wait_low(WAITING);
                self.send_all();
                self.control.script.wait_sent();
                self.control.script.wait(SPLAT_CYCLES * self.count() as u32);
                self.control.set(name, (value ^ bit.map_or(0, |bit| 1 << bit)) as u32);
                self.control.script.start_ahead();
                if bit.is_some() {
                    self.settle();
                    self.control.script.read(STATUS, BUSY | WAITING);
                } else {
                    self.control.script.wait_low(WAITING);
                }
                self.control.script.share(Channel::Receive, 0);
                self.control.script.wait_low(WAITING);
                self.send_end(EMPTY);
                self.now = now;
                self.control.script.wait_received(0);
                self.control.finish(self.count() + 1);
                self.control.set(name, *value as u32);
            }
        }
    }

    /// Sends the packet that ends a frame.
    fn send_end(&mut self, frame: usize) {
        self.now = frame;
        self.send(self.count() - 1);
    }

    /// A frame with broken packets among the good ones, a start that waits for it, and all that must not be done then.
    pub fn run_disturbed(&mut self) {
        self.control.script.pauses(Pauses::Some);
        self.expect_all(&[self.now; 2]);
        self.place(self.now);
        self.control.start();
        self.control.script.wait_low(WAITING);
        self.control.script.start_ahead();
        let end = self.count() - 1;
        for index in 0..end {
            self.send_broken(index);
            self.send(index);
        }
        self.send_broken(end);
        self.control.script.wait_sent();
        self.settle();
        refuse_while_busy(self.control.script, self.control.map);
        self.control.script.read(INTERRUPT_ENABLE, 1);
        self.control.script.errors(BUSY | WAITING);
        self.send(end);
        self.send_all();
        self.control.script.wait_received(0);
        self.control.finish(2 * self.count());
        clear(self.control.script);
        self.control.script.errors(DONE);
    }

    /// Packets of every length that is refused.
    fn send_broken(&mut self, index: usize) {
        let stream_bits = self.config.bus.stream_bits;
        let stream_words = (stream_bits / 32) as usize;
        let good = self.packet(index);
        let beats = good.len() / stream_words;
        // As the end of a frame, too: its flag lies in the first word.
        for length in (1..beats).chain([beats + 1, beats + 2, 2 * beats]) {
            let mut packet: Vec<u32> = good.iter().cycle().take(length * stream_words).copied().collect();
            packet[0] |= u32::from(length % 2 == 0);
            self.control.script.send(&packet, stream_bits);
            self.control.script.count(ErrorCounter::Packet);
        }
    }

    /// Frames with answers of memory that are errors, and bursts that are misshapen; beats that nobody asked for.
    pub fn run_spoilt(&mut self) {
        for shares in [[20, 0, 0], [0, 20, 0], [0, 0, 100], [60, 90, 60]] {
            self.control.script.spoil(shares);
            self.run(Pauses::Some);
        }
        self.control.script.spoil([0; 3]);
        clear(self.control.script);
        self.control.script.errors(DONE);
        for beats in [1, 3, 2] {
            self.control.script.give_unasked(0, beats);
            self.control.script.wait(20);
            self.control.script.errors(DONE);
        }
        clear(self.control.script);
        self.control.script.write(CONTROL, RESET);
        self.run(Pauses::None);
    }

    /// A frame that waits for its end for long.
    pub fn run_long(&mut self) {
        self.control.script.pauses(Pauses::None);
        self.expect();
        self.control.start();
        let end = self.count() - 1;
        (0..end).for_each(|index| self.send(index));
        self.control.script.wait(LONG_RUN_CYCLES);
        self.send(end);
        self.control.script.wait_received(0);
        self.control.finish(self.count());
    }

    /// A host that has sent a part of a packet goes on with it in the next run.
    pub fn abort_within_packet(&mut self) {
        self.control.script.pauses(Pauses::Some);
        let beats = Layout::record::<Splat>(self.config).beats(self.config.bus.stream_bits);
        for held in 1..beats {
            self.control.script.expect(&[]);
            self.control.start();
            self.control.script.hold(Some(held));
            self.send(0);
            self.settle();
            self.control.script.write(CONTROL, ABORT);
            self.control.finish(0);
            self.expect();
            self.control.start();
            self.control.script.hold(None);
            self.control.script.count(ErrorCounter::Packet);
            self.send_all();
            self.control.script.wait_received(0);
            self.control.finish(self.count());
        }
    }

    /// Nothing is taken back that is under way: until it has come, no run begins.
    pub fn abort_held(&mut self) {
        for channel in [Channel::Receive, Channel::ReadData, Channel::WriteAnswer] {
            self.control.script.pauses(Pauses::None);
            self.control.script.share(channel, ALWAYS);
            self.expect();
            self.control.start();
            self.send_all();
            self.control.script.wait_sent();
            // Until a tile has left, or the first is read.
            let tiles = self.config.buffer_tiles() as u32;
            self.control.script.wait(2 * tiles + CLEAR_CYCLES + 10 * SETTLE_CYCLES);
            self.control.script.write(CONTROL, ABORT);
            self.settle();
            self.control.script.refuse(CONTROL, START, Refusal::Busy);
            self.control.script.write(CONTROL, ABORT);
            self.control.script.errors(BUSY);
            self.control.script.share(channel, 128);
            self.control.script.wait_interrupt();
            self.control.check_counters(self.count());
            self.control.script.expect(&[]);
            self.control.script.errors(DONE);
            self.run(Pauses::Some);
        }
    }

    /// A frame that is aborted somewhere on its way.
    pub fn abort_somewhere(&mut self) {
        let sent = self.begin_somewhere();
        self.control.script.write(CONTROL, ABORT);
        self.control.script.wait_interrupt();
        self.control.check_counters(sent);
        self.control.script.expect(&[]);
        self.control.script.check_quiet(0);
        self.control.script.errors(DONE);
        // The end of a frame may have left before.
    }

    /// A frame that a reset of one cycle ends somewhere on its way, and one of which the reset leaves nothing.
    pub fn reset_somewhere(&mut self) {
        self.begin_somewhere();
        self.control.script.reset(1);
        self.control.script.expect(&[]);
        self.enter(self.now);
        self.run(Pauses::Some);
    }

    /// Begins a frame and sends some of its packets; returns how many.
    fn begin_somewhere(&mut self) -> usize {
        self.control.script.pauses(Pauses::Some);
        self.expect();
        self.control.start();
        let sent = self.control.script.random.usize(1..=self.count());
        (0..sent).for_each(|index| self.send(index));
        self.control.script.wait_sent();
        let cycles = self.control.script.random.u32(..2 * SETTLE_CYCLES);
        self.control.script.wait(cycles);
        sent
    }
}
