//! Control of the multi-tile cache (thesis 5.5.3): places copies in tile slots, exchanges tiles with the reconstruction
//! buffer and sends the finished frame; golden twin: `pointcore_golden::splat::tile_cache`.

mod directory;
mod leaving;
mod moves;
mod pending;
mod seeker;
mod state;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{
    PLACED_QUEUE_DEPTH, RUNS_ASKED_MAX, SLOT_BANKS, SURFACE_BITS, TILE_PIXELS, WRITE_QUEUE_DEPTH,
};
use pointcore_contract::splat::records::{PlacedCopy, SlotChange, SlotTile, TileCopy};
use pointcore_contract::splat::units::tile_cache::PORTS;

use super::parts::share;
use crate::units::ports::{InputPorts, PulseInPorts, PulseOutPorts, QueueOut, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::queue::Head;
use crate::units::twins::next_twins;
use crate::units::wires::Wires;
use directory::{Changes, Directory, Lookup};
use leaving::{Gone, Leaving, Surroundings};
use moves::{Begins, exchange};
use pending::{Lookups, Pending};
use rtl::{Expr, Module, Reg, Wire, bit, cat};
use state::State;

/// What happens to the copy at the head.
struct Placement {
    /// It is passed on.
    send: Expr,
    /// Its tile is in no slot, and the next one is free for it.
    misses: Expr,
    /// So it was in the last cycle.
    missed: Reg,
    /// A job brings its tile.
    start: Expr,
    /// It is the end: a slot that loses its tile without getting another starts to be written back.
    vacate: Expr,
    /// Its turn passes without that.
    pass: Expr,
    /// All slots were written back: the next frame is drawn.
    switch: Expr,
}

/// Sends the head with its slot on a hit, starts a job on a miss; the end of the frame waits until no slot holds a tile, and the frame
/// leaves.
fn place_copy(
    m: &mut Module,
    config: &Config,
    state: &State,
    directory: &Directory,
    head: &Head<TileCopy<Wires>>,
    out: QueueOut<PlacedCopy>,
    (frame_leaves, sends): (Expr, Expr),
) -> Placement {
    let ready = m.wire("head_waits", head.valid & !state.clearing);
    let end = head.record.end;
    let copy = ready & !end;
    let send = m.wire("send", copy & (directory.copy.found & (out.room & directory.has_room)));
    let misses = m.wire("misses", (copy & !directory.copy.found) & (state.no_job() & directory.next_idle));
    let missed = m.reg_reset("missed", 1, 0);
    m.next(missed, misses);
    // A tile that leaves goes first only in the first cycle of a miss.
    let start = m.wire("start", misses & (state.wanted.is_empty() & !sends));

    let waits = m.wire("end_waits", (ready & end) & state.no_job());
    let switch = m.wire("switches", (waits & frame_leaves) & !directory.any_resident);
    let vacate = m.wire("vacate", waits & (directory.next_resident & directory.next_idle));
    m.next(state.surface, state.surface ^ switch);
    head.leaves_at_half_rate(m, send | switch);
    let TileCopy { bounds, diagonals, tile, splat, .. } = head.record;
    out.push(m, config, send, PlacedCopy { bounds, diagonals, tile, splat, slot: directory.copy.slot });
    // A slot that holds a tile is looked at for two cycles.
    let looks = directory.is_new & directory.next_resident;
    Placement { send, misses, missed, start, vacate, pass: waits & !(switch | looks), switch }
}

/// Cycles in which something of the job begins or ends.
struct JobSteps {
    /// Its slot hears of its next tile.
    change: Expr,
    /// It is done.
    done: Expr,
}

/// Keeps what the job is about, and steps through it; there is `room` for a tile that is written back.
fn follow_job(
    m: &mut Module,
    state: &State,
    placement: &Placement,
    directory: &Directory,
    (tile, sample_reads, room): (Expr, Expr, Expr),
) -> JobSteps {
    let has_left = state.leaving.is_empty() & state.owed.is_zero();
    let unchanged = m.wire("still_unchanged", state.unchanged & sample_reads);
    let change = m.wire("change", state.unchanged.any() & unchanged.is_zero());
    m.next(state.unchanged, unchanged | state.looking.repeat(SLOT_BANKS));
    let may_go = room | !state.goes;
    let done = m.wire("done", state.moving & (has_left & (state.all_came() & (!state.filling & may_go))));

    let start = m.wire("job_starts", placement.start | placement.vacate);
    next_twins(m, "it_looks_or_not", [state.looking, state.looks_not], start);
    m.next(state.changed, change);
    m.next(state.keeps, change & state.goes);
    m.next(state.keeps_none, !(change & state.goes));
    m.next_if(state.moving, state.changed | done, state.changed);
    m.next_if(state.slot, start, directory.next_slot());
    m.next_if(state.comes, start, placement.start);
    m.next_if(state.tile, start, tile);
    m.next_if(state.goes, start, directory.next_resident);
    m.next_if(state.goes_tile, start, directory.next_tile);
    JobSteps { change, done }
}

/// The memory of masks: by surface and tile, which pixels the reconstruction buffer holds; `misses` reads that of the `tile` that comes,
/// and `written` becomes that of the one that goes.
fn stored_masks(
    m: &mut Module,
    config: &Config,
    state: &State,
    leaving: &Leaving,
    (misses, tile): (Expr, Expr),
    (written, sends, clears): (Expr, Expr, Expr),
) -> StoredMasks {
    let words = 1 << (SURFACE_BITS + config.place_bits());
    let word = |tile: Expr| cat([state.surface.expr(), share::place(config, tile)]);
    let looked_at = cat([leaving.surface(state), *leaving.place]);
    let masks = m.memory_unordered("stored_masks", words, TILE_PIXELS);
    // Whether a mask has a bit is told where it is written, not counted from what block memory shows late.
    let any = m.memory_unordered("stored_any", words, 1);
    let read = misses.mux(word(tile), looked_at);
    let [any_shown, shown] =
        [(any, "any_is_stored"), (masks, "stored_mask")].map(|(memory, name)| m.read(memory, name, read));
    let shown = cat([any_shown, shown]);
    m.next_if(state.mask, !state.looks_not, shown);

    m.assert(
        "masks_are_kept_of_tiles_that_go",
        state.keeps.eq(state.changed & state.goes) & (state.keeps ^ state.keeps_none),
    );
    let kept = state.keeps.repeat(TILE_PIXELS) & written;
    let address = clears.mux(*state.cleared, state.keeps_none.mux(looked_at, word(*state.goes_tile)));
    let writes = (!state.keeps_none | clears) | sends;
    m.write(masks, writes, address, kept);
    m.write(any, writes, address, state.keeps & written.any());
    StoredMasks { shown, looked_at }
}

/// What passes between the memory of masks and the frame that leaves.
struct StoredMasks {
    shown: Expr,
    /// The word of the tile that is looked at.
    looked_at: Expr,
}

/// Clears the memories after reset, a word of each in a cycle; those of the second surface in cycles in which nothing else may write.
fn clear(m: &mut Module, config: &Config, state: &State, clears: Wire, writes: Expr) {
    m.drive(clears, state.clearing | (state.clearing_second & !writes));
    let (next, is_last) = share::following(config, *state.cleared);
    m.next_if(state.cleared, clears, next);
    m.next(state.clearing, state.clearing & !next.msb());
    m.next_if(state.clearing_second, clears & is_last, bit(false));
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
    let leaving = Leaving::new(&mut m, config);
    let draws_what_leaves = m.wire("draws_what_leaves", leaving.leaves & !leaving.given);
    // The mask of the tile that is looked at becomes empty.
    let sends = m.forward("mask_is_sent", 1);
    let clears = m.forward("word_is_cleared", 1);
    let placement = place_copy(&mut m, config, &state, &directory, &head, out, (draws_what_leaves, sends.expr()));
    if config.tests_samples() {
        let placed = SlotTile { slot: *state.slot, tile: *state.tile };
        PORTS.placed.drive(&mut m, config, state.looking & state.comes, placed);
    }
    let masks = PORTS.masks.declare(&mut m, config);
    let writes = (masks.written, sends.expr(), clears.expr());
    let stored = stored_masks(&mut m, config, &state, &leaving, (placement.misses, tile), writes);
    let lookups =
        Lookups { surface: *state.surface, clears: clears.expr(), cleared: *state.cleared, place: stored.looked_at };
    let pending = Pending::new(&mut m, config, &lookups, &head);
    pending.count(&mut m, placement.switch);
    let is_full = pending.whole.bit(1) | (pending.whole.bit(0) & leaving.given);
    let is_late = state.clearing_second & pending.turns_to_second;
    PORTS.full.drive_word(&mut m, (state.clearing | is_late) | is_full);
    clear(&mut m, config, &state, clears, (state.changed | *leaving.seen) | pending.writes);

    let held = m.wire("mask_that_comes", state.comes.repeat(TILE_PIXELS) & state.mask.trunc(TILE_PIXELS));
    let change = SlotChange { slot: *state.slot, banks: *state.unchanged, held };
    PORTS.change.drive(&mut m, config, state.unchanged.any(), change);
    let sample_reads = PORTS.sample_reads.declare_word(&mut m, SLOT_BANKS);
    let (gone, waiting) = Leaving::gone(&mut m, config);
    let steps = follow_job(&mut m, &state, &placement, &directory, (tile, sample_reads, gone.room));
    let is_gone = (steps.done & state.goes) & draws_what_leaves;
    gone.push(&mut m, config, is_gone, Gone { place: share::place(config, *state.goes_tile) });
    let is_place = |tile: Expr| share::place(config, tile).eq(*leaving.place);
    let (goes, goes_tile) = state.tile_that_goes();
    let head_holds = (head.valid & !head.record.end) & is_place(tile);
    let around = Surroundings {
        is_whole: pending.whole.any(),
        switches: placement.switch,
        reads_taken: (head.takes & head.arrives) | (placement.misses | placement.vacate),
        writes_taken: !state.keeps_none,
        mask: stored.shown,
        is_pending: pending.is_shown,
        is_held: (directory.holds(is_place) | head_holds) | (goes & is_place(goes_tile)),
        may_want: state.wanted.is_empty() & !((state.looking | state.unchanged.any()) | placement.missed),
        all_left: state.all_left() & pixel.room,
    };
    let leaves = leaving.update(&mut m, config, &around, &waiting);
    m.drive(sends, leaves.sends);

    let fills = m.wire("fills_are_wanted", steps.change & state.comes);
    let begins = m.wire("begins", leaves.sends | fills);
    let number = (config.rasterizers > 1).then(|| PORTS.number.declare_word(&mut m, config.rasterizer_bits()));
    let leaving_tile = share::tile(config, number, *leaving.place);
    m.next_if(state.wanted_leaves, begins, leaves.sends);
    m.next_if(state.wanted_surface, begins, leaves.sends.mux(leaving.surface(&state), *state.surface));
    m.next_if(state.wanted_tile, begins, leaves.sends.mux(leaving_tile, *state.tile));
    let moves = Begins {
        asks: begins,
        mask: leaves.sends.mux(*leaving.mask, *state.mask).trunc(TILE_PIXELS),
        // A tile that leaves has pixels, so its mask is not looked at.
        any_asked: leaves.sends | state.mask.msb(),
        drains: state.keeps.expr(),
        dirty: masks.dirty,
        closes: leaves.closes,
    };
    exchange(&mut m, config, &state, pixel, sample_reads, &moves);

    let changes = Changes {
        allocate: placement.start,
        vacate: placement.vacate,
        pass: placement.pass,
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
