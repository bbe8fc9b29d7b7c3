//! Control: threads from their query to their result, and the neighbors of each; golden twin:
//! `pointcore_golden::process::control`.
//!
//! Threads wait in queues as long as there are threads: who pushes one need not ask for room.

use crate::stream::fifo_distributed;
use crate::units::ports::{Flow, Pulse, PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::queue::Pushed;
use crate::units::wires::{Bundle, Registers, Wires, layout};
use pointcore_contract::process::config::Config;
use pointcore_contract::process::queries::{Again, Found, Listed, Start};
use pointcore_contract::process::records::{Gather, NeighborPlace, Thread};
use pointcore_contract::process::stages::control::PORTS;
use pointcore_contract::record;
use pointcore_contract::splat::config::index_bits;
use rtl::{Expr, Memory, Module, bit, cat, lit};

/// Bits of a neighbor's place in its list.
fn place_bits(config: &Config) -> u32 {
    index_bits(config.neighbors)
}

/// A thread whose neighbors are gathered.
#[record(config: Config)]
struct Turn {
    /// The thread.
    thread: Thread,
    /// The neighbor that is next.
    #[bits(place_bits(config))]
    rank: u8,
    /// Its last one.
    #[bits(place_bits(config))]
    last: u8,
    /// It is the farthest neighbor, for `init`.
    farthest: bool,
    /// There is none.
    none: bool,
}

/// The neighbors of the threads: their indices, and of each thread the place of the last and whether there is none.
struct Lists {
    indices: Memory,
    ends: Memory,
}

/// A queue for all threads, and what is first in it.
fn queue(m: &mut Module, config: &Config, name: &str) -> (Pushed<Thread>, Flow<Thread<Wires>>) {
    let queue = fifo_distributed(config.threads.max(2), &layout::<Thread>(config));
    Pushed::place(m, config, name, queue)
}

/// Pushes a thread, for which there is room.
fn push(m: &mut Module, config: &Config, queue: Pushed<Thread>, name: &str, valid: Expr, thread: Thread<Wires>) {
    m.assert(&format!("{name}_has_room"), !valid | queue.room);
    queue.push(m, config, valid, thread);
}

/// A query goes to a thread that has not had one, else to the one that has been free for longest.
fn take_query(m: &mut Module, config: &Config, again: &Pulse<Again<Wires>>) {
    let query = PORTS.query.declare(m, config);
    let released = PORTS.released.declare(m, config);
    let (free, freed) = queue(m, config, "free");
    push(m, config, free, "free", released.valid, released.record);

    let count_bits = index_bits(config.threads + 1);
    let issued = m.reg_reset("issued", count_bits, 0);
    let is_new = m.wire("is_new", issued.lt_lit(config.threads.into()));
    let is_free = m.wire("is_free", is_new | freed.valid);
    let entering = m.reg_reset("entering_valid", 1, 0);
    m.drive(query.ready, is_free & !entering);
    let take = m.wire("take", query.transfer());
    m.next_if(issued, take & is_new, issued.add_lit(1));
    m.drive(freed.ready, take & !is_new);
    let new = issued.bits(config.thread_bits() - 1, 0);
    let thread = Thread { thread: is_new.mux(new, freed.record.thread) };
    let start = PORTS.start.registered(m, config, take, Start { thread, query: query.record });
    PORTS.event_query_wait.event(m, query.valid & !is_free);

    let busy = m.reg_reset("busy", count_bits, 0);
    m.next(busy, busy + take.zext(count_bits) - released.valid.zext(count_bits));
    PORTS.idle.drive_word(m, busy.is_zero());

    // A thread that comes back has the way.
    let entering_thread = m.reg("entering_thread", config.thread_bits());
    m.next_if(entering_thread, take, thread.thread);
    let searched = m.wire("searched", again.valid & again.record.search);
    m.next(entering, take | (entering & searched));
    let (want, wanting) = queue(m, config, "wants");
    let wants = Thread { thread: searched.mux(again.record.thread.thread, entering_thread) };
    push(m, config, want, "wants", searched | entering, wants);
    PORTS.want.export(m, config, wanting);
    let _ = start;
}

/// The place of a thread's neighbor in the lists.
fn address(thread: Expr, rank: Expr) -> Expr {
    cat([thread, rank])
}

/// Neighbors found enter their lists unless a thread is `kept`; returns whether a thread's are complete, and whose.
fn take_found(
    m: &mut Module,
    config: &Config,
    lists: &Lists,
    again: &Pulse<Again<Wires>>,
    kept: Expr,
) -> (Expr, Thread<Wires>) {
    let found = PORTS.found.queue(m, config);
    m.drive(found.ready, !kept);
    let is_same = found.record.thread.thread.eq(again.record.thread.thread);
    m.assert("finds_nothing_in_final", !(again.valid & found.valid) | !is_same);
    let take = m.wire("take_found", found.transfer());
    let Found { thread, last, found, index } = found.record;
    let bits = place_bits(config);
    let rank = m.reg_reset("found_rank", bits, 0);
    m.assert("a_list_ends_where_it_is_full", !take | (last | !rank.eq_lit(u128::from(config.neighbors) - 1)));
    m.next_if(rank, take, last.mux(lit(bits, 0), rank.add_lit(1)));
    m.write(lists.indices, take & found, address(thread.thread, rank.expr()), index);
    let complete = m.wire("complete", take & last);
    m.write(lists.ends, complete, thread.thread, cat([!found, rank.expr()]));
    let neighbors = rank.zext(config.rank_bits()).add_lit(1);
    let neighbors = found.mux(neighbors, lit(config.rank_bits(), 0));
    PORTS.listed.registered(m, config, complete, Listed { thread, neighbors });
    (complete, thread)
}

/// The neighbors of one thread after the other are gathered: of a thread before `init` the farthest, of one before
/// `kernel` all.
fn take_turns(
    m: &mut Module,
    config: &Config,
    lists: &Lists,
    ready: Option<Flow<Thread<Wires>>>,
    run: Flow<Thread<Wires>>,
) {
    let gather = PORTS.gather.queue(m, config);
    let turn_valid = m.reg_reset("turn_valid", 1, 0);
    let turn = Registers::<Turn<Wires>>::new(m, config, "turn_");
    let read_valid = m.reg_reset("read_valid", 1, 0);
    let advance = m.wire("advance", !read_valid | gather.room);
    let is_last = m.wire("is_last", turn.rank.eq(turn.last));
    let emits = m.wire("emits", turn_valid & advance);
    m.next_if(read_valid, advance, turn_valid);
    let place =
        NeighborPlace { thread: turn.thread, farthest: turn.farthest, none: turn.none, last: is_last & !turn.farthest };
    let place = place.register(m, config, "read_", advance);
    let index = m.read_if(lists.indices, "index", emits, address(turn.thread.thread, turn.rank));
    let index = index & (!place.none).repeat(config.index_bits);
    gather.push(m, config, read_valid, Gather { place, index });

    let was_farthest = m.reg_reset("was_farthest", 1, 0);
    let free = m.wire("turn_free", !turn_valid | (emits & is_last));
    let farthest = ready.map_or(bit(false), |ready| ready.valid & !(was_farthest & run.valid));
    let farthest = m.wire("farthest_next", farthest);
    let begins = m.wire("turn_begins", free & (farthest | run.valid));
    let thread = ready.map_or(run.record, |ready| Thread::choose(config, farthest, ready.record, run.record));
    if let Some(ready) = ready {
        m.drive(ready.ready, free & farthest);
    }
    m.drive(run.ready, free & !farthest);
    let list_end = m.read_now(lists.ends, "list_end", thread.thread);
    let bits = place_bits(config);
    let (none, last) = (list_end.msb(), list_end.bits(bits - 1, 0));
    let first = farthest.mux(last, lit(bits, 0));
    m.next(turn_valid, begins | (turn_valid & !free));
    m.next_if(was_farthest, begins, farthest);
    let begun = Turn { thread, rank: first, last, farthest, none };
    let next = Turn { rank: turn.rank.add_lit(1), ..*turn };
    let next = Turn::choose(config, begins, begun, next);
    turn.next_if(m, config, begins | emits, next);
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("process_control", "Gives queries to threads and says which block each goes to next.");
    m.parameter("threads", config.threads);
    m.parameter("neighbors", config.neighbors);
    let again = PORTS.again.declare(&mut m, config);
    take_query(&mut m, config, &again);

    let words = 1 << (config.thread_bits() + place_bits(config));
    let lists = Lists {
        indices: m.memory_unordered("lists", words, config.index_bits),
        ends: m.memory_distributed("ends", 1 << config.thread_bits(), 1 + place_bits(config)),
    };
    let kept = m.wire("kept", again.valid & !again.record.search);
    let (complete, listed) = take_found(&mut m, config, &lists, &again, kept);
    let ready = Thread::choose(config, kept, again.record.thread, listed);
    let is_ready = m.wire("is_ready", kept | complete);
    let (run, running) = queue(&mut m, config, "runs");
    if !config.has_init() {
        push(&mut m, config, run, "runs", is_ready, ready);
        take_turns(&mut m, config, &lists, None, running);
        return m;
    }
    let prepared = PORTS.prepared.declare(&mut m, config);
    push(&mut m, config, run, "runs", prepared.valid, prepared.record);
    let (before, waiting) = queue(&mut m, config, "readies");
    push(&mut m, config, before, "readies", is_ready, ready);
    if config.has_farthest() {
        take_turns(&mut m, config, &lists, Some(waiting), running);
    } else {
        PORTS.prepare.export(&mut m, config, waiting);
        take_turns(&mut m, config, &lists, None, running);
    }
    m
}
