//! Control of the multi-tile cache (thesis 5.5.3): places copies in tile slots, exchanges tiles with the reconstruction
//! buffer and sends the finished frame; golden twin: `pointcore_golden::splat::tile_cache`.

mod directory;
mod moves;
mod state;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::PLACED_QUEUE_DEPTH;
use pointcore_contract::splat::records::{PIXEL_BITS, PlacedCopy, SlotPixel, Tile, TileCopy};
use pointcore_contract::splat::units::tile_cache::PORTS;

use super::parts::share;
use crate::units::ports::{InputPorts, PulseInPorts, PulseOutPorts, QueueOut, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::queue::Head;
use crate::units::wires::Wires;
use directory::{Changes, Directory, Hit, Lookup};
use moves::{exchange, fill, push_pixels};
use rtl::{Expr, Module, lit};
use state::{Mode, State};

/// What happens to the copy at the head.
struct Placement {
    send: Expr,
    send_end: Expr,
    start: Expr,
}

/// Sends the head with its slot on a hit, starts a job on a miss.
fn place(
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

/// Steps through the modes; returns the cycles in which the frame starts to be sent and in which it is closed.
fn sequence(
    m: &mut Module,
    state: &State,
    placement: &Placement,
    touched: Expr,
    sent: &Hit,
    room: Expr,
) -> (Expr, Expr) {
    let mode = |mode: Mode| lit(state.mode.width(), mode as u128);
    let finish = m.wire("finish", state.is(Mode::Wait) & (state.frame_ended & state.no_job()));
    let close = m.wire("close", state.is(Mode::Close) & room);
    let slot_sent = state.is(Mode::FromSlot) & (state.all_drained() & !state.holds_pixels());
    let memory_sent = state.is(Mode::FromMemory) & state.all_drained();
    let skipped = state.is(Mode::Check) & !touched;
    let next_tile = m.wire("next_tile", slot_sent | memory_sent | skipped);
    let clear = state.is(Mode::Clear);
    let last = m.wire("last_place", state.place.all());
    m.next_if(state.place, clear | next_tile, state.place.add_lit(1));
    m.next(state.code_read, state.is(Mode::Look) & !state.code_read);

    let source = sent.found.mux(mode(Mode::FromSlot), mode(Mode::FromMemory));
    let following = last.mux(mode(Mode::Close), mode(Mode::Look));
    let changes = [
        ((clear & last) | close, mode(Mode::Run)),
        (placement.send_end, mode(Mode::Wait)),
        (finish, mode(Mode::Look)),
        (state.is(Mode::Look) & state.code_read, mode(Mode::Check)),
        (next_tile, following),
        (state.is(Mode::Check), source),
    ];
    let next = changes.iter().rev().fold(state.mode.expr(), |next, (when, mode)| when.mux(*mode, next));
    m.next(state.mode, next);
    (finish, close)
}

/// Keeps what the job, or the tile that is sent, is about.
fn follow_job(
    m: &mut Module,
    state: &State,
    [start, done]: [Expr; 2],
    touched: Expr,
    directory: &Directory,
    [tile, sent]: [Expr; 2],
) {
    m.next(state.looking, start);
    m.next(state.looked, state.looking);
    m.next_if(state.moving, state.looked | done, state.looked);
    m.next_if(state.load, state.looked, touched);
    m.next_if(state.evict, start, directory.next_resident);
    m.next_if(state.evict_tile, start, directory.next_tile);
    let check = state.is(Mode::Check);
    m.next_if(state.slot, start | check, check.mux(directory.sent.slot, directory.next_slot()));
    m.next_if(state.tile, start | check, check.mux(sent, tile));
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    sized(config, 0, PLACED_QUEUE_DEPTH)
}

/// The unit that moves of a tile only the pixels from `first_pixel` on, with room for `ahead` copies behind it: a proof need not wait for
/// 64 and 16 of them.
#[must_use]
pub fn sized(config: &Config, first_pixel: u32, ahead: u32) -> Module {
    let mut m =
        Module::new("splat_tile_cache", "Control of the tile slots: placement, exchange with memory, end of frame.");
    m.parameter("slots", config.tile_slots);
    let queued = PORTS.input.half(&mut m, config);
    let head = Head::new(&mut m, config, queued);
    let tile = head.record.tile;
    let out = PORTS.out.deep(&mut m, config, ahead);
    let state = State::new(&mut m, config, first_pixel);
    let read_ready = PORTS.read.drive(&mut m, config, state.read_valid, Tile { tile: *state.tile });
    let data = PORTS.data.declare(&mut m, config);
    let write = PORTS.write.queue(&mut m, config);
    let pixel = PORTS.pixel.queue(&mut m, config);

    let directory = Directory::new(&mut m, config);
    PORTS.slot_ready.drive_word(&mut m, directory.ready());
    let retire = PORTS.retire.declare(&mut m, config);
    let frame_end = PORTS.frame_end.declare_word(&mut m, 1);

    let number = (config.rasterizers > 1).then(|| PORTS.number.declare_word(&mut m, config.rasterizer_bits()));
    let sent = share::tile(config, number, *state.place);
    let place_of = |tile| share::place(config, tile);
    let touched_tiles = m.memory_unordered("touched_tiles", 1 << config.place_bits(), 1);
    let look_at = state.is(Mode::Look).mux(state.place, place_of(tile));
    let stored = m.read(touched_tiles, "stored_touched", look_at);
    let touched = m.reg("touched", 1);
    m.next(touched, stored);
    let check = state.is(Mode::Check);
    let touch = state.looked | (state.is(Mode::Clear) | (check & touched));
    m.write(touched_tiles, touch, state.looked.mux(place_of(*state.tile), state.place), state.looked);

    let placement = place(&mut m, config, &state, &directory, &head, out);
    let fill_valid = m.reg_reset("fill_valid", 1, 0);
    let moves = exchange(&mut m, &state, &data, &write, &pixel, fill_valid);
    let (finish, close) = sequence(&mut m, &state, &placement, *touched, &directory.sent, pixel.room);
    m.next_if(state.frame_ended, frame_end | finish, frame_end);
    follow_job(&mut m, &state, [placement.start, moves.done], *touched, &directory, [tile, sent]);
    let raise_read = touched & (state.looked | (check & !directory.sent.found));
    m.next_if(state.read_valid, raise_read | read_ready, raise_read);

    m.next(fill_valid, moves.fill);
    let filling = fill(&mut m, config, &state, &moves, data.record);
    PORTS.fill.drive(&mut m, config, fill_valid, filling);
    let drained = SlotPixel { slot: *state.slot, pixel: state.drained.trunc(PIXEL_BITS) };
    PORTS.drain.drive(&mut m, config, moves.step, drained);
    let held = PORTS.drained.declare(&mut m, config);
    push_pixels(&mut m, config, &state, &moves, (close, sent), [held, data.record], (write, pixel));

    let changes = Changes {
        allocate: placement.start,
        enter: placement.send,
        retire: retire.valid,
        retire_slot: retire.record.slot,
        filled: moves.done,
        filled_slot: *state.slot,
        close: finish,
        clear: close,
    };
    let lookup = Lookup { copy: tile, takes: *head.takes, arriving: head.arriving.tile, code: sent };
    directory.update(&mut m, &lookup, &changes);
    m
}
