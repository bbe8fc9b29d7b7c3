//! A row of the priority queues: a thread's neighbors, nearest first, side by side in one word.

use pointcore_contract::search::Config;
use pointcore_contract::{record, width};

use crate::search::parts::neighbor::Neighbor;
use crate::search::parts::sets::set;
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, cat, lit};

/// A neighbor in a row.
#[record(config: Config)]
pub(super) struct Entry {
    /// There is one.
    pub found: bool,
    /// Which.
    pub neighbor: Neighbor,
}

/// The bits of a row.
pub(super) fn row_bits(config: &Config) -> u32 {
    config.neighbors * width::<Entry>(config)
}

/// The neighbors of a row, nearest first.
pub(super) fn entries(config: &Config, row: Expr) -> Vec<Entry<Wires>> {
    let bits = width::<Entry>(config);
    let entry = |number: u32| Entry::unpack(config, row.bits((number + 1) * bits - 1, number * bits));
    (0..config.neighbors).map(entry).collect()
}

/// The word of a row.
pub(super) fn row(config: &Config, entries: &[Entry<Wires>]) -> Expr {
    cat(entries.iter().rev().map(|entry| entry.pack(config)))
}

/// The entries that stay empty in a row for `k` neighbors, a bit each.
pub(super) fn sentinels(config: &Config, k: Expr) -> Expr {
    set(&(0..config.neighbors).map(|number| k.lt_lit((config.neighbors - number).into())).collect::<Vec<_>>())
}

/// The row of a query that has met no point: sentinels of distance 0 that leave `k` entries, then placeholders at the
/// radius.
pub(super) fn initial(config: &Config, sentinels: Expr, radius2: Expr) -> Expr {
    let nothing = Entry::<Wires>::zeros(config);
    let entry = |number: u32| {
        let mut entry = nothing;
        entry.neighbor.distance2 = sentinels.bit(number).mux(lit(radius2.width(), 0), radius2);
        entry
    };
    row(config, &(0..config.neighbors).map(entry).collect::<Vec<_>>())
}

/// A row of anything after an insertion: the neighbor before those entries that it is `nearer` than, a bit each and the last
/// ones of the row; the last one falls out.
pub(super) fn insert<T>(old: &[T], nearer: Expr, neighbor: &T, mux: impl Fn(Expr, &T, &T) -> T) -> Vec<T> {
    let entry = |(number, entry): (u32, &T)| {
        let here = nearer.bit(number);
        match number {
            0 => mux(here, neighbor, entry),
            _ => mux(here, &mux(nearer.bit(number - 1), &old[number as usize - 1], neighbor), entry),
        }
    };
    (0..).zip(old).map(entry).collect()
}
