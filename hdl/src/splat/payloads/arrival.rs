//! Copies on their way in: those that begin a splat need a place for its payload.

use super::places::{Closed, Places};
use crate::units::ports::{StreamInPorts, held};
use crate::units::wires::Wires;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::SplatCopy;
use pointcore_contract::splat::units::payloads::PORTS;
use rtl::{Expr, Module, lit};

/// What comes in.
pub(super) struct Arrival {
    /// The copy that is shown.
    pub copy: SplatCopy<Wires>,
    /// It is taken in this cycle.
    pub take: Expr,
    /// It begins a splat, at the free place.
    pub begins: Expr,
    /// The place of the splat that began last, from the cycle after on.
    pub place: Expr,
    /// The cycles in which a splat is closed, and that splat.
    pub closed: (Expr, Closed<Wires>),
}

impl Arrival {
    /// Takes copies while there is `room`, those that begin a splat while a payload has some, too.
    pub fn new(m: &mut Module, config: &Config, places: &Places, room: Expr, payload_room: Expr) -> Self {
        let input = PORTS.input.declare(m, config);
        let copy = input.record;
        let SplatCopy { end, first, .. } = copy;
        let passes = m.reg_reset("passes", 1, 0);
        let ready = m.wire("ready", room & (places.may_close() & (payload_room | passes)));
        m.drive(input.ready, ready);
        let take = m.wire("take", ready & input.valid);
        let needs_place = m.wire("needs_place", first & !end);
        m.next(passes, (input.valid & !ready) & !needs_place);
        let begins = m.wire("begins_splat", take & needs_place);

        let place = held(m, "place", begins, places.free);
        let copies = m.reg("copies", config.copy_count_bits());
        m.next_if(copies, take, begins.mux(lit(copies.width(), 1), copies.add_lit(1)));
        // It is closed when the next one is seen, which may have to wait for its place.
        let open = m.reg_reset("open", 1, 0);
        let closes = m.wire("closes_splat", (input.valid & (first | end)) & (open & places.may_close()));
        m.next(open, begins | (open & !closes));
        Self { copy, take, begins, place, closed: (closes, Closed { place, copies: *copies }) }
    }
}
