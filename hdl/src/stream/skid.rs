//! `stream_skid`: two registers that cut every path between the two sides at full rate; golden twin:
//! `pointcore_golden::stream::Skid`.
//!
//! It is a queue of two: `out` shows its head, `in_ready` is set while it holds fewer than two, and an item pushed in
//! cycle `t` into an empty queue is seen at `t + 1`.

use super::item_width;
use crate::units::twins::{next_twins, twins};
use rtl::Module;

/// A queue of two items in registers.
#[must_use]
pub fn skid(layout: &[(impl AsRef<str>, u32)]) -> Module {
    let mut m = Module::new("stream_skid", "Queue of two in registers.");
    let width = item_width(layout);
    m.variant("width", width);
    let input = m.packed_in("in", layout);
    let item = input.data;

    let head_filled = m.reg_reset("head_filled", 1, 0);
    // Whether the second place is filled moves what may be hundreds of flip-flops; whoever gives asks the inverse.
    let [second_filled, room] = twins(&mut m, ["second_filled", "room"]);
    let head = m.reg("head", width);
    let second = m.reg("second", width);

    let out_ready = m.packed_out("out", head_filled, head, layout);
    m.drive(input.ready, room);

    // The head is free or leaves: the second item, or else the one that comes in, takes its place.
    let advance = m.wire("advance", !head_filled | out_ready);
    let some_item = m.wire("some_item", second_filled | input.valid);
    m.next_if(head_filled, advance, some_item);
    m.next_if(head, advance, second_filled.mux(second, item));
    next_twins(&mut m, "second_filled_or_room", [second_filled, room], !advance & some_item);
    m.next_if(second, !second_filled, item);
    m.assert("second_waits_behind_head", head_filled | !second_filled);
    m
}
