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
    /// For each whom it follows.
    leaders: Vec<Reg>,
    queries: Memory,
    /// The one that is read, alone.
    read: Expr,
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
        let [waits, ready, due] = ["waits", "follower_ready", "due"].map(|name| m.reg_reset(name, count, 0));
        let leaders = (0..count).map(|follower| m.reg(&format!("follows_{follower}"), config.leader_bits())).collect();
        let bits = address_width(count);
        let queries = m.memory("followers", 1 << bits, width::<CachedQuery>(config));
        let has_next = m.reg_reset("has_next", 1, 0);
        let takes = m.wire("next_taken", !has_next | room);
        let first = m.wire("first_due", lowest(due));
        m.next_if(has_next, takes, due.any());
        let reads = m.wire("reads_follower", takes & due.any());
        let next = m.read_if(queries, "next", reads, index_of(first, bits));
        let next = CachedQuery::unpack(config, next);
        let read = m.wire("follower_read", first & takes.repeat(count));
        Self { waits, ready, due, leaders, queries, read, has_room: !waits.all(), has_next, next }
    }

    /// The followers as they are after a cycle.
    pub fn update(self, m: &mut Module, config: &Config, role: &Role, finished: [Finished; 2]) {
        let Self { waits, ready, due, leaders, queries, read, .. } = self;
        let count = waits.width();
        let free = m.wire("free_follower", lowest(!waits));
        m.write(queries, role.follows, index_of(free, address_width(count)), role.asked.query.pack(config));
        let enters = m.wire("follower_enters", free & role.follows.repeat(count));
        let finishes = |leader: Expr| finished.iter().fold(bit(false), |any, finished| any | finished.is(leader));
        let met = set(&leaders.iter().map(|leader| finishes(leader.expr())).collect::<Vec<_>>());
        let unmet = waits & !(ready | due);
        let becomes = m.wire("becomes_ready", (unmet & met) | (enters & finishes(role.followed).repeat(count)));
        for (follower, leader) in (0..).zip(leaders) {
            m.next_if(leader, enters.bit(follower), role.followed);
        }
        let is_due = due.any().repeat(count);
        m.next(waits, (waits & !read) | enters);
        m.next(ready, (ready & is_due) | becomes);
        m.next(due, (due & !read) | (ready & !is_due));
    }
}
