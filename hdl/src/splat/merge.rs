//! Tests fragments against depths in memory (thesis 5.4.6); golden twin: `pointcore_golden::splat::merge`.

use crate::stream::fifo;
use crate::units::ports::{Flow, StreamInPorts, StreamOutPorts, WordPort, held};
use crate::units::queue::Pushed;
use crate::units::wires::{Bundle, Wires, layout};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::MERGED_DEPTH_BITS;
use pointcore_contract::splat::records::{Depth, DepthRun, Fragment, LOCAL_BITS, RUN_BITS, StoredDepth};
use pointcore_contract::splat::units::merge::PORTS;
use rtl::{Expr, Module, Reg, Wire, address_width, cat, lit};

/// Where a fragment's depth lies: its tile, and which of the tile's pixels.
struct Place {
    tile: Expr,
    pixel: Expr,
}

impl Place {
    fn of(fragment: &Fragment<Wires>) -> Self {
        let Fragment { column, row, .. } = *fragment;
        let tile_of = |place: Expr| place.bits(place.width() - 1, LOCAL_BITS);
        Self {
            tile: cat([tile_of(row), tile_of(column)]),
            pixel: cat([row.trunc(LOCAL_BITS), column.trunc(LOCAL_BITS)]),
        }
    }
}

/// Gathers the pixels of fragments that are taken, and asks for a row's depths at once; returns whether one can be.
fn ask(m: &mut Module, config: &Config, fragment: &Fragment<Wires>, takes: Expr) -> Expr {
    let read = PORTS.depth_read.queue(m, config);
    let room = read.room;
    let Place { tile, pixel } = Place::of(fragment);
    let has_run = m.reg_reset("has_run", 1, 0);
    let next = m.reg("run_next", pixel.width());
    let count = m.reg("run_count", RUN_BITS);
    let renews = m.forward("run_renews", 1);
    let starts = m.wire("run_starts", takes & renews);
    let run_tile = held(m, "run_tile", starts, tile);
    let run_pixel = held(m, "run_pixel", starts, pixel);
    // A row begins at a multiple of eight pixels.
    let in_row = pixel.bits(LOCAL_BITS - 1, 0).any();
    let follows = m.wire("follows", ((takes & has_run) & in_row) & (tile.eq(run_tile) & pixel.eq(next.expr())));
    m.drive(renews, room & !follows);
    m.next_if(has_run, renews, takes);
    m.next_if(next, takes, pixel.add_lit(1));
    m.next_if(count, takes, follows.mux(count.add_lit(1), lit(RUN_BITS, 1)));
    let asks = m.wire("asks", renews & has_run);
    read.push(m, config, asks, DepthRun { tile: run_tile, pixel: run_pixel, count: *count });
    room
}

/// A fragment beside the depth that came for it, in registers: what memories show comes late in a cycle.
struct Head {
    valid: Reg,
    takes: Wire,
    fragment: Fragment<Wires>,
    stored: Expr,
}

impl Head {
    fn new(m: &mut Module, config: &Config, waiting: Flow<Fragment<Wires>>, depths: Flow<Depth<Wires>>) -> Self {
        let valid = m.reg_reset("has_head", 1, 0);
        let takes = m.forward("head_takes", 1);
        let comes = m.wire("head_comes", waiting.valid & depths.valid);
        m.next_if(valid, takes, comes);
        m.drive(waiting.ready, takes & comes);
        m.drive(depths.ready, takes & comes);
        let fragment = waiting.record.register(m, config, "head_", takes);
        let stored = held(m, "head_stored_depth", takes, depths.record.depth);
        Self { valid, takes, fragment, stored }
    }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_merge", "Tests fragments against depths in memory.");
    let ahead = config.merge_ahead;
    m.parameter("ahead", ahead);
    let input = PORTS.input.declare(&mut m, config);
    let queue = fifo(ahead, &layout::<Fragment>(config));
    let (fragments, waiting) = Pushed::<Fragment>::place(&mut m, config, "fragments", queue);
    let takes = m.forward("takes", 1);
    let room = ask(&mut m, config, &input.record, takes.expr());
    let closing = m.reg_reset("closing", 1, 0);
    let ready = m.wire("ready", (fragments.room & room) & !closing);
    m.drive(input.ready, ready);
    let comes = m.wire("comes", input.valid & ready);
    m.drive(takes, comes & !input.record.end);
    fragments.push(&mut m, config, takes, input.record);
    let data = PORTS.depth_data.declare(&mut m, config);
    let depths = data.through(&mut m, config, "depths", fifo(ahead, &layout::<Depth>(config)));
    let head = Head::new(&mut m, config, waiting, depths);

    let out = PORTS.out.queue(&mut m, config);
    let write = PORTS.depth_write.queue(&mut m, config);
    let tested = m.wire("tested", (head.valid & out.room) & write.room);
    m.drive(head.takes, !head.valid | tested);
    // Those in the queue, and the head.
    let under_way = m.reg_reset("under_way", address_width(ahead + 2), 0);
    let [more, less] = [takes.expr(), tested].map(|flag| flag.zext(under_way.width()));
    m.next(under_way, under_way + more - less);
    let closes = m.wire("closes", ((closing & under_way.is_zero()) & out.room) & !write.holds);
    m.next(closing, (comes & input.record.end) | (closing & !closes));

    let low_bits = MERGED_DEPTH_BITS - config.geometry.width();
    let Head { fragment, stored, .. } = head;
    let visible = m.wire("visible", tested & fragment.depth.lt(stored.bits(MERGED_DEPTH_BITS - 1, low_bits)));
    let Place { tile, pixel } = Place::of(&fragment);
    let depth = if low_bits > 0 { cat([fragment.depth, lit(low_bits, 0)]) } else { fragment.depth };
    write.push(&mut m, config, visible, StoredDepth { tile, pixel, value: Depth { depth } });
    out.push(&mut m, config, visible | closes, Fragment { end: closes, ..fragment });
    PORTS.hidden.event(&mut m, tested & !visible);
    m
}
