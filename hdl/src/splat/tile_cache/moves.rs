//! The tile cache's moves of pixels: out of a slot, into it, to the reconstruction buffer and to the output.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Fill, FinishedPixel, PIXEL_BITS, Pixel, PlacedPixel, SlotPixel};

use super::state::{COUNT_BITS, Mode, State};
use crate::units::ports::{Flow, QueueOut, held};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module, Reg, lit};

/// Moves of pixels between slot, reconstruction buffer and output.
pub(super) struct Moves {
    /// The pixels that are shown and held move on, and one is read.
    pub step: Expr,
    /// The one that is held is pushed to the queue it is for.
    pub leaves: Expr,
    /// A beat of the data stream is taken.
    pub beat: Expr,
    /// A pixel is filled.
    pub fill: Expr,
    /// The job is done.
    pub done: Expr,
}

/// Drains a slot, for eviction or for the frame, and fills it.
pub(super) fn exchange(
    m: &mut Module,
    state: &State,
    data: &Flow<Pixel<Wires>>,
    write: &QueueOut<PlacedPixel>,
    pixel: &QueueOut<FinishedPixel>,
    fill_valid: Reg,
) -> Moves {
    let (from_slot, from_memory) = (state.is(Mode::FromSlot), state.is(Mode::FromMemory));
    let draining = m.wire("draining", from_slot | (state.moving & state.evict));
    let room = from_slot.mux(pixel.room, write.room);
    let step = m.wire("drain_step", draining & (!state.holding | room));
    let drain_next = m.wire("drain_next", step & !state.all_drained());
    m.next_if(state.showing, step, drain_next);
    m.next_if(state.shown_pixel, drain_next, state.drained.trunc(PIXEL_BITS));
    m.next_if(state.holding, step, state.showing);
    m.next_if(state.held_pixel, step, state.shown_pixel);
    let leaves = m.wire("held_leaves", state.holding & step);

    let vacated = !state.evict | state.filled.lt(state.drained);
    let may_fill = m.wire("may_fill", state.moving & (!state.filled.msb() & vacated));
    let memory_step = from_memory & (pixel.room & !state.all_drained());
    let data_ready = m.wire("take_data", (may_fill & state.load) | memory_step);
    m.drive(data.ready, data_ready);
    let beat = m.wire("beat", data_ready & data.valid);
    let fill = m.wire("fill", may_fill & (!state.load | data.valid));

    let evicted = !state.evict | (state.all_drained() & !(state.holds_pixels() | write.holds));
    let done = m.wire("done", state.moving & (state.filled.msb() & (!fill_valid & evicted)));
    let begin = state.looked | state.is(Mode::Check);
    let first = lit(COUNT_BITS, state.first_pixel.into());
    let drains = drain_next | (from_memory & beat);
    m.next_if(state.drained, begin | drains, begin.mux(first, state.drained.add_lit(1)));
    m.next_if(state.filled, begin | fill, begin.mux(first, state.filled.add_lit(1)));
    Moves { step, leaves, beat, fill, done }
}

/// What is written to the slot, a cycle after a pixel came.
pub(super) fn fill(m: &mut Module, config: &Config, state: &State, moves: &Moves, data: Pixel<Wires>) -> Fill<Wires> {
    let pixel = held(m, "fill_pixel", moves.fill, state.filled.trunc(PIXEL_BITS));
    let value = Bundle::choose(config, *state.load, data, Bundle::zeros(config));
    let value = value.register(m, config, "fill_", moves.fill);
    Fill { place: SlotPixel { slot: *state.slot, pixel }, value }
}

/// Pushes pixels to the reconstruction buffer and, at the end of the frame, those that are visible to the output.
pub(super) fn push_pixels(
    m: &mut Module,
    config: &Config,
    state: &State,
    moves: &Moves,
    (close, tile): (Expr, Expr),
    [held, data]: [Pixel<Wires>; 2],
    (write, pixel): (QueueOut<PlacedPixel>, QueueOut<FinishedPixel>),
) {
    let evicted = PlacedPixel { tile: *state.evict_tile, pixel: *state.held_pixel, value: held };
    write.push(m, config, state.moving & moves.leaves, evicted);
    let from_slot = state.is(Mode::FromSlot);
    let sent = PlacedPixel {
        tile,
        pixel: from_slot.mux(state.held_pixel, state.drained.trunc(PIXEL_BITS)),
        value: Bundle::choose(config, from_slot, held, data),
    };
    let sends = (from_slot & moves.leaves) | (state.is(Mode::FromMemory) & moves.beat);
    let visible = m.wire("visible", sent.value.weight.any());
    pixel.push(m, config, close | (sends & visible), FinishedPixel { end: close, placed: sent });
}
