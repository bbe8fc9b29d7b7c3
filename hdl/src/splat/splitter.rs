//! Splits a splat's rectangle at tile boundaries into copies, one per tile, row by row (thesis 5.5.1);
//! golden twin: `pointcore_golden::splat::splitter`.

use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::{Config, records};

use crate::units::records::{Record, half_out, stream_in};
use rtl::{Expr, Module, cat, lit};

/// Bits of a pixel's column or row within its tile.
const LOCAL: u32 = TILE_SIZE.ilog2();

/// The unit; ports as in `contract::splat::ports::splitter`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_splitter", "Splits a splat's rectangle into one copy per tile.");
    let input = stream_in(&mut m, "in", &records::setup(config));
    let out = half_out(&mut m, "out", &records::copy(config));

    // A splat of hundreds of bits hangs on whether one can be taken, so that is known before the cycle begins: there is none, or its
    // current tile is the last.
    let busy = m.reg_reset("busy", 1, 0);
    let idle = m.reg_reset("idle", 1, 1);
    let last = m.reg("last", 1);
    let ready = m.wire("ready", out.room & idle);
    m.ready(&input, ready);
    let take = m.wire("take", ready & input.valid);
    let arriving = Record::from(&input);
    let splat = arriving.register(&mut m, "splat_", ready);

    let tile_of = |record: &Record, edge: &str| {
        let pixel = record.get(edge);
        pixel.bits(pixel.width() - 1, LOCAL)
    };
    let tile_at = |record: &Record, row: &str, column: &str| cat([tile_of(record, row), tile_of(record, column)]);
    let column = m.reg("column", config.tile_column_bits());
    let row = m.reg("row", config.tile_row_bits());
    let left_most = column.eq(tile_of(&splat, "left"));
    let right_most = m.wire("right_most", column.eq(tile_of(&splat, "right")));
    let top_most = row.eq(tile_of(&splat, "top"));
    let bottom_most = row.eq(tile_of(&splat, "bottom"));

    m.next_if(busy, out.room, take | (busy & !last));
    let next_column = right_most.mux(tile_of(&splat, "left"), column.add_lit(1));
    m.next_if(column, out.room, take.mux(tile_of(&arriving, "left"), next_column));
    let next_row = right_most.mux(row.add_lit(1), row);
    m.next_if(row, out.room, take.mux(tile_of(&arriving, "top"), next_row));
    let single = arriving.get("end") | tile_at(&arriving, "top", "left").eq(tile_at(&arriving, "bottom", "right"));
    let reaches_last = cat([next_row, next_column]).eq(tile_at(&splat, "bottom", "right"));
    m.next_if(last, out.room, take.mux(single, reaches_last));
    let falls_idle = !busy | (last | reaches_last);
    m.next_if(idle, out.room, take.mux(single, falls_idle));

    // The rectangle's edge where it lies in this tile, else the tile's own.
    let clip = |edge: &str, here: Expr, tile_edge: u128| here.mux(splat.get(edge).trunc(LOCAL), lit(LOCAL, tile_edge));
    let far = u128::from(TILE_SIZE) - 1;
    let push = out.room & busy;
    out.push(&mut m, push, |name| match name {
        "left" => clip(name, left_most, 0),
        "right" => clip(name, right_most, far),
        "top" => clip(name, top_most, 0),
        "bottom" => clip(name, bottom_most, far),
        "tile" => cat([row, column]),
        passed => splat.get(passed),
    });
    m
}
