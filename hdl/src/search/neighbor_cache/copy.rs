//! Neighbor copy (thesis 6.5.3): takes the results of searches into the cache, each in place of the least recently used
//! neighborhood.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::QueryResult;
use pointcore_contract::search::units::neighbor_cache::PORTS;

use super::check::Searched;
use super::cover::Reach;
use super::deliver::Answer;
use super::lru::{Chosen, Entries};
use super::neighborhoods::Neighborhoods;
use super::tickets::Tickets;
use crate::search::parts::neighbor::{Neighbor, without_sign};
use crate::units::ports::StreamInPorts;
use crate::units::wires::Wires;
use rtl::{Expr, Module, bit, lit};

/// What becomes of results in a cycle.
pub(super) struct Copy {
    /// An entry is given to the neighborhood at the head.
    pub starts: Expr,
    /// The entry that is copied to.
    pub target: Chosen,
    /// A query is answered, and its entry complete but for the comparison value.
    pub end: Answer,
    /// What that follows from.
    pub reach: Reach<Wires>,
    /// The number of the search that ends: its ticket.
    pub ticket: Expr,
}

/// Takes one result a cycle; `hits` and `room` say whether a query is answered from the cache in this cycle, and whether one
/// can be.
pub(super) fn copy(
    m: &mut Module,
    config: &Config,
    (entries, tickets, neighborhoods): (&Entries, &Tickets, &Neighborhoods),
    (is_ball, hits, room): (Expr, Expr, Expr),
) -> Copy {
    let rank_bits = config.rank_bits();
    let found = PORTS.found.queue(m, config);
    let QueryResult { number: ticket, last, found: is_found, index, distance2 } = found.record;
    let copying = m.reg_reset("copying", 1, 0);
    let starts = m.wire("copy_starts", (found.valid & !copying) & (entries.victim.valid & !hits));
    // What counts from the start on is taken in every cycle before: nothing of that waits for the victim to be known.
    let target = m.reg("copy_entry", config.entry_bits());
    m.next_if(target, !copying, entries.victim.entry);
    let Searched { query, leading } = tickets.query(m, config, found.valid & !copying, ticket);

    let ready = m.wire("copy_ready", copying & (!last | (room & !hits)));
    m.drive(found.ready, ready);
    let takes = m.wire("copy_takes", found.valid & ready);
    let ends = m.wire("copy_ends", takes & last);
    m.next(copying, starts | (copying & !ends));

    // Neighbors found so far, and the squared distance of the last of them.
    let rank = m.reg("copy_rank", rank_bits);
    let previous = m.reg("copy_previous", config.geometry.width());
    let stores = m.wire("copy_stores", takes & is_found);
    let total = m.wire("copy_total", rank + is_found.zext(rank_bits));
    let latest = is_found.mux(distance2, previous);
    let zero = lit(distance2.width(), 0);
    m.next_if(rank, !copying | stores, copying.mux(total, lit(rank_bits, 0)));
    m.next_if(previous, !copying | stores, copying.mux(distance2, zero));
    let place = Chosen { valid: stores, entry: target.expr() };
    neighborhoods.store(m, config, place, *rank, Neighbor { index, distance2: without_sign(distance2) });

    // Whether this neighbor is one only chooses among comparisons that need not wait for it.
    let wanted = query.k;
    let left = |more: u128| if more < 1 << rank_bits { rank.add_lit(more).eq(wanted) } else { bit(false) };
    let [none_left, one_left, two_left] = [0, 1, 2].map(left);
    let full = m.wire("copy_full", is_found.mux(one_left, none_left));
    let one_less = is_found.mux(two_left, one_left);
    let end = Chosen { valid: ends, entry: target.expr() };
    // The same for whether the last one is left out.
    let less_surplus = |left: Expr, less: Expr, count: Expr| (left & !is_ball).mux(less, count);
    let rank = rank.expr();
    let with_last = less_surplus(one_left, rank, rank.add_lit(1));
    let without = less_surplus(none_left, rank.sub_lit(1), rank);
    neighborhoods.close(m, end, is_found.mux(with_last, without));

    let radius2 = query.radius2;
    let near2 = full.mux(previous, one_less.mux(latest, radius2));
    let reach = Reach {
        entry: target.expr(),
        point: query.point,
        far2: full.mux(distance2, radius2),
        near2: is_ball.mux(zero, near2),
        leading,
    };
    let target = Chosen { valid: copying.expr(), entry: target.expr() };
    Copy { starts, target, end: Answer { by: end, number: query.number }, reach, ticket }
}
