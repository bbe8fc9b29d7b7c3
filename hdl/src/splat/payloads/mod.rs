//! Keeps what the copies of a splat have in common in one place while they are put in order; golden twin:
//! `pointcore_golden::splat::payloads`.

mod places;
mod words;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{CompleteCopy, PlacedCopy, SplatCopy, TileCopy};
use pointcore_contract::splat::units::payloads::PORTS;

use crate::units::ports::{Flow, StreamInPorts, StreamOutPorts, held};
use crate::units::sliced::Sliced;
use crate::units::wires::{Bundle, Wires};
use places::{Closed, Places};
use rtl::{Expr, Module, Reg, bit, lit};
use words::{Payload, Words, WrittenWord};

/// What comes in.
struct Arrival {
    written: WrittenWord,
    /// The cycles in which a splat is closed, and that splat.
    closed: (Expr, Closed<Wires>),
    /// A splat begins, at the free place.
    begins: Expr,
}

/// The splat whose copies come: where it lies, and the splat that it is when it is closed.
fn follow_splats(
    m: &mut Module,
    config: &Config,
    input: &Flow<SplatCopy<Wires>>,
    [take, begins]: [Expr; 2],
    places: &Places,
) -> (Expr, Closed<Wires>) {
    let SplatCopy { end, first, .. } = input.record;
    let place = held(m, "place", begins, places.free);
    let copies = m.reg("copies", config.copy_count_bits());
    m.next_if(copies, take, begins.mux(lit(copies.width(), 1), copies.add_lit(1)));
    // It is closed when the next one is seen, which may have to wait for its place.
    let open = m.reg_reset("open", 1, 0);
    let closes = m.wire("closes_splat", (input.valid & (first | end)) & (open & places.may_close()));
    m.next(open, begins | (open & !closes));
    (closes, Closed { place, copies: *copies })
}

/// The first word is written as the copy comes, the others in the cycles that follow; returns whether the last one is, too.
fn write(
    m: &mut Module,
    words: Words,
    [holds, begins]: [Expr; 2],
    payload: &[Expr],
    [place, free, has_free]: [Expr; 3],
) -> (WrittenWord, Expr) {
    if words.count == 1 {
        let written = WrittenWord { enable: !holds & has_free, address: free, word: payload[0] };
        return (written, bit(true));
    }
    let writing = m.reg_reset("writing", 1, 0);
    let number = m.reg("word", words.index_bits());
    let last = m.wire("writes_last", words.is_last(*number));
    m.next(writing, writing.mux(!last, begins));
    let following = last.mux(lit(number.width(), 0), number.add_lit(1));
    m.next(number, writing.mux(following, begins.zext(number.width())));
    let (first, others) = (payload[0], payload.iter().zip(0..).skip(1));
    let others = others.map(|(word, number)| held(m, &format!("word_{number}"), !holds, *word));
    let entries: Vec<_> = [first].into_iter().chain(others).collect();
    let written = WrittenWord {
        enable: writing | (!holds & has_free),
        address: words.address(*number, writing.mux(place, free)),
        word: number.pick(entries),
    };
    (written, !writing | last)
}

/// The way in: takes copies, leaves their payload behind and sends them on.
fn arrive(m: &mut Module, config: &Config, words: Words, places: &Places) -> Arrival {
    let input = PORTS.input.declare(m, config);
    let SplatCopy { end, first, footprint, attributes, bounds, diagonals, tile } = input.record;
    let holds = m.reg_reset("holds", 1, 0);
    let passes = m.reg_reset("passes", 1, 0);
    let ready = m.wire("ready", !holds & (places.may_close() & (places.has_free | passes)));
    m.drive(input.ready, ready);
    let take = m.wire("take", ready & input.valid);
    let needs_place = m.wire("needs_place", first & !end);
    m.next(passes, (input.valid & !ready) & !needs_place);
    let begins = m.wire("begins_splat", take & needs_place);
    let closed = follow_splats(m, config, &input, [take, begins], places);
    let place = closed.1.place;

    let payload = words.cut(config, Payload { footprint, attributes });
    let free = [place, places.free.expr(), places.has_free.expr()];
    let (written, is_written) = write(m, words, [holds.expr(), begins], &payload, free);
    let empty = !holds;
    let copy = TileCopy {
        end: held(m, "held_end", empty, end),
        bounds: bounds.register(m, config, "held_", empty),
        diagonals: diagonals.register(m, config, "held_", empty),
        tile: held(m, "held_tile", empty, tile),
        splat: place,
    };
    let shown = m.wire("copy_shown", holds & is_written);
    let taken = PORTS.copy.drive(m, config, shown, copy);
    m.next(holds, holds.mux(!(shown & taken), take));
    Arrival { written, closed, begins }
}

/// The word that the memory shows of the current payload; on `advance` the first one of the next is read, else the one that follows.
fn read(
    m: &mut Module,
    words: Words,
    beat: Option<Reg>,
    advance: Expr,
    [next, current]: [Expr; 2],
    memory: &Sliced,
) -> Vec<Expr> {
    let Some(beat) = beat else {
        return vec![memory.read_if(m, "shown_word", advance, next)];
    };
    let last = words.is_last(*beat);
    let none = lit(beat.width(), 0);
    let following = beat.add_lit(1);
    m.next_if(beat, advance | !last, advance.mux(none, following));
    let address = words.address(advance.mux(none, following), advance.mux(next, current));
    let shown = memory.read_if(m, "shown_word", advance | !last, address);
    let keep = |word: u32| held(m, &format!("kept_{word}"), beat.eq_lit(word.into()), shown);
    let mut kept: Vec<_> = (0..words.count - 1).map(keep).collect();
    kept.push(shown);
    kept
}

/// The way out: gives copies their payload back; returns the cycles in which one has been read, and its place.
fn leave(m: &mut Module, config: &Config, words: Words, memory: &Sliced) -> (Expr, Expr) {
    let next = PORTS.placed.queue(m, config);
    let valid = m.reg_reset("current_valid", 1, 0);
    let beat = (words.count > 1).then(|| m.reg("beat", words.index_bits()));
    let is_read = beat.map_or(bit(true), |beat| words.is_last(*beat));
    let out_valid = m.reg_reset("out_holds", 1, 0);
    let out_taken = m.forward("out_taken", 1);
    let has_room = m.wire("out_room", !out_valid | out_taken);
    let leaves = m.wire("leaves", (valid & is_read) & has_room);
    let advance = m.wire("advance", !valid | leaves);
    m.drive(next.ready, advance);
    m.next_if(valid, advance, next.valid);
    let current = next.record.register(m, config, "current_", advance);
    let places = [next.record.splat, current.splat];
    let payload = read(m, words, beat, advance, places, memory);

    // What the memory shows last goes straight into a register, beside what was kept.
    let Payload { footprint, attributes } = words.join(config, &payload);
    let PlacedCopy { bounds, diagonals, tile, splat, slot } = current;
    let copy = CompleteCopy { footprint, attributes, bounds, diagonals, tile, slot };
    let out = copy.register(m, config, "held_out_", has_room);
    m.next_if(out_valid, has_room, leaves);
    let out_ready = PORTS.out.drive(m, config, out_valid, out);
    m.drive(out_taken, out_ready);
    (leaves, splat)
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_payloads", "Keeps what the copies of a splat have in common, once.");
    m.parameter("places", config.splats_held());
    m.parameter("beats", config.payload_beats);
    let words = Words::of(config);
    let places = Places::new(&mut m, config);
    let Arrival { written, closed, begins } = arrive(&mut m, config, words, &places);
    let WrittenWord { enable, address, word } = written;
    let memory = Sliced::new(&mut m, "payload_words", enable, address, word);
    let left = leave(&mut m, config, words, &memory);
    places.step(&mut m, config, closed, begins, left);
    m
}
