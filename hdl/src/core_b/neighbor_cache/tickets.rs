//! The searches under way: a search bears a ticket in place of its query's number, under which the query is kept.

use pointcore_spec::core_a::config::index_bits;
use pointcore_spec::core_b::{Config, records};

use super::check::Check;
use crate::core_b::sets::{decode, index_of, lowest};
use crate::rtl::{Expr, Memory, Module, Reg, address_width};
use crate::units::records::{Record, width};

/// The tickets and the queries they stand for.
pub(super) struct Tickets {
    taken: Reg,
    queries: Memory,
    bits: usize,
    /// Queries that hold a ticket or may still ask for one.
    under_way: Reg,
    /// Some ticket is free.
    pub any_free: Expr,
    /// The lowest free one.
    pub free: Expr,
}

impl Tickets {
    /// All free after reset.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let count = config.tickets() as usize;
        let bits = address_width(count);
        let taken = m.reg_reset("taken", count, 0);
        let queries = m.memory("tickets", 1 << bits, width(&records::query(config)));
        let free = m.wire("free_ticket", &index_of(&lowest(&!&taken), bits));
        let under_way = m.reg_reset("under_way", index_bits(config.tickets() + 1) as usize, 0);
        Self { any_free: !taken.all(), taken, queries, bits, under_way, free }
    }

    /// One more query may be compared: none waits for a ticket afterwards.
    pub fn admit(&self) -> Expr {
        self.under_way.lt_lit(self.taken.width() as u128)
    }

    /// The query of the ticket that a result bears; read where `enable` is set.
    pub fn query(&self, m: &mut Module, config: &Config, enable: &Expr, number: &Expr) -> Record {
        let query = m.read_if(&self.queries, "ticket_query", enable, &number.trunc(self.bits));
        Record::unpack(&records::query(config), &query)
    }

    /// The free ticket is taken for a query that misses; the one that a result bears comes back where `returns` is set.
    pub fn update(self, m: &mut Module, check: &Check, returns: &Expr, number: &Expr) {
        m.write(&self.queries, &check.misses, &self.free, &check.query.pack());
        let count = self.taken.width();
        let taken = decode(&check.misses, &self.free, count);
        let returned = decode(returns, &number.trunc(self.bits), count);
        let [enters, answered, returns] =
            [&check.enters, &check.answered, returns].map(|change| change.zext(self.under_way.width()));
        m.next(&self.under_way, &(&self.under_way + enters - answered - returns));
        m.next(&self.taken, &((&self.taken | taken) & !returned));
    }
}
