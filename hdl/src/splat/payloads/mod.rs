//! Keeps what the copies of a splat have in common in one place while they are put in order; golden twin:
//! `pointcore_golden::splat::payloads`.

mod arrival;
mod chip;
mod memory;
mod places;
mod words;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{CompleteCopy, Payload, PlacedCopy};
use pointcore_contract::splat::units::payloads::PORTS;

use crate::units::ports::{Flow, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::sliced::Sliced;
use crate::units::twins::{next_twins, twins};
use crate::units::wires::Bundle;
use places::Places;
use rtl::{Expr, Module, bit};
use words::Words;

/// Where words come from.
enum Store {
    Chip(Sliced),
    Memory(Flow<Expr>),
}

/// The way out: gives copies their payload back; returns the cycles in which one has been read, and its place.
fn leave(m: &mut Module, config: &Config, words: Words, store: Store) -> (Expr, Expr) {
    let next = PORTS.placed.queue(m, config);
    let valid = m.reg_reset("current_valid", 1, 0);
    let beat = (words.count > 1).then(|| match store {
        Store::Chip(_) => m.reg("beat", words.index_bits()),
        Store::Memory(_) => m.reg_reset("beat", words.index_bits(), 0),
    });
    let is_last = beat.map_or(bit(true), |beat| words.is_last(*beat));
    let is_read = match &store {
        Store::Chip(_) => is_last,
        Store::Memory(came) => is_last & came.valid,
    };
    // Where words come in several beats, a copy is completed in a register of its own, which takes the next when it is empty: whether
    // the rasterizer is ready says nothing to the block RAMs, a way across the device.
    // It says by one register what it holds, and by another, which has few loads, that it holds nothing.
    let completes = (words.count > 1).then(|| twins(m, ["complete_valid", "complete_room"]));
    let out_valid = m.reg_reset("out_holds", 1, 0);
    let out_taken = m.forward("out_taken", 1);
    let out_room = m.wire("out_room", !out_valid | out_taken);
    let has_room = completes.map_or(out_room, |[_, room]| room.expr());
    let leaves = m.wire("leaves", (valid & is_read) & has_room);
    let advance = m.wire("advance", !valid | leaves);
    m.drive(next.ready, advance);
    m.next_if(valid, advance, next.valid);
    let current = next.record.register(m, config, "current_", advance);
    let payload = match &store {
        Store::Chip(memory) => chip::read(m, words, beat, advance, [next.record.splat, current.splat], memory),
        Store::Memory(came) => memory::read(m, words, beat, [valid.expr(), has_room], *came),
    };

    // The last word goes straight into a register, beside what was kept.
    let Payload { footprint, moving, attributes } = words.join(config, &payload);
    let PlacedCopy { bounds, diagonals, tile, splat, slot } = current;
    let copy = CompleteCopy { footprint, moving, attributes, bounds, diagonals, tile, slot };
    let (copy, shown) = match completes {
        Some([complete, room]) => {
            let copy = copy.register(m, config, "complete_", !complete);
            let stays = leaves | (complete & !out_room);
            next_twins(m, "complete_or_room", [complete, room], stays);
            (copy, complete.expr())
        }
        None => (copy, leaves),
    };
    let out = copy.register(m, config, "held_out_", out_room);
    m.next_if(out_valid, out_room, shown);
    let out_ready = PORTS.out.drive(m, config, out_valid, out);
    m.drive(out_taken, out_ready);
    (leaves, splat)
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_payloads", "Keeps what the copies of a splat have in common, once.");
    m.parameter("places", config.splats_held());
    m.parameter("beats", config.payload_beats);
    let words = Words::of(config);
    let places = Places::new(&mut m, config);
    let (arrival, store) = if config.has_payloads_in_memory() {
        m.parameter("ahead", config.payload_ahead);
        let arrival = memory::arrive(&mut m, config, words, &places);
        (arrival, Store::Memory(memory::words(&mut m, config, words)))
    } else {
        let (arrival, memory) = chip::arrive(&mut m, config, words, &places);
        (arrival, Store::Chip(memory))
    };
    let left = leave(&mut m, config, words, store);
    let read = places.step(&mut m, config, arrival.closed, arrival.begins, left);
    if config.has_payloads_in_memory() {
        PORTS.read.drive_word(&mut m, read);
    }
    m
}
