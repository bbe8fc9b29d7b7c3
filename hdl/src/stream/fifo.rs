//! `stream_fifo`: a queue that cuts every path between its two sides; golden twin: `pointcore_golden::stream::Fifo`.
//!
//! It holds `depth` items: a memory, and an output register that is the memory's read register. An item that is pushed
//! in cycle `t` is in the memory from `t + 1` on, moves to the output register in the first cycle from then on in which
//! that is empty or popped, and is seen at `out` one cycle later: at `t + 2` in an empty queue. `in_ready` falls in the
//! cycle after the one that makes `depth` items and rises in the cycle after a pop. Rate: one item a cycle.

use super::item_width;
use rtl::{Expr, Module, Reg, address_width, cat, lit};

/// Where the items are.
enum Storage {
    Inferred,
    Distributed,
}

/// A queue of `depth` items (at least 2).
#[must_use]
pub fn fifo(depth: u32, layout: &[(impl AsRef<str>, u32)]) -> Module {
    queue(depth, layout, &Storage::Inferred)
}

/// A [`fifo`] in look-up tables: its output comes from flip-flops and so earlier in the cycle than out of a block memory.
#[must_use]
pub fn fifo_distributed(depth: u32, layout: &[(impl AsRef<str>, u32)]) -> Module {
    queue(depth, layout, &Storage::Distributed)
}

fn queue(depth: u32, layout: &[(impl AsRef<str>, u32)], storage: &Storage) -> Module {
    let mut m = Module::new("stream_fifo", "Queue in a memory with a registered output.");
    let width = item_width(layout);
    m.variant("depth", depth);
    m.variant("width", width);
    if let Storage::Distributed = storage {
        m.variant("storage", "distributed");
    }
    let input = m.packed_in("in", layout);

    let address_bits = address_width(depth);
    // Items in the queue, and those of them that wait in the memory. What they are to become is known before it is known whether
    // they change: who takes an item may tell late.
    let held = Count::new(&mut m, "held", depth);
    let waiting = Count::new(&mut m, "waiting", depth);
    let is_full = m.reg_reset("is_full", 1, 0);
    let any_waits = m.reg_reset("any_waits", 1, 0);
    let write_address = m.reg_reset("write_address", address_bits, 0);
    let read_address = m.reg_reset("read_address", address_bits, 0);
    let out_valid = m.reg_reset("out_valid", 1, 0);

    let has_room = m.wire("has_room", !is_full);
    m.drive(input.ready, has_room);
    let push = m.wire("push", input.transfer());
    let entries = match storage {
        Storage::Inferred => m.memory_unordered("entries", depth, width),
        Storage::Distributed => m.memory_distributed("entries", depth, width),
    };
    // What is there when nothing is pushed is written over.
    m.write(entries, has_room, write_address, input.data);

    let out_ready = m.forward("out_taken", 1);
    let pop = m.wire("pop", out_valid & out_ready);
    let fetch = m.wire("fetch", any_waits & (!out_valid | out_ready));
    let item = m.read_if(entries, "item", fetch, read_address);
    m.next(out_valid, fetch | (out_valid & !out_ready));

    held.moves(&mut m, push, pop);
    waiting.moves(&mut m, push, fetch);
    m.next_if(is_full, push ^ pop, push & held.is(depth - 1));
    m.next_if(any_waits, push ^ fetch, push | !waiting.is(1));
    advance(&mut m, write_address, push, depth);
    advance(&mut m, read_address, fetch, depth);
    let [held, waiting] = [held, waiting].map(|count| count.0.expr());
    m.assert("held_in_range", lit(held.width(), depth as u128).ge(held));
    m.assert("held_is_waiting_and_shown", held.eq(waiting + out_valid.zext(held.width())));
    m.assert("full_and_waiting_are_told", is_full.eq(held.eq_lit(depth as u128)) & any_waits.eq(waiting.any()));

    let ready = m.packed_out("out", out_valid, item, layout);
    m.drive(out_ready, ready);
    m
}

/// A count of up to `depth` items.
struct Count(Reg);

impl Count {
    fn new(m: &mut Module, name: &str, depth: u32) -> Self {
        Self(m.reg_reset(name, address_width(depth + 1), 0))
    }

    fn is(&self, items: u32) -> Expr {
        self.0.eq_lit(items.into())
    }

    /// One more, one less, or both.
    fn moves(&self, m: &mut Module, up: Expr, down: Expr) {
        let less = (!up).repeat(self.0.width() - 1);
        m.next_if(self.0, up ^ down, self.0 + cat([less, lit(1, 1)]));
    }
}

/// An address that goes round.
fn advance(m: &mut Module, address: Reg, step: Expr, depth: u32) {
    let next = address.add_lit(1);
    let next = if depth.is_power_of_two() {
        next
    } else {
        let last = address.eq_lit(depth as u128 - 1);
        last.mux(lit(address.width(), 0), next)
    };
    m.next_if(address, step, next);
}
