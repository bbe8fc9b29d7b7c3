//! Leaves out samples of what moves that lie behind depths in memory; golden twin: `pointcore_golden::splat::occlusion`.

use crate::stream::{fifo, fifo_distributed};
use crate::units::ports::{Pulse, PulseInPorts, StreamInPorts, StreamOutPorts, WordPort, held};
use crate::units::queue::{Head, Pushed};
use crate::units::wires::{Bundle, Wires, layout};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{DEPTH_BITS, OCCLUSION_QUEUE_DEPTH, TILE_SIZE};
use pointcore_contract::splat::records::{DepthRun, PIXEL_BITS, RUN_BITS, Sample, SamplePlace, Slot, SlotTile};
use pointcore_contract::splat::units::occlusion::PORTS;
use rtl::{Expr, Module, address_width, bit, cat, lit};

/// Bits of an `f32`'s fraction, and its exponent field of one.
const FRACTION_BITS: u32 = 23;
const EXPONENT_OF_ONE: u128 = 127;

/// An `f32` below one, truncated to [`DEPTH_BITS`] digits; the largest integer of any other, as bits that are compared as integers have it.
///
/// The operator `float_to_fixed` has what is no number as zero, which would hide everything.
fn fixed(m: &mut Module, depth: Expr) -> Expr {
    let exponent = depth.bits(30, FRACTION_BITS);
    let significand = cat([bit(true), depth.trunc(FRACTION_BITS)]);
    // One half has the exponent before that of one: its leading digit is the first.
    let shift = m.wire("shift", lit(8, EXPONENT_OF_ONE - 1) - exponent);
    let is_small = shift.ge_lit(DEPTH_BITS.into());
    let shifted = significand.shr_by(shift.trunc(address_width(DEPTH_BITS)));
    let is_below_one = !depth.msb() & exponent.lt_lit(EXPONENT_OF_ONE);
    let digits = is_small.mux(lit(DEPTH_BITS, 0), shifted);
    is_below_one.mux(digits, lit(DEPTH_BITS, (1 << DEPTH_BITS) - 1))
}

/// Asks for the depths of tiles of so many rows, a row at a time.
fn ask(m: &mut Module, config: &Config, edge: u32, placed: &Pulse<SlotTile<Wires>>) {
    let queue = fifo_distributed(config.tile_slots, &layout::<SlotTile>(config));
    let (queue, wanted) = Pushed::<SlotTile>::place(m, config, "wanted", queue);
    m.assert("a_tile_has_room", !placed.valid | queue.room);
    queue.push(m, config, placed.valid, placed.record);
    let read = PORTS.depth_read.queue(m, config);
    let bits = edge.ilog2();
    let row = m.reg_reset("row", bits, 0);
    let asks = m.wire("asks", wanted.valid & read.room);
    m.next_if(row, asks, row.add_lit(1));
    m.drive(wanted.ready, asks & row.all());
    let tile = wanted.record.tile;
    let tile = tile.bits(tile.width() - 1, config.bin_bits());
    let pixel = cat([row.expr(), lit(bits, 0)]).zext(PIXEL_BITS);
    let run = DepthRun { tile, pixel, count: lit(RUN_BITS, edge.into()) };
    read.push(m, config, asks, run);
}

/// A depth that came in the cycle before.
struct Fill {
    valid: Expr,
    /// It is the last one of its tile.
    is_last: Expr,
    slot: Expr,
    pixel: Expr,
    depth: Expr,
}

/// Takes depths in the order in which slots got their tiles.
fn fill(m: &mut Module, config: &Config, edge: u32, placed: &Pulse<SlotTile<Wires>>) -> Fill {
    let queue = fifo_distributed(config.tile_slots, &layout::<Slot>(config));
    let (queue, coming) = Pushed::<Slot>::place(m, config, "coming", queue);
    m.assert("a_slot_has_room", !placed.valid | queue.room);
    queue.push(m, config, placed.valid, Slot { slot: placed.record.slot });
    let data = PORTS.depth_data.declare(m, config);
    m.drive(data.ready, coming.valid);
    let takes = m.wire("takes", data.valid & coming.valid);
    let pixel = m.reg_reset("pixel", 2 * edge.ilog2(), 0);
    m.next_if(pixel, takes, pixel.add_lit(1));
    let is_last = pixel.all();
    m.drive(coming.ready, takes & is_last);
    let valid = m.reg_reset("fills", 1, 0);
    m.next(valid, takes);
    let depth = fixed(m, data.record.depth);
    Fill {
        valid: valid.expr(),
        is_last: held(m, "fills_last", bit(true), is_last),
        slot: held(m, "filled_slot", bit(true), coming.record.slot),
        pixel: held(m, "filled_pixel", bit(true), pixel.expr()),
        depth: held(m, "filled_depth", bit(true), depth),
    }
}

/// Whether a slot's depths have come.
fn known(m: &mut Module, config: &Config, placed: &Pulse<SlotTile<Wires>>, fill: &Fill, slot: Expr) -> Expr {
    let known: Vec<_> = (0..config.tile_slots)
        .map(|number| {
            let is = |slot: Expr| slot.eq_lit(number.into());
            let known = m.reg_reset(&format!("known_{number}"), 1, 0);
            let begins = placed.valid & is(placed.record.slot);
            let ends = (fill.valid & fill.is_last) & is(fill.slot);
            m.next_if(known, begins | ends, ends);
            known.expr()
        })
        .collect();
    slot.pick(known)
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    sized(config, TILE_SIZE)
}

/// The unit with so many rows of as many pixels a tile, a power of two: a proof need not wait for many depths.
#[must_use]
pub fn sized(config: &Config, edge: u32) -> Module {
    let mut m = Module::new("splat_occlusion", "Leaves out samples behind depths in memory.");
    m.parameter("slots", config.tile_slots);
    let input = PORTS.input.declare(&mut m, config);
    let head = Head::new(&mut m, config, input);
    let queue = fifo(OCCLUSION_QUEUE_DEPTH, &layout::<Sample>(config));
    let (queue, out) = Pushed::<Sample>::place(&mut m, config, "samples", queue);
    let sent = m.wire("sent", out.transfer());
    PORTS.out.export(&mut m, config, out);
    let placed = PORTS.placed.declare(&mut m, config);
    ask(&mut m, config, edge, &placed);
    let fill = fill(&mut m, config, edge, &placed);

    let SamplePlace { slot, pixel, .. } = head.record.place;
    let may_leave = known(&mut m, config, &placed, &fill, slot);
    // Samples between the head and the next unit.
    let under_way = m.reg_reset("under_way", address_width(OCCLUSION_QUEUE_DEPTH + 1), 0);
    let leaves = m.wire("leaves", (head.valid & may_leave) & under_way.lt_lit(OCCLUSION_QUEUE_DEPTH.into()));
    head.leaves(&mut m, leaves);
    let depths = m.memory_unordered("depths", config.tile_slots * edge * edge, DEPTH_BITS);
    m.write(depths, fill.valid, cat([fill.slot, fill.pixel]), fill.depth);
    let read = m.read(depths, "depth", cat([slot, pixel.trunc(fill.pixel.width())]));
    let was_read = m.reg_reset("was_read", 1, 0);
    m.next(was_read, leaves);
    let sample = head.record.register(&mut m, config, "read_", bit(true));
    let is_tested = m.reg_reset("is_tested", 1, 0);
    m.next(is_tested, was_read);
    let depth = held(&mut m, "stored_depth", bit(true), read);
    let sample = sample.register(&mut m, config, "tested_", bit(true));

    let SamplePlace { inside, last, .. } = sample.place;
    let is_behind = m.wire("is_behind", inside & depth.lt(sample.band.low));
    // One that closes its copy is passed on to say so.
    let kept = m.wire("kept", is_tested & (last | !is_behind));
    let place = SamplePlace { inside: inside & !is_behind, ..sample.place };
    m.assert("a_sample_has_room", !kept | queue.room);
    queue.push(&mut m, config, kept, Sample { place, ..sample });
    let [more, less, dropped] = [leaves, sent, is_tested & !kept].map(|flag| flag.zext(under_way.width()));
    m.next(under_way, under_way + more - less - dropped);
    PORTS.hidden.event(&mut m, is_tested & is_behind);
    m
}
