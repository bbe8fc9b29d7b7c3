//! Priority queues (thesis 6.5.2, 6.6.2): a sorted row of neighbors for each thread, an insertion a cycle; golden twin:
//! `pointcore_golden::search::queue`.
//!
//! The row of the thread whose points came last, its owner, is in a register; the others are in a memory. Four stages: of the
//! beat that comes next, `a`, the lanes that may be near are found, of which `b` chooses a candidate, whose place in its row is
//! found in `c`, and which is moved there in `d`. What moves a stage's hundreds of flip-flops is known early in the cycle:
//! beats wait in the place where they came in, for whether one is taken is known late.

mod arrivals;
mod readout;
mod row;
mod tokens;

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Radius, Start, Thread};
use pointcore_contract::search::units::queue::PORTS;
use pointcore_contract::{record, width};

use super::parts::neighbor::without_sign;
use super::parts::radii::radii_now;
use super::parts::sets::{contains, decode, set};
use crate::units::ports::{OutputPorts, Pulse, PulseInPorts, PulseOutPorts, StreamInPorts};
use crate::units::wires::{Bundle, Wires};
use arrivals::{Arrival, Arrivals, Caller};
use readout::{Readout, Rows, Whose};
use row::{Entry, entries, initial, insert, placeholders, row, row_bits, sentinels};
use rtl::{Expr, Module, Reg, Wire, bit, lit};
use tokens::{Beat, Candidate, Choice, Insertion, Item, near_lanes};

/// What is kept of a thread's query: what `start` says, and what follows for its row.
#[record(config: Config)]
struct KeptQuery {
    /// Its number.
    #[bits(config.index_bits)]
    number: u32,
    /// Neighbors wanted.
    #[bits(config.rank_bits())]
    k: u8,
    /// Squared radius within which neighbors count.
    #[bits(config.square_bits())]
    radius2: u32,
    /// The entries that stay empty in its row, a bit each but for the last.
    #[when(config.neighbors > 1)]
    #[bits(config.neighbors - 1)]
    sentinels: u64,
}

/// A memory of the queries: written at their start, read as the rows are.
fn queries(m: &mut Module, config: &Config, start: &Pulse<Start<Wires>>, thread: Expr) -> KeptQuery<Wires> {
    let memory = m.memory("queries", 1 << config.thread_bits(), width::<KeptQuery>(config));
    let Start { thread: starting, query } = start.record;
    let sentinels = sentinels(config, query.k);
    let kept = KeptQuery { number: query.number, k: query.k, radius2: without_sign(query.radius2), sentinels };
    m.write(memory, start.valid, starting.thread, kept.pack(config));
    let word = m.read(memory, "query", thread);
    KeptQuery::unpack(config, word)
}

/// Whose the working row is.
struct Owner {
    owned: Reg,
    owner: Reg,
    /// Its inverse, for who asks whose row it is: `owner` says where the row is written.
    not_owner: Reg,
}

/// The working row.
struct Working {
    /// Of one thread alone nobody asks.
    owner: Option<Owner>,
    row: Reg,
    /// The threads whose rows hold nothing of their searches yet.
    fresh: Reg,
}

impl Working {
    fn new(m: &mut Module, config: &Config) -> Self {
        let owner = |m: &mut Module| Owner {
            owned: m.reg_reset("owned", 1, 0),
            owner: m.reg("owner", config.thread_bits()),
            not_owner: m.reg("not_owner", config.thread_bits()),
        };
        Self {
            owner: (config.threads > 1).then(|| owner(m)),
            row: m.reg("working", row_bits(config)),
            // Not reset: a thread's first query sets it.
            fresh: m.reg("fresh", config.threads),
        }
    }
}

/// The working row after the insertion at work.
struct Inserted {
    row: Expr,
    /// The distance of its last neighbor.
    farthest: Expr,
    /// What the other units are told.
    radius: Pulse<Radius<Wires>>,
}

/// The farthest neighbor of the row that was the working row a cycle ago. What is not nearer is no candidate, which saves cycles where
/// a beat has several lanes; of one it is compared with the row anyway.
struct Farthest {
    distance: Reg,
    /// It still is the working row, and the row of the beat.
    is_current: Expr,
}

/// What is read from the memories in this cycle, and then shown.
struct Fetch {
    /// The beat waits, since a readout reads.
    waits: Expr,
    moves: Expr,
    reads: Expr,
    /// A thread's row, where there are several threads: that of one alone is nowhere but at work. Its query, and the row of a
    /// query that has met no point.
    stored: Option<Expr>,
    query: KeptQuery<Wires>,
    initial: Expr,
}

/// What the stages refer to.
struct Stages<'a> {
    config: &'a Config,
    arrivals: Arrivals,
    working: Working,
    beat: Beat,
    item: Item,
    insertion: Insertion,
}

impl Stages<'_> {
    /// The thread of the beat at work.
    fn thread(&self) -> Expr {
        self.beat.record.place.thread.thread
    }

    /// a: the next beat. A row that the beat at work will drive out is not in memory when the next beat's is read. Returns
    /// whether the beat is taken, and whether its row is to be read then.
    fn arrive(&self, m: &mut Module, free: Wire, fetch: &Fetch, choice: &Choice) -> (Expr, Expr) {
        let Self { arrivals: Arrivals { callers, .. }, beat, item, working, .. } = self;
        let Caller { thread: Thread { thread: head_thread }, follows, follows_second } = callers.head;
        let follows = if working.owner.is_some() { follows } else { bit(true) };
        let driven_out = working.owner.is_some().then(|| beat.valid & ((follows_second & !follows) & !beat.began));
        let driven_out = m.wire("driven_out", driven_out.unwrap_or(bit(false)));
        m.drive(free, !beat.valid | choice.ends);
        let take = m.wire("take", callers.holds & (free & !driven_out));
        m.next(beat.valid, take | (choice.stays | fetch.waits));
        // One that follows another is of the thread of what is behind that, which is known at the start of the cycle.
        let not_owner = working.owner.as_ref().map(|owner| !owner.not_owner);
        let tail = not_owner.map_or(head_thread, |owner| m.wire("tail", item.valid.mux(item.thread, owner)));
        let take_reads = !follows | (!beat.valid & contains(working.fresh, tail));
        m.next(beat.reads, take.mux(take_reads, beat.reads & fetch.waits));
        m.next(beat.began, !take & (beat.began | fetch.moves));
        if let Some(Owner { owned, .. }) = working.owner {
            let follows_tail = (item.valid | owned) & tail.eq(head_thread);
            let told = beat.valid.mux(follows.eq(self.thread().eq(head_thread)), follows.eq(follows_tail));
            let second_told = !beat.valid | (beat.began | follows_second.eq(follows_tail));
            m.assert("whom_a_beat_follows_is_told", !callers.holds | (told & second_told));
        }
        (take, take_reads)
    }

    /// a: pending are the lanes nearer than the radius of the thread's last leaf and than what is farthest now.
    fn arriving_lanes(&self, m: &mut Module, farthest: Option<&Farthest>, take_reads: Expr) -> Expr {
        let farthest = farthest.map(|Farthest { distance, is_current }| {
            (m.wire("farthest_will_be_known", *is_current & !take_reads), distance.expr())
        });
        self.arrivals.near_lanes(self.config, farthest)
    }

    /// b: the lowest pending lane goes on; whether others are nearer than what is farthest by now shows in the next cycle.
    /// Returns the choice, the lanes that are left, and the candidate.
    fn choose(
        &self,
        m: &mut Module,
        fetch: &Fetch,
        farthest: Option<&Farthest>,
        start: &Pulse<Start<Wires>>,
    ) -> (Choice, Expr, Candidate) {
        let Self { config, beat, item, working, .. } = self;
        let thread = self.thread();
        let choice = Choice::new(m, config, beat, fetch.moves);
        let farthest = farthest.map(|Farthest { distance, is_current }| (*is_current, distance.expr()));
        let near = near_lanes(config, &beat.record, farthest.into_iter());
        let left = m.wire("left", fetch.waits.mux(beat.pending, choice.rest & near));
        m.next(item.valid, fetch.moves);
        m.next(item.reads, fetch.reads);
        m.next(item.stays, !fetch.reads);
        let is_fresh = contains(working.fresh, thread);
        let inserts = fetch.moves & choice.any;
        m.next(item.inserts_here, inserts & !beat.reads);
        let from_initial = match item.inserts_stored {
            Some(stored) => {
                m.next(stored, inserts & (beat.reads & !is_fresh));
                is_fresh
            }
            None => bit(true),
        };
        m.next(item.inserts_initial, inserts & (beat.reads & from_initial));
        m.next(item.last, choice.ends & beat.record.place.last);
        m.next(item.fresh, is_fresh);
        m.next(item.thread, thread);
        let candidate = Candidate::register(m, config, choice.entry);
        let started = decode(start.valid, start.record.thread.thread, config.threads);
        m.next(working.fresh, (working.fresh & !decode(fetch.reads, thread, config.threads)) | started);
        (choice, left, candidate)
    }

    /// c: which entries the candidate is nearer than, in the row as it will be; in an initial row, the placeholders. Both
    /// rows are compared: to choose one of them first would take as much and come before the comparison.
    fn compare(&self, m: &mut Module, candidate: Candidate, fetch: &Fetch, inserted: &Inserted) {
        let Self { config, working, item, insertion, .. } = self;
        let are_nearer = |row: Expr| candidate.nearer(&entries(config, row));
        let nearer = are_nearer(*working.row);
        let than_inserted = candidate.entry.neighbor.distance2.lt(insertion.entry.neighbor.distance2);
        let nearer_now = insert(&nearer, *insertion.nearer, &than_inserted, |here, a, b| here.mux(*a, *b));
        let read = |initial: Expr, stored: Option<Expr>| match stored {
            Some(stored) => item.fresh.mux(initial, stored),
            None => initial,
        };
        // What a comparison says is late: which of them counts was chosen a cycle before.
        let of = |inserts: Reg, nearer: Expr| nearer & inserts.repeat(config.neighbors);
        let placeholders = placeholders(config, fetch.query.sentinels);
        let now_or_initial = of(item.inserts_here, set(&nearer_now)) | of(item.inserts_initial, placeholders);
        let stored = fetch.stored.zip(item.inserts_stored).map(|(row, inserts)| of(inserts, set(&are_nearer(row))));
        let nearer = stored.map_or(now_or_initial, |stored| now_or_initial | stored);
        insertion.take(m, config, item, nearer, candidate);
        m.next(working.row, item.stays.mux(inserted.row, read(fetch.initial, fetch.stored)));
        if let Some(Owner { owned, owner, not_owner }) = working.owner {
            m.next_if(owner, item.valid, item.thread);
            m.next_if(not_owner, item.valid, !item.thread);
            m.next(owned, owned | item.valid);
            m.assert("owner_or_not", !owned | (owner ^ not_owner).all());
        }
    }

    /// d: the neighbor is moved to its place in the working row.
    fn insert(&self, m: &mut Module) -> Inserted {
        let Self { config, working, insertion, .. } = self;
        let working_entries = entries(config, *working.row);
        let choose = |here: Expr, a: &Entry<Wires>, b: &Entry<Wires>| Entry::choose(config, here, *a, *b);
        let inserted = insert(&working_entries, *insertion.nearer, &*insertion.entry, choose);
        let row = m.wire("inserted_row", row(config, &inserted));
        let farthest = inserted[inserted.len() - 1].neighbor.distance2;
        let radius = Radius { thread: Thread { thread: *insertion.thread }, radius2: farthest };
        let radius = PORTS.radius.registered(m, config, insertion.last, radius);
        PORTS.events.event(m, config, |events| events.insert, insertion.nearer.msb());
        Inserted { row, farthest, radius }
    }

    /// e: what is farthest after it.
    fn farthest(&self, m: &mut Module, inserted: &Inserted) -> Option<Farthest> {
        let Self { config, working, beat, item, .. } = self;
        if config.lanes == 1 {
            return None;
        }
        let distance = m.reg("farthest", inserted.farthest.width());
        let valid = m.reg_reset("farthest_valid", 1, 0);
        m.next(distance, inserted.farthest);
        m.next(valid, !item.reads);
        let is_current = m.wire("farthest_is_current", valid & !(beat.reads | item.reads));
        if let Some(Owner { owned, owner, .. }) = working.owner {
            let is_its = owned & owner.eq(self.thread());
            m.assert("the_farthest_is_of_the_beat", !(beat.valid & is_current) | is_its);
        }
        Some(Farthest { distance, is_current })
    }

    /// Rows and queries are read for a beat that moves on or for a readout that may start, never for both; of one thread alone
    /// there are never both.
    fn fetch(
        &self,
        m: &mut Module,
        start: &Pulse<Start<Wires>>,
        readout: &Readout,
        finished: Expr,
        inserted: &Inserted,
    ) -> Fetch {
        let Self { config, working, beat, .. } = self;
        let waits = m.wire("waits", if working.owner.is_some() { beat.reads & readout.reads } else { bit(false) });
        let moves = m.wire("moves", beat.valid & !waits);
        let reads = m.wire("reads", moves & beat.reads);
        let read_thread = m.wire("read_thread", readout.reads.mux(finished, self.thread()));
        let stored = working.owner.as_ref().map(|Owner { owned, owner, .. }| {
            let rows = m.memory("rows", 1 << config.thread_bits(), row_bits(config));
            // What its row is can be written in every cycle: it is read again when its thread no longer owns the working row.
            m.write(rows, *owned, *owner, inserted.row);
            m.read(rows, "stored", read_thread)
        });
        let query = queries(m, config, start, read_thread);
        let initial = m.wire("initial_row", initial(config, query.sentinels, query.radius2));
        Fetch { waits, moves, reads, stored, query, initial }
    }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("search_queue", "A sorted row of neighbors for each thread.");
    m.parameter("threads", config.threads);
    m.parameter("neighbors", config.neighbors);
    m.parameter("lanes", config.lanes);
    let start = PORTS.start.declare(&mut m, config);
    let k = start.record.query.k;
    m.assert("k_fits_a_row", !start.valid | (k.any() & lit(config.rank_bits(), config.neighbors.into()).ge(k)));
    let candidates = PORTS.candidates.declare(&mut m, config);
    let finish = PORTS.finish.queue(&mut m, config);
    let arrivals = Arrivals::new(&mut m, config);
    m.drive(candidates.ready, arrivals.callers.room);
    let working = Working::new(&mut m, config);
    let free = m.forward("beat_free", 1);
    let beat = Beat::new(&mut m, config, arrivals.head(config), free);
    let item = Item::new(&mut m, config);
    let insertion = Insertion::new(&mut m, config);
    let stages = Stages { config, arrivals, working, beat, item, insertion };
    let Stages { arrivals, working, beat, item, .. } = &stages;

    // What a stage asks for comes from later ones.
    let inserted = stages.insert(&mut m);
    let farthest = stages.farthest(&mut m, &inserted);
    let owner = working.owner.as_ref().map(|owner| (owner.owned.expr(), !owner.not_owner));
    let whose = Whose { fresh: *working.fresh, owner, displaced: *item.reads };
    let readout = Readout::new(&mut m, config, &finish, &whose);
    let fetch = stages.fetch(&mut m, &start, &readout, finish.record.thread, &inserted);
    let (choice, left, candidate) = stages.choose(&mut m, &fetch, farthest.as_ref(), &start);
    let (take, take_reads) = stages.arrive(&mut m, free, &fetch, &choice);
    let writers = [start.into(), inserted.radius.into()];
    let limit = radii_now(&mut m, config, writers, candidates.record.place.thread.thread);
    let comes = candidates.transfer();
    arrivals.update(&mut m, config, comes, Arrival { candidates: candidates.record, limit }, take);
    let arriving_lanes = stages.arriving_lanes(&mut m, farthest.as_ref(), take_reads);
    beat.next_pending(&mut m, take.mux(arriving_lanes, left));
    stages.compare(&mut m, candidate, &fetch, &inserted);

    let rows = Rows { initial: fetch.initial, working: *working.row, stored: fetch.stored };
    readout.send(&mut m, config, &rows, &fetch.query);
    PORTS.events.event(&mut m, config, |events| events.beat, choice.ends);
    if config.lanes > 1 {
        PORTS.events.event(&mut m, config, |events| events.insert_wait, fetch.moves & choice.stays);
    }
    m
}
