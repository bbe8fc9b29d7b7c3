//! The neighbors of all entries.

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;

use super::lru::Chosen;
use crate::units::records::{Record, width};
use rtl::{Expr, Memory, Module, address_width, cat};

/// What is kept of a neighbor.
pub(super) fn neighbor_fields(config: &Config) -> Vec<Field> {
    let kept = |(name, _): &Field| ["index", "distance2"].contains(&name.as_str());
    records::result(config).into_iter().filter(kept).collect()
}

/// Words of a memory with one for each entry; a memory has two at least.
pub(super) fn entry_words(config: &Config) -> u32 {
    config.neighbor_cache.max(2)
}

/// A memory of neighbors by entry and rank, and one of their numbers by entry.
pub(super) struct Neighborhoods {
    fields: Vec<Field>,
    neighbors: Memory,
    counts: Memory,
    rank_bits: u32,
}

impl Neighborhoods {
    /// Unknown contents.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let (fields, words) = (neighbor_fields(config), entry_words(config));
        let rank_bits = address_width(config.neighbors);
        let neighbors = m.memory_unordered("neighborhoods", words << rank_bits, width(&fields));
        let counts = m.memory("counts", words, config.rank_bits());
        Self { fields, neighbors, counts, rank_bits }
    }

    fn address(&self, entry: Expr, rank: Expr) -> Expr {
        cat([entry, rank.trunc(self.rank_bits)])
    }

    /// The neighbor of a rank, in the cycle after `enable`.
    pub fn neighbor(&self, m: &mut Module, enable: Expr, entry: Expr, rank: Expr) -> Record {
        let neighbor = m.read_if(self.neighbors, "neighbor", enable, self.address(entry, rank));
        Record::unpack(&self.fields, neighbor)
    }

    /// The number of an entry's neighbors, in the cycle after `enable` and until the next.
    pub fn count(&self, m: &mut Module, enable: Expr, entry: Expr) -> Expr {
        m.read_if(self.counts, "count", enable, entry)
    }

    /// Writes a neighbor.
    pub fn store(&self, m: &mut Module, to: &Chosen, rank: Expr, neighbor: &Record) {
        m.write(self.neighbors, to.valid, self.address(to.entry, rank), neighbor.only(&self.fields).pack());
    }

    /// Writes how many neighbors there are.
    pub fn close(&self, m: &mut Module, to: &Chosen, count: Expr) {
        m.write(self.counts, to.valid, to.entry, count);
    }
}
