//! Control of the multi-tile cache (thesis 5.5.3): places copies in tile slots, exchanges tiles with the reconstruction
//! buffer and sends the finished frame; golden twin: `pointcore_golden::splat::tile_cache`.

mod directory;
mod moves;
mod seeker;
mod state;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{
    PLACED_QUEUE_DEPTH, RUNS_ASKED_MAX, SLOT_BANKS, TILE_PIXELS, WRITE_QUEUE_DEPTH,
};
use pointcore_contract::splat::records::{PlacedCopy, SlotChange, TileCopy};
use pointcore_contract::splat::units::tile_cache::PORTS;

use super::parts::share;
use crate::units::ports::{InputPorts, PulseInPorts, PulseOutPorts, QueueOut, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::queue::Head;
use crate::units::wires::Wires;
use directory::{Changes, Directory, Lookup};
use moves::exchange;
use rtl::{Expr, Module, lit};
use state::{Mode, State};

/// What happens to the copy at the head.
struct Placement {
    send: Expr,
    send_end: Expr,
    start: Expr,
}

/// Sends the head with its slot on a hit, starts a job on a miss.
fn place_copy(
    m: &mut Module,
    config: &Config,
    state: &State,
    directory: &Directory,
    head: &Head<TileCopy<Wires>>,
    out: QueueOut<PlacedCopy>,
) -> Placement {
    let ready = m.wire("head_waits", state.is(Mode::Run) & head.valid);
    let end = head.record.end;
    let send_end = m.wire("send_end", ready & (end & out.room));
    let copy = ready & !end;
    let send = m.wire("send", copy & (directory.copy.found & (out.room & directory.has_room)));
    let start = m.wire("start", copy & (!directory.copy.found & (state.no_job() & directory.next_idle)));
    let sent = send | send_end;
    head.leaves_at_half_rate(m, sent);
    out.push(m, config, sent, PlacedCopy { copy: head.record, slot: directory.copy.slot });
    Placement { send, send_end, start }
}

/// Cycles in which something begins or ends.
struct Steps {
    /// A slot that loses its tile without getting another starts to be written back.
    vacate: Expr,
    /// Its turn passes without that.
    pass: Expr,
    /// The job's slot hears of its next tile.
    change: Expr,
    /// The job is done.
    done: Expr,
    /// The frame is closed.
    close: Expr,
    /// Codes of the frame's tiles move on.
    advance: Expr,
    /// One with pixels in memory does.
    sends: Expr,
}

/// Steps through the modes, and through the places of tiles that are cleared or sent; there is `room` for a finished pixel, and
/// samples may read banks.
fn sequence(
    m: &mut Module,
    state: &State,
    placement: &Placement,
    directory: &Directory,
    [room, all_left, sample_reads]: [Expr; 3],
) -> Steps {
    let mode = |mode: Mode| lit(state.mode.width(), mode as u128);
    let flush = state.is(Mode::Flush);
    let waits = m.wire("waits", state.is(Mode::Wait) & state.no_job());
    let finish = m.wire("finish", waits & ((state.frame_ended & all_left) & !directory.any_resident));
    let vacate = m.wire("vacate", waits & (directory.next_resident & directory.next_idle));

    let has_pixels = m.wire("has_pixels", state.seen & state.mask.any());
    let advance = m.wire("advance", flush & (!has_pixels | state.wanted.is_empty));
    let sends = m.wire("sends", advance & has_pixels);
    let under_way = (state.walking | state.read) | state.seen;
    let close = m.wire("close", (flush & !under_way) & (state.all_came() & room));
    let (clear, last) = (state.is(Mode::Clear), m.wire("last_place", state.place.all()));
    m.next_if(state.place, clear | (advance & state.walking), state.place.add_lit(1));
    m.next_if(state.walking, finish | advance, finish | (state.walking & !last));
    m.next_if(state.read, advance, state.walking);
    m.next_if(state.read_place, advance, *state.place);
    m.next_if(state.seen, advance, state.read);
    m.next_if(state.seen_place, advance, *state.read_place);

    let changes = [
        ((clear & last) | close, mode(Mode::Run)),
        (placement.send_end, mode(Mode::Wait)),
        (finish, mode(Mode::Flush)),
    ];
    let next = changes.iter().rev().fold(state.mode.expr(), |next, (when, mode)| when.mux(*mode, next));
    m.next(state.mode, next);
    let frame_end = PORTS.frame_end.declare_word(m, 1);
    m.next_if(state.frame_ended, frame_end | finish, frame_end);

    let has_left = state.leaving.is_empty & state.owed.is_zero();
    let unchanged = m.wire("still_unchanged", state.unchanged & sample_reads);
    let change = m.wire("change", state.unchanged.any() & unchanged.is_zero());
    m.next(state.unchanged, unchanged | state.looking.repeat(SLOT_BANKS));
    let done = m.wire("done", state.moving & (has_left & (state.all_came() & !state.filling)));
    Steps { vacate, pass: waits & !finish, change, done, close, advance, sends }
}

/// Keeps what the job is about.
fn follow_job(m: &mut Module, state: &State, placement: &Placement, steps: &Steps, directory: &Directory, tile: Expr) {
    let start = m.wire("job_starts", placement.start | steps.vacate);
    m.next(state.looking, start);
    m.next(state.changed, steps.change);
    m.next_if(state.moving, state.changed | steps.done, state.changed);
    m.next_if(state.slot, start, directory.next_slot());
    m.next_if(state.comes, start, placement.start);
    m.next_if(state.tile, start, tile);
    m.next_if(state.goes, start, directory.next_resident);
    m.next_if(state.goes_tile, start, directory.next_tile);
}

/// The memory of masks: by tile, which pixels the reconstruction buffer holds.
fn stored_masks(m: &mut Module, config: &Config, state: &State, steps: &Steps, start: Expr, tile: Expr, written: Expr) {
    let flush = state.is(Mode::Flush);
    let masks = m.memory_unordered("stored_masks", 1 << config.place_bits(), TILE_PIXELS);
    let address = flush.mux(state.place, share::place(config, tile));
    let shown = m.read_if(masks, "stored_mask", start | steps.advance, address);
    m.next_if(state.mask, state.looking | steps.advance, shown);

    let clear = state.is(Mode::Clear);
    let goes = m.wire("mask_is_kept", state.changed & state.goes);
    let place = clear.mux(state.place, state.seen_place);
    let write = goes | (clear | (steps.advance & state.seen));
    let kept = goes.repeat(TILE_PIXELS) & written;
    m.write(masks, write, goes.mux(share::place(config, *state.goes_tile), place), kept);
}

/// Items that its queues hold.
#[derive(Clone, Copy)]
pub struct Depths {
    /// Copies with their slots.
    pub placed: u32,
    /// Runs of pixels that were asked for.
    pub asked: u32,
    /// Pixels that were read from a slot.
    pub written: u32,
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    sized(config, Depths { placed: PLACED_QUEUE_DEPTH, asked: RUNS_ASKED_MAX, written: WRITE_QUEUE_DEPTH })
}

/// The unit with queues of these depths: a proof need not wait for many items.
#[must_use]
pub fn sized(config: &Config, depths: Depths) -> Module {
    let mut m =
        Module::new("splat_tile_cache", "Control of the tile slots: placement, exchange with memory, end of frame.");
    m.parameter("slots", config.tile_slots);
    let queued = PORTS.input.half(&mut m, config);
    let head = Head::new(&mut m, config, queued);
    let tile = head.record.tile;
    let out = PORTS.out.deep(&mut m, config, depths.placed);
    let state = State::new(&mut m, config, depths);
    let pixel = PORTS.pixel.queue(&mut m, config);

    let directory = Directory::new(&mut m, config);
    PORTS.slot_ready.drive_word(&mut m, directory.ready());
    let retire = PORTS.retire.declare(&mut m, config);

    let placement = place_copy(&mut m, config, &state, &directory, &head, out);
    let held = m.wire("mask_that_comes", state.comes.repeat(TILE_PIXELS) & state.mask);
    let change = SlotChange { slot: *state.slot, banks: *state.unchanged, held };
    PORTS.change.drive(&mut m, config, state.unchanged.any(), change);
    let sample_reads = PORTS.sample_reads.declare_word(&mut m, SLOT_BANKS);
    let steps = sequence(&mut m, &state, &placement, &directory, [pixel.room, !pixel.holds, sample_reads]);
    follow_job(&mut m, &state, &placement, &steps, &directory, tile);
    let masks = PORTS.masks.declare(&mut m, config);
    stored_masks(&mut m, config, &state, &steps, placement.start, tile, masks.written);
    let begins = m.wire("begins", steps.sends | (steps.change & state.comes));
    let number = (config.rasterizers > 1).then(|| PORTS.number.declare_word(&mut m, config.rasterizer_bits()));
    let seen_tile = share::tile(config, number, *state.seen_place);
    m.next_if(state.wanted_tile, begins, steps.sends.mux(seen_tile, state.tile));
    exchange(&mut m, config, &state, (pixel, steps.close), sample_reads, begins, masks.dirty);

    let changes = Changes {
        allocate: placement.start,
        vacate: steps.vacate,
        pass: steps.pass,
        enter: placement.send,
        retire: retire.valid,
        retire_slot: retire.record.slot,
        filled: steps.done & state.comes,
        filled_slot: *state.slot,
    };
    let lookup = Lookup { copy: tile, takes: *head.takes, arriving: head.arriving.tile };
    directory.update(&mut m, &lookup, &changes);
    m
}
