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

/// What the core did.
#[record(config: Config)]
pub struct Events {
    /// The rasterizer.
    pub rasterizer: RasterizerEvents,
    /// The accumulator.
    pub accumulator: AccumulatorEvents,
}
