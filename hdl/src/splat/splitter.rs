//! Splits a splat's rectangle at tile boundaries into copies, one per tile, row by row (thesis 5.5.1);
//! golden twin: `pointcore_golden::splat::splitter`.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::records::{ImageRectangle, LOCAL_BITS, SplatCopy, TileRectangle};
use pointcore_contract::splat::units::splitter::PORTS;

use crate::units::ports::{StreamInPorts, StreamOutPorts};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module, cat, lit};

/// The tile's row or column that a pixel's lies in.
fn tile_of(pixel: Expr) -> Expr {
    pixel.bits(pixel.width() - 1, LOCAL_BITS)
}

/// The first tile that a rectangle touches, row above column.
fn first_tile(bounds: &ImageRectangle<Wires>) -> Expr {
    cat([tile_of(bounds.top), tile_of(bounds.left)])
}

/// The last one.
fn last_tile(bounds: &ImageRectangle<Wires>) -> Expr {
    cat([tile_of(bounds.bottom), tile_of(bounds.right)])
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_splitter", "Splits a splat's rectangle into one copy per tile.");
    let input = PORTS.input.declare(&mut m, config);
    let out = PORTS.out.half(&mut m, config);

    // A splat of hundreds of bits hangs on whether one can be taken, so that is known before the cycle begins: there is none, or its
    // current tile is the last.
    let busy = m.reg_reset("busy", 1, 0);
    let idle = m.reg_reset("idle", 1, 1);
    let last = m.reg("last", 1);
    let ready = m.wire("ready", out.room & idle);
    m.drive(input.ready, ready);
    let take = m.wire("take", ready & input.valid);
    let arriving = input.record;
    let splat = arriving.register(&mut m, config, "splat_", ready);
    let bounds = splat.bounds;

    let column = m.reg("column", config.tile_column_bits());
    let row = m.reg("row", config.tile_row_bits());
    let left_most = column.eq(tile_of(bounds.left));
    let right_most = m.wire("right_most", column.eq(tile_of(bounds.right)));
    let top_most = row.eq(tile_of(bounds.top));
    let bottom_most = row.eq(tile_of(bounds.bottom));

    m.next_if(busy, out.room, take | (busy & !last));
    let next_column = right_most.mux(tile_of(bounds.left), column.add_lit(1));
    m.next_if(column, out.room, take.mux(tile_of(arriving.bounds.left), next_column));
    let next_row = right_most.mux(row.add_lit(1), row);
    m.next_if(row, out.room, take.mux(tile_of(arriving.bounds.top), next_row));
    let single = arriving.end | first_tile(&arriving.bounds).eq(last_tile(&arriving.bounds));
    let reaches_last = cat([next_row, next_column]).eq(last_tile(&bounds));
    m.next_if(last, out.room, take.mux(single, reaches_last));
    let falls_idle = !busy | (last | reaches_last);
    m.next_if(idle, out.room, take.mux(single, falls_idle));

    // The rectangle's edge where it lies in this tile, else the tile's own.
    let clip = |edge: Expr, here: Expr, of_tile: u32| here.mux(edge.trunc(LOCAL_BITS), lit(LOCAL_BITS, of_tile.into()));
    let copy = SplatCopy {
        end: splat.end,
        footprint: splat.footprint,
        attributes: splat.attributes,
        bounds: TileRectangle {
            left: clip(bounds.left, left_most, 0),
            right: clip(bounds.right, right_most, TILE_SIZE - 1),
            top: clip(bounds.top, top_most, 0),
            bottom: clip(bounds.bottom, bottom_most, TILE_SIZE - 1),
        },
        tile: cat([row, column]),
    };
    let push = out.room & busy;
    out.push(&mut m, config, push, copy);
    m
}
