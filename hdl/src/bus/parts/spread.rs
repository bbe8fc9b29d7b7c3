//! Records to beats, as packets and as bursts: a register for the record, a queue of two for beats.

use super::beats::{Beat, Beats};
use crate::stream::skid;
use crate::units::passage::Passage;
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
    let bits = &beats.beat_bits();
    let queue = Passage::<Beat>::place(m, "beat_queue", skid(&layout::<Beat>(bits)));
    let room = queue.room(m);
    let out = queue.out(m, bits);
    if beats.count == 1 {
        let ready = m.wire("takes_record", room & accepts);
        queue.push(m, bits, valid & ready, Beat { data: beats.spread(record)[0], last: bit(true) });
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
    queue.push(m, bits, held, Beat { data: place.pick(words.iter().copied()), last: at_end });
    let idle = !held & !out.valid;
    Spread { ready, out, idle }
}
