//! Payloads in a memory on the chip.

use super::arrival::Arrival;
use super::places::Places;
use super::words::{Words, WrittenWord};
use crate::units::ports::{StreamOutPorts, held};
use crate::units::sliced::Sliced;
use crate::units::wires::Bundle;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Payload, SplatCopy, TileCopy};
use pointcore_contract::splat::units::payloads::PORTS;
use rtl::{Expr, Module, Reg, bit, lit};

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
pub(super) fn arrive(m: &mut Module, config: &Config, words: Words, places: &Places) -> (Arrival, Sliced) {
    let holds = m.reg_reset("holds", 1, 0);
    let arrival = Arrival::new(m, config, places, !holds, places.has_free.expr());
    let Arrival { copy, take, begins, place, .. } = arrival;
    let SplatCopy { end, footprint, moving, attributes, bounds, diagonals, tile, .. } = copy;

    let payload = words.cut(config, Payload { footprint, moving, attributes });
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
    let WrittenWord { enable, address, word } = written;
    (arrival, Sliced::new(m, "payload_words", enable, address, word))
}

/// The word that the memory shows of the current payload; on `advance` the first one of the next is read, else the one that follows.
pub(super) fn read(
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
    words.keep(m, !last, shown)
}
