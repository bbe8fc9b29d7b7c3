//! AXI4 slave that is only written (`docs/interfaces.md`): bursts of 64-bit words into the core's memories; golden twin:
//! `pointcore_golden::bus::window`.
//!
//! A write burst is judged in the cycle after its address was taken, from registers; its words follow.

use pointcore_contract::bus::config::{ID_BITS, TREE_WORD_BITS};

use super::{ADDRESS_BITS, INCREMENTING, LENGTH_BITS, OKAY, SLAVE_ERROR, size_of};
use crate::units::ports::event_out;
use rtl::{Expr, Module, lit};

const WORD_BITS: u32 = TREE_WORD_BITS;
const WORD_BYTES: u32 = WORD_BITS / 8;
/// Bits of a byte's place in its word.
const BYTE_BITS: u32 = WORD_BYTES.ilog2();

/// What an address channel says of a burst.
struct Address {
    valid: Expr,
    id: Expr,
    address: Expr,
    length: Expr,
    size: Expr,
    burst: Expr,
}

impl Address {
    fn input(m: &mut Module, prefix: &str, ready: Expr) -> Self {
        let valid = m.input(&format!("{prefix}valid"), 1);
        m.output(&format!("{prefix}ready"), ready);
        let mut input = |name: &str, width| m.input(&format!("{prefix}{name}"), width);
        let (id, address) = (input("id", ID_BITS), input("addr", ADDRESS_BITS));
        let (length, size, burst) = (input("len", LENGTH_BITS), input("size", 3), input("burst", 2));
        Self { valid, id, address, length, size, burst }
    }
}

/// The unit with `2^index_bits` words; ports as in `contract::bus::ports::window`.
#[must_use]
pub fn module(index_bits: u32) -> Module {
    let mut m = Module::new("bus_window", "Takes bursts of words into a memory, and refuses all others.");
    m.parameter("index_bits", index_bits);
    let locked = m.input("locked", 1);
    let refused_write = writes(&mut m, index_bits, locked);
    let read = reads(&mut m);
    // A refused read waits for the pulse where a write is refused at the same time: every burst counts.
    let read_waits = m.reg_reset("read_waits", 1, 0);
    m.next(read_waits, read | (read_waits & refused_write));
    event_out(&mut m, "refused_burst", refused_write | read_waits);
    m
}

/// The write half; returns where a burst ends that is refused for what it is.
fn writes(m: &mut Module, index_bits: u32, locked: Expr) -> Expr {
    let [is_judged, takes_words, bvalid] =
        ["is_judged", "takes_words", "s_axi_bvalid"].map(|name| m.reg_reset(name, 1, 0));
    let awready = !(is_judged | takes_words | bvalid);
    let awready = m.wire("address_ready", awready);
    let burst = Address::input(m, "s_axi_aw", awready);
    let begins = m.wire("begins", burst.valid & awready);
    m.next(is_judged, begins);

    let bid = m.reg("s_axi_bid", ID_BITS);
    m.next_if(bid, begins, burst.id);
    let is_plain = m.reg("is_plain", 1);
    let aligned = burst.address.trunc(BYTE_BITS).is_zero();
    let plain = burst.burst.eq(INCREMENTING.expr()) & burst.size.eq(size_of(WORD_BYTES)) & aligned;
    m.next_if(is_plain, begins, plain);
    let index = m.reg("index", index_bits);
    let left = m.reg("left", LENGTH_BITS);
    let width = index_bits.max(LENGTH_BITS) + 1;
    let last_index = index.zext(width) + left.zext(width);
    let is_inside = last_index.bits(width - 1, index_bits).is_zero();
    let fits = m.wire("fits", is_plain & is_inside);
    // Refused for what it is, or because the core is at work; neither while its words are written.
    let [is_refused, is_busy] = ["is_refused", "is_busy"].map(|name| m.reg(name, 1));

    let wvalid = m.input("s_axi_wvalid", 1);
    m.output("s_axi_wready", takes_words);
    let wdata = m.input("s_axi_wdata", WORD_BITS);
    let wstrb = m.input("s_axi_wstrb", WORD_BYTES);
    let wlast = m.input("s_axi_wlast", 1);
    let takes = m.wire("takes", takes_words & wvalid);
    let at_end = m.wire("at_end", left.is_zero());
    let ends = m.wire("ends", takes & at_end);
    let is_bad = m.wire("is_bad", !wstrb.all() | (wlast ^ at_end));
    m.next(takes_words, is_judged | (takes_words & !ends));
    m.next_if(index, begins | takes, begins.mux(index_of(burst.address, index_bits), index.add_lit(1)));
    m.next_if(left, begins | takes, begins.mux(burst.length, left.sub_lit(1)));
    let spoiled = is_refused | (is_bad & !is_busy);
    m.next_if(is_refused, is_judged | takes, is_judged.mux(!fits, spoiled));
    m.next_if(is_busy, is_judged, fits & locked);
    // Bad beats refuse the burst, but not its other beats.
    let is_unfit = m.reg("is_unfit", 1);
    m.next_if(is_unfit, is_judged, !fits);

    let write_valid = m.reg_reset("write_valid", 1, 0);
    m.next(write_valid, takes & !(is_bad | (is_busy | is_unfit)));
    let written = [("index", index.expr()), ("data", wdata)].map(|(name, value)| {
        let register = m.reg(&format!("write_{name}"), value.width());
        m.next(register, value);
        (name, register)
    });
    m.pulse_out("write", "valid", write_valid, written);

    m.output("s_axi_bvalid", bvalid);
    let bready = m.input("s_axi_bready", 1);
    m.next(bvalid, ends | (bvalid & !bready));
    m.output("s_axi_bid", bid);
    let is_error = m.reg("is_error", 1);
    m.next_if(is_error, ends, spoiled | is_busy);
    m.output("s_axi_bresp", is_error.mux(SLAVE_ERROR.expr(), OKAY.expr()));
    event_out(m, "refused_busy", ends & is_busy);
    m.output("occupied", is_judged | takes_words);
    m.wire("refused_write", ends & spoiled)
}

fn index_of(address: Expr, index_bits: u32) -> Expr {
    address.bits(BYTE_BITS + index_bits - 1, BYTE_BITS)
}

/// The read half, which answers all with errors; returns where a burst begins.
fn reads(m: &mut Module) -> Expr {
    let rvalid = m.reg_reset("s_axi_rvalid", 1, 0);
    let burst = Address::input(m, "s_axi_ar", !rvalid);
    let begins = m.wire("read_begins", burst.valid & !rvalid);
    m.output("s_axi_rvalid", rvalid);
    let rready = m.input("s_axi_rready", 1);
    let rid = m.reg("s_axi_rid", ID_BITS);
    m.next_if(rid, begins, burst.id);
    let left = m.reg("beats_left", LENGTH_BITS);
    let takes = m.wire("beat_goes", rvalid & rready);
    m.next_if(left, begins | takes, begins.mux(burst.length, left.sub_lit(1)));
    let at_end = m.wire("reads_last", left.is_zero());
    m.next(rvalid, begins | (rvalid & !(takes & at_end)));
    m.output("s_axi_rid", rid);
    m.output("s_axi_rdata", lit(WORD_BITS, 0));
    m.output("s_axi_rresp", SLAVE_ERROR.expr());
    m.output("s_axi_rlast", at_end);
    begins
}
