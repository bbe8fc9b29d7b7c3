//! A row of the priority queues: a thread's neighbors, nearest first, side by side in one word.

use pointcore_contract::search::Config;
use pointcore_contract::splat::Field;

use crate::search::parts::sets::set;
use crate::units::records::{Record, width};
use rtl::{Expr, cat, lit};

/// A neighbor in a row.
pub(super) fn entry_fields(config: &Config) -> Vec<Field> {
    vec![
        ("found".to_owned(), 1),
        ("index".to_owned(), config.index_bits),
        ("distance2".to_owned(), config.geometry.width()),
    ]
}

/// The bits of a row.
pub(super) fn row_bits(config: &Config) -> u32 {
    config.neighbors * width(&entry_fields(config))
}

/// The neighbors of a row, nearest first.
pub(super) fn entries(config: &Config, row: Expr) -> Vec<Record> {
    let fields = entry_fields(config);
    let bits = width(&fields);
    let entry = |number: u32| Record::unpack(&fields, row.bits((number + 1) * bits - 1, number * bits));
    (0..config.neighbors).map(entry).collect()
}

/// The word of a row.
pub(super) fn row(entries: &[Record]) -> Expr {
    cat(entries.iter().rev().map(Record::pack))
}

/// The entries that stay empty in a row for `k` neighbors, a bit each.
pub(super) fn sentinels(config: &Config, k: Expr) -> Expr {
    set(&(0..config.neighbors).map(|number| k.lt_lit((config.neighbors - number).into())).collect::<Vec<_>>())
}

/// The row of a query that has met no point: sentinels of distance 0 that leave `k` entries, then placeholders at the
/// radius.
pub(super) fn initial(config: &Config, sentinels: Expr, radius2: Expr) -> Expr {
    let nothing = Record::zeros(&entry_fields(config));
    let entry = |number: u32| {
        let is_sentinel = sentinels.bit(number);
        Record::new(&entry_fields(config), |name| match name {
            "distance2" => is_sentinel.mux(lit(radius2.width(), 0), radius2),
            field => nothing.get(field),
        })
    };
    row(&(0..config.neighbors).map(entry).collect::<Vec<_>>())
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
