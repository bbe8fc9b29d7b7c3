//! Entries of the heap and the order among them (eq. 5.14).

use pointcore_spec::core_a::Config;

use crate::rtl::{Expr, cat};

/// Widths of the parts of an entry, which is the word `{tile, sequence, pointer}`.
#[derive(Clone, Copy)]
pub(super) struct EntryFormat {
    pub tile: usize,
    pub sequence: usize,
    pub pointer: usize,
}

impl EntryFormat {
    pub fn new(config: &Config) -> Self {
        Self {
            tile: config.tile_bits() as usize,
            sequence: config.sequence_bits as usize,
            pointer: config.heap_levels as usize,
        }
    }

    pub const fn width(&self) -> usize {
        self.tile + self.sequence + self.pointer
    }

    pub fn tile(&self, entry: &Expr) -> Expr {
        entry.bits(self.width() - 1, self.sequence + self.pointer)
    }

    pub fn pointer(&self, entry: &Expr) -> Expr {
        entry.trunc(self.pointer)
    }

    /// The arrival number; its top bit is the epoch.
    pub fn sequence(&self, entry: &Expr) -> Expr {
        entry.bits(self.sequence + self.pointer - 1, self.pointer)
    }
}

/// The order in which entries leave: tiles from the current one upwards, then those before it; within a tile by arrival.
pub(super) struct Order {
    pub format: EntryFormat,
    /// The tile of the entry that left last.
    pub current: Expr,
    /// The epoch of the entry that came last: entries of the other epoch are older.
    pub last_epoch: Expr,
}

impl Order {
    /// Whether `a` leaves before `b`; both are in the heap.
    pub fn before(&self, a: &Expr, b: &Expr) -> Expr {
        let age = |entry: &Expr| {
            let sequence = self.format.sequence(entry);
            cat(&[&sequence.msb().eq(&self.last_epoch), &sequence.trunc(self.format.sequence - 1)])
        };
        let key = |entry: &Expr| cat(&[&self.format.tile(entry), &age(entry)]);
        self.cyclic(a, b, &key(a).lt(&key(b)))
    }

    /// Whether a `newcomer` leaves before `entry`: in the entry's own tile it comes last.
    pub fn newcomer_before(&self, newcomer: &Expr, entry: &Expr) -> Expr {
        let tile_before = self.format.tile(newcomer).lt(&self.format.tile(entry));
        self.cyclic(newcomer, entry, &tile_before)
    }

    /// The order of the tile indices, begun at the current tile.
    fn cyclic(&self, a: &Expr, b: &Expr, less: &Expr) -> Expr {
        let wrapped = |entry: &Expr| self.format.tile(entry).lt(&self.current);
        let (a_wrapped, b_wrapped) = (wrapped(a), wrapped(b));
        (&a_wrapped ^ &b_wrapped).mux(&b_wrapped, less)
    }
}
