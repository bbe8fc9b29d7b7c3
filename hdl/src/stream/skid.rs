//! `stream_skid`: two registers that cut every path between the two sides at full rate; golden twin:
//! `pointcore_golden::stream::Skid`.
//!
//! It is a queue of two: `out` shows its head, `in_ready` is set while it holds fewer than two, and an item pushed in
//! cycle `t` into an empty queue is seen at `t + 1`.

use super::{Pushes, item_width};
use rtl::{Module, bit};

/// A queue of two items in registers.
#[must_use]
pub fn skid(layout: &[(impl AsRef<str>, u32)]) -> Module {
    queue(layout, Pushes::ForGood)
}

/// A [`skid`] of items that are taken back unless `in_kept` is set in the cycle after they were pushed.
#[must_use]
pub fn tentative_skid(layout: &[(impl AsRef<str>, u32)]) -> Module {
    queue(layout, Pushes::Tentative)
}

fn queue(layout: &[(impl AsRef<str>, u32)], pushes: Pushes) -> Module {
    let mut m = Module::new("stream_skid", "Queue of two in registers.");
    let width = item_width(layout);
    m.variant("width", width);
    let input = m.packed_in("in", layout);
    let item = input.data;

    let head_filled = m.reg_reset("head_filled", 1, 0);
    let second_filled = m.reg_reset("second_filled", 1, 0);
    let taken_back = pushes.taken_back(&mut m);
    // Where the item went that is taken back.
    let new_is_second = m.forward("new_is_second", 1);
    let out_valid = m.wire("out_valid", head_filled & (!taken_back | new_is_second));
    let second_valid = m.wire("second_valid", second_filled & !(taken_back & new_is_second));
    let head = m.reg("head", width);
    let second = m.reg("second", width);

    let out_ready = m.packed_out("out", out_valid, head, layout);
    m.drive(input.ready, !second_valid);

    // The head is free or leaves: the second item, or else the one that comes in, takes its place.
    let advance = m.wire("advance", !out_valid | out_ready);
    let some_item = m.wire("some_item", second_valid | input.valid);
    m.next(head_filled, advance.mux(some_item, out_valid));
    m.next_if(head, advance, second_valid.mux(second, item));
    m.next(second_filled, !advance & some_item);
    m.next_if(second, !second_valid, item);
    let is_second = match pushes {
        Pushes::ForGood => bit(false),
        Pushes::Tentative => {
            let pushed_second = m.reg("pushed_second", 1);
            m.next(pushed_second, !advance);
            pushed_second.expr()
        }
    };
    m.drive(new_is_second, is_second);
    m.assert("second_waits_behind_head", out_valid | !second_valid);
    m
}
