//! Point cache (thesis 6.5.2, table 6.3): keeps the points of whole leaves in front of the memory; golden twin:
//! `pointcore_golden::search::point_cache`.
//!
//! A lookup `l` sends a leaf either to `run`, which reads it from its slot, or to the memory; `r` and `s` hold the beats on their
//! way out: it is late in its cycle that a block RAM shows what it has read, so that goes into a register, `s`, first. What `l`
//! has found of a tag stays, since no leaf is kept in such a slot; nor does one begin to come while `run` reads.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Beat, BeatPlace, Fetch, Points};
use pointcore_contract::search::units::point_cache::PORTS;
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::{record, width};

use super::parts::sets::{contains, decode, set};
use crate::stream::skid;
use crate::units::ports::{Flow, OutputPorts, StreamInPorts, StreamOutPorts, held};
use crate::units::twins::{next_twins, twins};
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Memory, Module, Reg, bit, cat, lit};

/// A request with its leaf's slot.
#[record(config: Config)]
struct SlottedFetch {
    /// The request.
    fetch: Fetch,
    /// The slot.
    #[bits(index_bits(config.point_cache))]
    slot: u8,
}

/// A beat with its slot, if it is a leaf's first.
#[record(config: Config)]
struct SlottedBeat {
    /// The beat.
    beat: Beat,
    /// The slot.
    #[bits(index_bits(config.point_cache))]
    slot: u8,
}

/// The slot of a leaf, by its first beat's address: all its bits have a say.
fn slot_of(config: &Config, address: Expr) -> Expr {
    let slot_bits = index_bits(config.point_cache);
    let pieces = (0..address.width()).step_by(slot_bits as usize).map(|low| {
        let high = address.width().min(low + slot_bits) - 1;
        address.bits(high, low).zext(slot_bits)
    });
    pieces.reduce(|folded, piece| folded ^ piece).expect("an address has bits")
}

/// Beats of a slot: those of the largest leaf, and then as many as make a power of two.
const fn slot_beats(config: &Config) -> u32 {
    config.bucket.div_ceil(config.lanes).next_power_of_two()
}

/// Whether a beat is its leaf's last one, where not every one is.
fn is_last(config: &Config, last: Expr) -> Expr {
    if slot_beats(config) == 1 { bit(true) } else { last }
}

/// Where a beat of a slot is in the memory of points.
fn word_of(config: &Config, slot: Expr, count: Expr) -> Expr {
    match slot_beats(config).ilog2() {
        0 => slot,
        bits => cat([slot, count.trunc(bits)]),
    }
}

/// Whether two words are the same, a bit for each eight of theirs: there is no time in the cycle to make it one.
fn same_parts(one: Expr, other: Expr) -> Expr {
    let width = one.width();
    let part = |low: u32| [one, other].map(|word| word.bits(width.min(low + 8) - 1, low));
    let parts: Vec<_> = (0..width).step_by(8).map(part).map(|[one, other]| one.eq(other)).collect();
    set(&parts)
}

/// Requests in a queue of two that holds their slots as well: a slot is there when the head is.
fn fetches(m: &mut Module, config: &Config) -> Flow<SlottedFetch<Wires>> {
    let ports = PORTS.fetch.declare(m, config);
    let slotted = ports.map(|fetch| SlottedFetch { fetch, slot: slot_of(config, fetch.address) });
    slotted.through(m, config, "fetch_queue", skid(&layout::<SlottedFetch>(config)))
}

/// As [`fetches`], the beats from memory.
fn fills(m: &mut Module, config: &Config) -> Flow<SlottedBeat<Wires>> {
    let ports = PORTS.fill.declare(m, config);
    let slotted = ports.map(|beat| SlottedBeat { beat, slot: slot_of(config, beat.place.address) });
    slotted.through(m, config, "fill_queue", skid(&layout::<SlottedBeat>(config)))
}

/// A leaf that is looked up or read.
struct Leaf {
    valid: Reg,
    request: SlottedFetch<Wires>,
}

impl Leaf {
    /// Takes a request where `enable` is set; `valid` is left to be set.
    fn new(m: &mut Module, config: &Config, name: &str, enable: Expr, request: SlottedFetch<Wires>) -> Self {
        let valid = m.reg_reset(&format!("{name}_valid"), 1, 0);
        Self { valid, request: request.register(m, config, &format!("{name}_"), enable) }
    }
}

/// A leaf on its way from the memory.
struct Fill {
    head: Flow<SlottedBeat<Wires>>,
    /// Some of its beats are taken, not the last.
    under_way: Reg,
    /// The inverse.
    between: Reg,
    slot: Expr,
    /// The head is the leaf's beat of this number.
    count: Reg,
    kept_before: Reg,
}

impl Fill {
    fn new(m: &mut Module, config: &Config) -> Self {
        let head = fills(m, config);
        let [under_way, between] = twins(m, ["fill_under_way", "fill_between"]);
        let slot_before = m.reg("fill_slot_before", index_bits(config.point_cache));
        let slot = m.wire("fill_slot", under_way.mux(slot_before, head.record.slot));
        m.next(slot_before, slot);
        let count = m.reg_reset("fill_count", config.beats_bits(), 0);
        Self { head, under_way, between, slot, count, kept_before: m.reg("fill_kept_before", 1) }
    }

    /// Writes the beats of a leaf that is kept, as they are taken, and its tag.
    fn store(&self, m: &mut Module, config: &Config, take: Expr, may_keep: Expr) -> Stored {
        let slots = config.point_cache;
        let Self { ref head, under_way, between, slot, count, kept_before } = *self;
        let Beat { place, points: item } = head.record.beat;
        let (last, address) = (is_last(config, place.last), place.address);
        m.drive(head.ready, take);
        let taken = m.wire("fill_taken", head.transfer());
        next_twins(m, "fill_under_way_or_between", [under_way, between], taken.mux(!last, under_way));
        m.next_if(count, taken, last.mux(lit(count.width(), 0), count.add_lit(1)));
        let kept = m.wire("fill_kept", under_way.mux(kept_before, may_keep));
        m.next_if(kept_before, taken, kept);

        let store = m.wire("store", taken & kept);
        // Written a cycle later, for what says whether is late: what is complete is read two cycles later, at the soonest.
        let points = m.memory_unordered("points", slots * slot_beats(config), width::<Points>(config));
        let stores = m.reg_reset("stores", 1, 0);
        m.next(stores, store);
        let stored = [("stored_at", word_of(config, slot, *count)), ("stored_points", item.pack(config))];
        let [at, item] = stored.map(|(name, value)| held(m, name, bit(true), value));
        m.write(points, stores, at, item);
        let begins = store & !under_way;
        let tags = m.memory_distributed("tags", slots, address.width());
        m.write(tags, begins, slot, address);
        // What happens to a slot is known late in a cycle, so it is told of in the next one.
        let [began, complete] = ["began", "complete"].map(|name| m.reg_reset(name, 1, 0));
        m.next(began, begins);
        m.next(complete, store & last);
        let changed = m.reg("changed_slot", slot.width());
        m.next(changed, slot);
        let present = m.reg_reset("present", slots, 0);
        let [begun, completed] = [began, complete].map(|happened| decode(happened, changed, slots));
        m.next(present, (present & !begun) | completed);
        Stored { points, tags, present, began, complete, changed }
    }
}

/// What is kept of leaves.
struct Stored {
    points: Memory,
    tags: Memory,
    /// The slots whose points are there, but for one that changed.
    present: Reg,
    /// A leaf began in a slot, or is complete: in the cycle before.
    began: Reg,
    complete: Reg,
    changed: Reg,
}

impl Stored {
    /// The points of a slot that is looked up are complete by now.
    fn completes(&self, slot: Expr) -> Expr {
        *self.complete & self.changed.eq(slot)
    }

    /// The points of a slot are there.
    fn is_present(&self, slot: Expr) -> Expr {
        let begins = *self.began & self.changed.eq(slot);
        (contains(*self.present, slot) & !begins) | self.completes(slot)
    }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("search_point_cache", "Keeps the points of leaves in front of the memory.");
    m.parameter("slots", config.point_cache);
    m.parameter("slot_beats", slot_beats(config));
    let fetch = fetches(&mut m, config);
    let miss = PORTS.miss.queue(&mut m, config);
    let beat = PORTS.beat.queue(&mut m, config);
    let fill = Fill::new(&mut m, config);

    // `advance_r` moves all of r; what comes to it hangs on other registers.
    let [advance_l, advance_r, flows, enter] =
        ["advance_l", "advance_r", "flows", "enter"].map(|name| m.forward(name, 1));
    m.drive(fetch.ready, advance_l);
    let l = Leaf::new(&mut m, config, "l", *advance_l, fetch.record);
    let run = Leaf::new(&mut m, config, "run", *enter, l.request);
    // Asked of the first beat of a leaf only.
    let (fetch_slot, fill_slot) = (fetch.record.slot, fill.head.record.slot);
    let in_lookup = l.valid & l.request.slot.eq(fill_slot);
    let in_head = fetch.valid & fetch_slot.eq(fill_slot);
    let may_keep = m.wire("may_keep", !(in_lookup | in_head));
    let runs = m.wire("runs", run.valid & fill.between);
    // As `!runs`, by registers of its own: a beat moves hundreds of flip-flops.
    let run_empty = m.reg_reset("run_empty", 1, 1);
    let comes = m.wire("comes", flows & (run_empty | fill.under_way));
    let stored = fill.store(&mut m, config, comes, may_keep);

    // A hit waits for the leaf that is read, a miss for the way to the memory. Whether a slot's points are there, and whether they are
    // those of the leaf, is found as its lookup begins; they may be complete later.
    let tag = m.read_now(stored.tags, "tag", fetch_slot);
    let is_its = held(&mut m, "l_same", *advance_l, same_parts(tag, fetch.record.fetch.address)).all();
    let is_present = m.reg("l_present", 1);
    let [found, completes] = [stored.is_present(fetch_slot), stored.completes(l.request.slot)];
    m.next(is_present, advance_l.mux(found, is_present | completes));
    let hit = m.wire("hit", is_present & is_its);
    let hits = m.wire("hits", l.valid & (hit & !run.valid));
    let misses = m.wire("misses", l.valid & (!hit & miss.room));
    m.drive(advance_l, !l.valid | (hits | misses));
    m.next_if(l.valid, advance_l, fetch.valid);
    m.drive(enter, hits);
    miss.push(&mut m, config, misses, l.request.fetch);

    // Beats of the leaf that is read, or of the one that comes.
    let run_count = m.reg_reset("run_count", config.beats_bits(), 0);
    let run_last = m.wire("run_last", is_last(config, run_count.add_lit(1).eq(run.request.fetch.beats)));
    let step = m.wire("run_step", flows & runs);
    m.next_if(run_count, step, run_last.mux(lit(run_count.width(), 0), run_count.add_lit(1)));
    next_twins(&mut m, "run_valid_or_empty", [run.valid, run_empty], hits | (run.valid & !(step & run_last)));
    // Never of a slot that is written: what is written need not be told from what is read.
    let read = m.read_if(stored.points, "read", step, word_of(config, run.request.slot, *run_count));

    let [r_valid, r_empty] = twins(&mut m, ["r_valid", "r_empty"]);
    let [s_valid, s_empty] = twins(&mut m, ["s_valid", "s_empty"]);
    let advance_s = m.wire("advance_s", !s_valid | beat.room);
    m.drive(advance_r, !r_valid | (s_empty | beat.room));
    m.drive(flows, r_empty | (s_empty | beat.room));
    let r_next = advance_r.mux(runs | fill.head.valid, r_valid);
    next_twins(&mut m, "r_valid_or_empty", [r_valid, r_empty], r_next);
    next_twins(&mut m, "s_valid_or_empty", [s_valid, s_empty], advance_s.mux(r_valid, s_valid));
    let r_read = m.reg("r_read", 1);
    m.next_if(r_read, advance_r, runs);
    let Fetch { thread, address: base, .. } = run.request.fetch;
    let running = BeatPlace { thread, address: base + run_count.resize(base.width()), last: run_last };
    let Beat { place, points: filling } = fill.head.record.beat;
    let next = Beat { place: BeatPlace::choose(config, runs, running, place), points: filling };
    let r = next.register(&mut m, config, "r_", advance_r);
    let points = Points::choose(config, r_read, Points::unpack(config, read), r.points);
    let s = Beat { place: r.place, points }.register(&mut m, config, "s_", advance_s);
    beat.push(&mut m, config, s_valid & advance_s, s);

    PORTS.events.event(&mut m, config, |events| events.hit, hits);
    PORTS.events.event(&mut m, config, |events| events.miss, misses);
    m.assert("what_is_read_is_there", !run.valid | stored.is_present(run.request.slot));
    m.assert("what_is_looked_up_is_known", !(l.valid & is_present) | stored.is_present(l.request.slot));
    m
}
