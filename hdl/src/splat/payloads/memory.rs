//! Payloads in memory behind a port: their words leave as copies come, and are asked for before their copies are drawn.

use super::arrival::Arrival;
use super::places::Places;
use super::words::Words;
use crate::stream::{fifo, fifo_distributed};
use crate::units::ports::{Flow, StreamInPorts, StreamOutPorts};
use crate::units::queue::Pushed;
use crate::units::wires::layout;
use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::WRITTEN_COPIES;
use pointcore_contract::splat::records::{Payload, PayloadWord, SplatCopy, StoredWord, TileCopy};
use pointcore_contract::splat::units::payloads::PORTS;
use rtl::{Expr, Module, Reg, address_width, bit, lit};

/// A copy that waits until memory has taken its splat's payload.
#[record(config: Config)]
struct WaitingCopy {
    /// It is the first of its splat.
    begins: bool,
    /// The copy.
    copy: TileCopy,
}

/// The way in: takes copies, sends their payload to memory, and them on when it is there.
pub(super) fn arrive(m: &mut Module, config: &Config, words: Words, places: &Places) -> Arrival {
    let queue = fifo_distributed(WRITTEN_COPIES, &layout::<WaitingCopy>(config));
    let (waiting, waits) = Pushed::<WaitingCopy>::place(m, config, "waiting_copies", queue);
    let writing = m.reg_reset("writing", 1, 0);
    let arrival = Arrival::new(m, config, places, waiting.room, places.has_free & !writing);
    let Arrival { copy, take, begins, place, .. } = arrival;
    let SplatCopy { end, footprint, moving, attributes, bounds, diagonals, tile, .. } = copy;
    let splat = begins.mux(places.free, place);
    let copy = TileCopy { end, bounds, diagonals, tile, splat };
    waiting.push(m, config, take, WaitingCopy { begins, copy });
    let payload = words.cut(config, Payload { footprint, moving, attributes });
    let stored = write(m, config, words, (writing, begins), payload, place);

    // Splats whose payload is in memory, and whose first copy waits.
    let written = m.reg_reset("written", address_width(WRITTEN_COPIES + 1), 0);
    let copies = PORTS.copy.half(m, config);
    let WaitingCopy { begins, copy } = waits.record;
    let may_leave = m.wire("copy_may_leave", copies.room & (!begins | written.any()));
    m.drive(waits.ready, may_leave);
    let leaves = m.wire("copy_leaves", waits.valid & may_leave);
    copies.push(m, config, leaves, copy);
    let [more, less] = [stored, leaves & begins].map(|flag| flag.zext(written.width()));
    m.next(written, written + more - less);
    arrival
}

/// Holds the words of a payload that begins, and sends them one after the other; returns the cycles in which the last one is taken.
fn write(
    m: &mut Module,
    config: &Config,
    words: Words,
    (writing, begins): (Reg, Expr),
    payload: Vec<Expr>,
    place: Expr,
) -> Expr {
    let taken = m.forward("word_taken", 1);
    let number = (words.count > 1).then(|| m.reg("word", words.index_bits()));
    let last = number.map_or(bit(true), |number| words.is_last(*number));
    let registers: Vec<_> =
        (0..).zip(&payload).map(|(word, bits)| m.reg(&format!("word_{word}"), bits.width())).collect();
    let following = registers.iter().skip(1).map(|word| word.expr()).chain([registers[0].expr()]);
    for ((&register, first), following) in registers.iter().zip(payload).zip(following) {
        m.next_if(register, begins | taken, begins.mux(first, following));
    }
    if let Some(number) = number {
        m.next_if(number, begins | taken, begins.mux(lit(number.width(), 0), number.add_lit(1)));
    }
    let word = number.map_or(lit(1, 0), |number| number.expr());
    let value = words.part(config, registers[0].expr());
    let ready = PORTS.write.drive(m, config, writing, StoredWord { splat: place, word, value });
    m.drive(taken, writing & ready);
    let stored = m.wire("payload_stored", taken & last);
    m.next(writing, begins | (writing & !stored));
    stored
}

/// Words that have come, in a queue with room for all that are asked for.
pub(super) fn words(m: &mut Module, config: &Config, words: Words) -> Flow<Expr> {
    let depth = (config.payload_ahead * config.payload_beats).max(2);
    let came = PORTS.data.declare(m, config);
    let came = came.through(m, config, "came", fifo(depth, &layout::<PayloadWord>(config)));
    came.map(|word| words.joined(config, word))
}

/// The payload whose words are taken one after the other while there is a current copy; the last one where there is `room`, too.
pub(super) fn read(
    m: &mut Module,
    words: Words,
    beat: Option<Reg>,
    [current, room]: [Expr; 2],
    came: Flow<Expr>,
) -> Vec<Expr> {
    let word = came.record;
    let Some(beat) = beat else {
        m.drive(came.ready, current & room);
        return vec![word];
    };
    let last = words.is_last(*beat);
    m.drive(came.ready, current & (!last | room));
    let takes = m.wire("takes_word", came.valid & came.ready);
    m.next_if(beat, takes, last.mux(lit(beat.width(), 0), beat.add_lit(1)));
    words.keep(m, takes, word)
}
