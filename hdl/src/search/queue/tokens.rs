//! What is on its way through the stages: a beat, the item that is chosen of it, and the neighbor that is inserted.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::Candidates;

use super::row::Entry;
use crate::search::parts::neighbor::Neighbor;
use crate::search::parts::sets::{index_of, lowest, set, several};
use crate::units::wires::{Bundle, Registers, Wires};
use rtl::{Expr, Module, Reg, Wire, bit, cat};

/// The beat that chooses its candidates.
pub(super) struct Beat {
    pub valid: Reg,
    /// Its thread's row has to be read from memory.
    pub reads: Reg,
    /// A candidate of it went on before.
    pub began: Reg,
    /// Lanes that are to be chosen.
    pub pending: Reg,
    /// The others, for who asks whether the beat stays: `pending` chooses of hundreds of bits.
    pub settled: Reg,
    pub record: Candidates<Wires>,
}

impl Beat {
    /// Takes its record from `head` where `free` is set.
    pub fn new(m: &mut Module, config: &Config, head: Candidates<Wires>, free: Wire) -> Self {
        Self {
            valid: m.reg_reset("beat_valid", 1, 0),
            reads: m.reg_reset("beat_reads", 1, 0),
            began: m.reg_reset("beat_began", 1, 0),
            pending: m.reg("beat_pending", config.lanes),
            settled: m.reg("beat_settled", config.lanes),
            record: head.register(m, config, "beat_", free),
        }
    }

    /// The lanes that are to be chosen from the next cycle on.
    pub fn next_pending(&self, m: &mut Module, pending: Expr) {
        m.next(self.pending, pending);
        m.next(self.settled, !pending);
        m.assert("pending_or_settled", !self.valid | (self.pending ^ self.settled).all());
    }
}

/// What becomes of the beat in this cycle.
pub(super) struct Choice {
    /// The pending lanes but for the one chosen.
    pub rest: Expr,
    pub any: Expr,
    /// Another is left.
    pub stays: Expr,
    /// The last one is chosen.
    pub ends: Expr,
    pub entry: Entry<Wires>,
}

/// The lanes of a beat that are nearer than each of the limits that counts.
pub(super) fn near_lanes(
    config: &Config,
    beat: &Candidates<Wires>,
    limits: impl Iterator<Item = (Expr, Expr)> + Clone,
) -> Expr {
    let is_near = |distance: Expr| {
        let within = limits.clone().map(|(counts, limit)| !counts | distance.lt(limit));
        within.fold(bit(true), |all, one| all & one)
    };
    let near: Vec<_> = beat.distances[..config.lanes as usize].iter().copied().map(is_near).collect();
    set(&near)
}

impl Choice {
    /// Chooses among the pending lanes; where the beat `moves`, the chosen one goes on.
    pub fn new(m: &mut Module, config: &Config, beat: &Beat, moves: Expr) -> Self {
        let chosen = m.wire("chosen", lowest(beat.pending));
        let rest = m.wire("rest", beat.pending & !chosen);
        let distances = &beat.record.distances[..config.lanes as usize];
        let lanes = distances.iter().enumerate().rev().map(|(lane, &distance)| (lane as u32, distance));
        let nearest = lanes.reduce(|(_, other), (lane, distance)| (lane, chosen.bit(lane).mux(distance, other)));
        let (_, distance2) = nearest.expect("a beat has a lane");
        let address = beat.record.place.address;
        let index = match config.lanes.ilog2() {
            0 => address,
            bits => cat([address, index_of(chosen, bits)]),
        };
        let entry = Entry { found: bit(true), neighbor: Neighbor { index, distance2 } };
        let stays = m.wire("stays", beat.valid & several(!beat.settled));
        let ends = m.wire("ends", moves & !stays);
        Self { any: beat.pending.any(), rest, stays, ends, entry }
    }
}

/// What is compared with the entries of a row.
#[derive(Clone, Copy)]
pub(super) struct Candidate {
    pub entry: Entry<Wires>,
    /// Its distance again, from other registers: a row is wide, and each of its quarters has its own.
    again: [Expr; 3],
}

impl Candidate {
    /// In registers. Of two that are alike synthesis would make one, so some hold the inverse, and some are reset.
    pub fn register(m: &mut Module, config: &Config, entry: Entry<Wires>) -> Self {
        let distance2 = entry.neighbor.distance2;
        let width = distance2.width();
        let inverse = m.reg("item_distance2_inverse", width);
        let after_reset = m.reg_reset("item_distance2_reset", width, 0);
        let inverse_after_reset = m.reg_reset("item_distance2_inverse_reset", width, 0);
        m.next(inverse, !distance2);
        m.next(after_reset, distance2);
        m.next(inverse_after_reset, !distance2);
        let entry = entry.register(m, config, "item_", bit(true));
        Self { entry, again: [!inverse, after_reset.expr(), !inverse_after_reset] }
    }

    /// Whether it is nearer than each of a row's entries.
    pub fn nearer(&self, row: &[Entry<Wires>]) -> Vec<Expr> {
        let [second, third, fourth] = self.again;
        let distances = [self.entry.neighbor.distance2, second, third, fourth];
        let is_nearer =
            |(number, entry): (usize, &Entry<Wires>)| distances[4 * number / row.len()].lt(entry.neighbor.distance2);
        row.iter().enumerate().map(is_nearer).collect()
    }
}

/// A candidate, or none of a beat, on its way to its thread's row.
pub(super) struct Item {
    pub valid: Reg,
    /// Its row is being read from memory.
    pub reads: Reg,
    /// It is not: a register of its own, for thousands of bits of rows are chosen by it.
    pub stays: Reg,
    /// That row holds nothing of its search yet.
    pub fresh: Reg,
    /// It is to be compared with the row at work, with the one that is read, or with the initial one. One thread alone has its row nowhere
    /// but at work.
    pub inserts_here: Reg,
    pub inserts_stored: Option<Reg>,
    pub inserts_initial: Reg,
    pub last: Reg,
    pub thread: Reg,
}

impl Item {
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let mut flag = |name: &str| m.reg_reset(&format!("item_{name}"), 1, 0);
        let [valid, reads, last] = ["valid", "reads", "last"].map(&mut flag);
        let [inserts_here, inserts_initial] = ["inserts_here", "inserts_initial"].map(&mut flag);
        let inserts_stored = (config.threads > 1).then(|| flag("inserts_stored"));
        let thread = m.reg("item_thread", config.thread_bits());
        let stays = m.reg_reset("item_stays", 1, 1);
        let fresh = m.reg("item_fresh", 1);
        Self { valid, reads, stays, fresh, inserts_here, inserts_stored, inserts_initial, last, thread }
    }
}

/// A candidate at the working row.
pub(super) struct Insertion {
    /// The entries that it is nearer than: none where it is not to be inserted.
    pub nearer: Reg,
    pub entry: Registers<Entry<Wires>>,
    pub last: Reg,
    pub thread: Reg,
}

impl Insertion {
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let entry = Registers::new(m, config, "new_");
        let nearer = m.reg_reset("nearer", config.neighbors, 0);
        let (last, thread) = (m.reg_reset("new_last", 1, 0), m.reg("new_thread", config.thread_bits()));
        Self { nearer, entry, last, thread }
    }

    /// Takes an item's candidate, which is `nearer` than some entries.
    pub fn take(&self, m: &mut Module, config: &Config, item: &Item, nearer: Expr, candidate: Candidate) {
        m.next(self.nearer, nearer);
        self.entry.next(m, config, candidate.entry);
        m.next(self.last, item.last);
        m.next(self.thread, item.thread);
    }
}
