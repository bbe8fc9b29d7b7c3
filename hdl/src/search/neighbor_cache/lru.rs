//! The cache's entries: which hold a neighborhood, who reads them, and the order of their use (the LRU cache manager with its
//! locks of thesis 6.6.3).
//!
//! The order is an age matrix: for each pair of entries a bit that says which of the two was used before the other.

use std::cmp::Ordering;

use pointcore_contract::search::Config;
use pointcore_contract::splat::config::index_bits;

use super::deliver;
use crate::search::parts::sets::{contains, decode, index_of, set};
use rtl::{Expr, Module, Reg, bit, lit};

/// Bits of a version: far more neighborhoods than an entry is given to while a comparison with it is under way.
pub(super) const VERSION_BITS: u32 = 8;

/// An entry that something happens to in a cycle, if at all.
#[derive(Clone, Copy)]
pub(super) struct Chosen {
    pub valid: Expr,
    pub entry: Expr,
}

/// What happens to the entries in a cycle.
pub(super) struct Uses {
    /// The settings change.
    pub setup: Expr,
    /// A query is answered from an entry.
    pub hit: Chosen,
    /// The victim is given to another neighborhood.
    pub start: Expr,
    /// It has all of it, and is to be delivered.
    pub end: Chosen,
    /// Its comparison value is known.
    pub judged: Chosen,
    /// Its neighbors have been delivered once.
    pub release: Chosen,
}

/// The state of all entries.
pub(super) struct Entries {
    present: Reg,
    writing: Reg,
    /// Those `writing` whose comparison value follows from old settings.
    stale: Reg,
    versions: Vec<Reg>,
    readers: Vec<Reg>,
    /// Those that a query was answered from or that were given away in the last cycle: their ages and readers follow.
    used: Reg,
    /// For each entry but the first, which of those before it were used earlier.
    older: Vec<Reg>,
    /// The least recently used entry that is neither read nor written; valid if there is one.
    pub victim: Chosen,
    /// The same as a set.
    victims: Expr,
}

/// The member of `eligible` that was used before all others of it, alone.
fn oldest(m: &mut Module, eligible: Expr, older: &[Reg]) -> Expr {
    let entries = eligible.width();
    let used_before = |entry: u32, other: u32| match other.cmp(&entry) {
        Ordering::Less => older[entry as usize - 1].bit(other),
        Ordering::Equal => bit(false),
        Ordering::Greater => !older[other as usize - 1].bit(entry),
    };
    let mut is_oldest = |entry: u32| {
        let before = set(&(0..entries).map(|other| used_before(entry, other)).collect::<Vec<_>>());
        let before = m.wire(&format!("before_{entry}"), eligible & before);
        eligible.bit(entry) & before.is_zero()
    };
    set(&(0..entries).map(&mut is_oldest).collect::<Vec<_>>())
}

impl Entries {
    /// After reset none is present and they count as used in order, entry 0 first.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let count = config.neighbor_cache;
        let [present, writing, stale] = ["present", "writing", "stale"].map(|name| m.reg_reset(name, count, 0));
        let versions = (0..count).map(|entry| m.reg_reset(&format!("version_{entry}"), VERSION_BITS, 0)).collect();
        // Those who wait in the queue of deliveries, and the one that is served.
        let readers_bits = index_bits(deliver::DEPTH + 2);
        let readers: Vec<_> =
            (0..count).map(|entry| m.reg_reset(&format!("readers_{entry}"), readers_bits, 0)).collect();
        let all = |width: u32| (1 << width) - 1;
        let older: Vec<_> =
            (1..count).map(|entry| m.reg_reset(&format!("older_than_{entry}"), entry, all(entry))).collect();

        let read = set(&readers.iter().map(|readers| readers.any()).collect::<Vec<_>>());
        let used = m.reg_reset("used", count, 0);
        let eligible = m.wire("eligible", !(read | writing | used));
        let chosen = oldest(m, eligible, &older);
        let victims = m.wire("oldest", chosen);
        let victim = m.wire("victim", index_of(victims, config.entry_bits()));
        let victim = Chosen { valid: eligible.any(), entry: victim };
        Self { present, writing, stale, versions, readers, used, older, victim, victims }
    }

    /// Whether the entry holds a neighborhood that may be reused.
    pub fn is_present(&self, entry: Expr) -> Expr {
        contains(self.present, entry)
    }

    /// The number of neighborhoods that the entry was given to so far, modulo a power of two.
    pub fn version(&self, entry: Expr) -> Expr {
        entry.pick(self.versions.iter().copied())
    }

    /// The entries as they are after a cycle. A hit and a start never come together.
    pub fn update(self, m: &mut Module, uses: &Uses) {
        let Self { present, writing, stale, versions, readers, used, older, victims, .. } = self;
        let count = present.width();
        let events = [("hit", uses.hit), ("end", uses.end), ("judged", uses.judged), ("release", uses.release)];
        let [hit, end, judged, release] =
            events.map(|(name, chosen)| m.wire(&format!("{name}_set"), decode(chosen.valid, chosen.entry, count)));
        let start = m.wire("start_set", victims & uses.start.repeat(count));
        let setup = uses.setup.repeat(count);
        m.next(present, ((present & !start) | (judged & !stale)) & !setup);
        m.next(writing, (writing | start) & !judged);
        m.next(stale, (stale | (writing & setup)) & !judged);
        for (entry, version) in (0..).zip(versions) {
            m.next_if(version, start.bit(entry), version.add_lit(1));
        }

        // One whose neighbors have all come is written until it is judged.
        let more = m.reg_reset("more_readers", count, 0);
        m.next(more, hit | end);
        for (entry, &readers) in (0..).zip(&readers) {
            let [up, down] = [more.expr(), release].map(|set| set.bit(entry).zext(readers.width()));
            m.next(readers, readers + up - down);
        }
        let none_read = (0..).zip(&readers).map(|(entry, readers)| readers.is_zero() & release.bit(entry));
        m.assert("released_entries_have_readers", !none_read.fold(bit(false), |any, faulty| any | faulty));

        m.next(used, hit | start);
        for (entry, older) in (1..).zip(older) {
            let width = older.width();
            let now = used.bit(entry).mux(!lit(width, 0), older & !used.trunc(width));
            m.next(older, now);
        }
    }
}
