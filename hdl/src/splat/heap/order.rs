//! Entries of the heap and the order among them (eq. 5.14).
//!
//! The sweep says whether an entry leaves in the current pass over the tiles or in the next; it is settled when the entry
//! comes, so that no comparison needs the current tile.

use pointcore_contract::splat::Config;

use rtl::{Expr, cat};

/// Widths of the parts of an entry, which is the word `{sweep, tile, sequence, pointer}`; all but the pointer is its key.
#[derive(Clone, Copy)]
pub(super) struct EntryFormat {
    pub tile: u32,
    pub sequence: u32,
    pub pointer: u32,
}

impl EntryFormat {
    pub fn new(config: &Config, sequence_bits: u32) -> Self {
        Self { tile: config.tile_bits(), sequence: sequence_bits, pointer: config.heap_levels }
    }

    pub const fn width(&self) -> u32 {
        self.key_width() + self.pointer
    }

    pub const fn key_width(&self) -> u32 {
        1 + self.tile + self.sequence
    }

    pub fn key(&self, entry: Expr) -> Expr {
        entry.bits(self.width() - 1, self.pointer)
    }

    pub fn tile(&self, entry: Expr) -> Expr {
        entry.bits(self.width() - 2, self.sequence + self.pointer)
    }

    pub fn pointer(&self, entry: Expr) -> Expr {
        entry.trunc(self.pointer)
    }

    /// The top bit of the arrival number.
    pub fn epoch(&self, entry: Expr) -> Expr {
        entry.bit(self.sequence + self.pointer - 1)
    }
}

/// The order in which entries leave: by sweep, by tile, and within a tile by arrival.
pub(super) struct Order {
    pub format: EntryFormat,
    /// The sweep of the entry that left last: entries of the other sweep leave later.
    pub sweep: Expr,
    /// The epoch of the entry that came last: entries of the other epoch are older.
    pub last_epoch: Expr,
}

impl Order {
    /// Whether the entry with key `a` leaves before that with key `b`; both are in the heap.
    pub fn before(&self, a: Expr, b: Expr) -> Expr {
        let EntryFormat { tile, sequence, .. } = self.format;
        let in_sweep = |key: Expr| {
            let is_new = key.bit(sequence - 1).eq(self.last_epoch);
            cat([key.bits(tile + sequence - 1, sequence), is_new, key.trunc(sequence - 1)])
        };
        (a.msb() ^ b.msb()).mux(a.msb().eq(self.sweep), in_sweep(a).lt(in_sweep(b)))
    }
}
