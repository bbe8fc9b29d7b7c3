//! The tile cache's directory: which tile each slot holds, whether it has arrived, and how many copies are under way in it.

use pointcore_spec::core_a::Config;
use pointcore_spec::core_a::config::IN_FLIGHT_BITS;

use crate::rtl::{Expr, Module, Reg, cat, lit};

/// The state of one slot.
struct Slot {
    tile: Reg,
    resident: Reg,
    ready: Reg,
    in_flight: Reg,
    /// It is the next to be allocated.
    is_next: Expr,
}

/// The directory's registers and what they say about one tile.
pub(super) struct Directory {
    slots: Vec<Slot>,
    next: Reg,
    /// The tile that is looked up.
    pub sought: Expr,
    /// Some slot holds it.
    pub hit: Expr,
    /// That slot, or 0.
    pub hit_slot: Expr,
    /// That slot can take one more copy.
    pub hit_has_room: Expr,
    /// The tile in the slot to be allocated next, if `next_resident`.
    pub next_tile: Expr,
    pub next_resident: Expr,
    /// No copy is under way in the slot to be allocated next.
    pub next_idle: Expr,
}

/// What changes the directory in a cycle.
pub(super) struct Changes<'a> {
    /// The next slot is given to the tile that is looked up.
    pub allocate: &'a Expr,
    /// A copy enters slot [`Directory::hit_slot`].
    pub enter: &'a Expr,
    /// A copy of `retire_slot` is done.
    pub retire: &'a Expr,
    pub retire_slot: &'a Expr,
    /// The tile of `filled_slot` has arrived.
    pub filled: &'a Expr,
    pub filled_slot: &'a Expr,
    /// The frame is over: no slot is ready any more.
    pub close: &'a Expr,
    /// The frame has left: no slot holds a tile any more.
    pub clear: &'a Expr,
}

/// Of the values, the one whose condition is set, or 0 where none is.
fn pick<'a>(width: usize, choices: impl Iterator<Item = (Expr, &'a Expr)>) -> Expr {
    choices.fold(lit(width, 0), |all, (condition, value)| all | (condition.repeat(width) & value))
}

impl Directory {
    /// Declares the registers and looks `sought` up.
    pub fn new(m: &mut Module, config: &Config, sought: &Expr) -> Self {
        let (tile_bits, slot_bits) = (config.tile_bits() as usize, config.slot_bits() as usize);
        let next = m.reg_reset("next", slot_bits, 0);
        let slots: Vec<_> = (0..config.tile_slots)
            .map(|slot| Slot {
                tile: m.reg(&format!("tile_{slot}"), tile_bits),
                resident: m.reg_reset(&format!("resident_{slot}"), 1, 0),
                ready: m.reg_reset(&format!("ready_{slot}"), 1, 0),
                in_flight: m.reg_reset(&format!("in_flight_{slot}"), IN_FLIGHT_BITS as usize, 0),
                is_next: next.eq_lit(slot.into()),
            })
            .collect();
        let hits: Vec<_> = slots.iter().map(|slot| &slot.resident & slot.tile.eq(sought)).collect();
        let hit = cat(&hits.iter().collect::<Vec<_>>()).any();
        let hit = m.wire("hit", &hit);
        let numbers: Vec<_> = (0..slots.len()).map(|slot| lit(slot_bits, slot as u128)).collect();
        let hit_slot = pick(slot_bits, hits.iter().cloned().zip(&numbers));
        let hit_slot = m.wire("hit_slot", &hit_slot);
        let full: Vec<_> = slots.iter().map(|slot| slot.in_flight.all()).collect();
        let hit_full = pick(1, hits.into_iter().zip(&full));
        let of_next = |width, value: fn(&Slot) -> &Expr| {
            pick(width, slots.iter().map(|slot| (slot.is_next.clone(), value(slot))))
        };
        let next_tile = of_next(tile_bits, |slot| &slot.tile);
        let next_resident = of_next(1, |slot| &slot.resident);
        let next_idle = of_next(IN_FLIGHT_BITS as usize, |slot| &slot.in_flight).is_zero();
        let hit_has_room = !hit_full;
        Self { slots, next, sought: sought.clone(), hit, hit_slot, hit_has_room, next_tile, next_resident, next_idle }
    }

    /// The slot to be allocated next.
    pub fn next_slot(&self) -> Expr {
        self.next.expr()
    }

    /// A bit per slot: its tile has arrived.
    pub fn ready(&self) -> Expr {
        let ready: Vec<&Expr> = self.slots.iter().rev().map(|slot| &*slot.ready).collect();
        cat(&ready)
    }

    /// States how the registers change.
    pub fn update(self, m: &mut Module, changes: &Changes<'_>) {
        let last = self.next.eq_lit(self.slots.len() as u128 - 1) | changes.clear;
        let next = last.mux(&lit(self.next.width(), 0), &self.next.add_lit(1));
        m.next_if(&self.next, &(changes.allocate | changes.clear), &next);
        for (number, slot) in self.slots.iter().enumerate() {
            let is = |other: &Expr| other.eq_lit(number as u128);
            let allocated = changes.allocate & &slot.is_next;
            m.next_if(&slot.tile, &allocated, &self.sought);
            m.next_if(&slot.resident, &(&allocated | changes.clear), &allocated);
            let filled = changes.filled & is(changes.filled_slot);
            m.next_if(&slot.ready, &(&filled | &allocated | changes.close), &filled);
            let enters = changes.enter & is(&self.hit_slot);
            let leaves = changes.retire & is(changes.retire_slot);
            let count = enters.mux(&slot.in_flight.add_lit(1), &slot.in_flight.sub_lit(1));
            m.next_if(&slot.in_flight, &(&enters ^ &leaves), &count);
            m.assert(&format!("slot_{number}_retires_what_entered"), &(!&leaves | slot.in_flight.any()));
        }
    }
}
