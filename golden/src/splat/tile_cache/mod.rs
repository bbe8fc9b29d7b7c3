//! Tile cache: which tiles of the reconstruction buffer lie in the accumulator's slots, and the traffic that brings them there.
//!
//! A copy is passed on with its tile's slot. A miss starts a *job*: of the slot's former tile those pixels go that samples came to, and
//! of the new one those come that memory holds, while copies of other slots go on. Behind the last copy of a frame every slot is
//! written back; then memory has the frame, and the pixels that it holds are sent to normalization, tile by tile.

mod job;
mod seeker;
#[cfg(test)]
mod tests;
mod traffic;

use super::parts::share::Share;
use crate::stream::{Fifo, HalfBuffer, Skid};
use crate::unit::Model;
use job::{Job, JobStep, Walk};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{IN_FLIGHT_BITS, PLACED_QUEUE_DEPTH, SLOT_BANKS};
use pointcore_contract::splat::records::{FinishedPixel, PlacedCopy, Slot, SlotChange, TileCopy};
pub use pointcore_contract::splat::units::tile_cache::{In, Out};
use traffic::{Aim, Traffic};

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
    /// Nothing is known of `stored` after reset.
    Clear(usize),
    Run,
    /// The last copy is on its way; slots are written back.
    Wait,
    Flush(Walk),
}

/// The tile cache.
#[derive(Clone, Debug)]
pub struct TileCache {
    share: Share,
    slots: Vec<Entry>,
    /// The slot that is replaced next.
    next: u8,
    /// By a tile's place among those of the rasterizer: a bit for each pixel that memory holds.
    stored: Vec<u64>,
    mode: Mode,
    job: Option<Job>,
    frame_ended: bool,
    traffic: Traffic,
    input: HalfBuffer<TileCopy>,
    /// The copy that is placed next.
    head: Option<TileCopy>,
    out: Fifo<PlacedCopy>,
    pixel: Skid<FinishedPixel>,
}

/// The bit of a pixel's bank.
pub const fn bank(pixel: u8) -> u32 {
    1 << (pixel as u32 % SLOT_BANKS)
}

/// The bits of all banks.
const BANKS: u32 = (1 << SLOT_BANKS) - 1;

impl TileCache {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            share: Share::new(config),
            slots: vec![Entry::default(); config.tile_slots as usize],
            next: 0,
            stored: vec![0; 1 << config.place_bits()],
            mode: Mode::Clear(0),
            job: None,
            frame_ended: false,
            traffic: Traffic::new(),
            input: HalfBuffer::default(),
            head: None,
            out: Fifo::new(PLACED_QUEUE_DEPTH as usize),
            pixel: Skid::default(),
        }
    }

    fn slot_of(&self, tile: u32) -> Option<u8> {
        self.slots.iter().position(|entry| entry.resident && entry.tile == tile).map(|slot| slot as u8)
    }

    fn is_at(&self, step: JobStep) -> Option<Job> {
        self.job.filter(|job| job.step == step)
    }

    /// Where pixels go in this cycle.
    fn aim(&self) -> Aim {
        match (self.mode, self.is_at(JobStep::Move)) {
            (Mode::Flush(_), _) => Aim::Output { has_room: self.pixel.in_ready() },
            (_, Some(Job { slot: Slot { slot }, .. })) => Aim::Slot(slot),
            _ => Aim::Nowhere,
        }
    }

    fn change(&self) -> Option<SlotChange> {
        let Job { slot: Slot { slot }, comes, unchanged, .. } = self.is_at(JobStep::Change)?;
        Some(SlotChange {
            slot,
            banks: unchanged as u8,
            held: comes.map_or(0, |tile| self.stored[self.share.place(tile) as usize]),
        })
    }

    fn slot_ready(&self) -> u64 {
        self.slots.iter().rev().fold(0, |bits, entry| bits << 1 | u64::from(entry.ready))
    }

    fn follow_turn(&mut self) {
        self.next = (self.next + 1) % self.slots.len() as u8;
    }

    /// The turn of a slot that was used since its last one goes to the next slot.
    fn skip(&mut self) -> bool {
        let skips = std::mem::take(&mut self.slots[usize::from(self.next)].used);
        if skips {
            self.follow_turn();
        }
        skips
    }

    /// Starts a job on the slot whose turn it is, unless a copy is under way in it.
    fn start(&mut self, comes: Option<u32>) {
        let slot = self.next;
        let entry = &mut self.slots[usize::from(slot)];
        let goes = entry.resident.then_some(entry.tile);
        *entry = Entry { tile: comes.unwrap_or(entry.tile), resident: comes.is_some(), ..Entry::default() };
        self.job = Some(Job { slot: Slot { slot }, comes, goes, unchanged: BANKS, step: JobStep::Read });
        self.follow_turn();
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
        if !skips && self.job.is_none() && self.slots[usize::from(self.next)].in_flight == 0 {
            self.start(Some(copy.tile));
        }
        None
    }

    /// Mode *wait*: the slot whose turn it is is written back, and when none holds a tile the frame is sent.
    fn wait(&mut self, skips: bool) {
        if self.job.is_some() {
            return;
        }
        let all_left = self.pixel.out().is_none();
        if self.frame_ended && all_left && !self.slots.iter().any(|entry| entry.resident) {
            self.frame_ended = false;
            self.mode = Mode::Flush(Walk::FIRST);
            return;
        }
        let Entry { resident, in_flight, .. } = self.slots[usize::from(self.next)];
        if !skips && resident && in_flight == 0 {
            self.start(None);
        } else if !skips {
            self.follow_turn();
        }
    }

    /// A cycle of the job; `is_over` says that no pixel was under way.
    fn clock_job(&mut self, mut job: Job, is_over: bool, inputs: &In) {
        match job.step {
            JobStep::Read => job.step = JobStep::Change,
            JobStep::Change => {
                job.unchanged &= inputs.sample_reads;
                if job.unchanged == 0 {
                    if let Some(tile) = job.comes {
                        self.traffic.want(tile, self.stored[self.share.place(tile) as usize]);
                    }
                    job.step = JobStep::Changed;
                }
            }
            JobStep::Changed => {
                if let Some(tile) = job.goes {
                    self.stored[self.share.place(tile) as usize] = inputs.masks.written;
                    self.traffic.let_leave(inputs.masks.dirty);
                }
                job.step = JobStep::Move;
            }
            JobStep::Move if is_over => {
                self.slots[usize::from(job.slot.slot)].ready = job.comes.is_some();
                self.job = None;
                return;
            }
            JobStep::Move => {}
        }
        self.job = Some(job);
    }

    /// A cycle of the walk through the frame, before whose end another tile could be asked for or all pixels had come: returns what
    /// closes it.
    fn walk(&mut self, walk: Walk, number: u8, [may_want, all_came]: [bool; 2]) -> Option<FinishedPixel> {
        if walk.is_over() && all_came && self.pixel.in_ready() {
            self.mode = Mode::Run;
            return Some(FinishedPixel { end: true, ..FinishedPixel::default() });
        }
        let mask = walk.seen.map_or(0, |code| self.stored[code]);
        if mask == 0 || may_want {
            if let Some(code) = walk.seen {
                self.stored[code] = 0;
                if mask != 0 {
                    self.traffic.want(self.share.tile(number.into(), code as u32), mask);
                }
            }
            self.mode = Mode::Flush(walk.advance(self.stored.len()));
        }
        None
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
            read: self.traffic.read.out().copied(),
            data_ready: self.traffic.data_ready(self.aim()),
            write: self.traffic.write.out().copied(),
            pixel: self.pixel.out().copied(),
            slot_ready: self.slot_ready(),
            change: self.change(),
            fill: self.traffic.fill,
            drain: self.traffic.drain(self.aim()),
        }
    }

    fn clock(&mut self, inputs: &In) {
        let job = self.job;
        let goes = job.and_then(|job| job.goes);
        // As the registers are.
        let (may_want, all_came) = (self.traffic.may_want(), self.traffic.all_came());
        let is_over = self.traffic.is_over();
        let sent = self.traffic.clock(self.aim(), goes, inputs);
        let sent = sent.filter(|placed| placed.value.weight != 0).map(|placed| FinishedPixel { end: false, placed });

        let (mut passed, mut close) = (None, None);
        let skips = self.skip();
        match self.mode {
            Mode::Clear(code) => {
                self.stored[code] = 0;
                self.mode = if code + 1 < self.stored.len() { Mode::Clear(code + 1) } else { Mode::Run };
            }
            Mode::Run => passed = self.run(skips),
            Mode::Wait => self.wait(skips),
            Mode::Flush(walk) => close = self.walk(walk, inputs.number, [may_want, all_came]),
        }
        if let Some(job) = job {
            self.clock_job(job, is_over, inputs);
        }
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
        self.pixel.step(sent.or(close), inputs.pixel_ready);
    }
}
