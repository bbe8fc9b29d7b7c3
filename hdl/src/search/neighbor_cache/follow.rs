//! The queries that follow others: each waits until its leader's fate is known, and is compared then; golden twin:
//! `pointcore_golden::search::neighbor_cache`.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::CachedQuery;
use pointcore_contract::width;

use super::lead::{Finished, Role};
use crate::search::parts::sets::{index_of, lowest, set};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Memory, Module, Reg, address_width, bit};

/// The followers, and the one that goes next.
pub(super) struct Follow {
    /// Who is there.
    waits: Reg,
    /// Whose leader has finished.
    ready: Reg,
    /// Who goes before those that become ready later.
    due: Reg,
    /// Who goes next, alone: known a cycle before the query is read.
    chosen: Reg,
    /// Where the next query that follows goes, alone.
    free: Reg,
    /// For each whom it follows.
    leaders: Vec<Reg>,
    queries: Memory,
    /// The chosen one's query is read in this cycle.
    reads: Expr,
    /// Another is chosen in this cycle, of those that are due the first, alone.
    chooses: Expr,
    first: Expr,
    /// A query can follow in this cycle.
    pub has_room: Expr,
    /// A query waits to be compared.
    pub has_next: Reg,
    /// That query.
    pub next: CachedQuery<Wires>,
}

impl Follow {
    /// None after reset; the next one leaves where there is `room`.
    pub fn new(m: &mut Module, config: &Config, room: Expr) -> Self {
        let count = config.followers();
        let [waits, ready, due, chosen] =
            ["waits", "follower_ready", "due", "chosen"].map(|name| m.reg_reset(name, count, 0));
        let leaders = (0..count).map(|follower| m.reg(&format!("follows_{follower}"), config.leader_bits())).collect();
        let bits = address_width(count);
        let queries = m.memory("followers", 1 << bits, width::<CachedQuery>(config));
        let has_next = m.reg_reset("has_next", 1, 0);
        let has_chosen = m.reg_reset("has_chosen", 1, 0);
        let takes = m.wire("next_taken", !has_next | room);
        m.next_if(has_next, takes, has_chosen);
        let reads = m.wire("reads_follower", takes & has_chosen);
        let next = m.read_if(queries, "next", reads, index_of(chosen, bits));
        let next = CachedQuery::unpack(config, next);

        let chooses = m.wire("chooses_follower", takes | !has_chosen);
        let first = m.wire("first_due", lowest(due));
        m.next_if(has_chosen, chooses, due.any());
        m.next_if(chosen, chooses, first);

        let has_room = m.reg_reset("has_free_follower", 1, 0);
        let free = m.reg("free_follower", count);
        m.next(has_room, !waits.all());
        m.next(free, lowest(!waits));
        let has_room = has_room.expr();
        Self { waits, ready, due, chosen, free, leaders, queries, reads, chooses, first, has_room, has_next, next }
    }

    /// The followers as they are after a cycle.
    pub fn update(self, m: &mut Module, config: &Config, role: &Role, finished: [Finished; 2]) {
        let Self { waits, ready, due, chosen, free, leaders, queries, reads, chooses, first, .. } = self;
        let count = waits.width();
        m.write(queries, role.follows, index_of(free, address_width(count)), role.asked.query.pack(config));
        let enters = m.wire("follower_enters", free & role.follows.repeat(count));
        let finishes = |leader: Expr| finished.iter().fold(bit(false), |any, finished| any | finished.is(leader));
        let met = set(&leaders.iter().map(|leader| finishes(leader.expr())).collect::<Vec<_>>());
        let unmet = waits & !(ready | due | chosen);
        // Of one that enters the leader is known too late: whether it finishes in that cycle counts in the next.
        let entered = m.reg_reset("entered", count, 0);
        m.next(entered, enters);
        let followed = m.reg("followed_before", config.leader_bits());
        m.next(followed, role.followed);
        let names = ["hit_before", "delivered_before"];
        let before: Vec<_> = names.iter().zip(finished).map(|(name, finished)| finished.register(m, name)).collect();
        let missed = before.iter().fold(finishes(followed.expr()), |any, finished| any | finished.is(followed.expr()));
        let missed = m.wire("missed", missed);
        let becomes = m.wire("becomes_ready", unmet & ((entered & missed.repeat(count)) | (met & !entered.expr())));
        for (follower, leader) in (0..).zip(leaders) {
            m.next_if(leader, entered.bit(follower), followed);
        }
        let is_due = due.any().repeat(count);
        m.next(waits, (waits & !(chosen & reads.repeat(count))) | enters);
        m.next(ready, (ready & is_due) | becomes);
        m.next(due, (due & !(first & chooses.repeat(count))) | (ready & !is_due));
        m.assert("a_follower_enters_where_none_waits", (enters & waits).is_zero());
    }
}
