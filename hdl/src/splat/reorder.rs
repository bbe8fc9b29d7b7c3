//! Brings splat copies into the order of their tiles by heap or lists, which sort pointers to the rest of them (thesis 5.5.2);
//! golden twin: `pointcore_golden::splat::reorder`.

use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::Reordering;
use pointcore_contract::splat::records::{HeapEntry, TileCopy, TileDiagonals, TileRectangle};
use pointcore_contract::splat::units::heap;
use pointcore_contract::splat::units::reorder::PORTS;

use crate::stream::fifo;
use crate::units::ports::{StreamInPorts, StreamOutPorts, WordPort, held};
use crate::units::queue::Pushed;
use crate::units::sliced::Sliced;
use crate::units::wires::{Bundle, layout};
use rtl::Module;

/// What of a copy waits in the memory.
#[record(config: Config)]
struct Rest {
    /// Bounds in the tile.
    bounds: TileRectangle,
    /// What they leave of its corners.
    diagonals: TileDiagonals,
    /// Place of its splat's payload.
    #[bits(config.splat_bits())]
    splat: u16,
}

/// A place of the memory.
#[record(config: Config)]
struct Pointer {
    /// Its address.
    #[bits(config.heap_levels)]
    pointer: u16,
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let pointer_bits = config.heap_levels;
    let mut m = Module::new("splat_reorder", "Orders splat copies by tile; what else they have waits in a memory.");
    m.parameter("levels", pointer_bits);
    let head = PORTS.input.half(&mut m, config);
    let out = PORTS.out.half(&mut m, config);
    // Both have the same ports.
    let order = match config.reorder {
        Reordering::Heap => m.instance("heap", super::heap::module(config)),
        Reordering::Lists => m.instance("lists", super::lists::module(config)),
    };
    let queue = fifo(1 << pointer_bits, &layout::<Pointer>(config));
    let (returned, reused) = Pushed::<Pointer>::place(&mut m, config, "returned", queue);
    let first = heap::PORTS.out.of(&mut m, config, order);

    // A free pointer waits for the next copy: one that was never used, or else one that came back.
    let free_valid = m.reg_reset("free_valid", 1, 0);
    let free = m.reg("free", pointer_bits);
    let fresh = m.reg_reset("fresh", pointer_bits + 1, 0);
    let all_used = m.wire("all_used", fresh.msb());
    m.next_if(free, !free_valid, all_used.mux(reused.record.pointer, fresh.trunc(pointer_bits)));
    m.next_if(fresh, !(free_valid | all_used), fresh.add_lit(1));
    m.drive(reused.ready, !free_valid & all_used);

    // Insertion. The rest is written as long as the copy is offered: nobody reads at a free pointer.
    let draining = m.reg_reset("draining", 1, 0);
    let open = m.wire("open", head.valid & !draining);
    let TileCopy { end, bounds, diagonals, tile, splat } = head.record;
    let offer = m.wire("offer", (open & !end) & free_valid);
    let accepts = heap::PORTS.input.offer(&mut m, config, order, offer, HeapEntry { tile, pointer: *free });
    let insert = m.wire("insert", offer & accepts);
    let has_free = !all_used | reused.valid;
    m.next(free_valid, free_valid.mux(!insert, has_free));
    let take_end = m.wire("take_end", open & end);
    m.drive(head.ready, insert | take_end);
    let rest = Rest { bounds, diagonals, splat };
    let rests = Sliced::new(&mut m, "rests", offer, *free, rest.pack(config));

    // The read stage. What its memory shows is caught before it travels.
    let stage_valid = m.reg_reset("stage_valid", 1, 0);
    let advance = m.wire("advance", !stage_valid | out.room);
    m.drive(first.ready, advance);
    let leaving = m.wire("leaving", first.transfer());
    m.next_if(stage_valid, advance, leaving);
    let HeapEntry { tile, pointer } = first.record;
    let tile = held(&mut m, "stage_tile", advance, tile);
    let stored = rests.read_if(&mut m, "stage_rest", advance, pointer);
    m.assert("pointers_fit", !leaving | returned.room);
    returned.push(&mut m, config, leaving, Pointer { pointer });

    // The end record follows when everything before it has left.
    let empty = heap::PORTS.empty.word_of(&mut m, order);
    let drained = empty & !stage_valid;
    let close = m.wire("close", draining & (drained & out.room));
    m.next_if(draining, take_end | close, take_end);
    let Rest { bounds, diagonals, splat } = Rest::unpack(config, stored);
    let leaves = close | (stage_valid & out.room);
    out.push(&mut m, config, leaves, TileCopy { end: close, bounds, diagonals, tile, splat });
    m
}
