//! Delivers neighborhoods: an entry's neighbors one after the other, under the number of the query they answer.

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;

use super::lru::Chosen;
use super::neighborhoods::{Neighborhoods, neighbor_fields};
use crate::stream::fifo;
use crate::units::records::{QueueOut, Record, layout, queue_out};
use rtl::{Expr, Instance, Module, lit};

/// Answers that may wait.
pub(super) const DEPTH: u32 = 4;

/// What is known of an answer.
fn fields(config: &Config) -> Vec<Field> {
    let number = ("number".to_owned(), config.index_bits);
    vec![("entry".to_owned(), config.entry_bits()), number, ("cached".to_owned(), 1)]
}

/// The answers that wait.
pub(super) struct Deliveries {
    queue: Instance,
    result: QueueOut,
    /// An answer can be pushed in this cycle.
    pub room: Expr,
}

/// A query answered in this cycle, if at all.
pub(super) struct Answer {
    pub by: Chosen,
    pub number: Expr,
}

impl Deliveries {
    /// None after reset.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let queue = m.instance("deliver_queue", fifo(DEPTH, &layout(&fields(config))));
        let room = m.out(queue, "in_ready");
        Self { queue, result: queue_out(m, "result", &records::cached_result(config)), room }
    }

    /// Sends one answer after the other; of `cached` and `searched` never both are there. Returns the entry that has been
    /// sent.
    pub fn send(
        self,
        m: &mut Module,
        config: &Config,
        [cached, searched]: [&Answer; 2],
        from: &Neighborhoods,
    ) -> Chosen {
        let Self { queue, result, .. } = self;
        let is_cached = &cached.by.valid;
        m.connect(queue, "in_valid", *is_cached | searched.by.valid);
        m.connect(queue, "in_entry", is_cached.mux(cached.by.entry, searched.by.entry));
        m.connect(queue, "in_number", is_cached.mux(cached.number, searched.number));
        m.connect(queue, "in_cached", *is_cached);

        // d0: an answer and the rank of its next neighbor.
        let head = m.stream_from(queue, "out");
        let d0_valid = m.reg_reset("d0_valid", 1, 0);
        let takes = m.wire("d0_takes", !d0_valid & head.valid);
        m.ready(&head, !d0_valid);
        let answer = Record::from(&head).register(m, "d0_", takes);
        let count = from.count(m, takes, head.field("entry"));
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
        let known = Record::new(&known_fields(config), |name| match name {
            "last" => last,
            "found" => count.any(),
            field => answer.get(field),
        });
        let known = known.register(m, "d1_", reads);
        let neighbor = from.neighbor(m, reads, answer.get("entry"), *rank);
        let neighbor = neighbor.mux(known.get("found"), &Record::zeros(&neighbor_fields(config)));
        let sends = d1_valid & result.room;
        result.push(m, sends, |name| match name {
            "index" | "distance2" => neighbor.get(name),
            field => known.get(field),
        });
        Chosen { valid: releases, entry: answer.get("entry") }
    }
}

/// What of a result is not read from memory.
fn known_fields(config: &Config) -> Vec<Field> {
    let read = neighbor_fields(config);
    records::cached_result(config).into_iter().filter(|field| !read.contains(field)).collect()
}
