//! Priority queues (thesis 6.5.2, 6.6.2): a sorted row of neighbors for each thread, an insertion a cycle; golden twin:
//! `pointcore_golden::search::queue`.
//!
//! The row of the thread whose points came last, its owner, is in a register; the others are in a memory. Four stages: of the
//! beat that comes next, `a`, the lanes that may be near are found, of which `b` chooses a candidate, whose place in its row is
//! found in `c`, and which is moved there in `d`. What moves a stage's hundreds of flip-flops is known early in the cycle:
//! beats wait in a memory, for whether one is taken is known late.

mod readout;
mod row;

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;

use super::parts::head_queue::HeadQueue;
use super::parts::radii::{Writer, radii_now};
use super::parts::sets::{contains, decode, index_of, lowest, set, several};
use crate::units::records::{Pulse, Record, event_out, pulse_in, queue_in, registered_pulse_out, stream_in, width};
use readout::{Readout, Rows, Whose};
use row::{entries, entry_fields, initial, insert, row, row_bits, sentinels};
use rtl::{Expr, Module, Reg, bit, cat};

/// Beats that wait.
const BEATS: u32 = 2;

/// The beat that chooses its candidates.
struct Beat {
    valid: Reg,
    /// Its thread's row has to be read from memory.
    reads: Reg,
    /// Lanes that are to be chosen.
    pending: Reg,
    record: Record,
}

/// What becomes of the beat in this cycle.
struct Choice {
    /// The pending lanes but for the one chosen.
    rest: Expr,
    any: Expr,
    stays: Expr,
    neighbor: Record,
}

fn lane_distance(beat: &Record, lane: u32) -> Expr {
    beat.get(&format!("distance{lane}"))
}

/// The lanes of a beat that are nearer than each of the limits that counts.
fn near_lanes(config: &Config, beat: &Record, limits: &[(Expr, Expr)]) -> Expr {
    let is_near = |distance: Expr| {
        let within = limits.iter().map(|(counts, limit)| !*counts | distance.lt(*limit));
        within.fold(bit(true), |all, one| all & one)
    };
    let near: Vec<_> = (0..config.lanes).map(|lane| is_near(lane_distance(beat, lane))).collect();
    set(&near)
}

impl Choice {
    /// Chooses among the pending lanes.
    fn new(m: &mut Module, config: &Config, beat: &Beat) -> Self {
        let chosen = m.wire("chosen", lowest(beat.pending));
        let rest = m.wire("rest", beat.pending & !chosen);
        let nearest_lane =
            (1..config.lanes).rev().fold(lane_distance(&beat.record, config.lanes - 1), |other, lane| {
                chosen.bit(lane - 1).mux(lane_distance(&beat.record, lane - 1), other)
            });
        let address = beat.record.get("address");
        let index = match config.lanes.ilog2() {
            0 => address,
            bits => cat([address, index_of(chosen, bits)]),
        };
        let neighbor = Record::new(&entry_fields(config), |name| match name {
            "found" => bit(true),
            "index" => index,
            _ => nearest_lane,
        });
        let stays = m.wire("stays", beat.valid & several(beat.pending));
        Self { any: beat.pending.any(), rest, stays, neighbor }
    }
}

/// A candidate, or none of a beat, on its way to its thread's row.
struct Item {
    valid: Reg,
    /// Its row is being read from memory.
    reads: Reg,
    /// That row holds nothing of its search yet.
    fresh: Reg,
    inserts: Reg,
    last: Reg,
    thread: Reg,
}

impl Item {
    fn new(m: &mut Module, config: &Config) -> Self {
        let mut flag = |name: &str| m.reg_reset(&format!("item_{name}"), 1, 0);
        let [valid, reads, inserts, last] = ["valid", "reads", "inserts", "last"].map(&mut flag);
        let thread = m.reg("item_thread", config.thread_bits());
        Self { valid, reads, fresh: m.reg("item_fresh", 1), inserts, last, thread }
    }
}

/// A candidate at the working row.
struct Insertion {
    /// The entries that it is nearer than: none where it is not to be inserted.
    nearer: Reg,
    fields: Vec<Reg>,
    neighbor: Record,
    last: Reg,
    thread: Reg,
}

impl Insertion {
    fn new(m: &mut Module, config: &Config) -> Self {
        let names = entry_fields(config);
        let fields: Vec<_> = names.iter().map(|(name, width)| m.reg(&format!("new_{name}"), *width)).collect();
        let mut values = fields.iter();
        let neighbor = Record::new(&names, |_| values.next().expect("a register for every field").expr());
        Self {
            nearer: m.reg_reset("nearer", config.neighbors, 0),
            fields,
            neighbor,
            last: m.reg_reset("new_last", 1, 0),
            thread: m.reg("new_thread", config.thread_bits()),
        }
    }

    /// Takes an item's candidate, which is `nearer` than some entries.
    fn take(&self, m: &mut Module, config: &Config, item: &Item, nearer: Expr, candidate: &Record) {
        m.next(self.nearer, nearer & item.inserts.repeat(self.nearer.width()));
        for ((name, _), register) in entry_fields(config).iter().zip(&self.fields) {
            m.next(*register, candidate.get(name));
        }
        m.next(self.last, item.last);
        m.next(self.thread, item.thread);
    }
}

/// What is kept of a thread's query, in the order of the word that holds it: what `start` says, and what follows for its row.
fn query_fields(config: &Config) -> Vec<Field> {
    let kept = |(name, _): &Field| ["number", "k", "radius2"].contains(&name.as_str());
    let sentinels = ("sentinels".to_owned(), config.neighbors);
    records::start(config).into_iter().filter(kept).chain([sentinels]).collect()
}

/// A memory of the queries: written at their start, read as the rows are.
fn queries(m: &mut Module, config: &Config, start: &Pulse, thread: Expr) -> Record {
    let fields = query_fields(config);
    let memory = m.memory("queries", 1 << config.thread_bits(), width(&fields));
    let query = Record::new(&fields, |name| match name {
        "sentinels" => sentinels(config, start.record.get("k")),
        field => start.record.get(field),
    });
    m.write(memory, start.valid, start.record.get("thread"), query.pack());
    let word = m.read(memory, "query", thread);
    Record::unpack(&fields, word)
}

/// A beat on its way, with the squared radius of its thread's last leaf as it came in.
fn arrival_fields(config: &Config) -> Vec<Field> {
    let mut fields = records::candidates(config);
    fields.push(("limit".to_owned(), config.geometry.width()));
    fields
}

/// The unit; ports as in `contract::search::ports::queue`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let (threads, thread_bits) = (config.threads, config.thread_bits());
    let lanes = config.lanes;
    let mut m = Module::new("search_queue", "A sorted row of neighbors for each thread.");
    m.parameter("threads", threads);
    m.parameter("neighbors", config.neighbors);
    m.parameter("lanes", lanes);
    let start = pulse_in(&mut m, "start", &records::start(config));
    let candidates = stream_in(&mut m, "candidates", &records::candidates(config));
    let finish = queue_in(&mut m, "finish", &records::thread_only(config));
    let arrivals = HeadQueue::new(&mut m, "arrivals", BEATS, &arrival_fields(config));
    m.ready(&candidates, arrivals.room);
    let head_thread = arrivals.head.get("thread");

    let owned = m.reg_reset("owned", 1, 0);
    let owner = m.reg("owner", thread_bits);
    let working = m.reg("working", row_bits(config));
    let fresh = m.reg_reset("fresh", threads, 0);
    let free = m.forward("beat_free", 1);
    let beat = Beat {
        valid: m.reg_reset("beat_valid", 1, 0),
        reads: m.reg_reset("beat_reads", 1, 0),
        pending: m.reg("beat_pending", lanes),
        record: arrivals.head.only(&records::candidates(config)).register(&mut m, "beat_", free),
    };
    let thread = beat.record.get("thread");
    let item = Item::new(&mut m, config);
    let write_back = m.wire("write_back", item.reads & owned);

    // d: the neighbor is moved to its place in the working row.
    let insertion = Insertion::new(&mut m, config);
    let working_entries = entries(config, *working);
    let inserted = insert(&working_entries, *insertion.nearer, &insertion.neighbor, |here, a, b| a.mux(here, b));
    let inserted_row = m.wire("inserted_row", row(&inserted));
    let radius = Record::new(&records::radius(config), |name| match name {
        "thread" => insertion.thread.expr(),
        _ => inserted[inserted.len() - 1].get("distance2"),
    });
    let radius = registered_pulse_out(&mut m, "radius", insertion.last, &radius);
    event_out(&mut m, "event_insert", insertion.nearer.msb());

    // e: the farthest neighbor of the row that was the working row a cycle ago and still is.
    let farthest = m.reg("farthest", config.geometry.width());
    let farthest_thread = m.reg("farthest_thread", thread_bits);
    let farthest_valid = m.reg_reset("farthest_valid", 1, 0);
    m.next(farthest, inserted[inserted.len() - 1].get("distance2"));
    m.next(farthest_thread, owner);
    m.next(farthest_valid, owned & !item.reads);
    let is_current = m.wire("farthest_is_current", farthest_valid & !(beat.reads | item.reads));

    // Rows and queries are read for a beat that moves on or for a readout that may start, never for both.
    let whose = Whose { fresh: *fresh, owned: *owned, owner: *owner, displaced: *item.reads };
    let readout = Readout::new(&mut m, config, &finish, &whose);
    let waits = m.wire("waits", beat.reads & readout.reads);
    let moves = m.wire("moves", beat.valid & !waits);
    let reads = m.wire("reads", moves & beat.reads);
    let read_thread = m.wire("read_thread", readout.reads.mux(finish.field("thread"), thread));
    let rows = m.memory("rows", 1 << thread_bits, row_bits(config));
    m.write(rows, write_back, owner, inserted_row);
    let stored = m.read(rows, "stored", read_thread);
    let query = queries(&mut m, config, &start, read_thread);
    let initial = m.wire("initial_row", initial(config, query.get("sentinels"), query.get("radius2")));

    // b: the lowest pending lane goes on; whether others are nearer than what is farthest by now shows in the next cycle.
    let choice = Choice::new(&mut m, config, &beat);
    let is_known = m.wire("farthest_is_known", is_current & farthest_thread.eq(thread));
    let near = near_lanes(config, &beat.record, &[(is_known, *farthest)]);
    let left = m.wire("left", waits.mux(beat.pending, choice.rest & near));
    let done = m.wire("done", moves & !choice.stays);
    m.next(item.valid, moves);
    m.next(item.reads, reads);
    m.next(item.inserts, moves & choice.any);
    m.next(item.last, done & beat.record.get("last"));
    m.next(item.fresh, contains(fresh, thread));
    m.next(item.thread, thread);
    let candidate = choice.neighbor.register(&mut m, "item_", bit(true));
    let started = decode(start.valid, start.record.get("thread"), threads);
    m.next(fresh, (fresh & !decode(reads, thread, threads)) | started);

    // a: a row that the beat at work will drive out is not in memory when the next beat's is read.
    let tail = m.wire("tail", item.valid.mux(item.thread, owner));
    let follows_tail = m.wire("follows_tail", (item.valid | owned) & tail.eq(head_thread));
    let follows_beat = m.wire("follows_beat", thread.eq(head_thread));
    let driven_out = beat.valid & (follows_tail & !follows_beat);
    m.drive(free, !beat.valid | (moves & !choice.stays));
    let take = m.wire("take", arrivals.holds & (free & !driven_out));
    m.next(beat.valid, take | (choice.stays | waits));
    let is_fresh = m.wire("is_fresh", contains(fresh, head_thread));
    let take_reads = beat.valid.mux(!follows_beat, !follows_tail | is_fresh);
    m.next(beat.reads, take.mux(take_reads, beat.reads & waits));
    // Pending are the lanes nearer than the radius of the thread's last leaf and than what is farthest now.
    let writers = [&start, &radius].map(|writer| {
        let (thread, radius2) = (writer.record.get("thread"), writer.record.get("radius2"));
        Writer { valid: writer.valid, thread, radius2 }
    });
    let limit = radii_now(&mut m, config, writers, candidates.field("thread"));
    let arriving = Record::from(&candidates);
    let arriving =
        Record::new(&arrival_fields(config), |name| if name == "limit" { limit } else { arriving.get(name) });
    arrivals.update(&mut m, candidates.transfer(), &arriving, take);
    let limit = arrivals.head.get("limit");
    let will_be_known = is_current & (farthest_thread.eq(head_thread) & !take_reads);
    let will_be_known = m.wire("farthest_will_be_known", will_be_known);
    let near = near_lanes(config, &arrivals.head, &[(bit(true), limit), (will_be_known, *farthest)]);
    m.next(beat.pending, take.mux(near, left));

    // c: which entries the candidate is nearer than, in the row as it will be; in an initial row, the placeholders. Both rows are
    // compared: to choose one of them first would take as much and come before the comparison.
    let is_nearer = |entry: &Record| candidate.get("distance2").lt(entry.get("distance2"));
    let [nearer, nearer_stored] =
        [&working.expr(), &stored].map(|row| entries(config, *row).iter().map(is_nearer).collect::<Vec<_>>());
    let nearer_now = insert(&nearer, *insertion.nearer, &is_nearer(&insertion.neighbor), |here, a, b| here.mux(*a, *b));
    let nearer_now = set(&nearer_now);
    let nearer_read = item.fresh.mux(!query.get("sentinels"), set(&nearer_stored));
    let nearer = m.wire("nearer_entries", item.reads.mux(nearer_read, nearer_now));
    insertion.take(&mut m, config, &item, nearer, &candidate);
    let read_row = item.fresh.mux(initial, stored);
    m.next(working, item.reads.mux(read_row, inserted_row));
    m.next_if(owner, item.valid, item.thread);
    m.next(owned, owned | item.valid);

    readout.send(&mut m, config, &Rows { initial, working: *working, stored }, &query);
    event_out(&mut m, "event_beat", done);
    event_out(&mut m, "event_insert_wait", moves & choice.stays);
    m
}
