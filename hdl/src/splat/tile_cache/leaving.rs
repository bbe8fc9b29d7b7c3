//! The frame that leaves: its tiles one by one, as soon as no copy of them is to come.

use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{GONE_TILES, TILE_PIXELS};
use pointcore_contract::splat::units::tile_cache::PORTS;

use super::share;
use super::state::State;
use crate::stream::fifo_distributed;
use crate::units::ports::{Flow, WordPort};
use crate::units::queue::Pushed;
use crate::units::wires::{Wires, layout};
use rtl::{Expr, Module, Reg, bit, lit};

/// A tile that was written back.
#[record(config: Config)]
pub(super) struct Gone {
    /// Its place among those of the rasterizer.
    #[bits(config.place_bits())]
    pub place: u32,
}

/// Registers of the frame that leaves.
pub(super) struct Leaving {
    /// One does: until all of it is drawn it is the one that is drawn.
    pub leaves: Reg,
    pub given: Reg,
    /// The place that is looked at next, among all of the image, if one is left.
    next: Reg,
    any_next: Reg,
    /// The place that is looked at, step by step: memories are read, they show it, it is judged.
    pub place: Reg,
    reading: Reg,
    shown: Reg,
    pub seen: Reg,
    /// Its mask, and above that whether it has a bit.
    pub mask: Reg,
    /// It stays: copies of it are to come, or it is in a slot.
    stays: Reg,
}

/// What it sees of a cycle.
pub(super) struct Surroundings {
    /// A whole frame is drawn.
    pub is_whole: Expr,
    /// All of it is.
    pub switches: Expr,
    /// Memories are read, and that of masks is written, for others.
    pub reads_taken: Expr,
    pub writes_taken: Expr,
    /// What they show.
    pub mask: Expr,
    pub is_pending: Expr,
    /// The tile that is looked at is in a slot, or on its way.
    pub is_held: Expr,
    /// A tile's pixels may be asked for.
    pub may_want: Expr,
    /// All that were asked for have left, and there is room for the end.
    pub all_left: Expr,
}

/// What it does.
pub(super) struct Steps {
    /// Pixels of the tile that is looked at are asked for, and are no longer in memory.
    pub sends: Expr,
    /// The frame is closed.
    pub closes: Expr,
}

impl Leaving {
    /// Declares the registers.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        Self {
            leaves: m.reg_reset("frame_leaves", 1, 0),
            given: m.reg_reset("frame_is_given", 1, 0),
            next: m.reg("next_place", config.place_bits()),
            any_next: m.reg_reset("any_next_place", 1, 0),
            place: m.reg("looked_at", config.place_bits()),
            reading: m.reg_reset("look_reads", 1, 0),
            shown: m.reg_reset("look_is_shown", 1, 0),
            seen: m.reg_reset("look_is_seen", 1, 0),
            mask: m.reg("seen_mask", TILE_PIXELS + 1),
            stays: m.reg("seen_stays", 1),
        }
    }

    /// The surface that leaves: the one that is drawn, until all of it is.
    pub fn surface(&self, state: &State) -> Expr {
        state.surface ^ self.given
    }

    /// Places the queue of tiles that were written back meanwhile.
    pub fn gone(m: &mut Module, config: &Config) -> (Pushed<Gone>, Flow<Gone<Wires>>) {
        Pushed::place(m, config, "gone_tiles", fifo_distributed(GONE_TILES, &layout::<Gone>(config)))
    }

    /// States how the registers change; tiles of which the memory holds all come from `waiting`.
    pub fn update(&self, m: &mut Module, config: &Config, around: &Surroundings, waiting: &Flow<Gone<Wires>>) -> Steps {
        let may_leave = m.wire("may_leave", self.mask.msb() & !self.stays);
        let sends = m.wire("sends", (self.seen & may_leave) & (around.may_want & !around.writes_taken));
        let idle = m.wire("looks_at_none", !(self.reading | (self.shown | self.seen)));
        let is_over = (self.given & !self.any_next) & !waiting.valid;
        let closes = m.wire("closes", ((self.leaves & idle) & is_over) & around.all_left);
        let waits = self.wait(m, config, closes);
        let begins = m.wire("frame_begins_to_leave", (around.is_whole & !self.leaves) & !waits);
        m.next_if(self.leaves, begins | closes, begins);
        m.next_if(self.given, around.switches | closes, around.switches);

        let looks = m.wire("looks", (self.leaves & idle) | (sends | (self.seen & !may_leave)));
        m.drive(waiting.ready, looks);
        let from_next = m.wire("looks_at_next", (looks & !waiting.valid) & self.any_next);
        let (following, is_last) = share::following(config, *self.next);
        m.next_if(self.next, begins | from_next, begins.mux(lit(self.next.width(), 0), following));
        m.next_if(self.any_next, begins | from_next, begins | !is_last);
        m.next_if(self.place, looks, waiting.valid.mux(waiting.record.place, *self.next));
        let read = m.wire("look_is_read", self.reading & !around.reads_taken);
        let starts = from_next | (looks & waiting.valid);
        m.next(self.reading, starts | (self.reading & !read));
        m.next(self.shown, read);
        m.next(self.seen, self.shown | (self.seen & !looks));
        m.next_if(self.mask, self.shown, around.mask);
        m.next_if(self.stays, self.shown, around.is_pending | (around.is_held & !self.given));
        Steps { sends, closes }
    }

    /// Where other rasterizers have tiles of the frame, the next does not begin to leave before the end of all of them has left.
    fn wait(&self, m: &mut Module, config: &Config, closes: Expr) -> Expr {
        if config.rasterizers == 1 {
            return bit(false);
        }
        let sent = PORTS.frame_sent.declare_word(m, 1);
        let waits = m.reg_reset("others_leave", 1, 0);
        m.next_if(waits, closes | sent, closes);
        waits.expr()
    }
}
