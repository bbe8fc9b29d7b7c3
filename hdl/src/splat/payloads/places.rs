//! Places of payloads: which are free, and how many copies of the splats in the others are on their way.

use pointcore_contract::record;
use pointcore_contract::splat::Config;

use crate::stream::{fifo, skid};
use crate::units::queue::Pushed;
use crate::units::wires::{Wired, Wires, layout};
use rtl::{Expr, Module, Reg, lit};

/// A place.
#[record(config: Config)]
pub(super) struct Place {
    /// Its number.
    #[bits(config.splat_bits())]
    place: u16,
}

/// A splat whose copies have come.
#[record(config: Config)]
pub(super) struct Closed {
    /// Where it lies.
    #[bits(config.splat_bits())]
    pub place: u16,
    /// How many they are.
    #[bits(config.copy_count_bits())]
    pub copies: u32,
}

/// A number that is added to a place's balance, or the balance it made.
struct Stage {
    valid: Reg,
    place: Expr,
    number: Expr,
}

impl Stage {
    /// Registers for what comes a cycle earlier.
    fn new(m: &mut Module, name: &str, valid: impl Into<Expr>, [place, number]: [Expr; 2]) -> Self {
        let stage = m.reg_reset(&format!("{name}_valid"), 1, 0);
        m.next(stage, valid);
        let mut register = |what: &str, value: Expr| {
            let register = m.reg(&format!("{name}_{what}"), value.width());
            m.next(register, value);
            register.expr()
        };
        Self { valid: stage, place: register("place", place), number: register("number", number) }
    }

    /// Whether it is about a place.
    fn is_of(&self, place: Expr) -> Expr {
        self.valid & self.place.eq(place)
    }
}

/// The places, to be told once what changes.
pub(super) struct Places {
    closes: Pushed<Closed>,
    closed: (Expr, Wired<Closed>),
    close: rtl::Wire,
    released: Pushed<Place>,
    clearing: Reg,
    cleared: Reg,
    /// There is a free place.
    pub has_free: Reg,
    /// It.
    pub free: Reg,
    takes: Expr,
    refilled: Expr,
}

impl Places {
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let bits = config.splat_bits();
        let (closes, closed) = Pushed::<Closed>::place(m, config, "closes", skid(&layout::<Closed>(config)));
        let queue = fifo(config.splats_held().max(2), &layout::<Place>(config));
        let (released, reused) = Pushed::<Place>::place(m, config, "released", queue);

        // After reset nothing is known of the balances: one after the other is cleared, and its place is free then.
        let clearing = m.reg_reset("clearing", 1, 1);
        let cleared = m.reg_reset("cleared", bits, 0);

        let has_free = m.reg_reset("has_free", 1, 0);
        let free = m.reg("free", bits);
        let takes = m.wire("takes_free", !has_free);
        m.drive(reused.ready, takes);
        m.next_if(free, takes, reused.record.place);
        Self {
            closes,
            closed: (closed.valid, closed.record),
            close: closed.ready,
            released,
            clearing,
            cleared,
            has_free,
            free,
            takes,
            refilled: reused.valid,
        }
    }

    /// A splat can be closed in this cycle.
    pub fn may_close(&self) -> Expr {
        self.closes.room
    }

    /// In a cycle of `closes` a splat is closed, in one of `begun` another takes the free place, in one of `leaves` a copy of a place
    /// leaves. Returns whether one left in the cycle before.
    pub fn step(
        self,
        m: &mut Module,
        config: &Config,
        (closes, splat): (Expr, Closed<Wires>),
        begun: Expr,
        (leaves, place): (Expr, Expr),
    ) -> Expr {
        let (bits, width) = (config.splat_bits(), config.copy_count_bits());
        self.closes.push(m, config, closes, splat);
        m.next(self.has_free, self.takes.mux(self.refilled, self.has_free & !begun));

        // A copy that left comes first: there are pauses between two of them.
        let left = Stage::new(m, "left", leaves, [place, !lit(width, 0)]);
        m.drive(self.close, !left.valid);
        let (is_closed, closed) = self.closed;
        let begins = m.wire("begins", left.valid | is_closed);
        let place = m.wire("begins_place", left.valid.mux(left.place, closed.place));
        let amount = left.valid.mux(left.number, closed.copies);

        // What is read is caught before it is added to. What the memory does not show yet stands in a register by then.
        let balances = m.memory_unordered("balances", 1 << bits, width);
        let shown = m.read(balances, "shown_balance", place);
        let reading = Stage::new(m, "reading", begins, [place, amount]);
        let caught = Stage::new(m, "caught", reading.valid, [reading.place, reading.number]);
        let balance = m.reg("balance", width);
        m.next(balance, shown);
        let sum = m.forward("sum", width);
        let added = Stage::new(m, "added", caught.valid, [caught.place, sum.expr()]);
        let earlier = Stage::new(m, "earlier", added.valid, [added.place, added.number]);
        let earliest = Stage::new(m, "earliest", earlier.valid, [earlier.place, earlier.number]);
        let mut follows = |name: &str, stage: &Stage| {
            let follows = m.reg(name, 1);
            m.next(follows, stage.is_of(reading.place));
            follows
        };
        // Where the one that began a cycle before is in the next cycle, and so on.
        let sources = [
            (follows("follows_added", &caught), added.number),
            (follows("follows_earlier", &added), earlier.number),
            (follows("follows_earliest", &earlier), earliest.number),
        ];
        let sources = sources.into_iter().rev();
        let before = sources.fold(balance.expr(), |before, (follows, number)| follows.mux(number, before));
        m.drive(sum, before + caught.number);

        // The memory is written by sums, and where there is none by what clears it.
        let (clearing, cleared) = (self.clearing, self.cleared);
        let clears = m.wire("clears", clearing & !added.valid);
        m.next_if(cleared, clears, cleared.add_lit(1));
        let is_last = cleared.eq_lit(u128::from(config.splats_held()) - 1);
        m.next(clearing, clearing & !(clears & is_last));
        let written = added.valid.mux(added.place, cleared);
        m.write(balances, clearing | added.valid, written, added.valid.repeat(width) & added.number);
        let releases = m.wire("releases", clears | (added.valid & added.number.is_zero()));
        m.assert("a_place_that_is_free_has_room", !releases | self.released.room);
        self.released.push(m, config, releases, Place { place: written });
        left.valid.expr()
    }
}
