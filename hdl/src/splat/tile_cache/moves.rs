//! The tile cache's moves of pixels: out of a slot to the reconstruction buffer, and from there into a slot or to the output.

use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{
    Fill, FinishedPixel, LOCAL_BITS, PIXEL_BITS, PixelRun, PlacedPixel, RUN_BITS, SlotPixel, StoredPixel,
};
use pointcore_contract::splat::units::tile_cache::PORTS;

use super::state::{State, is_in};
use crate::stream::fifo_distributed;
use crate::units::ports::{Flow, PulseInPorts, PulseOutPorts, QueueOut, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::queue::Pushed;
use crate::units::twins::next_twins;
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Module, Reg, lit};

/// Pixels that were asked for.
#[record(config: Config)]
struct AskedRun {
    /// They leave with their frame.
    leaves: bool,
    /// Tile index.
    #[bits(config.tile_bits())]
    tile: u32,
    /// The first pixel of the tile.
    #[bits(PIXEL_BITS)]
    pixel: u8,
    /// How many there are.
    #[bits(RUN_BITS)]
    count: u8,
}

/// Asks memory for the pixels that are wanted, a run a cycle; returns the runs that were asked for, in order, and the bits of the row
/// that are asked for in this cycle.
fn ask(m: &mut Module, config: &Config, state: &State) -> (Flow<AskedRun<Wires>>, Expr, Expr) {
    let read = PORTS.read.queue(m, config);
    let queue = fifo_distributed(state.depths.asked, &layout::<AskedRun>(config));
    let (runs, asked) = Pushed::<AskedRun>::place(m, config, "asked_runs", queue);
    let found = state.wanted.found(m);
    let asks = m.wire("asks", found.any & (read.room & runs.room));
    let (tile, pixel, count) = (*state.wanted_tile, found.pixel, found.count);
    read.push(m, config, asks, PixelRun { surface: *state.wanted_surface, tile, pixel, count });
    runs.push(m, config, asks, AskedRun { leaves: *state.wanted_leaves, tile, pixel, count });
    (asked, asks, asks.repeat(found.run.width()) & found.run)
}

/// Reads pixels that leave out of the slot, and writes them; returns the bit of the row that is read in this cycle.
fn drain(m: &mut Module, config: &Config, state: &State, sample_reads: Expr) -> Expr {
    let found = state.leaving.found(m);
    let has_room = !state.owed.eq_lit(state.depths.written.into());
    let offers = m.wire("offers_drain", state.moving & (found.any & has_room));
    PORTS.drain.drive(m, config, offers, SlotPixel { slot: *state.slot, pixel: found.pixel });
    let drains = m.wire("drains", offers & !is_in(sample_reads, found.pixel));

    let queue = fifo_distributed(state.depths.written, &layout::<StoredPixel>(config));
    let (pixels, write) = Pushed::<StoredPixel>::place(m, config, "write_queue", queue);
    let drained = PORTS.drained.declare(m, config);
    m.assert("drained_pixels_find_room", !drained.valid | pixels.room);
    let placed = PlacedPixel { tile: *state.goes_tile, pixel: drained.record.pixel, value: drained.record.value };
    pixels.push(m, config, drained.valid, StoredPixel { surface: *state.surface, placed });
    let leaves = m.wire("pixel_leaves", write.transfer());
    PORTS.write.export(m, config, write);
    let width = state.owed.width();
    m.next(state.owed, state.owed + drains.zext(width) - leaves.zext(width));
    drains.repeat(found.first.width()) & found.first
}

/// Takes pixels that come, into the slot or to the output, which `close` ends; returns whether a run's last one does.
fn take(
    m: &mut Module,
    config: &Config,
    state: &State,
    asked: &Flow<AskedRun<Wires>>,
    pixel: QueueOut<FinishedPixel>,
    close: Expr,
) -> Expr {
    let data = PORTS.data.declare(m, config);
    let run = asked.record;
    let place = m.wire("coming_pixel", run.pixel + state.came.zext(PIXEL_BITS));
    let row = run.pixel.bits(PIXEL_BITS - 1, LOCAL_BITS);
    let vacated = state.leaving.is_empty() | state.leaving.is_behind(row);
    let fill_pixel = m.reg("fill_pixel", PIXEL_BITS);
    let is_taken = is_in(*state.taken_banks, *fill_pixel);
    let fills = m.wire("fills", state.filling & !is_taken);
    // While none waits the registers may take what they will: their enables do not wait for who has data. And who has data does not
    // wait for their enables.
    let is_free = m.wire("fill_is_free", !state.filling | fills);
    let may_fill = m.wire("may_fill", (state.moving & vacated) & (state.fills_none | !is_taken));
    let takes = m.wire("takes_data", asked.valid & run.leaves.mux(pixel.room, may_fill));
    m.drive(data.ready, takes);
    let beat = m.wire("beat", takes & data.valid);
    let next = m.wire("came_now", state.came.zext(RUN_BITS).add_lit(1));
    let ends = m.wire("run_ends", beat & next.eq(run.count));
    m.drive(asked.ready, ends);
    m.next_if(state.came, beat, ends.mux(lit(LOCAL_BITS, 0), next.trunc(LOCAL_BITS)));

    let fill = beat & !run.leaves;
    let waits = fill | (state.filling & !fills);
    next_twins(m, "fills_or_none", [state.filling, state.fills_none], waits);
    m.next_if(fill_pixel, is_free, place);
    let value = data.record.register(m, config, "fill_", is_free);
    let filled = SlotPixel { slot: *state.slot, pixel: *fill_pixel };
    PORTS.fill.drive(m, config, *state.filling, Fill { place: filled, value });

    let sent = PlacedPixel { tile: run.tile, pixel: place, value: data.record };
    let visible = m.wire("visible", (run.leaves & beat) & data.record.weight.any());
    pixel.push(m, config, close | visible, FinishedPixel { end: close, placed: sent });
    ends
}

/// Cycles in which pixels begin to move.
pub(super) struct Begins {
    /// Those of `mask` are asked for, of which there are `any_asked`.
    pub asks: Expr,
    pub mask: Expr,
    pub any_asked: Expr,
    /// Those of `dirty` leave the slot.
    pub drains: Expr,
    pub dirty: Expr,
    /// The frame is closed.
    pub closes: Expr,
}

/// Moves pixels between slot, reconstruction buffer and output.
pub(super) fn exchange(
    m: &mut Module,
    config: &Config,
    state: &State,
    pixel: QueueOut<FinishedPixel>,
    sample_reads: Expr,
    begins: &Begins,
) {
    let banks = PORTS.sample_writes.declare_word(m, state.taken_banks.width());
    m.next(state.taken_banks, banks);
    let (asked, asks, asked_bits) = ask(m, config, state);
    state.wanted.update(m, begins.asks, (begins.mask, begins.any_asked), asked_bits);
    let drained_bits = drain(m, config, state, sample_reads);
    state.leaving.update(m, begins.drains, (begins.dirty, begins.dirty.any()), drained_bits);
    let ends = take(m, config, state, &asked, pixel, begins.closes);
    let count = |m: &mut Module, awaited: Reg, leaves: [Expr; 2]| {
        let width = awaited.width();
        let [asks, ends] = [asks & leaves[0], ends & leaves[1]];
        m.next(awaited, awaited + asks.zext(width) - ends.zext(width));
    };
    let leaves = [*state.wanted_leaves, asked.record.leaves];
    count(m, state.awaited_leaving, leaves);
    count(m, state.awaited_fills, leaves.map(|leaves| !leaves));
}
