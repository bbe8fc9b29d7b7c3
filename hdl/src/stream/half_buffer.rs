//! `stream_half_buffer`: one register that cuts every path between the two sides at half rate; golden twin:
//! `pointcore_golden::stream::HalfBuffer`.
//!
//! An item pushed in cycle `t` is seen at `t + 1`; there is room again in the cycle after the one in which it leaves. A [`skid`](super::skid)
//! moves an item in every cycle, for twice the flip-flops and a choice before each. Here the register loads whenever it is empty: its
//! enable, which reaches every bit of a wide item, waits for nothing.

use super::item_width;
use rtl::Module;

/// A buffer of one item.
#[must_use]
pub fn half_buffer(layout: &[(impl AsRef<str>, u32)]) -> Module {
    let mut m = Module::new("stream_half_buffer", "One item in a register, at half rate.");
    let width = item_width(layout);
    m.variant("width", width);
    let input = m.packed_in("in", layout);
    let filled = m.reg_reset("filled", 1, 0);
    let item = m.reg("item", width);
    m.drive(input.ready, !filled);
    m.next_if(item, !filled, input.data);

    let out_ready = m.packed_out("out", filled, item, layout);
    m.next(filled, filled.mux(!out_ready, input.valid));
    m
}
