//! Point cache (thesis 6.5.2, table 6.3): keeps the points of whole leaves in front of the memory; golden twin:
//! `pointcore_golden::search::point_cache`.
//!
//! A lookup `l` sends a leaf either to `run`, which reads it from its slot, or to the memory; `r` holds the beat on its way
//! out. What `l` has read of a tag stays, since no leaf is kept in such a slot; nor does one begin to come while `run` reads.

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;
use pointcore_contract::splat::config::index_bits;

use super::parts::sets::{contains, decode};
use crate::stream::skid;
use crate::units::records::{Record, event_out, layout, queue_out, stream_in, width};
use rtl::{Expr, Memory, Module, Reg, Stream, cat, lit};

/// The field beside a record's own that holds its slot.
const SLOT: &str = "slot";

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

/// Where a beat of a slot is in the memory of points.
fn place(config: &Config, slot: Expr, count: Expr) -> Expr {
    match slot_beats(config).ilog2() {
        0 => slot,
        bits => cat([slot, count.trunc(bits)]),
    }
}

/// The fields of a beat that are points.
fn point_fields(config: &Config) -> Vec<Field> {
    let is_place = |(name, _): &Field| ["thread", "address", "last"].contains(&name.as_str());
    records::beat(config).into_iter().filter(|field| !is_place(field)).collect()
}

/// A stream of records with the address of a leaf's beat, in a queue of two that holds that beat's slot as well: it is there
/// when the head is.
fn queue_with_slot(m: &mut Module, config: &Config, name: &str, record: &[Field]) -> Stream {
    let ports = stream_in(m, name, record);
    let fields = with_slot(config, record);
    let queue = m.instance(&format!("{name}_queue"), skid(&layout(&fields)));
    m.connect(queue, "in_valid", ports.valid);
    let room = m.out(queue, "in_ready");
    m.ready(&ports, room);
    let slot = slot_of(config, ports.field("address"));
    let item = Record::new(&fields, |name| if name == SLOT { slot } else { ports.field(name) });
    item.connect(m, queue, "in_");
    m.stream_from(queue, "out")
}

/// A record's fields and its slot.
fn with_slot(config: &Config, record: &[Field]) -> Vec<Field> {
    [record, &[(SLOT.to_owned(), index_bits(config.point_cache))]].concat()
}

/// A leaf that is looked up or read.
struct Leaf {
    valid: Reg,
    request: Record,
    slot: Expr,
}

impl Leaf {
    /// Takes a request where `enable` is set; `valid` is left to be driven.
    fn new(m: &mut Module, name: &str, enable: Expr, request: &Record) -> Self {
        let valid = m.reg_reset(&format!("{name}_valid"), 1, 0);
        let request = request.register(m, &format!("{name}_"), enable);
        Self { valid, slot: request.get(SLOT), request }
    }
}

/// A leaf on its way from the memory.
struct Fill {
    head: Stream,
    /// Some of its beats are taken, not the last.
    under_way: Reg,
    slot: Expr,
    /// The head is the leaf's beat of this number.
    count: Reg,
    kept_before: Reg,
}

impl Fill {
    fn new(m: &mut Module, config: &Config) -> Self {
        let head = queue_with_slot(m, config, "fill", &records::beat(config));
        let under_way = m.reg_reset("fill_under_way", 1, 0);
        let slot_before = m.reg("fill_slot_before", index_bits(config.point_cache));
        let slot = m.wire("fill_slot", under_way.mux(slot_before, head.field(SLOT)));
        m.next(slot_before, slot);
        let count = m.reg_reset("fill_count", config.beats_bits(), 0);
        Self { head, under_way, slot, count, kept_before: m.reg("fill_kept_before", 1) }
    }

    /// Writes the beats of a leaf that is kept, as they are taken, and its tag; returns the memories and the set of slots
    /// whose points are there.
    fn store(&self, m: &mut Module, config: &Config, take: Expr, may_keep: Expr) -> (Memory, Memory, Reg) {
        let slots = config.point_cache;
        let Self { ref head, under_way, slot, count, kept_before } = *self;
        let (last, address) = (head.field("last"), head.field("address"));
        m.ready(head, take);
        let taken = m.wire("fill_taken", head.transfer());
        m.next_if(under_way, taken, !last);
        m.next_if(count, taken, last.mux(lit(count.width(), 0), count.add_lit(1)));
        let kept = m.wire("fill_kept", under_way.mux(kept_before, may_keep));
        m.next_if(kept_before, taken, kept);

        let store = m.wire("store", taken & kept);
        let fields = point_fields(config);
        let points = m.memory_unordered("points", slots * slot_beats(config), width(&fields));
        m.write(points, store, place(config, slot, *count), Record::from(head).only(&fields).pack());
        let begins = store & !under_way;
        let tags = m.memory("tags", slots, address.width());
        m.write(tags, begins, slot, address);
        let present = m.reg_reset("present", slots, 0);
        let complete = decode(store & last, slot, slots);
        m.next(present, (present & !decode(begins, slot, slots)) | complete);
        (points, tags, present)
    }
}

/// The unit; ports as in `contract::search::ports::point_cache`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let point_fields = point_fields(config);
    let mut m = Module::new("search_point_cache", "Keeps the points of leaves in front of the memory.");
    m.parameter("slots", config.point_cache);
    m.parameter("slot_beats", slot_beats(config));
    let fetch = queue_with_slot(&mut m, config, "fetch", &records::fetch(config));
    let miss = queue_out(&mut m, "miss", &records::fetch(config));
    let beat = queue_out(&mut m, "beat", &records::beat(config));
    let fill = Fill::new(&mut m, config);

    let [advance_l, advance_r, enter] = ["advance_l", "advance_r", "enter"].map(|name| m.forward(name, 1));
    m.ready(&fetch, advance_l);
    let l = Leaf::new(&mut m, "l", *advance_l, &Record::from(&fetch));
    let run = Leaf::new(&mut m, "run", *enter, &l.request);
    // Asked of the first beat of a leaf only.
    let (fetch_slot, fill_slot) = (fetch.field(SLOT), fill.head.field(SLOT));
    let in_lookup = l.valid & l.slot.eq(fill_slot);
    let in_head = fetch.valid & fetch_slot.eq(fill_slot);
    let may_keep = m.wire("may_keep", !(in_lookup | in_head));
    let runs = m.wire("runs", run.valid & !fill.under_way);
    let (points, tags, present) = fill.store(&mut m, config, advance_r & !runs, may_keep);

    // A hit waits for the leaf that is read, a miss for the way to the memory.
    let tag = m.read_if(tags, "tag", advance_l, fetch_slot);
    let hit = m.wire("hit", contains(present, l.slot) & tag.eq(l.request.get("address")));
    let hits = m.wire("hits", l.valid & (hit & !run.valid));
    let misses = m.wire("misses", l.valid & (!hit & miss.room));
    m.drive(advance_l, !l.valid | (hits | misses));
    m.next_if(l.valid, advance_l, fetch.valid);
    m.drive(enter, hits);
    miss.push(&mut m, misses, |name| l.request.get(name));

    // Beats of the leaf that is read, or of the one that comes.
    let run_count = m.reg_reset("run_count", config.beats_bits(), 0);
    let run_last = m.wire("run_last", run_count.add_lit(1).eq(run.request.get("beats")));
    let step = m.wire("run_step", advance_r & runs);
    m.next_if(run_count, step, run_last.mux(lit(run_count.width(), 0), run_count.add_lit(1)));
    m.next(run.valid, hits | (run.valid & !(step & run_last)));
    // Never in a cycle in which one is stored: what is written need not be told from what is read.
    let read = m.read_if(points, "read", step, place(config, run.slot, *run_count));

    let r_valid = m.reg_reset("r_valid", 1, 0);
    m.drive(advance_r, !r_valid | beat.room);
    m.next_if(r_valid, advance_r, runs | fill.head.valid);
    let r_read = m.reg("r_read", 1);
    m.next_if(r_read, advance_r, runs);
    let next = Record::new(&records::beat(config), |name| match name {
        "thread" => runs.mux(run.request.get("thread"), fill.head.field("thread")),
        "address" => {
            let base = run.request.get("address");
            runs.mux(base + run_count.resize(base.width()), fill.head.field("address"))
        }
        "last" => runs.mux(run_last, fill.head.field("last")),
        field => fill.head.field(field),
    });
    let r = next.register(&mut m, "r_", advance_r);
    let read = Record::unpack(&point_fields, read);
    let r_points = read.mux(*r_read, &r.only(&point_fields));
    let is_point = |name: &str| point_fields.iter().any(|(point, _)| point == name);
    beat.push(&mut m, r_valid & advance_r, |name| if is_point(name) { r_points.get(name) } else { r.get(name) });

    event_out(&mut m, "event_point_hit", hits);
    event_out(&mut m, "event_point_miss", misses);
    m.assert("what_is_read_is_there", !run.valid | contains(present, run.slot));
    m
}
