//! Readout of the priority queues: a finished thread's row, sent neighbor by neighbor.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{QueryResult, Thread};
use pointcore_contract::search::units::queue::PORTS;

use super::KeptQuery;
use super::row::{Entry, entries, row_bits};
use crate::search::parts::neighbor::with_sign;
use crate::search::parts::sets::contains;
use crate::units::ports::{Flow, PulseOutPorts, StreamOutPorts};
use crate::units::wires::Wires;
use rtl::{Expr, Module, Reg, address_width, bit, lit};

/// Idle, *fetch* or *send*.
pub(super) struct Readout {
    /// It is idle and a thread has finished, whose row is read; no other is in this cycle.
    pub reads: Expr,
    starts: Expr,
    fetching: Reg,
    sending: Reg,
    idle: Reg,
    from_working: Option<Reg>,
    from_nothing: Reg,
    thread: Reg,
}

/// Whose row is where.
pub(super) struct Whose {
    pub fresh: Expr,
    /// Whether the working row is anybody's, and whose; of one thread alone nobody asks.
    pub owner: Option<(Expr, Expr)>,
    /// The owner's row is written back in this cycle.
    pub displaced: Expr,
}

/// Where a thread's row may be.
pub(super) struct Rows {
    pub initial: Expr,
    pub working: Expr,
    pub stored: Option<Expr>,
}

impl Readout {
    /// Takes a finished thread when idle, unless its row is written back in this cycle.
    pub fn new(m: &mut Module, config: &Config, finish: &Flow<Thread<Wires>>, rows: &Whose) -> Self {
        let [fetching, sending] = ["fetching", "sending"].map(|name| m.reg_reset(name, 1, 0));
        // Not `sending`, which is where the results leave: beats ask whether a row is read.
        let idle = m.reg_reset("readout_idle", 1, 1);
        let reads = m.wire("readout_reads", finish.valid & idle);
        let finished = finish.record.thread;
        let owns = |of: Expr| rows.owner.map(|(owned, owner)| owned & owner.eq(of));
        let finished_owns = owns(finished).map(|owns| m.wire("finished_owns", owns));
        let waits = finished_owns.map(|owns| rows.displaced & owns);
        let starts = m.wire("readout_starts", waits.map_or(reads, |waits| reads & !waits));
        m.drive(finish.ready, starts);
        m.next(fetching, starts);
        let thread = m.reg("readout_thread", config.thread_bits());
        m.next_if(thread, starts, finished);
        // Where the row is does not change while it is fetched: its search is over, and it is not displaced.
        let from_working = finished_owns.map(|owns| {
            let from_working = m.reg("fetch_from_working", 1);
            m.next(from_working, owns);
            from_working
        });
        if let (Some(from_working), Some(owns_now)) = (from_working, owns(*thread)) {
            m.assert("a_fetched_row_stays_where_it_is", !fetching | from_working.eq(owns_now));
        }
        let from_nothing = m.reg("fetch_from_nothing", 1);
        m.next(from_nothing, contains(rows.fresh, finished));
        m.assert("a_fetched_row_stays_fresh", !fetching | from_nothing.eq(contains(rows.fresh, thread)));
        Self { reads, starts, fetching, sending, idle, from_working, from_nothing, thread }
    }

    /// Fetches the row from where it is and sends it.
    pub fn send(self, m: &mut Module, config: &Config, rows: &Rows, query: &KeptQuery<Wires>) {
        let Self { starts, fetching, sending, idle, from_working, from_nothing, thread, .. } = self;
        let stored = from_working.zip(rows.stored);
        let kept = stored.map_or(rows.working, |(from_working, stored)| from_working.mux(rows.working, stored));
        let fetched = from_nothing.mux(rows.initial, kept);
        let row = m.reg("sent_row", row_bits(config));
        m.next_if(row, fetching, fetched);
        let number = m.reg("sent_number", config.index_bits);
        m.next_if(number, fetching, query.number);
        PORTS.released.registered(m, config, fetching, Thread { thread: *thread });

        let transfer = m.forward("result_transfer", 1);
        // Of a row of one neighbor that one is sent, found or not.
        let places = (config.neighbors > 1).then(|| places(m, config, query.k, fetching, transfer.expr()));
        let words = entries(config, *row);
        let at = |position: Option<Reg>, value: fn(&Entry<Wires>) -> Expr| match position {
            Some(position) => {
                let entry = position.trunc(address_width(config.neighbors));
                entry.pick(words.iter().map(value).collect::<Vec<_>>())
            }
            None => value(&words[0]),
        };
        let position = places.map(|[position, _]| position);
        let at_end = position.map_or(bit(true), |position| position.eq_lit(u128::from(config.neighbors) - 1));
        let no_other = places.map_or(bit(true), |[_, next]| !at(Some(next), |entry| entry.found));
        let last = m.wire("last_result", at_end | no_other);
        let result = QueryResult {
            number: *number,
            last,
            found: at(position, |entry| entry.found),
            index: at(position, |entry| entry.neighbor.index),
            distance2: with_sign(at(position, |entry| entry.neighbor.distance2)),
        };
        let ready = PORTS.result.drive(m, config, sending, result);
        m.drive(transfer, sending & ready);
        let ends = m.wire("result_ends", transfer & last);
        m.next(sending, fetching | (sending & !ends));
        m.next(idle, (idle & !starts) | ends);
        m.assert("idle_when_neither", idle.eq(!(fetching | sending)));
    }
}

/// The place in the row of the neighbor that is sent and of the next one, which is a register, too: whether there is a neighbor has to be
/// found within the cycle. The first of `k` comes with what is fetched.
fn places(m: &mut Module, config: &Config, k: Expr, fetching: Reg, transfer: Expr) -> [Reg; 2] {
    let rank_bits = config.rank_bits();
    let [position, next_position] = ["position", "next_position"].map(|name| m.reg(name, rank_bits));
    let first = |places: u32| lit(rank_bits + 1, places.into()).trunc(rank_bits) - k;
    let moves = fetching | transfer;
    m.next_if(position, moves, fetching.mux(first(config.neighbors), next_position));
    m.next_if(next_position, moves, fetching.mux(first(config.neighbors + 1), next_position.add_lit(1)));
    [position, next_position]
}
