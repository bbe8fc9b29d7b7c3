//! The slots' memories: banks of some pixels of every slot, which samples and the tile cache share, and the masks of what counts.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{SLOT_BANKS, TILE_PIXELS, index_bits};
use pointcore_contract::splat::records::{DrainedPixel, Fill, PIXEL_BITS, Pixel, SlotChange, SlotMasks, SlotPixel};
use pointcore_contract::splat::units::accumulator::PORTS;
use pointcore_contract::width;

use crate::units::ports::{OutputPorts, Pulse, PulseInPorts, PulseOutPorts, WordPort, held};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module, bit, cat, lit};

/// Pixels of a tile in a bank.
const BANK_PIXELS: u32 = TILE_PIXELS / SLOT_BANKS;
/// Bits of a pixel's place among them, and of its place among those that are near it.
const PLACE_BITS: u32 = BANK_PIXELS.ilog2();
const NEAR_BITS: u32 = 2;

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
    /// A sample may write in the next cycle, and which pixel.
    pub comes: Expr,
    pub coming_pixel: Expr,
    /// A sample is in the last stage, its place, and whether it changes its pixel.
    pub ends: Expr,
    pub written: SlotPixel<Wires>,
    pub changes: Expr,
    /// The pixel that is written, as a word.
    pub result: Expr,
}

/// The bank of a pixel.
pub(super) fn bank(pixel: Expr) -> Expr {
    pixel.trunc(SLOT_BANKS.ilog2())
}

/// Whether that is the one of this number.
fn is_in(pixel: Expr, number: u32) -> Expr {
    bank(pixel).eq_lit(number.into())
}

/// A bit for each bank: that of the pixel, if `condition` is set.
fn bank_bit(condition: Expr, pixel: Expr) -> Expr {
    cat((0..SLOT_BANKS).rev().map(|number| condition & is_in(pixel, number)))
}

/// Where a pixel lies in its bank, of slots of so many pixels.
fn address(place: SlotPixel<Wires>, pixels: u32) -> Expr {
    let (pixel_bits, bank_bits) = (index_bits(pixels), SLOT_BANKS.ilog2());
    if pixel_bits == bank_bits { place.slot } else { cat([place.slot, place.pixel.bits(pixel_bits - 1, bank_bits)]) }
}

/// The bits of a mask that are of one bank's pixels.
fn half(mask: Expr, number: u32) -> Expr {
    cat((0..BANK_PIXELS).rev().map(|place| mask.bit(place * SLOT_BANKS + number)))
}

/// The mask of these bits of each bank's pixels.
fn whole(halves: &[Expr]) -> Expr {
    cat((0..BANK_PIXELS).rev().flat_map(|place| halves.iter().rev().map(move |half| half.bit(place))))
}

/// Shows the tile cache which banks samples leave to it; returns a bit for each bank that one reads.
pub(super) fn show_precedence(m: &mut Module, accesses: &Accesses) -> Expr {
    let reads = m.wire("reads_bank", bank_bit(accesses.reads, accesses.read.pixel));
    PORTS.sample_reads.drive_word(m, reads);
    let writes = m.wire("will_write_bank", bank_bit(accesses.comes, accesses.coming_pixel));
    PORTS.sample_writes.drive_word(m, writes);
    reads
}

/// The banks: a sample's read or write first, the tile cache's in cycles that it leaves free. Returns the register behind each.
pub(super) fn banks(m: &mut Module, config: &Config, pixels: u32, ports: &SlotPorts, accesses: &Accesses) -> Vec<Expr> {
    let pixel_bits = width::<Pixel>(config);
    let words = config.tile_slots * pixels / SLOT_BANKS;
    let SlotPorts { fill, drain, .. } = ports;
    let Fill { place: filled, value } = fill.record;
    let value = value.pack(config);
    let mut bank = |number: u32| {
        let memory = m.memory_unordered(&format!("bank_{number}_pixels"), words, pixel_bits);
        let ends = m.wire(&format!("sample_ends_in_{number}"), accesses.ends & is_in(accesses.written.pixel, number));
        let filling = fill.valid & is_in(filled.pixel, number);
        let write = m.wire(&format!("writes_{number}"), ends.mux(accesses.changes, filling));
        let written = ends.mux(address(accesses.written, pixels), address(filled, pixels));
        m.write(memory, write, written, ends.mux(accesses.result, value));

        let reads = m.wire(&format!("sample_reads_{number}"), accesses.reads & is_in(accesses.read.pixel, number));
        let read = reads.mux(address(accesses.read, pixels), address(drain.record, pixels));
        let draining = drain.valid & is_in(drain.record.pixel, number);
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
    let pixel = drain.record.pixel;
    let meets = (0..SLOT_BANKS).map(|number| is_in(pixel, number) & reads.bit(number));
    let meets = meets.reduce(|all, one| all | one).expect("there are banks");
    let [mut valid, mut of_pixel] = [drain.valid & !meets, pixel];
    for number in 1..=2 {
        let register = m.reg_reset(&format!("drains_{number}"), 1, 0);
        m.next(register, valid);
        valid = register.expr();
        of_pixel = held(m, &format!("drained_pixel_{number}"), bit(true), of_pixel);
    }
    let value = m.wire("drained_word", bank(of_pixel).pick(banks.iter().copied()));
    let drained = DrainedPixel { pixel: of_pixel, value: Pixel::unpack(config, value) };
    PORTS.drained.drive(m, config, valid, drained);
}

/// Which pixels of each slot are written and dirty, bank by bank: a sample that issues marks its own, and a slot that changes begins
/// anew. Returns whether the head's pixel is written, two cycles later.
pub(super) fn masks(m: &mut Module, config: &Config, change: &Pulse<SlotChange<Wires>>, accesses: &Accesses) -> Expr {
    let Accesses { reads, issues, read, .. } = *accesses;
    let SlotChange { slot, banks, held: comes } = change.record;
    let place = read.pixel.bits(PIXEL_BITS - 1, SLOT_BANKS.ilog2());
    let own = m.wire("pixel_bit", lit(BANK_PIXELS, 1).shl_by(place));
    let mut bank_masks = |number: u32| {
        let memory = m.memory_distributed(&format!("bank_{number}_masks"), config.tile_slots, 2 * BANK_PIXELS);
        let reads = reads & is_in(read.pixel, number);
        let address = m.wire(&format!("masked_slot_{number}"), reads.mux(read.slot, slot));
        let word = m.read_now(memory, &format!("bank_{number}_mask"), address);
        let changes = m.wire(&format!("changes_{number}"), (change.valid & banks.bit(number)) & !reads);
        let marks = issues & is_in(read.pixel, number);
        let begun = cat([half(comes, number), lit(BANK_PIXELS, 0)]);
        m.write(memory, marks | changes, address, reads.mux(word | cat([own, own]), begun));
        let written = word.bits(2 * BANK_PIXELS - 1, BANK_PIXELS);
        let before = [("written", written), ("dirty", word.trunc(BANK_PIXELS))];
        let before = before.map(|(name, half)| held(m, &format!("bank_{number}_was_{name}"), changes, half));
        // One of so many bits is chosen in two steps, a register behind each.
        let high = place.bits(PLACE_BITS - 1, NEAR_BITS);
        let near = m
            .wire(&format!("bank_{number}_near"), written.shr_by(cat([high, lit(NEAR_BITS, 0)])).trunc(1 << NEAR_BITS));
        (before, held(m, &format!("bank_{number}_was_near"), bit(true), near))
    };
    let (before, near): (Vec<_>, Vec<_>) = (0..SLOT_BANKS).map(&mut bank_masks).unzip();
    let [written, dirty] = [0, 1].map(|which| whole(&before.iter().map(|halves| halves[which]).collect::<Vec<_>>()));
    PORTS.masks.drive(m, config, SlotMasks { written, dirty });
    let [near_place, of_bank] = [("near_place", place.trunc(NEAR_BITS)), ("near_bank", bank(read.pixel))]
        .map(|(name, value)| held(m, name, bit(true), value));
    let is_written = of_bank.pick(near.into_iter().map(|near| near.shr_by(near_place).bit(0)));
    held(m, "is_written", bit(true), is_written)
}
