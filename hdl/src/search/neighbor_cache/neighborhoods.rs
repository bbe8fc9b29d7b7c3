//! The neighbors of all entries.

use pointcore_contract::search::Config;
use pointcore_contract::width;

use super::lru::Chosen;
use crate::search::parts::neighbor::Neighbor;
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Memory, Module, address_width, cat};

/// Words of a memory with one for each entry; a memory has two at least.
pub(super) fn entry_words(config: &Config) -> u32 {
    config.neighbor_cache.max(2)
}

/// A memory of neighbors by entry and rank, and one of their numbers by entry.
pub(super) struct Neighborhoods {
    neighbors: Memory,
    counts: Memory,
    rank_bits: u32,
}

impl Neighborhoods {
    /// Unknown contents.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let words = entry_words(config);
        let rank_bits = address_width(config.neighbors);
        let neighbors = m.memory_unordered("neighborhoods", words << rank_bits, width::<Neighbor>(config));
        let counts = m.memory("counts", words, config.rank_bits());
        Self { neighbors, counts, rank_bits }
    }

    fn address(&self, entry: Expr, rank: Expr) -> Expr {
        cat([entry, rank.trunc(self.rank_bits)])
    }

    /// The neighbor of a rank, in the cycle after `enable`.
    pub fn neighbor(&self, m: &mut Module, config: &Config, enable: Expr, entry: Expr, rank: Expr) -> Neighbor<Wires> {
        let neighbor = m.read_if(self.neighbors, "neighbor", enable, self.address(entry, rank));
        Neighbor::unpack(config, neighbor)
    }

    /// The number of an entry's neighbors, in the cycle after `enable` and until the next.
    pub fn count(&self, m: &mut Module, enable: Expr, entry: Expr) -> Expr {
        m.read_if(self.counts, "count", enable, entry)
    }

    /// Writes a neighbor.
    pub fn store(&self, m: &mut Module, config: &Config, to: Chosen, rank: Expr, neighbor: Neighbor<Wires>) {
        m.write(self.neighbors, to.valid, self.address(to.entry, rank), neighbor.pack(config));
    }

    /// Writes how many neighbors there are.
    pub fn close(&self, m: &mut Module, to: Chosen, count: Expr) {
        m.write(self.counts, to.valid, to.entry, count);
    }
}
