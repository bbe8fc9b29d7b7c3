//! The tile cache's directory: which tile each slot holds, whether it has arrived, and how many copies are under way in it.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::IN_FLIGHT_BITS;

use super::seeker::pick;
use rtl::{Expr, Module, Reg, cat, lit};

/// The state of one slot.
struct Slot {
    tile: Reg,
    resident: Reg,
    ready: Reg,
    in_flight: Reg,
    /// A copy was placed in it since its turn to be allocated came last.
    used: Reg,
    /// It is the next to be allocated.
    is_next: Expr,
    /// It holds a tile, which is that of the copy to be placed.
    is_of_copy: Reg,
}

/// The slot that holds a tile.
pub(super) struct Hit {
    /// Some slot does.
    pub found: Expr,
    /// Which, or 0.
    pub slot: Expr,
}

/// The tile that is looked up, a cycle before it matters where it is.
pub(super) struct Lookup {
    /// The tile of the copy to be placed.
    pub copy: Expr,
    /// A copy with tile `arriving` takes its place.
    pub takes: Expr,
    pub arriving: Expr,
}

/// The directory's registers and what they say about the tile looked up.
pub(super) struct Directory {
    slots: Vec<Slot>,
    next: Reg,
    /// Where the copy's tile is.
    pub copy: Hit,
    /// That slot can take one more copy.
    pub has_room: Expr,
    /// Some slot holds a tile.
    pub any_resident: Expr,
    /// The tile in the slot to be allocated next, if `next_resident`.
    pub next_tile: Expr,
    pub next_resident: Expr,
    /// The slot to be allocated next was used since its last turn: another's turn comes.
    skips: Expr,
    /// It was not, and no copy is under way in it: told a cycle after its turn has come.
    pub next_idle: Reg,
    /// Its turn has just come.
    pub is_new: Reg,
}

/// What changes the directory in a cycle.
pub(super) struct Changes {
    /// The next slot is given to the tile of the copy.
    pub allocate: Expr,
    /// The next slot's tile is written back, and no other comes.
    pub vacate: Expr,
    /// Another slot's turn comes without either.
    pub pass: Expr,
    /// The copy enters its slot.
    pub enter: Expr,
    /// A copy of `retire_slot` is done.
    pub retire: Expr,
    pub retire_slot: Expr,
    /// The tile of `filled_slot` has arrived.
    pub filled: Expr,
    pub filled_slot: Expr,
}

impl Hit {
    fn new(m: &mut Module, name: &str, width: u32, hits: &[Expr]) -> Self {
        let found = m.wire(&format!("{name}_hit"), cat(hits.iter().copied()).any());
        let numbers: Vec<_> = (0..hits.len()).map(|slot| lit(width, slot as u128)).collect();
        let slot = pick(width, hits.iter().copied().zip(numbers));
        Self { found, slot: m.wire(&format!("{name}_slot"), slot) }
    }
}

impl Directory {
    /// Declares the registers.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let (tile_bits, slot_bits) = (config.tile_bits(), config.slot_bits());
        let next = m.reg_reset("next", slot_bits, 0);
        let slots: Vec<_> = (0..config.tile_slots)
            .map(|slot| Slot {
                tile: m.reg(&format!("tile_{slot}"), tile_bits),
                resident: m.reg_reset(&format!("resident_{slot}"), 1, 0),
                ready: m.reg_reset(&format!("ready_{slot}"), 1, 0),
                in_flight: m.reg_reset(&format!("in_flight_{slot}"), IN_FLIGHT_BITS, 0),
                used: m.reg_reset(&format!("used_{slot}"), 1, 0),
                is_next: next.eq_lit(slot.into()),
                is_of_copy: m.reg_reset(&format!("is_of_copy_{slot}"), 1, 0),
            })
            .collect();
        let holds_copy: Vec<_> = slots.iter().map(|slot| slot.is_of_copy.expr()).collect();
        let copy = Hit::new(m, "copy", slot_bits, &holds_copy);
        let any_resident = m.wire("any_resident", cat(slots.iter().map(|slot| slot.resident)).any());
        let full: Vec<_> = slots.iter().map(|slot| slot.in_flight.all()).collect();
        let has_room = !pick(1, holds_copy.into_iter().zip(full));
        let of_next =
            |width, value: fn(&Slot) -> Expr| pick(width, slots.iter().map(|slot| (slot.is_next, value(slot))));
        let next_tile = of_next(tile_bits, |slot| *slot.tile);
        let next_resident = of_next(1, |slot| *slot.resident);
        let skips = m.wire("skips", of_next(1, |slot| *slot.used));
        let next_idle = m.reg_reset("next_idle", 1, 0);
        let is_new = m.reg_reset("turn_is_new", 1, 1);
        Self { slots, next, copy, has_room, any_resident, next_tile, next_resident, skips, next_idle, is_new }
    }

    /// Whether a slot holds a tile of which this is so.
    pub fn holds(&self, is: impl Fn(Expr) -> Expr) -> Expr {
        cat(self.slots.iter().map(|slot| slot.resident & is(*slot.tile))).any()
    }

    /// The slot to be allocated next.
    pub fn next_slot(&self) -> Expr {
        self.next.expr()
    }

    /// A bit per slot: its tile has arrived.
    pub fn ready(&self) -> Expr {
        cat(self.slots.iter().rev().map(|slot| slot.ready))
    }

    /// States how the registers change.
    pub fn update(self, m: &mut Module, lookup: &Lookup, changes: &Changes) {
        let last = self.next.eq_lit(self.slots.len() as u128 - 1);
        let next = last.mux(lit(self.next.width(), 0), self.next.add_lit(1));
        let starts = m.wire("starts", changes.allocate | changes.vacate);
        let turns = m.wire("turns", (starts | self.skips) | changes.pass);
        m.next_if(self.next, turns, next);
        m.next(self.is_new, turns);
        let mut idle = vec![];
        for (number, slot) in self.slots.iter().enumerate() {
            let is = |other: Expr| other.eq_lit(number as u128);
            let allocated = changes.allocate & slot.is_next;
            m.next_if(slot.tile, allocated, lookup.copy);
            let starts = starts & slot.is_next;
            // A slot is given to a copy that stays.
            let holds = slot.resident & !starts;
            let is_of_copy =
                lookup.takes.mux(holds & slot.tile.eq(lookup.arriving), allocated | (slot.is_of_copy & !starts));
            m.next(slot.is_of_copy, is_of_copy);
            m.next_if(slot.resident, starts, allocated);
            let filled = changes.filled & is(changes.filled_slot);
            m.next_if(slot.ready, filled | starts, filled);
            let enters = changes.enter & is(self.copy.slot);
            let leaves = changes.retire & is(changes.retire_slot);
            m.next(slot.used, enters | (slot.used & !slot.is_next));
            let count = enters.mux(slot.in_flight.add_lit(1), slot.in_flight.sub_lit(1));
            m.next_if(slot.in_flight, enters ^ leaves, count);
            let becomes_empty = slot.in_flight.is_zero() | (slot.in_flight.eq_lit(1) & leaves);
            idle.push((slot.is_next, becomes_empty & !(enters | slot.used)));
            m.assert(&format!("slot_{number}_retires_what_entered"), !leaves | slot.in_flight.any());
        }
        m.next(self.next_idle, pick(1, idle.into_iter()) & !turns);
    }
}
