//! Tile cache: which tiles of the reconstruction buffer lie in the accumulator's slots, and the traffic that brings them there.
//!
//! A copy is passed on with its tile's slot. A miss starts a *job*: of the slot's former tile those pixels go that samples came to, and
//! of the new one those come that memory holds, while copies of other slots go on. Once the last copy of a frame has come, the frame
//! *leaves*: of every tile to which no copy is to come, the pixels that memory holds are sent to normalization, while others are drawn,
//! and the next frame on the other surface of memory.

mod job;
mod leaving;
mod pending;
mod seeker;
#[cfg(test)]
mod tests;
mod traffic;

use super::parts::share::Share;
use crate::stream::{Fifo, HalfBuffer, Skid};
use crate::unit::Model;
use job::{Job, JobStep};
use leaving::{Leaving, Seen};
use pending::{Pending, SurfacePlace};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{IN_FLIGHT_BITS, PLACED_QUEUE_DEPTH, SLOT_BANKS, SURFACES};
use pointcore_contract::splat::records::{FinishedPixel, PlacedCopy, Slot, SlotChange, SlotTile, TileCopy};
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

/// What is known of the slot that is replaced next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Turn {
    /// Its turn has just come: nothing.
    New,
    /// A copy is under way in it, or was placed in it since its last turn.
    Busy,
    /// It may be replaced.
    Idle,
}

/// The tile cache.
#[derive(Clone, Debug)]
pub struct TileCache {
    share: Share,
    is_alone: bool,
    /// The place of a surface, among those of the image, of which memories are cleared next after reset.
    clears: Option<SurfacePlace>,
    slots: Vec<Entry>,
    /// The slot that is replaced next.
    next: u8,
    turn: Turn,
    /// By surface and a tile's place among those of the rasterizer: a bit for each pixel that memory holds.
    stored: Vec<u64>,
    pending: Pending,
    /// The surface that is drawn.
    surface: bool,
    job: Option<Job>,
    /// In the last cycle a copy waited for a job to begin, and a slot was free for it.
    missed: bool,
    leaving: Leaving,
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
            is_alone: config.rasterizers == 1,
            clears: Some(SurfacePlace { surface: false, place: 0 }),
            slots: vec![Entry::default(); config.tile_slots as usize],
            next: 0,
            turn: Turn::New,
            stored: vec![0; (SURFACES as usize) << config.place_bits()],
            pending: Pending::new(config),
            surface: false,
            job: None,
            missed: false,
            leaving: Leaving::new(),
            traffic: Traffic::new(),
            input: HalfBuffer::default(),
            head: None,
            out: Fifo::new(PLACED_QUEUE_DEPTH as usize),
            pixel: Skid::default(),
        }
    }

    /// Whether memories hold what they should after reset, of the surface that is drawn first.
    const fn is_clear(&self) -> bool {
        matches!(self.clears, None | Some(SurfacePlace { surface: true, .. }))
    }

    /// Clears the next word of the memories; of the second surface in cycles in which nothing else may write.
    fn clear(&mut self) {
        let writes = self.is_at(JobStep::Changed).is_some() || self.leaving.is_seen() || self.pending.writes();
        let Some(at) = self.clears.filter(|at| !at.surface || !writes) else { return };
        let word = at.word(self.places());
        self.stored[word] = 0;
        self.pending.clear(word);
        self.clears = match self.share.following(at.place) {
            Some(place) => Some(SurfacePlace { place, ..at }),
            None => (!at.surface).then_some(SurfacePlace { surface: true, place: 0 }),
        };
    }

    /// Whether no copies may come: not before memories are clear, those of the second surface not before these are.
    fn is_full(&self) -> bool {
        let frames = self.pending.whole + u32::from(self.leaving.given);
        frames >= SURFACES || !self.is_clear() || (self.clears.is_some() && self.pending.turns_to_second())
    }

    /// Places that a surface has.
    const fn places(&self) -> usize {
        self.stored.len() / SURFACES as usize
    }

    /// Where a tile of the surface that is drawn has its words.
    fn word(&self, tile: u32) -> usize {
        SurfacePlace { surface: self.surface, place: self.share.place(tile) }.word(self.places())
    }

    fn slot_of(&self, tile: u32) -> Option<u8> {
        self.slots.iter().position(|entry| entry.resident && entry.tile == tile).map(|slot| slot as u8)
    }

    fn is_at(&self, step: JobStep) -> Option<Job> {
        self.job.filter(|job| job.step == step)
    }

    /// Where pixels may go in this cycle.
    fn aim(&self) -> Aim {
        Aim { slot: self.is_at(JobStep::Move).map(|job| job.slot.slot), has_room: self.pixel.in_ready() }
    }

    fn placed(&self) -> Option<SlotTile> {
        let Job { slot: Slot { slot }, comes, .. } = self.is_at(JobStep::Read)?;
        Some(SlotTile { slot, tile: comes? })
    }

    fn change(&self) -> Option<SlotChange> {
        let Job { slot: Slot { slot }, comes, unchanged, .. } = self.is_at(JobStep::Change)?;
        Some(SlotChange { slot, banks: unchanged as u8, held: comes.map_or(0, |tile| self.stored[self.word(tile)]) })
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

    fn head_misses(&self) -> bool {
        self.head.is_some_and(|copy| !copy.end && self.slot_of(copy.tile).is_none())
    }

    /// Passes the copy at the head on, if it can be; a miss starts a job instead, if pixels may be asked for.
    fn place(&mut self, copy: TileCopy, may_want: bool) -> Option<PlacedCopy> {
        if let Some(slot) = self.slot_of(copy.tile) {
            let entry = &mut self.slots[usize::from(slot)];
            let passes = self.out.in_ready() && entry.in_flight < IN_FLIGHT_MAX;
            entry.in_flight += u8::from(passes);
            entry.used |= passes;
            let TileCopy { bounds, diagonals, tile, splat, .. } = copy;
            return passes.then_some(PlacedCopy { bounds, diagonals, tile, splat, slot });
        }
        if self.job.is_none() && self.turn == Turn::Idle && may_want {
            self.start(Some(copy.tile));
        }
        None
    }

    /// The end is at the head: the slot whose turn it is is written back; returns whether none holds a tile, and the frame that leaves
    /// is this one: the next is drawn from now on.
    fn switch(&mut self, skips: bool) -> bool {
        if self.job.is_some() {
            return false;
        }
        let leaves = self.leaving.surface == Some(self.surface);
        if leaves && !self.slots.iter().any(|entry| entry.resident) {
            self.leaving.given = true;
            self.surface = !self.surface;
            return true;
        }
        match self.turn {
            Turn::Idle if self.is_next_resident() => self.start(None),
            Turn::New if self.is_next_resident() => {}
            _ if skips => {}
            _ => self.follow_turn(),
        }
        false
    }

    fn is_next_resident(&self) -> bool {
        self.slots[usize::from(self.next)].resident
    }

    /// A cycle of the job; `is_over` says that no pixel was under way. Returns the place of a tile that was written back.
    fn clock_job(&mut self, mut job: Job, is_over: bool, inputs: &In) -> Option<u32> {
        match job.step {
            JobStep::Read => job.step = JobStep::Change,
            JobStep::Change => {
                job.unchanged &= inputs.sample_reads;
                if job.unchanged == 0 {
                    if let Some(tile) = job.comes {
                        self.traffic.want(self.surface, tile, self.stored[self.word(tile)], false);
                    }
                    job.step = JobStep::Changed;
                }
            }
            JobStep::Changed => {
                if let Some(tile) = job.goes {
                    let word = self.word(tile);
                    self.stored[word] = inputs.masks.written;
                    self.traffic.let_leave(inputs.masks.dirty);
                }
                job.step = JobStep::Move;
            }
            JobStep::Move if is_over => {
                self.slots[usize::from(job.slot.slot)].ready = job.comes.is_some();
                self.job = None;
                return job.goes.map(|tile| self.share.place(tile));
            }
            JobStep::Move => {}
        }
        self.job = Some(job);
        None
    }

    /// Whether a tile is in a slot, or on the way into one or out of it.
    fn is_held(&self, place: u32) -> bool {
        let resident = self.slots.iter().filter(|entry| entry.resident).map(|entry| entry.tile);
        let goes = self.job.and_then(|job| job.goes);
        let head = self.head.filter(|copy| !copy.end).map(|copy| copy.tile);
        resident.chain(goes).chain(head).any(|tile| self.share.place(tile) == place)
    }
}

impl Model for TileCache {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            in_ready: self.input.in_ready(),
            full: self.is_full(),
            out: self.out.out().copied(),
            read: self.traffic.read.out().copied(),
            data_ready: self.traffic.data_ready(self.aim()),
            write: self.traffic.write.out().copied(),
            pixel: self.pixel.out().copied(),
            slot_ready: self.slot_ready(),
            placed: self.placed(),
            change: self.change(),
            fill: self.traffic.fill,
            drain: self.traffic.drain(self.aim()),
        }
    }

    fn clock(&mut self, inputs: &In) {
        let job = self.job;
        let goes = job.and_then(|job| job.goes).map(|tile| (self.surface, tile));
        // As the registers are.
        let (is_over, may_want) = (self.traffic.is_over(), self.traffic.may_want());
        let arriving = self.input.out().copied().filter(|_| self.head.is_none());
        let mut seen = Seen {
            reads_taken: arriving.is_some(),
            sends: self.leaving.may_send() && may_want && !self.missed && !job.is_some_and(Job::has_mask),
            all_left: self.traffic.all_left(),
            is_held: self.leaving.looked_at.is_some_and(|(place, _)| self.is_held(place)),
            drawn: self.surface,
            is_given: self.leaving.given,
            is_whole: self.pending.whole > 0,
        };
        let was_leaving = self.leaving.surface == Some(self.surface);
        let gone_has_room = self.leaving.gone.in_ready();
        let sent = self.traffic.clock(self.aim(), goes, inputs);
        let sent = sent.filter(|placed| placed.value.weight != 0).map(|placed| FinishedPixel { end: false, placed });

        let (mut passed, mut switches) = (None, false);
        let next = self.next;
        let is_clear = self.is_clear();
        let misses = is_clear && self.turn == Turn::Idle && job.is_none() && self.head_misses();
        let skips = self.skip();
        self.clear();
        if let Some(copy) = self.head.filter(|_| is_clear) {
            if copy.end {
                switches = self.switch(skips);
            } else {
                passed = self.place(copy, may_want && !seen.sends);
            }
        }
        let starts = job.is_none() && self.job.is_some();
        seen.reads_taken |= starts || misses;
        self.missed = misses;
        let (pops, close) = self.leave(&seen, inputs);
        let mut gone = None;
        if let Some(job) = job {
            gone = self.clock_job(job, is_over && (gone_has_room || goes.is_none()), inputs).filter(|_| was_leaving);
        }
        self.leaving.gone.step(gone, pops);
        if let Some(Slot { slot }) = inputs.retire {
            self.slots[usize::from(slot)].in_flight -= 1;
        }
        self.turn = match self.slots[usize::from(self.next)] {
            _ if self.next != next => Turn::New,
            Entry { in_flight: 0, used: false, .. } => Turn::Idle,
            _ => Turn::Busy,
        };

        self.pending.clock(inputs.arrives, arriving, seen.drawn, switches);
        let takes = self.head.is_none();
        if takes {
            self.head = arriving;
        } else if passed.is_some() || switches {
            self.head = None;
        }
        self.input.step(inputs.input, takes);
        self.out.step(passed, inputs.out_ready);
        self.pixel.step(sent.or(close), inputs.pixel_ready);
    }
}
