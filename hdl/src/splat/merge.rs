//! Tests fragments against depths in memory (thesis 5.4.6); golden twin: `pointcore_golden::splat::merge`.

use crate::stream::fifo;
use crate::units::ports::{Flow, StreamInPorts, StreamOutPorts, WordPort, held};
use crate::units::queue::Pushed;
use crate::units::wires::{Wires, layout};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::MERGED_DEPTH_BITS;
use pointcore_contract::splat::records::{Depth, DepthRun, Fragment, LOCAL_BITS, RUN_BITS, StoredDepth};
use pointcore_contract::splat::units::merge::PORTS;
use rtl::{Expr, Module, cat, lit};

/// Where a fragment's depth lies: its tile, and which of the tile's pixels.
struct Place {
    tile: Expr,
    pixel: Expr,
}

impl Place {
    fn of(fragment: &Fragment<Wires>) -> Self {
        let Fragment { column, row, .. } = *fragment;
        let tile_of = |place: Expr| place.bits(place.width() - 1, LOCAL_BITS);
        let [tile, pixel] =
            [cat([tile_of(row), tile_of(column)]), cat([row.trunc(LOCAL_BITS), column.trunc(LOCAL_BITS)])];
        Self { tile, pixel }
    }
}

/// Gathers the pixels of fragments that are taken, and asks for a row's depths at once.
fn ask(m: &mut Module, config: &Config, fragment: &Fragment<Wires>, takes: Expr) -> Expr {
    let read = PORTS.depth_read.queue(m, config);
    let room = read.room;
    let Place { tile, pixel } = Place::of(fragment);
    let begins = m.wire("begins", takes & !fragment.end);
    let has_run = m.reg_reset("has_run", 1, 0);
    let next = m.reg("run_next", pixel.width());
    let count = m.reg("run_count", RUN_BITS);
    let renews = m.forward("run_renews", 1);
    let starts = m.wire("run_starts", begins & renews);
    let run_tile = held(m, "run_tile", starts, tile);
    let run_pixel = held(m, "run_pixel", starts, pixel);
    // A row begins at a multiple of eight pixels.
    let in_row = pixel.bits(LOCAL_BITS - 1, 0).any();
    let follows = m.wire("follows", ((begins & has_run) & in_row) & (tile.eq(run_tile) & pixel.eq(next.expr())));
    m.drive(renews, room & !follows);
    m.next_if(has_run, renews, begins);
    m.next_if(next, begins, pixel.add_lit(1));
    m.next_if(count, begins, follows.mux(count.add_lit(1), lit(RUN_BITS, 1)));
    let asks = m.wire("asks", renews & has_run);
    read.push(m, config, asks, DepthRun { tile: run_tile, pixel: run_pixel, count: *count });
    room
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_merge", "Tests fragments against depths in memory.");
    m.parameter("ahead", config.merge_ahead);
    let input = PORTS.input.declare(&mut m, config);
    let queue = fifo(config.merge_ahead, &layout::<Fragment>(config));
    let (waiting, shown) = Pushed::<Fragment>::place(&mut m, config, "fragments", queue);
    let takes = m.forward("takes", 1);
    let room = ask(&mut m, config, &input.record, takes.expr());
    let closes = m.forward("closes", 1);
    let closing = m.reg_reset("closing", 1, 0);
    let ready = m.wire("ready", (waiting.room & room) & !closing);
    m.drive(input.ready, ready);
    m.drive(takes, input.valid & ready);
    m.next(closing, (takes & input.record.end) | (closing & !closes));
    waiting.push(&mut m, config, takes, input.record);

    let data = PORTS.depth_data.declare(&mut m, config);
    let stored = data.through(&mut m, config, "depths", fifo(config.merge_ahead, &layout::<Depth>(config)));
    test(&mut m, config, shown, stored, closes);
    m
}

/// Tests what waits against the depth that came for it.
fn test(m: &mut Module, config: &Config, shown: Flow<Fragment<Wires>>, stored: Flow<Depth<Wires>>, closes: rtl::Wire) {
    let out = PORTS.out.queue(m, config);
    let write = PORTS.depth_write.queue(m, config);
    let fragment = shown.record;
    let width = config.geometry.width();
    let nearest = stored.record.depth.bits(MERGED_DEPTH_BITS - 1, MERGED_DEPTH_BITS - width);
    let waits = m.wire("waits", shown.valid & out.room);
    m.drive(closes, (waits & fragment.end) & !write.holds);
    let tested = m.wire("tested", ((waits & !fragment.end) & stored.valid) & write.room);
    let visible = m.wire("visible", tested & fragment.depth.lt(nearest));
    m.drive(shown.ready, tested | closes);
    m.drive(stored.ready, tested);
    let Place { tile, pixel } = Place::of(&fragment);
    let depth = match MERGED_DEPTH_BITS - width {
        0 => fragment.depth,
        low_bits => cat([fragment.depth, lit(low_bits, 0)]),
    };
    write.push(m, config, visible, StoredDepth { tile, pixel, value: Depth { depth } });
    out.push(m, config, visible | closes, fragment);
    PORTS.hidden.event(m, tested & !visible);
}
