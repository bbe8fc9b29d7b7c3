//! Tile cache: which tiles of the reconstruction buffer lie in the accumulator's slots, and the traffic that brings them there.
//!
//! A copy is passed on with its tile's slot; a miss starts a *job* that writes the slot's former tile back and loads the new one
//! behind it, pixel by pixel, while copies of other slots go on. A tile that nobody touched in this frame is not loaded but
//! cleared. After the last copy of a frame is accumulated, every touched tile is sent to normalization.

mod moves;
#[cfg(test)]
mod tests;

use super::parts::share::Share;
use crate::stream::{Fifo, HalfBuffer, Skid};
use crate::unit::Model;
use moves::{Drain, Job, JobStep};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{IN_FLIGHT_BITS, PLACED_QUEUE_DEPTH, TILE_PIXELS};
use pointcore_contract::splat::records::{
    Fill, FinishedPixel, Pixel, PlacedCopy, PlacedPixel, Slot, SlotPixel, Tile, TileCopy,
};
pub use pointcore_contract::splat::units::tile_cache::{In, Out};

const PIXELS: u8 = TILE_PIXELS as u8;
const IN_FLIGHT_MAX: u8 = ((1_u32 << IN_FLIGHT_BITS) - 1) as u8;

/// A slot's entry of the directory.
#[derive(Clone, Copy, Debug, Default)]
struct Entry {
    tile: u32,
    resident: bool,
    ready: bool,
    /// A copy was placed in it since its turn to be replaced came last.
    used: bool,
    /// Copies passed on and not yet retired.
    in_flight: u8,
}

#[derive(Clone, Copy, Debug)]
enum Mode {
    /// Nothing is known of `touched` after reset.
    Clear(usize),
    Run,
    /// The last copy is on its way.
    Wait,
    Flush(usize, FlushStep),
}

#[derive(Clone, Copy, Debug)]
enum FlushStep {
    /// The memory of touched tiles is read, for two cycles.
    Read,
    Look,
    Check,
    FromSlot(u8, Drain),
    FromMemory(u8),
    Close,
}

/// The tile cache.
#[derive(Clone, Debug)]
pub struct TileCache {
    share: Share,
    slots: Vec<Entry>,
    /// The slot that is replaced next.
    next: u8,
    /// By a tile's place among those of the rasterizer.
    touched: Vec<bool>,
    mode: Mode,
    job: Option<Job>,
    frame_ended: bool,
    read: Option<Tile>,
    fill: Option<Fill>,
    input: HalfBuffer<TileCopy>,
    /// The copy that is placed next.
    head: Option<TileCopy>,
    out: Fifo<PlacedCopy>,
    write: Skid<PlacedPixel>,
    pixel: Skid<FinishedPixel>,
}

impl TileCache {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            share: Share::new(config),
            slots: vec![Entry::default(); config.tile_slots as usize],
            next: 0,
            touched: vec![false; 1 << config.place_bits()],
            mode: Mode::Clear(0),
            job: None,
            frame_ended: false,
            read: None,
            fill: None,
            input: HalfBuffer::default(),
            head: None,
            out: Fifo::new(PLACED_QUEUE_DEPTH as usize),
            write: Skid::default(),
            pixel: Skid::default(),
        }
    }

    fn slot_of(&self, tile: u32) -> Option<u8> {
        self.slots.iter().position(|entry| entry.resident && entry.tile == tile).map(|slot| slot as u8)
    }

    fn data_ready(&self) -> bool {
        match self.mode {
            Mode::Flush(_, FlushStep::FromMemory(received)) => self.pixel.in_ready() && received < PIXELS,
            _ => self.job.as_ref().is_some_and(Job::may_load),
        }
    }

    fn drain(&self) -> Option<SlotPixel> {
        let (slot, pixel) = match (&self.mode, &self.job) {
            (Mode::Flush(_, FlushStep::FromSlot(slot, drain)), _) => (*slot, drain.request(self.pixel.in_ready())),
            (_, Some(job)) => (job.slot, job.request(self.write.in_ready())),
            _ => return None,
        };
        pixel.map(|pixel| SlotPixel { slot, pixel })
    }

    fn slot_ready(&self) -> u64 {
        self.slots.iter().rev().fold(0, |bits, entry| bits << 1 | u64::from(entry.ready))
    }

    /// The turn of a slot that was used since its last one goes to the next slot.
    fn skip(&mut self) -> bool {
        let skips = std::mem::take(&mut self.slots[usize::from(self.next)].used);
        if skips {
            self.next = (self.next + 1) % self.slots.len() as u8;
        }
        skips
    }

    /// Mode *run*: returns the copy at the head if it is passed on; a miss starts a job instead, unless a turn was skipped.
    fn run(&mut self, skips: bool) -> Option<PlacedCopy> {
        let copy = self.head?;
        if copy.end {
            return self.out.in_ready().then(|| {
                self.mode = Mode::Wait;
                PlacedCopy { copy, slot: 0 }
            });
        }
        if let Some(slot) = self.slot_of(copy.tile) {
            let entry = &mut self.slots[usize::from(slot)];
            let passes = self.out.in_ready() && entry.in_flight < IN_FLIGHT_MAX;
            entry.in_flight += u8::from(passes);
            entry.used |= passes;
            return passes.then_some(PlacedCopy { copy, slot });
        }
        let slot = self.next;
        let entry = &mut self.slots[usize::from(slot)];
        if !skips && self.job.is_none() && entry.in_flight == 0 {
            let evicted = entry.resident.then_some(entry.tile);
            *entry = Entry { tile: copy.tile, resident: true, ready: false, used: false, in_flight: 0 };
            self.job = Some(Job { slot, tile: copy.tile, evicted, step: JobStep::Read });
            self.next = (slot + 1) % self.slots.len() as u8;
        }
        None
    }

    /// A cycle of the job: returns its next state and what is written to memory. `fills` says that a fill is shown.
    fn clock_job(&mut self, mut job: Job, data: Option<Pixel>, drained: Pixel, fills: bool) -> Option<PlacedPixel> {
        let may_fill = job.may_fill();
        let mut written = None;
        match &mut job.step {
            JobStep::Read => job.step = JobStep::Lookup,
            JobStep::Lookup => {
                let load = std::mem::replace(&mut self.touched[self.share.place(job.tile) as usize], true);
                if load {
                    self.read = Some(Tile { tile: job.tile });
                }
                job.step = JobStep::Move { load, drain: Drain::default(), filled: 0 };
            }
            JobStep::Move { load, drain, filled } => {
                let moved_out = job.evicted.is_none() || (drain.is_done() && self.write.out().is_none());
                if *filled == PIXELS && !fills && moved_out {
                    self.slots[usize::from(job.slot)].ready = true;
                    self.job = None;
                    return None;
                }
                if let Some(tile) = job.evicted {
                    let taken = drain.clock(self.write.in_ready(), drained);
                    written = taken.map(|(pixel, value)| PlacedPixel { tile, pixel, value });
                }
                let value = if *load { data } else { may_fill.then(Pixel::default) };
                if let Some(value) = value {
                    self.fill = Some(Fill { place: SlotPixel { slot: job.slot, pixel: *filled }, value });
                    *filled += 1;
                }
            }
        }
        self.job = Some(job);
        written
    }

    /// A cycle of mode *flush*: returns what goes to normalization.
    fn flush(&mut self, (code, step): (usize, FlushStep), inputs: &In, data: Option<Pixel>) -> Option<FinishedPixel> {
        let tile = self.share.tile(inputs.number.into(), code as u32);
        let drained = inputs.drained;
        let room = self.pixel.in_ready();
        let finished = |pixel, value: Pixel| {
            let placed = PlacedPixel { tile, pixel, value };
            (value.weight != 0).then_some(FinishedPixel { end: false, placed })
        };
        let next_tile = if code + 1 < self.touched.len() {
            Mode::Flush(code + 1, FlushStep::Read)
        } else {
            Mode::Flush(code, FlushStep::Close)
        };
        let mut pushed = None;
        self.mode = match step {
            FlushStep::Read => Mode::Flush(code, FlushStep::Look),
            FlushStep::Look => Mode::Flush(code, FlushStep::Check),
            FlushStep::Check => {
                if !std::mem::take(&mut self.touched[code]) {
                    next_tile
                } else if let Some(slot) = self.slot_of(tile) {
                    Mode::Flush(code, FlushStep::FromSlot(slot, Drain::default()))
                } else {
                    self.read = Some(Tile { tile });
                    Mode::Flush(code, FlushStep::FromMemory(0))
                }
            }
            FlushStep::FromSlot(_, drain) if drain.is_done() => next_tile,
            FlushStep::FromSlot(slot, mut drain) => {
                pushed = drain.clock(room, drained).and_then(|(pixel, value)| finished(pixel, value));
                Mode::Flush(code, FlushStep::FromSlot(slot, drain))
            }
            FlushStep::FromMemory(PIXELS) => next_tile,
            FlushStep::FromMemory(received) => {
                pushed = data.and_then(|value| finished(received, value));
                Mode::Flush(code, FlushStep::FromMemory(received + u8::from(data.is_some())))
            }
            FlushStep::Close if room => {
                pushed = Some(FinishedPixel { end: true, ..FinishedPixel::default() });
                for entry in &mut self.slots {
                    (entry.resident, entry.used) = (false, false);
                }
                self.next = 0;
                Mode::Run
            }
            FlushStep::Close => self.mode,
        };
        pushed
    }
}

impl Model for TileCache {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            in_ready: self.input.in_ready(),
            out: self.out.out().copied(),
            read: self.read,
            data_ready: self.data_ready(),
            write: self.write.out().copied(),
            pixel: self.pixel.out().copied(),
            slot_ready: self.slot_ready(),
            fill: self.fill,
            drain: self.drain(),
        }
    }

    fn clock(&mut self, inputs: &In) {
        let data = inputs.data.filter(|_| self.data_ready());
        let fills = self.fill.take().is_some();
        self.read = self.read.filter(|_| !inputs.read_ready);

        let (mut passed, mut pixel) = (None, None);
        let skips = self.skip();
        let job = self.job;
        match self.mode {
            Mode::Clear(code) => {
                self.touched[code] = false;
                self.mode = if code + 1 < self.touched.len() { Mode::Clear(code + 1) } else { Mode::Run };
            }
            Mode::Run => passed = self.run(skips),
            Mode::Wait if self.frame_ended && job.is_none() => {
                self.frame_ended = false;
                self.slots.iter_mut().for_each(|entry| entry.ready = false);
                self.mode = Mode::Flush(0, FlushStep::Read);
            }
            Mode::Wait => {}
            Mode::Flush(code, step) => pixel = self.flush((code, step), inputs, data),
        }
        let written = job.and_then(|job| self.clock_job(job, data, inputs.drained, fills));
        if let Some(Slot { slot }) = inputs.retire {
            self.slots[usize::from(slot)].in_flight -= 1;
        }
        self.frame_ended |= inputs.frame_end;

        let takes = self.head.is_none();
        if takes {
            self.head = self.input.out().copied();
        } else if passed.is_some() {
            self.head = None;
        }
        self.input.step(inputs.input, takes);
        self.out.step(passed, inputs.out_ready);
        self.write.step(written, inputs.write_ready);
        self.pixel.step(pixel, inputs.pixel_ready);
    }
}
