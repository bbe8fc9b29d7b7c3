//! What units did in the last cycle, for utilisation and stalls by cause.

use crate::record;
use crate::splat::Config;

/// What the rasterizer did.
#[record(config: Config)]
pub struct RasterizerEvents {
    /// The rasterizer evaluated a sample.
    #[name("event_sample")]
    pub sample: bool,
    /// The rasterizer had no copy to work on.
    #[name("event_starved")]
    pub starved: bool,
    /// The rasterizer's pipeline was held by what follows it.
    #[name("event_blocked")]
    pub blocked: bool,
}

/// What the accumulator did.
#[record(config: Config)]
pub struct AccumulatorEvents {
    /// The accumulator took a sample.
    #[name("event_accumulate")]
    pub accumulate: bool,
    /// The accumulator waited for an earlier sample of the same pixel.
    #[name("event_hazard")]
    pub hazard: bool,
    /// The accumulator waited for its tile to arrive in the cache.
    #[name("event_slot_wait")]
    pub slot_wait: bool,
}

/// What a lane did.
#[record(config: Config)]
pub struct LaneEvents {
    /// Its rasterizer.
    pub rasterizer: RasterizerEvents,
    /// Its accumulator.
    pub accumulator: AccumulatorEvents,
    /// A depth in memory hid a sample.
    #[when(config.tests_samples())]
    #[name("event_hidden")]
    pub hidden: bool,
}

/// What the core did: numbers of its rasterizers or accumulators.
#[record(config: Config)]
pub struct Events {
    /// Rasterizers that evaluated a sample.
    #[name("event_sample")]
    #[bits(config.rasterizer_bits() + 1)]
    pub sample: u8,
    /// Rasterizers that had no copy to work on.
    #[name("event_starved")]
    #[bits(config.rasterizer_bits() + 1)]
    pub starved: u8,
    /// Rasterizers whose pipeline was held by what follows it.
    #[name("event_blocked")]
    #[bits(config.rasterizer_bits() + 1)]
    pub blocked: u8,
    /// Accumulators that took a sample.
    #[name("event_accumulate")]
    #[bits(config.rasterizer_bits() + 1)]
    pub accumulate: u8,
    /// Accumulators that waited for an earlier sample of the same pixel.
    #[name("event_hazard")]
    #[bits(config.rasterizer_bits() + 1)]
    pub hazard: u8,
    /// Accumulators that waited for a tile to arrive in the cache.
    #[name("event_slot_wait")]
    #[bits(config.rasterizer_bits() + 1)]
    pub slot_wait: u8,
    /// Fragments that something nearer in memory hides, or samples of what moves.
    #[when(config.merge.is_on())]
    #[name("event_hidden")]
    #[bits(config.merge_count_bits())]
    pub hidden: u8,
}
