//! Brings splat copies into the order of their tiles by the heap, which sorts pointers to payloads (thesis 5.5.2);
//! golden twin: `pointcore_golden::splat::reorder`.

use pointcore_contract::splat::{Config, records};

use super::heap;
use crate::stream::{fifo, half_buffer};
use crate::units::records::{Record, half_in, half_out, layout};
use crate::units::sliced::Sliced;
use rtl::Module;

/// The unit; ports as in `contract::splat::ports::reorder`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let pointer_bits = config.heap_levels;
    let pointers = 1 << pointer_bits;
    let payload = records::payload(config);
    let mut m = Module::new("splat_reorder", "Orders splat copies by tile; their payloads wait in a memory.");
    m.parameter("levels", pointer_bits);
    let copy = records::copy(config);
    let head = half_in(&mut m, "in", &copy);
    let out = half_out(&mut m, "out", &copy);
    let caught = m.instance("caught", half_buffer(&layout(&copy)));
    let heap = m.instance("heap", heap::module(config));
    let returned = m.instance("returned", fifo(pointers, &[("pointer", pointer_bits)]));

    let (accepts, empty) = (m.out(heap, "in_ready"), m.out(heap, "empty"));
    let first = m.stream_from(heap, "out");
    let reused = m.stream_from(returned, "out");

    // A free pointer waits for the next copy: one that was never used, or else one that came back.
    let free_valid = m.reg_reset("free_valid", 1, 0);
    let free = m.reg("free", pointer_bits);
    let fresh = m.reg_reset("fresh", pointer_bits + 1, 0);
    let all_used = m.wire("all_used", fresh.msb());
    m.next_if(free, !free_valid, all_used.mux(reused.field("pointer"), fresh.trunc(pointer_bits)));
    m.next_if(fresh, !(free_valid | all_used), fresh.add_lit(1));
    m.ready(&reused, !free_valid & all_used);

    // Insertion. The payload is written as long as the copy is offered: nobody reads at a free pointer.
    let draining = m.reg_reset("draining", 1, 0);
    let open = m.wire("open", head.valid & !draining);
    let head_end = head.field("end");
    let offer = m.wire("offer", (open & !head_end) & free_valid);
    let insert = m.wire("insert", offer & accepts);
    m.connect(heap, "in_valid", offer);
    m.connect(heap, "in_tile", head.field("tile"));
    m.connect(heap, "in_pointer", free);
    let has_free = !all_used | reused.valid;
    m.next(free_valid, free_valid.mux(!insert, has_free));
    let take_end = m.wire("take_end", open & head_end);
    m.ready(&head, insert | take_end);
    let word = Record::from(&head).only(&payload).pack();
    let payloads = Sliced::new(&mut m, "payloads", offer, *free, word);

    // The read stage. Its memory is spread over the whole device, so that what it shows is caught before it travels.
    let stage_valid = m.reg_reset("stage_valid", 1, 0);
    let room = m.out(caught, "in_ready");
    let advance = m.wire("advance", !stage_valid | room);
    m.ready(&first, advance);
    let leaving = m.wire("leaving", first.transfer());
    m.next_if(stage_valid, advance, leaving);
    let stage_tile = m.reg("stage_tile", config.tile_bits());
    m.next_if(stage_tile, advance, first.field("tile"));
    let stage_payload = payloads.read_if(&mut m, "stage_payload", advance, first.field("pointer"));
    m.connect(returned, "in_valid", leaving);
    m.connect(returned, "in_pointer", first.field("pointer"));
    let returns = m.out(returned, "in_ready");
    m.assert("pointers_fit", !leaving | returns);

    // The end record follows when everything before it has left.
    let drained = empty & !stage_valid;
    let close = m.wire("close", draining & (drained & room));
    m.next_if(draining, take_end | close, take_end);
    let stored = Record::unpack(&payload, stage_payload);
    m.connect(caught, "in_valid", close | (stage_valid & room));
    let pushed = Record::new(&copy, |name| match name {
        "end" => close,
        "tile" => stage_tile.expr(),
        passed => stored.get(passed),
    });
    pushed.connect(&mut m, caught, "in_");
    let shown = m.stream_from(caught, "out");
    m.ready(&shown, out.room);
    out.push(&mut m, shown.transfer(), |name| shown.field(name));
    m
}
