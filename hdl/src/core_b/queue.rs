//! Priority queues (thesis 6.5.2, 6.6.2): a sorted row of neighbors for each thread, an insertion a cycle; golden twin:
//! `pointcore_golden::core_b::queue`.
//!
//! The row of the thread whose points came last, its owner, is in a register; the others are in a memory.

use pointcore_spec::core_a::Field;
use pointcore_spec::core_b::{Config, records};

use super::queue_readout::{Readout, Rows};
use super::queue_row::{entries, entry_fields, initial, insert, row_bits};
use super::sets::{contains, decode, index_of, lowest, set};
use crate::rtl::{Expr, Module, Reg, bit, cat, lit};
use crate::units::records::{Pulse, Record, event_out, pulse_in, queue_in, registered_pulse_out, width};

/// The beat of candidates at work.
struct Beat {
    valid: Reg,
    /// Nothing of it has been looked at.
    first: Reg,
    /// Lanes that may still be inserted.
    pending: Reg,
    record: Record,
}

impl Beat {
    fn lane_distance(&self, lane: u32) -> Expr {
        self.record.get(&format!("distance{lane}"))
    }
}

/// What becomes of the beat in this cycle.
struct Choice {
    /// The lanes that are nearer than the farthest neighbor, but for the one inserted.
    rest: Expr,
    inserts: Expr,
    stays: Expr,
    neighbor: Record,
}

impl Choice {
    fn new(m: &mut Module, config: &Config, beat: &Beat, farthest: &Expr) -> Self {
        let nearer: Vec<_> = (0..config.lanes).map(|lane| beat.lane_distance(lane).lt(farthest)).collect();
        let candidates = m.wire("nearer", &(&beat.pending & set(&nearer)));
        let chosen = m.wire("chosen", &lowest(&candidates));
        let rest = m.wire("rest", &(&candidates & !&chosen));
        let nearest_lane = (1..config.lanes).rev().fold(beat.lane_distance(config.lanes - 1), |other, lane| {
            chosen.bit(lane as usize - 1).mux(&beat.lane_distance(lane - 1), &other)
        });
        let address = beat.record.get("address");
        let index = match config.lanes.ilog2() as usize {
            0 => address,
            bits => cat(&[&address, &index_of(&chosen, bits)]),
        };
        let neighbor = Record::new(&entry_fields(config), |name| match name {
            "found" => bit(true),
            "index" => index.clone(),
            _ => nearest_lane.clone(),
        });
        let inserts = m.wire("inserts", &(&beat.valid & candidates.any()));
        let stays = m.wire("stays", &(&beat.valid & rest.any()));
        Self { rest, inserts, stays, neighbor }
    }
}

/// What `start` says of a thread's query, in the order of the word that holds it.
fn query_fields(config: &Config) -> Vec<Field> {
    let kept = |(name, _): &Field| ["number", "k", "radius2"].contains(&name.as_str());
    records::start(config).into_iter().filter(kept).collect()
}

/// A memory of the queries: written at their start, read as the rows are.
fn queries(m: &mut Module, config: &Config, start: &Pulse, thread: &Expr) -> Record {
    let fields = query_fields(config);
    let memory = m.memory("queries", 1 << config.thread_bits(), width(&fields));
    m.write(&memory, &start.valid, &start.record.get("thread"), &start.record.only(&fields).pack());
    let word = m.read(&memory, "query", thread);
    Record::unpack(&fields, &word)
}

/// The unit; ports as in `spec::core_b::ports::queue`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let (threads, thread_bits) = (config.threads as usize, config.thread_bits() as usize);
    let lanes = config.lanes as usize;
    let mut m = Module::new("core_b_queue", "A sorted row of neighbors for each thread.");
    m.parameter("threads", threads);
    m.parameter("neighbors", config.neighbors);
    m.parameter("lanes", lanes);
    let start = pulse_in(&mut m, "start", &records::start(config));
    let head = queue_in(&mut m, "candidates", &records::candidates(config));
    let finish = queue_in(&mut m, "finish", &records::thread_only(config));
    let head_thread = head.field("thread");

    let owned = m.reg_reset("owned", 1, 0);
    let owner = m.reg("owner", thread_bits);
    let working = m.reg("working", row_bits(config));
    let fresh = m.reg_reset("fresh", threads, 0);
    let take = m.forward("take", 1);
    let beat = Beat {
        valid: m.reg_reset("beat_valid", 1, 0),
        first: m.reg("beat_first", 1),
        pending: m.reg("beat_pending", lanes),
        record: Record::from(&head).register(&mut m, "beat_", &take),
    };
    let thread = beat.record.get("thread");
    let begins = m.wire("begins", &(&beat.valid & &beat.first));
    let owns = m.wire("owns", &(&owned & owner.eq(&thread)));
    let write_back = m.wire("write_back", &(&begins & (&owned & !&owns)));

    // Rows and queries are read for a beat that is taken or for a readout that starts, never for both.
    let readout = Readout::new(&mut m, config, &finish, &(&write_back & owner.eq(&finish.field("thread"))));
    let read_thread = m.wire("read_thread", &readout.starts.mux(&finish.field("thread"), &head_thread));
    let rows = m.memory("rows", 1 << thread_bits, row_bits(config));
    m.write(&rows, &write_back, &owner, &working);
    let stored = m.read(&rows, "stored", &read_thread);
    let query = queries(&mut m, config, &start, &read_thread);
    let initial = m.wire("initial_row", &initial(config, &query.get("k"), &query.get("radius2")));

    let is_fresh = m.wire("is_fresh", &(&beat.first & contains(&fresh, &thread)));
    let keeps = !&beat.first | owns;
    let base = m.wire("base", &is_fresh.mux(&initial, &keeps.mux(&working, &stored)));
    let neighbors = entries(config, &base);
    let farthest = neighbors[neighbors.len() - 1].get("distance2");
    let choice = Choice::new(&mut m, config, &beat, &farthest);
    let inserted = insert(&neighbors, &choice.neighbor);
    let row = m.wire("row", &choice.inserts.mux(&inserted, &base));
    m.next_if(&working, &beat.valid, &row);
    m.next_if(&owner, &beat.valid, &thread);
    m.next(&owned, &(&owned | &beat.valid));
    let started = decode(&start.valid, &start.record.get("thread"), threads);
    m.next(&fresh, &((&fresh & !decode(&begins, &thread, threads)) | started));

    let done = m.wire("done", &(&beat.valid & !&choice.stays));
    let away = &write_back & owner.eq(&head_thread);
    let takes = (!&choice.stays & &head.valid) & !(&readout.starts | away);
    m.drive(&take, &takes);
    m.ready(&head, &take);
    m.next(&beat.valid, &(&take | &choice.stays));
    m.next(&beat.first, &take);
    m.next(&beat.pending, &take.mux(&!lit(lanes, 0), &choice.rest));

    let row_entries = entries(config, &row);
    let radius = Record::new(&records::radius(config), |name| match name {
        "thread" => thread.clone(),
        _ => row_entries[row_entries.len() - 1].get("distance2"),
    });
    registered_pulse_out(&mut m, "radius", &(&done & beat.record.get("last")), &radius);
    let owner_row =
        Rows { fresh: &fresh, initial: &initial, owned: &owned, owner: &owner, working: &working, stored: &stored };
    readout.send(&mut m, config, &owner_row, &query);
    event_out(&mut m, "event_beat", &done);
    event_out(&mut m, "event_insert", &choice.inserts);
    event_out(&mut m, "event_insert_wait", &choice.stays);
    m
}
