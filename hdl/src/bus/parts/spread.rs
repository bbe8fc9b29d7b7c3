//! Records to beats, as packets and as bursts: a register for the record, a queue of two for beats.

use super::beats::Beats;
use crate::stream::skid;
use crate::units::records::Record;
use rtl::{Expr, Module, Stream, bit, lit};

/// Beats of records on their way out.
pub(crate) struct Spread {
    /// A record is taken in this cycle if there is one.
    pub ready: Expr,
    /// The beats: `data`, and `last` with the last of a record.
    pub out: Stream,
    /// Nothing is held.
    pub idle: Expr,
}

/// Takes a record while `valid` and `accepts` are set and there is room, and sends its beats, one in each cycle.
pub(crate) fn spread(m: &mut Module, beats: &Beats, valid: Expr, record: &Record, accepts: Expr) -> Spread {
    let queue = m.instance("beat_queue", skid(&[("data", beats.beat_bits()), ("last", 1)]));
    let room = m.out(queue, "in_ready");
    let out = m.stream_from(queue, "out");
    if beats.count == 1 {
        let ready = m.wire("takes_record", room & accepts);
        m.connect(queue, "in_valid", valid & ready);
        m.connect(queue, "in_data", beats.spread(record)[0]);
        m.connect(queue, "in_last", bit(true));
        let idle = !out.valid;
        return Spread { ready, out, idle };
    }
    // The register takes the next record while the last beat of the one before moves on.
    let held = m.reg_reset("held", 1, 0);
    let place = m.reg_reset("place", beats.place_bits(), 0);
    let at_end = m.wire("at_end", place.eq_lit(beats.count as u128 - 1));
    let moves = m.wire("moves", held & room);
    let leaves = m.wire("leaves", moves & at_end);
    let ready = m.wire("takes_record", (!held | leaves) & accepts);
    let takes = m.wire("takes", valid & ready);
    m.next(held, takes | (held & !leaves));
    let next = at_end.mux(lit(beats.place_bits(), 0), place.add_lit(1));
    m.next_if(place, moves, next);
    let record = record.register(m, "held_", takes);
    let words = beats.spread(&record);
    m.connect(queue, "in_valid", held);
    m.connect(queue, "in_data", place.pick(words.iter().copied()));
    m.connect(queue, "in_last", at_end);
    let idle = !held & !out.valid;
    Spread { ready, out, idle }
}
