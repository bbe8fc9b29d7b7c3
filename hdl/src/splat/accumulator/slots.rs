//! The slots' memories: banks of several slots each, which samples and the tile cache share, and the masks of what counts in a slot.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{SLOT_BANKS, TILE_PIXELS, index_bits};
use pointcore_contract::splat::records::{DrainedPixel, Fill, Pixel, SlotChange, SlotMasks, SlotPixel};
use pointcore_contract::splat::units::accumulator::PORTS;
use pointcore_contract::width;

use crate::units::ports::{OutputPorts, Pulse, PulseInPorts, PulseOutPorts, WordPort, held};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module, bit, cat, lit};

/// The ports through which the tile cache reaches the slots.
pub(super) struct SlotPorts {
    pub change: Pulse<SlotChange<Wires>>,
    pub fill: Pulse<Fill<Wires>>,
    pub drain: Pulse<SlotPixel<Wires>>,
}

impl SlotPorts {
    /// Declares them on the unit.
    pub fn declare(m: &mut Module, config: &Config) -> Self {
        Self {
            change: PORTS.change.declare(m, config),
            fill: PORTS.fill.declare(m, config),
            drain: PORTS.drain.declare(m, config),
        }
    }
}

/// Accesses of the samples to the slots; all but `result` and `changes` come from flip-flops.
pub(super) struct Accesses {
    /// The head may read its pixel.
    pub reads: Expr,
    /// It does.
    pub issues: Expr,
    /// Its place.
    pub read: SlotPixel<Wires>,
    /// A sample may write in the next cycle, and in which slot.
    pub comes: Expr,
    pub coming_slot: Expr,
    /// A sample is in the last stage, its place, and whether it changes its pixel.
    pub ends: Expr,
    pub written: SlotPixel<Wires>,
    pub changes: Expr,
    /// The pixel that is written, as a word.
    pub result: Expr,
}

/// The bank of a slot.
pub(super) fn bank(slot: Expr) -> Expr {
    slot.trunc(SLOT_BANKS.ilog2())
}

/// Whether that is the one of this number.
fn is_in(slot: Expr, number: u32) -> Expr {
    bank(slot).eq_lit(number.into())
}

/// A bit for each bank: that of the slot, if `condition` is set.
fn bank_bit(condition: Expr, slot: Expr) -> Expr {
    cat((0..SLOT_BANKS).rev().map(|number| condition & is_in(slot, number)))
}

/// Which of its bank's slots it is, in a bit at least.
fn row(slot: Expr) -> Expr {
    let bank_bits = SLOT_BANKS.ilog2();
    if slot.width() == bank_bits { lit(1, 0) } else { slot.bits(slot.width() - 1, bank_bits) }
}

/// Where a pixel lies in its bank, of slots of so many pixels.
fn address(place: SlotPixel<Wires>, pixels: u32) -> Expr {
    let pixel = place.pixel.trunc(index_bits(pixels));
    if place.slot.width() == SLOT_BANKS.ilog2() { pixel } else { cat([row(place.slot), pixel]) }
}

/// Shows the tile cache which banks samples leave to it; returns a bit for each bank that one reads.
pub(super) fn show_precedence(m: &mut Module, accesses: &Accesses) -> Expr {
    let reads = m.wire("reads_bank", bank_bit(accesses.reads, accesses.read.slot));
    PORTS.sample_reads.drive_word(m, reads);
    let writes = m.wire("will_write_bank", bank_bit(accesses.comes, accesses.coming_slot));
    PORTS.sample_writes.drive_word(m, writes);
    reads
}

/// The banks: a sample's read or write first, the tile cache's in cycles that it leaves free. Returns the register behind each.
pub(super) fn banks(m: &mut Module, config: &Config, pixels: u32, ports: &SlotPorts, accesses: &Accesses) -> Vec<Expr> {
    let pixel_bits = width::<Pixel>(config);
    let words = config.tile_slots.div_ceil(SLOT_BANKS) * pixels;
    let SlotPorts { fill, drain, .. } = ports;
    let Fill { place: filled, value } = fill.record;
    let value = value.pack(config);
    let mut bank = |number: u32| {
        let memory = m.memory_unordered(&format!("bank_{number}_pixels"), words, pixel_bits);
        let ends = m.wire(&format!("sample_ends_in_{number}"), accesses.ends & is_in(accesses.written.slot, number));
        let filling = fill.valid & is_in(filled.slot, number);
        let write = m.wire(&format!("writes_{number}"), ends.mux(accesses.changes, filling));
        let written = ends.mux(address(accesses.written, pixels), address(filled, pixels));
        m.write(memory, write, written, ends.mux(accesses.result, value));

        let reads = m.wire(&format!("sample_reads_{number}"), accesses.reads & is_in(accesses.read.slot, number));
        let read = reads.mux(address(accesses.read, pixels), address(drain.record, pixels));
        let draining = drain.valid & is_in(drain.record.slot, number);
        let read = m.read_if(memory, &format!("bank_{number}_read"), reads | draining, read);
        let pixel = m.reg(&format!("bank_{number}_pixel"), pixel_bits);
        m.next(pixel, read);
        pixel.expr()
    };
    (0..SLOT_BANKS).map(&mut bank).collect()
}

/// Hands the tile cache what it read, when it is in the registers behind the banks.
pub(super) fn show_drained(
    m: &mut Module,
    config: &Config,
    drain: &Pulse<SlotPixel<Wires>>,
    reads: Expr,
    banks: &[Expr],
) {
    let SlotPixel { slot, pixel } = drain.record;
    let meets = (0..SLOT_BANKS).map(|number| is_in(slot, number) & reads.bit(number));
    let meets = meets.reduce(|all, one| all | one).expect("there are banks");
    let [mut valid, mut of_bank, mut of_pixel] = [drain.valid & !meets, bank(slot), pixel];
    for number in 1..=2 {
        let register = m.reg_reset(&format!("drains_{number}"), 1, 0);
        m.next(register, valid);
        valid = register.expr();
        of_bank = held(m, &format!("drained_bank_{number}"), bit(true), of_bank);
        of_pixel = held(m, &format!("drained_pixel_{number}"), bit(true), of_pixel);
    }
    let value = m.wire("drained_word", of_bank.pick(banks.iter().copied()));
    let drained = DrainedPixel { pixel: of_pixel, value: Pixel::unpack(config, value) };
    PORTS.drained.drive(m, config, valid, drained);
}

/// Which pixels of each slot are written and dirty, bank by bank: a sample that issues marks its own, and a slot that changes begins
/// anew. Returns whether the head's pixel is written.
pub(super) fn masks(m: &mut Module, config: &Config, change: &Pulse<SlotChange<Wires>>, accesses: &Accesses) -> Expr {
    let Accesses { reads, issues, read, .. } = *accesses;
    let SlotChange { slot, held } = change.record;
    let own = m.wire("pixel_bit", lit(TILE_PIXELS, 1).shl_by(read.pixel));
    let begun = cat([held, lit(TILE_PIXELS, 0)]);
    let slots = config.tile_slots.div_ceil(SLOT_BANKS).max(2);
    let mut carried_out = bit(false);
    let mut word = |number: u32| {
        let memory = m.memory_distributed(&format!("bank_{number}_masks"), slots, 2 * TILE_PIXELS);
        let reads = reads & is_in(read.slot, number);
        let address = m.wire(&format!("masked_slot_{number}"), reads.mux(row(read.slot), row(slot)));
        let word = m.read_now(memory, &format!("bank_{number}_mask"), address);
        let changes = m.wire(&format!("changes_{number}"), (change.valid & is_in(slot, number)) & !reads);
        carried_out = carried_out | changes;
        let marks = issues & is_in(read.slot, number);
        m.write(memory, marks | changes, address, reads.mux(word | cat([own, own]), begun));
        word
    };
    let words: Vec<_> = (0..SLOT_BANKS).map(&mut word).collect();
    let before = bank(slot).pick(words.iter().copied());
    let [written, dirty] = [before.bits(2 * TILE_PIXELS - 1, TILE_PIXELS), before.trunc(TILE_PIXELS)];
    let before = SlotMasks { written, dirty }.register(m, config, "masks_", carried_out);
    PORTS.masks.drive(m, config, before);
    let is_written =
        words.into_iter().map(|word| word.bits(2 * TILE_PIXELS - 1, TILE_PIXELS).shr_by(read.pixel).bit(0));
    bank(read.slot).pick(is_written.collect::<Vec<_>>())
}
