//! AXI4 slave that is only written (`docs/interfaces.md`): bursts of 64-bit words into the core's memories; golden twin:
//! `pointcore_golden::bus::window`.
//!
//! A write burst is judged in the cycle after its address was taken, from registers; its words follow.

use pointcore_contract::bus::axi::{ReadBeat, WriteAnswer};
use pointcore_contract::bus::config::{ID_BITS, TREE_WORD_BITS};
use pointcore_contract::bus::units::window::Ports;
use pointcore_contract::bus::units::{WindowWrite, window_bits};

use super::{INCREMENTING, LENGTH_BITS, OKAY, SLAVE_ERROR, size_of};
use crate::units::ports::{ChannelInPorts, ChannelOutPorts, PulseOutPorts, WordPort};
use crate::units::wires::Bundle;
use rtl::{Expr, Module, bit, lit};

const WORD_BITS: u32 = TREE_WORD_BITS;
const WORD_BYTES: u32 = WORD_BITS / 8;
/// Bits of a byte's place in its word.
const BYTE_BITS: u32 = WORD_BYTES.ilog2();

/// The unit with `2^index_bits` words; ports as in `contract::bus::units::window`.
#[must_use]
pub fn module(index_bits: u32) -> Module {
    let mut m = Module::new("bus_window", "Takes bursts of words into a memory, and refuses all others.");
    m.parameter("index_bits", index_bits);
    let locked = Ports::ALL.locked.declare_word(&mut m, 1);
    let refused_write = writes(&mut m, index_bits, locked);
    let read = reads(&mut m, index_bits);
    // A refused read waits for the pulse where a write is refused at the same time: every burst counts.
    let read_waits = m.reg_reset("read_waits", 1, 0);
    m.next(read_waits, read | (read_waits & refused_write));
    Ports::ALL.refused_burst.event(&mut m, refused_write | read_waits);
    m
}

/// The write half; returns where a burst ends that is refused for what it is.
fn writes(m: &mut Module, index_bits: u32, locked: Expr) -> Expr {
    let [is_judged, takes_words, bvalid] =
        ["is_judged", "takes_words", "s_axi_bvalid"].map(|name| m.reg_reset(name, 1, 0));
    let awready = !(is_judged | takes_words | bvalid);
    let awready = m.wire("address_ready", awready);
    let ports = Ports::ALL;
    let address_bits = window_bits(index_bits).address;
    let (awvalid, burst) = ports.host.write_address.declare(m, &address_bits, awready);
    let begins = m.wire("begins", awvalid & awready);
    m.next(is_judged, begins);

    let bid = m.reg("s_axi_bid", ID_BITS);
    m.next_if(bid, begins, burst.id);
    let is_plain = m.reg("is_plain", 1);
    let aligned = burst.address.trunc(BYTE_BITS).is_zero();
    let plain = burst.burst.eq(INCREMENTING.expr()) & burst.size.eq(size_of(WORD_BYTES)) & aligned;
    // A window smaller than the range of its addresses is at their beginning.
    let end_bits = BYTE_BITS + index_bits;
    let begins_inside =
        if address_bits > end_bits { burst.address.bits(address_bits - 1, end_bits).is_zero() } else { bit(true) };
    m.next_if(is_plain, begins, plain & begins_inside);
    let index = m.reg("index", index_bits);
    let left = m.reg("left", LENGTH_BITS);
    let width = index_bits.max(LENGTH_BITS) + 1;
    let last_index = index.zext(width) + left.zext(width);
    let is_inside = last_index.bits(width - 1, index_bits).is_zero();
    let fits = m.wire("fits", is_plain & is_inside);
    // Refused for what it is, or because the core is at work; neither while its words are written.
    let [is_refused, is_busy] = ["is_refused", "is_busy"].map(|name| m.reg(name, 1));

    let (wvalid, beat) = ports.host.write_data.declare(m, &WORD_BITS, takes_words);
    let takes = m.wire("takes", takes_words & wvalid);
    let at_end = m.wire("at_end", left.is_zero());
    let ends = m.wire("ends", takes & at_end);
    let is_bad = m.wire("is_bad", !beat.strobes.all() | (beat.last ^ at_end));
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
    let written = WindowWrite { index: index.expr(), data: beat.data };
    let written = written.register(m, &index_bits, "write_", bit(true));
    ports.write.drive(m, &index_bits, write_valid, written);

    ports.host.write_answer.drive_with(m, &(), bvalid, |m, bready| {
        m.next(bvalid, ends | (bvalid & !bready));
        let is_error = m.reg("is_error", 1);
        m.next_if(is_error, ends, spoiled | is_busy);
        WriteAnswer { id: bid.expr(), response: is_error.mux(SLAVE_ERROR.expr(), OKAY.expr()) }
    });
    ports.refused_busy.event(m, ends & is_busy);
    ports.occupied.drive_word(m, is_judged | takes_words);
    m.wire("refused_write", ends & spoiled)
}

fn index_of(address: Expr, index_bits: u32) -> Expr {
    address.bits(BYTE_BITS + index_bits - 1, BYTE_BITS)
}

/// The read half, which answers all with errors; returns where a burst begins.
fn reads(m: &mut Module, index_bits: u32) -> Expr {
    let rvalid = m.reg_reset("s_axi_rvalid", 1, 0);
    let (arvalid, burst) = Ports::ALL.host.read_address.declare(m, &window_bits(index_bits).address, !rvalid);
    let begins = m.wire("read_begins", arvalid & !rvalid);
    Ports::ALL.host.read_data.drive_with(m, &WORD_BITS, rvalid, |m, rready| {
        let rid = m.reg("s_axi_rid", ID_BITS);
        m.next_if(rid, begins, burst.id);
        let left = m.reg("beats_left", LENGTH_BITS);
        let takes = m.wire("beat_goes", rvalid & rready);
        m.next_if(left, begins | takes, begins.mux(burst.length, left.sub_lit(1)));
        let at_end = m.wire("reads_last", left.is_zero());
        m.next(rvalid, begins | (rvalid & !(takes & at_end)));
        ReadBeat { id: rid.expr(), data: lit(WORD_BITS, 0), response: SLAVE_ERROR.expr(), last: at_end }
    });
    begins
}
