//! The searches under way: a search bears a ticket in place of its query's number, under which the query is kept.

use pointcore_spec::core_b::{Config, records};

use crate::core_b::sets::{decode, index_of, lowest};
use crate::rtl::{Expr, Memory, Module, Reg};
use crate::units::records::{Record, width};

/// The tickets and the queries they stand for.
pub(super) struct Tickets {
    taken: Reg,
    queries: Memory,
    bits: usize,
    /// Some ticket is free.
    pub any_free: Expr,
    /// The lowest free one.
    pub free: Expr,
}

impl Tickets {
    /// All free after reset.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let count = config.tickets() as usize;
        let bits = count.ilog2() as usize;
        let taken = m.reg_reset("taken", count, 0);
        let queries = m.memory("tickets", count, width(&records::query(config)));
        let free = m.wire("free_ticket", &index_of(&lowest(&!&taken), bits));
        Self { any_free: !taken.all(), taken, queries, bits, free }
    }

    /// The query of the ticket that a result bears; read where `enable` is set.
    pub fn query(&self, m: &mut Module, config: &Config, enable: &Expr, number: &Expr) -> Record {
        let query = m.read_if(&self.queries, "ticket_query", enable, &number.trunc(self.bits));
        Record::unpack(&records::query(config), &query)
    }

    /// The free ticket is taken for `query` where `takes` is set; the one that a result bears comes back where `returns` is.
    pub fn update(self, m: &mut Module, takes: &Expr, query: &Record, returns: &Expr, number: &Expr) {
        m.write(&self.queries, takes, &self.free, &query.pack());
        let count = self.taken.width();
        let taken = decode(takes, &self.free, count);
        let returned = decode(returns, &number.trunc(self.bits), count);
        m.next(&self.taken, &((&self.taken | taken) & !returned));
    }
}
