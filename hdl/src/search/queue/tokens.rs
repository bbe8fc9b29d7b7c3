//! What is on its way through the stages: a beat, the item that is chosen of it, and the neighbor that is inserted.

use pointcore_contract::search::{Config, records};

use super::row::entry_fields;
use crate::search::parts::sets::{index_of, lowest, set, several};
use crate::units::records::Record;
use rtl::{Expr, Module, Reg, Wire, bit, cat};

/// The beat that chooses its candidates.
pub(super) struct Beat {
    pub valid: Reg,
    /// Its thread's row has to be read from memory.
    pub reads: Reg,
    /// Lanes that are to be chosen.
    pub pending: Reg,
    pub record: Record,
}

impl Beat {
    /// Takes its record from `head` where `free` is set.
    pub fn new(m: &mut Module, config: &Config, head: &Record, free: Wire) -> Self {
        Self {
            valid: m.reg_reset("beat_valid", 1, 0),
            reads: m.reg_reset("beat_reads", 1, 0),
            pending: m.reg("beat_pending", config.lanes),
            record: head.only(&records::candidates(config)).register(m, "beat_", free),
        }
    }
}

/// What becomes of the beat in this cycle.
pub(super) struct Choice {
    /// The pending lanes but for the one chosen.
    pub rest: Expr,
    pub any: Expr,
    pub stays: Expr,
    pub neighbor: Record,
}

fn lane_distance(beat: &Record, lane: u32) -> Expr {
    beat.get(&format!("distance{lane}"))
}

/// The lanes of a beat that are nearer than each of the limits that counts.
pub(super) fn near_lanes(config: &Config, beat: &Record, limits: &[(Expr, Expr)]) -> Expr {
    let is_near = |distance: Expr| {
        let within = limits.iter().map(|(counts, limit)| !*counts | distance.lt(*limit));
        within.fold(bit(true), |all, one| all & one)
    };
    let near: Vec<_> = (0..config.lanes).map(|lane| is_near(lane_distance(beat, lane))).collect();
    set(&near)
}

impl Choice {
    /// Chooses among the pending lanes.
    pub fn new(m: &mut Module, config: &Config, beat: &Beat) -> Self {
        let chosen = m.wire("chosen", lowest(beat.pending));
        let rest = m.wire("rest", beat.pending & !chosen);
        let nearest_lane =
            (1..config.lanes).rev().fold(lane_distance(&beat.record, config.lanes - 1), |other, lane| {
                chosen.bit(lane - 1).mux(lane_distance(&beat.record, lane - 1), other)
            });
        let address = beat.record.get("address");
        let index = match config.lanes.ilog2() {
            0 => address,
            bits => cat([address, index_of(chosen, bits)]),
        };
        let neighbor = Record::new(&entry_fields(config), |name| match name {
            "found" => bit(true),
            "index" => index,
            _ => nearest_lane,
        });
        let stays = m.wire("stays", beat.valid & several(beat.pending));
        Self { any: beat.pending.any(), rest, stays, neighbor }
    }
}

/// A candidate, or none of a beat, on its way to its thread's row.
pub(super) struct Item {
    pub valid: Reg,
    /// Its row is being read from memory.
    pub reads: Reg,
    /// That row holds nothing of its search yet.
    pub fresh: Reg,
    pub inserts: Reg,
    pub last: Reg,
    pub thread: Reg,
}

impl Item {
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let mut flag = |name: &str| m.reg_reset(&format!("item_{name}"), 1, 0);
        let [valid, reads, inserts, last] = ["valid", "reads", "inserts", "last"].map(&mut flag);
        let thread = m.reg("item_thread", config.thread_bits());
        Self { valid, reads, fresh: m.reg("item_fresh", 1), inserts, last, thread }
    }
}

/// A candidate at the working row.
pub(super) struct Insertion {
    /// The entries that it is nearer than: none where it is not to be inserted.
    pub nearer: Reg,
    fields: Vec<Reg>,
    pub neighbor: Record,
    pub last: Reg,
    pub thread: Reg,
}

impl Insertion {
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let names = entry_fields(config);
        let fields: Vec<_> = names.iter().map(|(name, width)| m.reg(&format!("new_{name}"), *width)).collect();
        let mut values = fields.iter();
        let neighbor = Record::new(&names, |_| values.next().expect("a register for every field").expr());
        Self {
            nearer: m.reg_reset("nearer", config.neighbors, 0),
            fields,
            neighbor,
            last: m.reg_reset("new_last", 1, 0),
            thread: m.reg("new_thread", config.thread_bits()),
        }
    }

    /// Takes an item's candidate, which is `nearer` than some entries.
    pub fn take(&self, m: &mut Module, config: &Config, item: &Item, nearer: Expr, candidate: &Record) {
        m.next(self.nearer, nearer & item.inserts.repeat(self.nearer.width()));
        for ((name, _), register) in entry_fields(config).iter().zip(&self.fields) {
            m.next(*register, candidate.get(name));
        }
        m.next(self.last, item.last);
        m.next(self.thread, item.thread);
    }
}
