//! Gathering (thesis 6.5.4): makes points with attributes of the indices that a search found, through lines that it keeps;
//! golden twin: `pointcore_golden::process::gatherer`.
//!
//! A neighbor's slot is read in stage `l` and judged in stage `k`, which sends the neighbor to `pending`, where it waits for
//! its turn, and a line that is missing to the memory and to `missed`. A line that comes takes its slot when all that was wanted of the former one has been read.

use pointcore_contract::process::Config;
use pointcore_contract::process::records::{Gather, Gathered, LineFetch, Neighbor, NeighborPlace};
use pointcore_contract::process::units::gatherer::PORTS;
use pointcore_contract::process::units::{LINES_UNDER_WAY, NEIGHBORS_UNDER_WAY};
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::{record, width};

use crate::stream::fifo_distributed;
use crate::units::ports::{Flow, OutputPorts, QueueOut, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::queue::Pushed;
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Memory, Module, Reg, Wire, bit, cat, lit};

/// Bits of a number of neighbors that tells all those under way, before and behind the queue too, from those that were.
const COUNT_BITS: u32 = NEIGHBORS_UNDER_WAY.ilog2() + 2;

const fn slot_bits(config: &Config) -> u32 {
    config.cache_lines.ilog2()
}

/// Bits of a line's number above those of its slot; 0 where every line has a slot of its own.
const fn tag_bits(config: &Config) -> u32 {
    config.line_bits().saturating_sub(slot_bits(config))
}

/// What is known of a slot.
#[record(config: Config)]
struct Slot {
    /// It has a line, or will have.
    used: bool,
    /// Which one.
    #[when(tag_bits(config) > 0)]
    #[bits(tag_bits(config))]
    tag: u32,
    /// How many neighbors had been wanted when one of it was, that one included.
    #[bits(COUNT_BITS)]
    wanted: u8,
}

/// A neighbor that waits for its turn.
#[record(config: Config)]
struct Pending {
    /// Whose, and of what use.
    place: NeighborPlace,
    /// Where it is kept.
    #[bits(point_bits(config))]
    point: u32,
    /// It waits for its line.
    missed: bool,
}

/// A line that was asked for.
#[record(config: Config)]
struct Missed {
    /// Its slot.
    #[bits(slot_bits(config))]
    slot: u32,
    /// It may be kept when so many neighbors have been read.
    #[bits(COUNT_BITS)]
    after: u8,
}

/// Bits of a place of a point.
const fn point_bits(config: &Config) -> u32 {
    slot_bits(config) + config.line_points.ilog2()
}

/// The parts of an index: the line's number, its slot, and the point's place.
fn parts(config: &Config, index: Expr) -> (Expr, Expr, Expr) {
    let in_line = config.line_points.ilog2();
    let line = if in_line < index.width() { index.bits(index.width() - 1, in_line) } else { lit(1, 0) };
    (line, line.resize(slot_bits(config)), index.resize(point_bits(config)))
}

/// How many neighbors were wanted, and how many of them read, modulo a power of two.
#[derive(Clone, Copy)]
struct Counts {
    wanted: Reg,
    read: Reg,
}

/// What is looked up: the stages l and k.
struct Lookup {
    head: Flow<Gather<Wires>>,
    l_valid: Reg,
    l: Gather<Wires>,
    l_advance: Wire,
    /// What was read of the slot of l.
    read: Slot<Wires>,
    k_valid: Reg,
    k: Gather<Wires>,
    k_advance: Wire,
    slots: Memory,
    clearing: Reg,
    cleared: Reg,
}

impl Lookup {
    /// Reads what is known of the slot of the neighbor that is wanted next.
    fn new(m: &mut Module, config: &Config, forget: Expr) -> Self {
        let head = PORTS.gather.queue(m, config);
        let clearing = m.reg_reset("clearing", 1, 1);
        let cleared = m.reg_reset("cleared", slot_bits(config), 0);
        let last = m.wire("clears_last", cleared.eq_lit(u128::from(config.cache_lines) - 1));
        m.next(clearing, forget | (clearing & !last));
        m.next(cleared, (forget | !clearing.expr()).mux(lit(slot_bits(config), 0), cleared.add_lit(1)));

        let [l_advance, k_advance] = ["l_advance", "k_advance"].map(|name| m.forward(name, 1));
        m.drive(head.ready, l_advance.expr() & !clearing);
        let [l_valid, k_valid] = ["l_valid", "k_valid"].map(|name| m.reg_reset(name, 1, 0));
        m.next_if(l_valid, l_advance, head.valid & !clearing);
        m.drive(l_advance, !l_valid | k_advance.expr());
        let l = head.record.register(m, config, "l_", l_advance);
        let slots = m.memory_unordered("slots", config.cache_lines, width::<Slot>(config));
        let (_, next_slot, _) = parts(config, head.record.index);
        let read = m.read_if(slots, "slot_read", l_advance, next_slot);
        m.next_if(k_valid, k_advance, l_valid);
        let k = l.register(m, config, "k_", k_advance);
        let read = Slot::unpack(config, read);
        Self { head, l_valid, l, l_advance, read, k_valid, k, k_advance, slots, clearing, cleared }
    }

    /// The slot of the neighbor in k as those before it have left it; writes it as this one leaves it, after so many.
    fn update(&self, m: &mut Module, config: &Config, leaves: Expr, count: Expr) -> Slot<Wires> {
        let (line, slot, _) = parts(config, self.k.index);
        let writes = m.wire("writes_slot", leaves & !self.k.place.none);
        let tag = if tag_bits(config) > 0 { line.bits(line.width() - 1, slot_bits(config)) } else { Expr::default() };
        let written = Slot { used: bit(true), tag, wanted: count };
        let address = self.clearing.mux(self.cleared.expr(), slot);
        let word = Slot::choose(config, self.clearing.expr(), Slot::zeros(config), written);
        m.write(self.slots, writes | self.clearing.expr(), address, word.pack(config));

        // What is written in the cycle of a read is not read; nor is what is written when the neighbor moves on to k.
        let [(_, next_slot, _), (_, l_slot, _)] =
            [self.head.record.index, self.l.index].map(|index| parts(config, index));
        let same = m.reg_reset("same_slot", 1, 0);
        m.next_if(same, self.l_advance, writes & next_slot.eq(slot));
        let before = written.register(m, config, "before_", writes);
        let seen = Slot::choose(config, same.expr(), before, self.read);
        let changes = m.wire("slot_changes", writes & l_slot.eq(slot));
        Slot::choose(config, changes, written, seen).register(m, config, "known_", self.k_advance)
    }
}

/// Takes lines that come, each when its slot is free; returns the memory of points, and whether a line is there that no
/// neighbor has been read of, `uses` being one that is.
fn fill(m: &mut Module, config: &Config, read: Reg, missed: Flow<Missed<Wires>>, uses: Expr) -> (Memory, Expr) {
    let fill = PORTS.fill.queue(m, config);
    let valid = m.reg_reset("filling", 1, 0);
    let in_line = config.line_points.ilog2();
    let taken = m.wire("fill_taken", fill.valid & valid);
    m.drive(fill.ready, valid);
    let (last, point) = match in_line {
        0 => (bit(true), None),
        _ => {
            let count = m.reg_reset("fill_count", in_line, 0);
            m.next_if(count, taken, count.add_lit(1));
            (count.all(), Some(count.expr()))
        }
    };
    let ends = m.wire("line_ends", taken & last);
    let takes = m.wire("takes_line", !valid | ends);
    let behind = m.wire("read_since", read - missed.record.after);
    let may_be_kept = m.wire("may_be_kept", missed.valid & !behind.msb());
    m.drive(missed.ready, takes & may_be_kept);
    m.next_if(valid, takes, may_be_kept);
    let slot = m.reg("filled_slot", slot_bits(config));
    m.next_if(slot, takes, missed.record.slot);
    let address = point.map_or_else(|| slot.expr(), |point| cat([slot.expr(), point]));
    let points = m.memory_unordered("points", config.cache_lines * config.line_points, width::<Neighbor>(config));
    m.write(points, taken, address, fill.record.pack(config));

    let bits = index_bits(LINES_UNDER_WAY + 2);
    let complete = m.reg_reset("complete", bits, 0);
    m.next(complete, complete + ends.zext(bits) - uses.zext(bits));
    (points, complete.any())
}

/// Shows neighbors in their turn.
fn show(
    m: &mut Module,
    config: &Config,
    gathered: QueueOut<Gathered>,
    pending: Pending<Wires>,
    [takes, advance]: [Expr; 2],
    points: Memory,
) -> Expr {
    let [r_valid, s_valid] = ["r_valid", "s_valid"].map(|name| m.reg_reset(name, 1, 0));
    let s_advance = m.wire("s_advance", !s_valid | gathered.room);
    let r_advance = m.wire("r_advance", !r_valid | s_advance);
    m.next_if(r_valid, r_advance, takes);
    m.next_if(s_valid, s_advance, r_valid);
    let reads = m.wire("reads", advance);
    let read = m.read_if(points, "read", reads, pending.point);
    let r_place = pending.place.register(m, config, "r_", reads);
    // A block RAM is slow to show what it has read.
    let neighbor = Neighbor::<Wires>::unpack(config, read);
    let shown = Neighbor::choose(config, r_place.none, Neighbor::zeros(config), neighbor);
    let s = Gathered { place: r_place, neighbor: shown }.register(m, config, "s_", s_advance);
    let shows = s_valid & gathered.room;
    gathered.push(m, config, shows, s);
    r_advance
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("process_gather", "Makes points with attributes of indices.");
    m.parameter("lines", config.cache_lines);
    m.parameter("line_points", config.line_points);
    let forget = PORTS.forget.declare_word(&mut m, 1);
    let lookup = Lookup::new(&mut m, config, forget);
    let (pending, waiting) = {
        let queue = fifo_distributed(NEIGHBORS_UNDER_WAY, &layout::<Pending>(config));
        Pushed::<Pending>::place(&mut m, config, "pending", queue)
    };
    let (missed, awaited) = {
        let queue = fifo_distributed(LINES_UNDER_WAY, &layout::<Missed>(config));
        Pushed::<Missed>::place(&mut m, config, "missed", queue)
    };
    let fetch = PORTS.fetch.queue(&mut m, config);
    let gathered = PORTS.gathered.queue(&mut m, config);
    let counts =
        Counts { wanted: m.reg_reset("wanted", COUNT_BITS, 0), read: m.reg_reset("read_count", COUNT_BITS, 0) };

    // k: a neighbor leaves when it can wait for its turn and its line can be asked for.
    let leaves = m.forward("k_leaves", 1);
    let count = m.wire("count", counts.wanted.add_lit(1));
    let slot = lookup.update(&mut m, config, leaves.expr(), count);
    let Gather { place, index } = lookup.k;
    let (line, slot_number, point) = parts(config, index);
    let is_of_line =
        if tag_bits(config) > 0 { slot.tag.eq(line.bits(line.width() - 1, slot_bits(config))) } else { bit(true) };
    let hit = m.wire("hit", place.none | (slot.used & is_of_line));
    let can_ask = m.wire("can_ask", fetch.room & missed.room);
    m.drive(leaves, lookup.k_valid & (pending.room & (hit | can_ask)));
    m.drive(lookup.k_advance, !lookup.k_valid | leaves.expr());
    m.next_if(counts.wanted, leaves, count);
    let misses = m.wire("misses", leaves.expr() & !hit);
    let hits = m.wire("hits", leaves.expr() & (hit & !place.none));

    // What was wanted of the slot's former line is waited for if it is still under way.
    let under_way = m.wire("under_way", counts.wanted - counts.read);
    let since = m.wire("wanted_since", counts.wanted - slot.wanted);
    let waits = m.wire("waits", slot.used & since.lt(under_way));
    let after = waits.mux(slot.wanted, counts.read.expr());
    missed.push(&mut m, config, misses, Missed { slot: slot_number, after });
    fetch.push(&mut m, config, misses, LineFetch { line });
    pending.push(&mut m, config, leaves.expr(), Pending { place, point, missed: !hit });
    OutputPorts::event(PORTS.events, &mut m, config, |events| events.hit, hits);
    OutputPorts::event(PORTS.events, &mut m, config, |events| events.miss, misses);

    // Neighbors are read in their turn, as soon as their lines are there.
    let takes = m.forward("takes", 1);
    let uses = m.wire("uses_line", takes.expr() & waiting.record.missed);
    let (points, is_complete) = fill(&mut m, config, counts.read, awaited, uses);
    let is_there = m.wire("is_there", waiting.valid & (!waiting.record.missed | is_complete));
    let advance = show(&mut m, config, gathered, waiting.record, [is_there, takes.expr()], points);
    m.drive(takes, is_there & advance);
    m.drive(waiting.ready, takes);
    m.next_if(counts.read, takes, counts.read.add_lit(1));
    m.assert(
        "nothing_is_forgotten_while_it_is_wanted",
        !forget | !(lookup.l_valid | lookup.k_valid | (lookup.head.valid | under_way.any())),
    );
    m
}
