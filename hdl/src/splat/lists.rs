//! Lists of splat copies, one for each tile, of which some are served in turn (thesis 5.5.2), an entry in and one out every second
//! cycle; golden twin: `pointcore_golden::splat::lists`.
//!
//! A tick has two cycles. In the first the list that waits first is opened, in the second an entry is appended to its tile's list and
//! one leaves from the list whose turn it is. Both operations read where their tile's list ends in the cycle in which they begin, and
//! write it in the next, whatever was read: only neighbors of the same tile meet.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::HeapEntry;
use pointcore_contract::splat::units::lists::PORTS;
use pointcore_contract::{record, width};

use super::parts::share;
use crate::stream::{fifo, half_buffer};
use crate::units::ports::{StreamInPorts, StreamOutPorts, WordPort, held};
use crate::units::queue::Pushed;
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Module, Reg, bit};

/// An open list, from its next entry on.
#[record(config: Config)]
struct List {
    /// Its next entry.
    next: HeapEntry,
    /// The pointer of its last one.
    #[bits(config.heap_levels)]
    last: u16,
}

/// Where the lists of all tiles end: `valid` if there is one that was not opened.
#[record(config: Config)]
struct End {
    /// There is a list.
    valid: bool,
    /// The pointer of its last entry.
    #[bits(config.heap_levels)]
    last: u16,
}

/// The open lists, the next to give an entry first.
struct Turns {
    valid: Vec<Reg>,
    lists: Vec<Reg>,
}

impl Turns {
    fn new(m: &mut Module, config: &Config) -> Self {
        let count = config.turns();
        Self {
            valid: (0..count).map(|place| m.reg_reset(&format!("turn_{place}_valid"), 1, 0)).collect(),
            lists: (0..count).map(|place| m.reg(&format!("turn_{place}"), width::<List>(config))).collect(),
        }
    }

    fn list(&self, config: &Config, place: usize) -> List<Wires> {
        List::unpack(config, self.lists[place].expr())
    }

    /// Whether a list of a tile is open.
    fn holds(&self, config: &Config, tile: Expr) -> Expr {
        let places = 0..self.valid.len();
        places.fold(bit(false), |any, place| any | (self.valid[place] & self.list(config, place).next.tile.eq(tile)))
    }

    /// Whether as many are open as may be, with one more or not.
    fn is_full(&self, one_more: impl Into<Expr>) -> Expr {
        let last = self.valid.len() - 1;
        let but_one = last.checked_sub(1).map_or(bit(true), |place| self.valid[place].expr());
        self.valid[last] | (one_more.into() & but_one)
    }

    /// The first leaves on `pop`, a list joins behind the others on `push`.
    fn step(self, m: &mut Module, pop: Expr, push: Expr, joining: Expr) {
        let count = self.valid.len();
        let stays = |place: usize| {
            let behind = if place + 1 < count { self.valid[place + 1].expr() } else { bit(false) };
            pop.mux(behind, self.valid[place])
        };
        let mut before = bit(true);
        for place in 0..count {
            let joins = push & (before & !stays(place));
            let moved = if place + 1 < count { self.lists[place + 1].expr() } else { joining };
            m.next_if(self.lists[place], pop | joins, joins.mux(joining, moved));
            m.next(self.valid[place], stays(place) | joins);
            before = stays(place);
        }
    }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let (place_bits, pointer_bits) = (config.place_bits(), config.heap_levels);
    let mut m = Module::new("splat_lists", "Lists of splat copies, one for each tile; some are served in turn.");
    m.parameter("pointers", config.pointers());
    m.parameter("tiles_in_turn", config.turns());
    let input = PORTS.input.declare(&mut m, config);
    let out = PORTS.out.queue(&mut m, config);
    let queue = fifo(config.pointers(), &layout::<HeapEntry>(config));
    let (beginnings, waiting) = Pushed::<HeapEntry>::place(&mut m, config, "beginnings", queue);
    // What a block RAM shows comes late in the cycle.
    let waiting = waiting.through(&mut m, config, "first", half_buffer(&layout::<HeapEntry>(config)));

    // After reset no tile has a list.
    let clearing = m.reg_reset("clearing", 1, 1);
    let cleared = m.reg_reset("cleared", place_bits, 0);
    let (next, is_last) = share::following(config, *cleared);
    m.next_if(cleared, clearing, next);
    m.next_if(clearing, is_last, bit(false));
    let second = m.reg_reset("second", 1, 0);
    m.next(second, !(clearing | second));

    // Both operations look up the end of their list, opening in the first cycle of a tick, appending in the second.
    let may_open = m.reg_reset("may_open", 1, 0);
    let opens = m.wire("opens", may_open & !second);
    let opening = m.reg_reset("opening", 1, 0);
    m.next(opening, opens);
    m.drive(waiting.ready, opens);
    let opened = waiting.record.register(&mut m, config, "opened_", opens);
    m.drive(input.ready, second);
    let appends = m.wire("appends", second & input.valid);
    let appending = m.reg_reset("appending", 1, 0);
    m.next(appending, appends);
    let appended = input.record.register(&mut m, config, "appended_", appends);

    let ends = m.memory_unordered("ends", 1 << place_bits, width::<End>(config));
    let place = |tile| share::place(config, tile);
    let found = m.read(ends, "found", second.mux(place(input.record.tile), place(waiting.record.tile)));
    let found = End::unpack(config, found);
    let end = End { valid: appending.expr(), last: appended.pointer };
    let written = appending.mux(place(appended.tile), place(opened.tile));
    let writes = clearing | (appending | opening);
    m.write(ends, writes, clearing.mux(cleared, written), end.pack(config));
    let meets_opened = m.reg("meets_opened", 1);
    m.next(meets_opened, opening & input.record.tile.eq(opened.tile));
    let meets_appended = m.reg("meets_appended", 1);
    m.next(meets_appended, appending & waiting.record.tile.eq(appended.tile));

    // An entry follows the last of its list, or begins one.
    let linking = m.reg_reset("linking", 1, 0);
    m.next(linking, appending);
    let follows = held(&mut m, "follows", appending, found.valid & !meets_opened);
    let last = held(&mut m, "last", appending, found.last);
    let begins = m.wire("begins", linking & !follows);
    m.assert("a_list_that_begins_has_room", !begins | beginnings.room);
    beginnings.push(&mut m, config, begins, appended);
    let links = m.memory_unordered("links", config.pointers(), pointer_bits);
    m.write(links, linking & follows, last, appended.pointer);

    // A list that was opened takes its turn; one that gave an entry looks up the next, and takes its turn again.
    let joins = m.reg_reset("joins", 1, 0);
    m.next(joins, opening);
    m.assert("a_list_that_waits_has_an_end", !(opening & !meets_appended) | found.valid);
    let opened_last = held(&mut m, "opened_last", opening, meets_appended.mux(appended.pointer, found.last));
    let turns = Turns::new(&mut m, config);
    let first = turns.list(config, 0);
    let leaves = m.wire("leaves", (second & turns.valid[0]) & out.room);
    let goes_on = m.reg_reset("goes_on", 1, 0);
    m.next_if(goes_on, second, leaves & first.next.pointer.ne(first.last));
    let gone_on = List { next: first.next, last: first.last }.register(&mut m, config, "going_", second);
    let link = m.read_if(links, "link", second, first.next.pointer);
    let following = held(&mut m, "following", !second, link);

    let tile = waiting.record.tile;
    let is_open = turns.holds(config, tile) | (goes_on & gone_on.next.tile.eq(tile));
    let is_full = turns.is_full(goes_on);
    m.next_if(may_open, second, (waiting.valid & !opening) & !(is_open | is_full));
    let again = List { next: HeapEntry { tile: gone_on.next.tile, pointer: following }, last: gone_on.last };
    let fresh = List { next: opened, last: opened_last };
    let joining = List::choose(config, second, again, fresh);
    let push = second.mux(goes_on, joins);

    let count = m.reg_reset("count", pointer_bits + 1, 0);
    m.next_if(count, appends ^ leaves, appends.mux(count.add_lit(1), count.sub_lit(1)));
    PORTS.empty.drive_word(&mut m, !(count.any() | out.holds));
    out.push(&mut m, config, leaves, first.next);
    turns.step(&mut m, leaves, push, joining.pack(config));
    m
}
