//! Records to beats, as packets and as bursts: a register for the record, a queue of two for beats.

use super::beats::{Beat, Beats};
use crate::stream::skid;
use crate::units::ports::Flow;
use crate::units::wires::{Wires, layout};
use rtl::{Expr, Module, bit, lit};

/// Beats of records on their way out.
pub(crate) struct Spread {
    /// A record is taken in this cycle if there is one.
    pub ready: Expr,
    /// The beats; a record's last closes it.
    pub out: Flow<Beat<Wires>>,
    /// Nothing is held.
    pub idle: Expr,
}

/// Takes a record while `valid` and `accepts` are set and there is room, and sends its beats, one in each cycle.
pub(crate) fn spread(m: &mut Module, beats: &Beats, valid: Expr, record: &[Expr], accepts: Expr) -> Spread {
    let queue = m.instance("beat_queue", skid(&layout::<Beat>(&beats.beat_bits())));
    let room = m.out(queue, "in_ready");
    let out = Flow::from(m, &beats.beat_bits(), queue, "out");
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
    let record = beats.hold(m, record, takes);
    let words = beats.spread(&record);
    m.connect(queue, "in_valid", held);
    m.connect(queue, "in_data", place.pick(words.iter().copied()));
    m.connect(queue, "in_last", at_end);
    let idle = !held & !out.valid;
    Spread { ready, out, idle }
}
