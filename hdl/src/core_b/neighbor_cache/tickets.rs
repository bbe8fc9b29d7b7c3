//! The searches under way: a search bears a ticket in place of its query's number, under which the query is kept.

use pointcore_spec::core_a::config::index_bits;
use pointcore_spec::core_b::{Config, records};

use crate::core_b::sets::{decode, index_of, lowest};
use crate::rtl::{Expr, Memory, Module, Reg, address_width};
use crate::units::records::{Record, width};

/// The tickets and the queries they stand for.
pub(super) struct Tickets {
    taken: Reg,
    queries: Memory,
    bits: usize,
    taken_count: Reg,
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
        let taken_count = m.reg_reset("taken_count", index_bits(config.tickets() + 1) as usize, 0);
        Self { any_free: !taken.all(), taken, queries, bits, taken_count, free }
    }

    /// One more query may be compared while `compared` are, so that none waits for a ticket afterwards.
    pub fn admit(&self, compared: &Expr) -> Expr {
        let bits = self.taken_count.width().max(compared.width()) + 1;
        (compared.zext(bits) + self.taken_count.zext(bits)).lt_lit(self.taken.width() as u128)
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
        let [more, less] = [takes, returns].map(|change| change.zext(self.taken_count.width()));
        m.next(&self.taken_count, &(&self.taken_count + more - less));
        m.next(&self.taken, &((&self.taken | taken) & !returned));
    }
}
