//! Entries of the heap and the order among them (eq. 5.14).
//!
//! The lap says whether an entry leaves in the current pass over the tiles or in the next; it is decided when the entry
//! comes, so that no comparison needs the current tile.

use pointcore_contract::splat::Config;
use pointcore_contract::{record, width};

use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, cat};

/// Widths of the parts of an entry.
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

    /// Bits of a packed [`Entry`].
    pub fn width(&self) -> u32 {
        width::<Entry>(self)
    }

    /// Bits of a packed [`Key`].
    pub fn key_width(&self) -> u32 {
        width::<Key>(self)
    }

    /// The packed key of a packed entry.
    pub fn key(&self, entry: Expr) -> Expr {
        Entry::unpack(self, entry).key.pack(self)
    }
}

/// What entries are ordered by.
#[record(format: EntryFormat)]
pub(super) struct Key {
    /// The parity of the pass over the tiles in which the entry leaves.
    lap: bool,
    /// Tile index.
    #[bits(format.tile)]
    tile: u32,
    /// The arrival number, whose top bit is the epoch.
    #[bits(format.sequence)]
    sequence: u32,
}

/// What a node holds.
#[record(format: EntryFormat)]
pub(super) struct Entry {
    /// Its place in the order.
    key: Key,
    /// Place of the payload.
    #[bits(format.pointer)]
    pointer: u16,
}

/// The order in which entries leave: by lap, by tile, and within a tile by arrival.
pub(super) struct Order {
    pub format: EntryFormat,
    /// The lap of the entry that left last: entries of the other lap leave later.
    pub lap: Expr,
    /// The epoch of the entry that came last: entries of the other epoch are older.
    pub last_epoch: Expr,
}

impl Order {
    /// Whether the entry with the packed key `a` leaves before that with key `b`; both are in the heap.
    pub fn before(&self, a: Expr, b: Expr) -> Expr {
        let [a, b] = [a, b].map(|key| Key::unpack(&self.format, key));
        let in_lap = |key: Key<Wires>| {
            let is_new = key.sequence.msb().eq(self.last_epoch);
            cat([key.tile, is_new, key.sequence.trunc(self.format.sequence - 1)])
        };
        (a.lap ^ b.lap).mux(a.lap.eq(self.lap), in_lap(a).lt(in_lap(b)))
    }
}
