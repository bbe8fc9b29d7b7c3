//! Units that work on copies of splats for tiles.

use crate::splat::Config;
use crate::splat::config::SLOT_BANKS;
use crate::splat::records::{
    ArrivedCopy, CompleteCopy, DrainedPixel, Fill, FinishedPixel, HeapEntry, PayloadPlace, PayloadWord, Pixel,
    PixelRun, PlacedCopy, SetupSplat, Slot, SlotChange, SlotMasks, SlotPixel, SlotTile, SplatCopy, StoredPixel,
    StoredWord, TileCopy,
};
use crate::unit;

/// Makes a copy of a splat for each tile that its bounds touch.
#[unit(splat_splitter, config: Config)]
pub struct Splitter {
    /// Footprints with bounds in the image.
    #[port("in")]
    input: In<SetupSplat>,
    /// Copies with bounds in their tiles.
    out: Out<SplatCopy>,
}

/// Keeps what the copies of a splat have in common, once, while the copies are put in order.
#[unit(splat_payloads, config: Config)]
pub struct Payloads {
    /// Copies, those of a splat one after the other.
    #[port("in")]
    input: In<SplatCopy>,
    /// The same, with where their payload lies in its place.
    copy: Out<TileCopy>,
    /// Copies that are to be drawn, in any order.
    placed: In<PlacedCopy>,
    /// The same with their payload.
    out: Out<CompleteCopy>,
    /// Words of payloads for memory.
    #[when(config.has_payloads_in_memory())]
    write: Out<StoredWord>,
    /// Words from there, those of each placed copy one after the other.
    #[when(config.has_payloads_in_memory())]
    data: In<PayloadWord>,
    /// A copy's words were all taken in the last cycle from where they had come to.
    #[when(config.has_payloads_in_memory())]
    read: Output<bool>,
}

/// Asks memory for payloads before their copies are drawn.
#[unit(splat_prefetch, config: Config)]
#[when(config.has_payloads_in_memory())]
pub struct Prefetch {
    /// Copies in order of tiles.
    #[port("in")]
    input: In<TileCopy>,
    /// The same.
    out: Out<TileCopy>,
    /// The payloads wanted, in this order.
    read: Out<PayloadPlace>,
    /// A copy's words have left where they had come to.
    left: Input<bool>,
}

/// Orders entries by tile, and within a tile by arrival (thesis 5.5.2).
#[unit(splat_heap, config: Config)]
pub struct Heap {
    /// Entries in any order.
    #[port("in")]
    input: In<HeapEntry>,
    /// Entries in order.
    out: Out<HeapEntry>,
    /// It holds no entry.
    empty: Output<bool>,
}

/// Keeps entries in a list for each tile, and serves some tiles in turn (thesis 5.5.2).
#[unit(splat_lists, config: Config)]
pub struct Lists {
    /// Entries in any order; no pointer comes again before it has left.
    #[port("in")]
    input: In<HeapEntry>,
    /// Entries of a tile in order of arrival, those of some tiles in turn.
    out: Out<HeapEntry>,
    /// It holds no entry.
    empty: Output<bool>,
}

/// Puts copies in the order of their tiles.
#[unit(splat_reorder, config: Config)]
pub struct Reorder {
    /// Copies in any order.
    #[port("in")]
    input: In<TileCopy>,
    /// Copies in order of tiles.
    out: Out<TileCopy>,
}

/// Keeps tiles of the reconstruction buffer in slots, and fetches them ahead.
#[unit(splat_tile_cache, config: Config)]
pub struct TileCache {
    /// Copies in order of tiles.
    #[port("in")]
    input: In<TileCopy>,
    /// Copies as they come before they are put in order.
    arrives: PulseIn<ArrivedCopy>,
    /// As many frames are under way as there are surfaces: no copy of another may come.
    full: Output<bool>,
    /// Copies with their slots.
    out: Out<PlacedCopy>,
    /// Request for pixels of a tile.
    read: Out<PixelRun>,
    /// The pixels requested, in order.
    data: In<Pixel>,
    /// Pixels of evicted tiles.
    write: Out<StoredPixel>,
    /// Pixels of a finished frame.
    pixel: Out<FinishedPixel>,
    /// A bit for each slot that may be accumulated into.
    #[bits(config.tile_slots)]
    slot_ready: Output<u64>,
    /// The number of the rasterizer whose tiles these are.
    #[when(config.rasterizers > 1)]
    #[bits(config.rasterizer_bits())]
    number: Input<u8>,
    /// The end of a frame has left all rasterizers, a cycle long.
    #[when(config.rasterizers > 1)]
    frame_sent: Input<bool>,
    /// The accumulator is done with a copy.
    retire: PulseIn<Slot>,
    /// A slot gets another tile, until that is carried out in every bank.
    change: PulseOut<SlotChange>,
    /// A slot gets this tile, and no sample of it comes for another cycle.
    #[when(config.tests_samples())]
    placed: PulseOut<SlotTile>,
    /// What the slot that changed last held before.
    masks: Input<SlotMasks>,
    /// Write to a slot, until it is carried out.
    fill: PulseOut<Fill>,
    /// A bit for each bank that a sample may write in the next cycle: no fill of it is carried out then.
    #[bits(SLOT_BANKS)]
    sample_writes: Input<u32>,
    /// Read of a slot, until it is carried out.
    #[flag("enable")]
    drain: PulseOut<SlotPixel>,
    /// A bit for each bank that a sample may read: no drain and no change of it is carried out.
    #[bits(SLOT_BANKS)]
    sample_reads: Input<u32>,
    /// A pixel that was read.
    drained: PulseIn<DrainedPixel>,
}
