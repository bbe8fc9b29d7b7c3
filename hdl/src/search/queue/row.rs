//! A row of the priority queues: a thread's neighbors, nearest first, side by side in one word.

use pointcore_contract::search::Config;
use pointcore_contract::{record, width};

use crate::search::parts::neighbor::Neighbor;
use crate::search::parts::sets::set;
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, bit, cat, lit};

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

/// The entries that stay empty in a row for `k` neighbors, a bit each but for the last entry: one neighbor is always wanted.
pub(super) fn sentinels(config: &Config, k: Expr) -> Expr {
    let bits = (1..config.neighbors).rev().map(|behind| k.lt_lit(u128::from(behind) + 1)).collect::<Vec<_>>();
    if bits.is_empty() { Expr::default() } else { set(&bits) }
}

/// The others of a row's entries, a bit each.
pub(super) fn placeholders(config: &Config, sentinels: Expr) -> Expr {
    if config.neighbors == 1 { bit(true) } else { cat([bit(true), !sentinels]) }
}

/// The row of a query that has met no point: sentinels of distance 0 that leave `k` entries, then placeholders at the
/// radius, of which the sign is left out.
pub(super) fn initial(config: &Config, sentinels: Expr, radius2: Expr) -> Expr {
    let nothing = Entry::<Wires>::zeros(config);
    let entry = |number: u32| {
        let mut entry = nothing;
        entry.neighbor.distance2 = match number + 1 == config.neighbors {
            true => radius2,
            false => sentinels.bit(number).mux(lit(radius2.width(), 0), radius2),
        };
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
