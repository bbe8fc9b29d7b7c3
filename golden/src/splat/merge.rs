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
    head: Option<(Fragment, Depth)>,
    /// Fragments that were taken and not tested.
    under_way: u32,
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
            head: None,
            under_way: 0,
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
        let place = taken.map(|fragment| self.place(fragment));
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
        let (fragment, ends) = (taken.filter(|taken| !taken.end), taken.is_some_and(|taken| taken.end));
        let asked = self.gather(fragment.as_ref());

        let has_room = self.out.in_ready();
        let closes = self.closing && self.under_way == 0 && has_room && self.writes.out().is_none();
        let tested = self.head.filter(|_| has_room && self.writes.in_ready());
        let is_nearer = |fragment: &Fragment, stored: &Depth| fragment.depth < stored.depth >> self.low_bits;
        let sent = tested.filter(|(fragment, stored)| is_nearer(fragment, stored)).map(|(sent, _)| sent);
        let written = sent.map(|fragment| {
            let (tile, pixel) = self.place(&fragment);
            StoredDepth { tile, pixel, value: Depth { depth: fragment.depth << self.low_bits } }
        });
        self.hidden = tested.is_some() && sent.is_none();
        self.closing = self.closing && !closes || ends;
        self.under_way = self.under_way + u32::from(fragment.is_some()) - u32::from(tested.is_some());

        let is_free = self.head.is_none() || tested.is_some();
        let pair = self.waiting.out().copied().zip(self.depths.out().copied()).filter(|_| is_free);
        self.head = pair.or(self.head.filter(|_| !is_free));
        self.waiting.step(fragment, pair.is_some());
        self.depths.step(inputs.depth_data, pair.is_some());
        self.reads.step(asked, inputs.depth_read_ready);
        self.writes.step(written, inputs.depth_write_ready);
        let end = closes.then(|| Fragment { end: true, ..Fragment::default() });
        self.out.step(sent.or(end), inputs.out_ready);
    }
}
