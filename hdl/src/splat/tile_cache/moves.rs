//! The tile cache's moves of pixels: out of a slot, into it, to the reconstruction buffer and to the output.

use pointcore_contract::splat::Field;
use pointcore_contract::splat::records::PIXEL_BITS;

use super::state::{COUNT_BITS, Mode, State};
use crate::units::records::{QueueOut, Record};
use rtl::{Expr, Module, Reg, Stream, lit};

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
    data: &Stream,
    write: &QueueOut,
    pixel: &QueueOut,
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
    m.ready(data, data_ready);
    let beat = m.wire("beat", data_ready & data.valid);
    let fill = m.wire("fill", may_fill & (!state.load | data.valid));

    let evicted = !state.evict | (state.all_drained() & !(state.holds_pixels() | write.holds));
    let done = m.wire("done", state.moving & (state.filled.msb() & (!fill_valid & evicted)));
    let begin = state.looked | state.is(Mode::Check);
    let zero = lit(COUNT_BITS, 0);
    let drains = drain_next | (from_memory & beat);
    m.next_if(state.drained, begin | drains, begin.mux(zero, state.drained.add_lit(1)));
    m.next_if(state.filled, begin | fill, begin.mux(zero, state.filled.add_lit(1)));
    Moves { step, leaves, beat, fill, done }
}

/// The ports that write the slot, a cycle after a pixel came.
pub(super) fn fill_ports(m: &mut Module, state: &State, fill: Expr, fill_valid: Reg, data: &Record, fields: &[Field]) {
    let fill_pixel = m.reg("fill_pixel", PIXEL_BITS);
    m.next(fill_valid, fill);
    m.next_if(fill_pixel, fill, state.filled.trunc(PIXEL_BITS));
    let filling = data.mux(*state.load, &Record::zeros(fields)).register(m, "fill_", fill);
    let place = [("slot", *state.slot), ("pixel", *fill_pixel)];
    m.pulse_out("fill", "valid", fill_valid, place.into_iter().chain(filling.named()));
}

/// Pushes pixels to the reconstruction buffer and, at the end of the frame, those that are visible to the output.
pub(super) fn push_pixels(
    m: &mut Module,
    state: &State,
    moves: &Moves,
    close: Expr,
    held: &Record,
    data: &Record,
    [write, pixel]: [QueueOut; 2],
) {
    let evicted = state.moving & moves.leaves;
    write.push(m, evicted, |name| match name {
        "tile" => state.evict_tile.expr(),
        "pixel" => state.held_pixel.expr(),
        field => held.get(field),
    });
    let from_slot = state.is(Mode::FromSlot);
    let sent_pixel = from_slot.mux(state.held_pixel, state.drained.trunc(PIXEL_BITS));
    let sent = held.mux(from_slot, data);
    let sends = (from_slot & moves.leaves) | (state.is(Mode::FromMemory) & moves.beat);
    let visible = m.wire("visible", sent.get("weight").any());
    pixel.push(m, close | (sends & visible), |name| match name {
        "end" => close,
        "tile" => state.code.expr(),
        "pixel" => sent_pixel,
        field => sent.get(field),
    });
}
