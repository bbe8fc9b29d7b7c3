//! Delivers neighborhoods: an entry's neighbors one after the other, under the number of the query they answer.

use pointcore_contract::record;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{CachedResult, QueryResult};
use pointcore_contract::search::units::neighbor_cache::PORTS;

use super::lru::Chosen;
use super::neighborhoods::Neighborhoods;
use crate::search::parts::neighbor::{Neighbor, with_sign};
use crate::stream::fifo;
use crate::units::passage::Passage;
use crate::units::ports::{QueueOut, StreamOutPorts};
use crate::units::wires::{Bundle, layout};
use rtl::{Expr, Module, lit};

/// Answers that may wait.
pub(super) const DEPTH: u32 = 4;

/// What is known of an answer.
#[record(config: Config)]
struct Delivery {
    /// The entry that holds the neighbors.
    #[bits(config.entry_bits())]
    entry: u8,
    /// The query's number.
    #[bits(config.index_bits)]
    number: u32,
    /// The neighborhood is reused.
    cached: bool,
}

/// What of a result is not read from memory.
#[record(config: Config)]
struct Known {
    /// The query's number.
    #[bits(config.index_bits)]
    number: u32,
    /// Closes the query.
    last: bool,
    /// There is a neighbor.
    found: bool,
    /// The neighborhood is reused.
    cached: bool,
}

/// The answers that wait.
pub(super) struct Deliveries {
    queue: Passage<Delivery>,
    result: QueueOut<CachedResult>,
    /// An answer can be pushed in this cycle.
    pub room: Expr,
}

/// A query answered in this cycle, if at all.
#[derive(Clone, Copy)]
pub(super) struct Answer {
    pub by: Chosen,
    pub number: Expr,
}

impl Deliveries {
    /// None after reset.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let queue = Passage::place(m, "deliver_queue", fifo(DEPTH, &layout::<Delivery>(config)));
        let room = queue.room(m);
        Self { queue, result: PORTS.result.queue(m, config), room }
    }

    /// Sends one answer after the other; of `cached` and `searched` never both are there. Returns the entry that has been
    /// sent.
    pub fn send(
        self,
        m: &mut Module,
        config: &Config,
        [cached, searched]: [Answer; 2],
        from: &Neighborhoods,
    ) -> Chosen {
        let Self { queue, result, .. } = self;
        let is_cached = cached.by.valid;
        let is_there = is_cached | searched.by.valid;
        let [cached, searched] = [cached, searched].map(|answer| Delivery {
            entry: answer.by.entry,
            number: answer.number,
            cached: is_cached,
        });
        let delivery = Delivery { cached: is_cached, ..Delivery::choose(config, is_cached, cached, searched) };
        queue.push(m, config, is_there, delivery);

        // d0: an answer and the rank of its next neighbor.
        let head = queue.out(m, config);
        let d0_valid = m.reg_reset("d0_valid", 1, 0);
        let takes = m.wire("d0_takes", !d0_valid & head.valid);
        m.drive(head.ready, !d0_valid);
        let answer = head.record.register(m, config, "d0_", takes);
        let count = from.count(m, takes, head.record.entry);
        let rank_bits = config.rank_bits();
        let rank = m.reg("d0_rank", rank_bits);
        let next_rank = m.reg("d0_next_rank", rank_bits);

        // d1: the neighbor is read.
        let d1_valid = m.reg_reset("d1_valid", 1, 0);
        let advance = m.wire("d_advance", !d1_valid | result.room);
        let reads = m.wire("d0_reads", d0_valid & advance);
        // Ranks are counted up to the last one: it need not be told from those behind it.
        let last = m.wire("d0_last", next_rank.eq(count) | count.is_zero());
        let releases = m.wire("releases", reads & last);
        m.next_if(rank, takes | reads, takes.mux(lit(rank_bits, 0), next_rank));
        m.next_if(next_rank, takes | reads, takes.mux(lit(rank_bits, 1), next_rank.add_lit(1)));
        m.next(d0_valid, takes | (d0_valid & !releases));
        m.next_if(d1_valid, advance, d0_valid);
        let known = Known { number: answer.number, last, found: count.any(), cached: answer.cached };
        let Known { number, last, found, cached } = known.register(m, config, "d1_", reads);
        let neighbor = from.neighbor(m, config, reads, answer.entry, *rank);
        let neighbor = Neighbor::choose(config, found, neighbor, Neighbor::zeros(config));
        let sends = d1_valid & result.room;
        let (index, distance2) = (neighbor.index, with_sign(neighbor.distance2));
        let next = QueryResult { number, last, found, index, distance2 };
        result.push(m, config, sends, CachedResult { result: next, cached });
        Chosen { valid: releases, entry: answer.entry }
    }
}
