//! Merge: tests fragments against depths in memory, and leaves out those that something nearer hides (thesis 5.4.6).

use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{MERGED_DEPTH_BITS, TILE_SIZE};
use pointcore_contract::splat::records::{Depth, DepthRun, Fragment, StoredDepth};
pub use pointcore_contract::splat::units::merge::{In, Out};

/// The unit.
#[derive(Clone, Debug)]
pub struct Merge {
    tile_column_bits: u32,
    /// Bits of a depth in memory below those of a fragment's.
    low_bits: u32,
    waiting: Fifo<Fragment>,
    depths: Fifo<Depth>,
    reads: Skid<DepthRun>,
    writes: Skid<StoredDepth>,
    out: Skid<Fragment>,
    /// Depths that are wanted and not asked for.
    run: Option<DepthRun>,
    /// An end waits.
    closing: bool,
    hidden: bool,
}

impl Merge {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let ahead = config.merge_ahead as usize;
        Self {
            tile_column_bits: config.tile_column_bits(),
            low_bits: MERGED_DEPTH_BITS - config.geometry.width(),
            waiting: Fifo::new(ahead),
            depths: Fifo::new(ahead),
            reads: Skid::default(),
            writes: Skid::default(),
            out: Skid::default(),
            run: None,
            closing: false,
            hidden: false,
        }
    }

    fn in_ready(&self) -> bool {
        self.waiting.in_ready() && self.reads.in_ready() && !self.closing
    }

    /// The tile of a fragment, and which of its pixels it is.
    fn place(&self, fragment: &Fragment) -> (u32, u8) {
        let [column, row] = [fragment.column, fragment.row].map(u32::from);
        let tile = ((row / TILE_SIZE) << self.tile_column_bits) | (column / TILE_SIZE);
        (tile, (row % TILE_SIZE * TILE_SIZE + column % TILE_SIZE) as u8)
    }

    /// A fragment is taken, or none: returns the run that is to be asked for.
    fn gather(&mut self, taken: Option<&Fragment>) -> Option<DepthRun> {
        let place = taken.filter(|fragment| !fragment.end).map(|fragment| self.place(fragment));
        match (place, &mut self.run) {
            (Some((tile, pixel)), Some(run))
                if tile == run.tile
                    && pixel == run.pixel + run.count
                    && !u32::from(pixel).is_multiple_of(TILE_SIZE) =>
            {
                run.count += 1;
                None
            }
            _ if !self.reads.in_ready() => None,
            _ => std::mem::replace(&mut self.run, place.map(|(tile, pixel)| DepthRun { tile, pixel, count: 1 })),
        }
    }
}

impl Model for Merge {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            in_ready: self.in_ready(),
            out: self.out.out().copied(),
            depth_read: self.reads.out().copied(),
            depth_data_ready: self.depths.in_ready(),
            depth_write: self.writes.out().copied(),
            hidden: self.hidden,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let taken = inputs.input.filter(|_| self.in_ready());
        let asked = self.gather(taken.as_ref());

        let shown = self.waiting.out().copied().filter(|_| self.out.in_ready());
        let closes = shown.is_some_and(|fragment| fragment.end) && self.writes.out().is_none();
        let tested = match (shown, self.depths.out()) {
            (Some(fragment), Some(stored)) if !fragment.end && self.writes.in_ready() => {
                Some((fragment, fragment.depth < stored.depth >> self.low_bits))
            }
            _ => None,
        };
        let visible = tested.filter(|(_, is_visible)| *is_visible).map(|(fragment, _)| fragment);
        let written = visible.map(|fragment| {
            let (tile, pixel) = self.place(&fragment);
            StoredDepth { tile, pixel, value: Depth { depth: fragment.depth << self.low_bits } }
        });
        self.hidden = tested.is_some() && visible.is_none();
        self.closing = self.closing && !closes || taken.is_some_and(|fragment| fragment.end);
        self.waiting.step(taken, tested.is_some() || closes);
        self.depths.step(inputs.depth_data, tested.is_some());
        self.reads.step(asked, inputs.depth_read_ready);
        self.writes.step(written, inputs.depth_write_ready);
        self.out.step(if closes { shown } else { visible }, inputs.out_ready);
    }
}
