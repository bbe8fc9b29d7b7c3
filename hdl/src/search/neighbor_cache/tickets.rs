//! The searches under way: a search bears a ticket in place of its query's number, under which the query is kept.

use pointcore_contract::search::Config;
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::width;

use super::check::{Check, Searched};
use crate::search::parts::sets::{decode, index_of, lowest};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Memory, Module, Reg, address_width};

/// The tickets and the queries they stand for.
pub(super) struct Tickets {
    taken: Reg,
    queries: Memory,
    /// Queries that hold a ticket or may still ask for one.
    under_way: Reg,
    /// One more query may be compared: none waits for a ticket afterwards.
    pub admits: Reg,
    /// `next` is a ticket: it is one whenever a query misses.
    pub any: Reg,
    /// The ticket of the next query that misses, found ahead: the way on is long enough without the search for a free one.
    pub next: Reg,
}

impl Tickets {
    /// All free after reset.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let count = config.tickets();
        let bits = address_width(count);
        let taken = m.reg_reset("taken", count, 0);
        let queries = m.memory("tickets", 1 << bits, width::<Searched>(config));
        let any = m.reg_reset("any_ticket", 1, 0);
        let next = m.reg("next_ticket", bits);
        let under_way = m.reg_reset("under_way", index_bits(config.tickets() + 1), 0);
        let admits = m.reg_reset("admits_query", 1, 1);
        Self { taken, queries, under_way, admits, any, next }
    }

    /// The query of the ticket that a result bears; read where `enable` is set.
    pub fn query(&self, m: &mut Module, config: &Config, enable: Expr, number: Expr) -> Searched<Wires> {
        let query = m.read_if(self.queries, "ticket_query", enable, number.trunc(self.next.width()));
        Searched::unpack(config, query)
    }

    /// The next ticket is given to a query that misses; the one that a result bears comes back where `returns` is set.
    pub fn update(self, m: &mut Module, config: &Config, check: &Check, returns: Expr, number: Expr) {
        m.write(self.queries, check.misses, self.next, check.searched.pack(config));
        let (count, bits) = (self.taken.width(), self.next.width());
        let lowest = m.wire("lowest_ticket", lowest(!self.taken));
        let takes = m.wire("takes_ticket", !self.any | check.misses);
        m.next_if(self.any, takes, !self.taken.all());
        m.next_if(self.next, takes, index_of(lowest, bits));
        m.assert("a_miss_has_a_ticket", !check.misses | self.any);
        let returned = decode(returns, number.trunc(bits), count);
        let [answered, returns] = [check.answered, returns].map(|change| change.zext(self.under_way.width()));
        // Whether a query enters is known last.
        let left = m.wire("still_under_way", self.under_way - answered - returns);
        m.next(self.under_way, check.enters.mux(left.add_lit(1), left));
        let [full, one_left] = [0, 1].map(|left_over| left.eq_lit(u128::from(count - left_over)));
        m.next(self.admits, !(full | (one_left & check.enters)));
        m.next(self.taken, (self.taken | (lowest & takes.repeat(count))) & !returned);
    }
}
