//! Occlusion: leaves out samples of what moves that lie behind depths in memory, those of what stands still.
//!
//! The depths of a tile are asked for when it gets its slot. A sample waits until those of its slot have come.

use crate::number::Number;
use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::Format;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{DEPTH_BITS, OCCLUSION_QUEUE_DEPTH, TILE_PIXELS, TILE_SIZE};
use pointcore_contract::splat::records::{Depth, DepthRun, Sample, SamplePlace, SlotTile};
pub use pointcore_contract::splat::units::occlusion::{In, Out};
use std::collections::VecDeque;

/// Cycles from the head to the test: one for the memory, one for the register behind it.
const STAGES: usize = 2;
const DEPTH_MAX: u32 = (1 << DEPTH_BITS) - 1;

/// A depth for a slot, as it is compared.
#[derive(Clone, Copy, Debug)]
struct Fill {
    slot: u8,
    pixel: u32,
    depth: u32,
}

/// The unit.
#[derive(Clone, Debug)]
pub struct Occlusion {
    bin_bits: u32,
    /// The depths of all slots, and whether they have come.
    depths: Vec<u32>,
    known: Vec<bool>,
    /// Tiles whose depths are wanted, and the row that is asked for next.
    wanted: Fifo<SlotTile>,
    row: u32,
    reads: Skid<DepthRun>,
    /// Slots whose depths have been wanted and have not all come, and the pixel that comes next.
    coming: Fifo<u8>,
    pixel: u32,
    fill: Option<Fill>,
    head: Option<Sample>,
    /// Samples that are read, the latest first, with the depth of their pixel.
    stages: VecDeque<Option<(Sample, u32)>>,
    /// Samples that have left the head, and neither the unit nor the test.
    under_way: u32,
    out: Fifo<Sample>,
    hidden: bool,
}

/// A depth in memory, an `f32`, as an integer: what is not below one hides nothing.
fn fixed(depth: u32) -> u32 {
    if depth >= 1.0_f32.to_bits() {
        return DEPTH_MAX;
    }
    Number::new(Format::F32, depth).to_fixed(DEPTH_BITS, DEPTH_BITS) as u32
}

impl Occlusion {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let slots = config.tile_slots as usize;
        Self {
            bin_bits: config.bin_bits(),
            depths: vec![0; slots * TILE_PIXELS as usize],
            known: vec![false; slots],
            wanted: Fifo::new(slots),
            row: 0,
            reads: Skid::default(),
            coming: Fifo::new(slots),
            pixel: 0,
            fill: None,
            head: None,
            stages: vec![None; STAGES].into(),
            under_way: 0,
            out: Fifo::new(OCCLUSION_QUEUE_DEPTH as usize),
            hidden: false,
        }
    }

    /// The sample at the head leaves it.
    fn leaving(&self) -> Option<Sample> {
        let may_leave = |sample: &Sample| self.known[usize::from(sample.place.slot)];
        self.head.filter(|sample| self.under_way < OCCLUSION_QUEUE_DEPTH && may_leave(sample))
    }

    fn in_ready(&self) -> bool {
        self.head.is_none() || self.leaving().is_some()
    }

    /// Asks for the depths of tiles, a row at a time.
    fn ask(&mut self, inputs: &In) {
        let tile = self.wanted.out().filter(|_| self.reads.in_ready()).map(|wanted| wanted.tile);
        let first = self.row * TILE_SIZE;
        let run = tile.map(|tile| DepthRun { tile: tile >> self.bin_bits, pixel: first as u8, count: TILE_SIZE as u8 });
        let is_asked = run.is_some() && self.row == TILE_SIZE - 1;
        if run.is_some() {
            self.row = (self.row + 1) % TILE_SIZE;
        }
        self.wanted.step(inputs.placed, is_asked);
        self.reads.step(run, inputs.depth_read_ready);
    }

    /// Takes a depth that has come; one that came in the cycle before is written.
    fn take(&mut self, inputs: &In) {
        let came = self.coming.out().copied().zip(inputs.depth_data);
        if let Some(Fill { slot, pixel, depth }) = self.fill {
            self.depths[index(slot, pixel)] = depth;
            self.known[usize::from(slot)] |= pixel == TILE_PIXELS - 1;
        }
        self.fill = came.map(|(slot, Depth { depth })| Fill { slot, pixel: self.pixel, depth: fixed(depth) });
        let is_last = came.is_some() && self.pixel == TILE_PIXELS - 1;
        if came.is_some() {
            self.pixel = (self.pixel + 1) % TILE_PIXELS;
        }
        self.coming.step(inputs.placed.map(|placed| placed.slot), is_last);
        if let Some(SlotTile { slot, .. }) = inputs.placed {
            self.known[usize::from(slot)] = false;
        }
    }
}

fn index(slot: u8, pixel: u32) -> usize {
    usize::from(slot) * TILE_PIXELS as usize + pixel as usize
}

impl Model for Occlusion {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            in_ready: self.in_ready(),
            out: self.out.out().copied(),
            depth_read: self.reads.out().copied(),
            depth_data_ready: self.coming.out().is_some(),
            hidden: self.hidden,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let leaving = self.leaving();
        let read = leaving.map(|sample| {
            let SamplePlace { slot, pixel, .. } = sample.place;
            (sample, self.depths[index(slot, pixel.into())])
        });
        if self.in_ready() {
            self.head = inputs.input;
        }
        self.ask(inputs);
        self.take(inputs);

        let tested = self.stages.pop_back().flatten();
        self.stages.push_front(read);
        self.hidden = tested.is_some_and(|(sample, depth)| sample.place.inside && depth < sample.band.low);
        // One that closes its copy is passed on to say so.
        let kept = tested.map(|(sample, _)| sample).filter(|sample| !self.hidden || sample.place.last).map(|sample| {
            let place = SamplePlace { inside: sample.place.inside && !self.hidden, ..sample.place };
            Sample { place, ..sample }
        });
        let leaves = self.out.out().is_some() && inputs.out_ready;
        let dropped = tested.is_some() && kept.is_none();
        self.under_way = self.under_way + u32::from(leaving.is_some()) - u32::from(leaves) - u32::from(dropped);
        self.out.step(kept, inputs.out_ready);
    }
}
