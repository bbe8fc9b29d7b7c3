//! Which tiles still get copies: of each the copy that came last is known until it has reached the head.

use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::SURFACE_BITS;
use pointcore_contract::splat::records::TileCopy;
use pointcore_contract::splat::units::tile_cache::PORTS;
use pointcore_contract::width;

use crate::splat::parts::share;
use crate::units::ports::PulseInPorts;
use crate::units::queue::Head;
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module, Reg, bit, cat};

/// What is known of a tile.
#[record(config: Config)]
struct LastCopy {
    /// Copies are still to come.
    valid: bool,
    /// The splat of the last one that came.
    #[bits(config.splat_bits())]
    splat: u16,
}

/// Registers of what arrives.
pub(super) struct Pending {
    /// Frames that have come whole and are still drawn.
    pub whole: Reg,
    is_end: Expr,
    /// What the memory shows.
    pub is_shown: Expr,
    /// A word may be written in this cycle.
    pub writes: Expr,
    /// The next copy is one for the second surface; while that is cleared none has come.
    pub turns_to_second: Expr,
}

/// What the memory of copies is told.
pub(super) struct Lookups {
    /// The surface that is drawn.
    pub surface: Expr,
    /// The word that is cleared after reset, while `clears`.
    pub clears: Expr,
    pub cleared: Expr,
    /// The word that is looked up in cycles in which no copy reaches the head.
    pub place: Expr,
}

impl Pending {
    /// Follows the copies that arrive, and those that reach the head.
    pub fn new(m: &mut Module, config: &Config, lookups: &Lookups, head: &Head<TileCopy<Wires>>) -> Self {
        let Lookups { surface, clears, cleared, place } = *lookups;
        let arrives = PORTS.arrives.declare(m, config);
        let comes = m.reg_reset("arrived", 1, 0);
        m.next(comes, arrives.valid);
        let arrived = arrives.record.register(m, config, "arrived_", bit(true));
        let is_end = m.wire("frame_is_whole", comes & arrived.end);
        let enters = m.wire("copy_enters", comes & !arrived.end);
        let arriving_surface = m.reg_reset("arriving_surface", SURFACE_BITS, 0);
        m.next(arriving_surface, arriving_surface ^ is_end);
        let whole = m.reg_reset("whole_frames", 2, 0);

        let word = |surface: Expr, tile: Expr| cat([surface, share::place(config, tile)]);
        let arrived_word = word(arriving_surface.expr(), arrived.tile);
        let (head_word, next_word) = (word(surface, head.record.tile), word(surface, head.arriving.tile));
        let reaches = head.takes & head.arrives;
        let last_copies = m.memory_unordered("last_copies", 1 << place.width(), width::<LastCopy>(config));
        let shown = m.read(last_copies, "last_copy", reaches.mux(next_word, place));
        let shown = LastCopy::unpack(config, shown);

        // Compared a cycle after it is shown, behind a register; a copy that came meanwhile is a later one.
        let looked_up = m.reg_reset("looked_up", 1, 0);
        m.next(looked_up, reaches & !head.arriving.end);
        let compared = m.reg_reset("compared", 1, 0);
        m.next(compared, looked_up);
        let found = shown.register(m, config, "found_", bit(true));
        let overtaken = m.reg("overtaken", 1);
        let overtakes = overtaken | (enters & arrived_word.eq(head_word));
        m.next(overtaken, reaches.mux(enters & arrived_word.eq(next_word), overtakes));
        let is_last = found.valid & found.splat.eq(head.record.splat);
        let reached = m.wire("last_reached", (compared & is_last) & !overtakes);
        let forgets = m.reg_reset("forgets", 1, 0);
        let forgotten = m.reg("forgotten", place.width());
        m.assert("one_copy_is_forgotten_at_a_time", !(reached & (forgets & enters)));
        m.next(forgets, reached | (forgets & (enters & arrived_word.ne(forgotten))));
        m.next_if(forgotten, reached, head_word);

        let written = enters.mux(arrived_word, forgotten);
        let value = LastCopy { valid: enters & !clears, splat: arrived.splat }.pack(config);
        m.write(last_copies, clears | (enters | forgets), clears.mux(cleared, written), value);
        let (writes, turns_to_second) = (comes | forgets, arriving_surface | is_end);
        Self { whole, is_end, is_shown: shown.valid, writes, turns_to_second }
    }

    /// Counts the frames that are whole: one is drawn in cycles where `switches` is set.
    pub fn count(&self, m: &mut Module, switches: Expr) {
        let more = self.is_end.zext(2);
        m.next(self.whole, self.whole + more - switches.zext(2));
    }
}
