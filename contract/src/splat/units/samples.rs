//! Units that work on samples and pixels.

use super::events::{AccumulatorEvents, RasterizerEvents};
use crate::splat::Config;
use crate::splat::config::{DEPTH_BITS, DEPTH_SUM_BITS, SLOT_BANKS, WEIGHT_SUM_BITS};
use crate::splat::records::{
    CompleteCopy, Depth, DepthRun, DrainedPixel, Fill, FinishedPixel, Fragment, Sample, Shutter, Slot, SlotChange,
    SlotMasks, SlotPixel, SlotTile, StoredDepth, WeightedSample,
};
use crate::unit;

/// Evaluates a splat's kernel at the samples within its bounds (thesis table 5.2).
#[unit(splat_rasterizer, config: Config)]
pub struct Rasterizer {
    /// Copies with their slots.
    #[port("in")]
    input: In<CompleteCopy>,
    /// Samples.
    out: Out<Sample>,
    /// The reciprocal of the squared radius of the screen filter.
    #[when(config.screen_filter.is_on())]
    #[bits(config.filter_scale_format().width())]
    filter_scale: Input<u32>,
    /// Where splats may move, depth is `depth_a` and what follows from the distance.
    #[when(config.has_motion())]
    #[bits(config.geometry.width())]
    depth_a: Input<u32>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<RasterizerEvents>,
}

/// Leaves out samples that lie behind depths in memory.
#[unit(splat_occlusion, config: Config)]
#[when(config.tests_samples())]
pub struct Occlusion {
    /// Samples.
    #[port("in")]
    input: In<Sample>,
    /// Those that nothing hides. One that is hidden and closes its copy lies outside.
    out: Out<Sample>,
    /// A slot gets another tile.
    placed: PulseIn<SlotTile>,
    /// Depths wanted.
    depth_read: Out<DepthRun>,
    /// They, in order.
    depth_data: In<Depth>,
    /// A sample was hidden in the last cycle.
    #[port("event_hidden")]
    hidden: Output<bool>,
}

/// Weights depth and attributes.
#[unit(splat_weighting, config: Config)]
pub struct Weighting {
    /// Samples.
    #[port("in")]
    input: In<Sample>,
    /// Samples with their contributions.
    out: Out<WeightedSample>,
}

/// The ternary depth test (thesis 5.4.4): a pipeline without stalls, whose results follow two cycles later.
#[unit(splat_depth_test, config: Config)]
pub struct DepthTest {
    /// The pixel's sum of weights.
    #[bits(WEIGHT_SUM_BITS)]
    weight: Input<u32>,
    /// The pixel's sum of weighted depths.
    #[bits(DEPTH_SUM_BITS)]
    depth: Input<u64>,
    /// Near end of the sample's depth band.
    #[bits(DEPTH_BITS)]
    depth_low: Input<u32>,
    /// Far end of the sample's depth band.
    #[bits(DEPTH_BITS)]
    depth_high: Input<u32>,
    /// The pixel hides the sample.
    fail: Output<bool>,
    /// The sample hides the pixel.
    pass: Output<bool>,
}

/// Adds samples to pixels of the tile slots (eq. 5.10 to 5.12).
#[unit(splat_accumulator, config: Config)]
pub struct Accumulator {
    /// Samples with their contributions.
    #[port("in")]
    input: In<WeightedSample>,
    /// A bit for each slot that may be accumulated into.
    #[bits(config.tile_slots)]
    slot_ready: Input<u64>,
    /// A copy is done with.
    retire: PulseOut<Slot>,
    /// A slot gets another tile, until that is carried out in every bank.
    change: PulseIn<SlotChange>,
    /// What the slot that changed last held before.
    masks: Output<SlotMasks>,
    /// Write to a slot, until it is carried out.
    fill: PulseIn<Fill>,
    /// A bit for each bank that a sample may write in the next cycle: no fill of it is carried out then.
    #[bits(SLOT_BANKS)]
    sample_writes: Output<u32>,
    /// Read of a slot, until it is carried out.
    #[flag("enable")]
    drain: PulseIn<SlotPixel>,
    /// A bit for each bank that a sample may read: no drain and no change of it is carried out.
    #[bits(SLOT_BANKS)]
    sample_reads: Output<u32>,
    /// A pixel that was read.
    drained: PulseOut<DrainedPixel>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<AccumulatorEvents>,
}

/// Divides sums by weights (eq. 5.13).
#[unit(splat_normalizer, config: Config)]
pub struct Normalizer {
    /// Pixels of a finished frame.
    #[port("in")]
    input: In<FinishedPixel>,
    /// Fragments.
    out: Out<Fragment>,
    /// How much each bin of the exposure counts.
    #[when(config.has_motion())]
    #[port("")]
    shutter: Input<Shutter>,
}

/// Tests fragments against depths in memory, and leaves out those that are not nearer (thesis 5.4.6).
#[unit(splat_merge, config: Config)]
#[when(config.tests_fragments())]
pub struct Merge {
    /// Fragments.
    #[port("in")]
    input: In<Fragment>,
    /// Those that are nearer than what was there.
    out: Out<Fragment>,
    /// Depths wanted.
    depth_read: Out<DepthRun>,
    /// They, in order.
    depth_data: In<Depth>,
    /// Depths of the fragments that leave.
    depth_write: Out<StoredDepth>,
    /// Something nearer hid a fragment in the last cycle.
    #[port("event_hidden")]
    hidden: Output<bool>,
}
