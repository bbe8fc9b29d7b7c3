//! What bounds a frame: the cycles that each resource would take for it if it never waited.

use super::fates::Fates;
use super::host::SplatCounters;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::Reordering;
use serde::Serialize;

/// Cycles between two copies in the reorder stage with lists: one is appended and one leaves in a tick.
const LISTS_INTERVAL: u32 = 2;

/// A resource and the cycles it would take for a frame if it never waited.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct FrameBound {
    /// What is used.
    pub name: &'static str,
    /// Cycles in use.
    pub cycles: u64,
}

/// Cycles between two copies out of the splitter, which makes no more than one lane takes.
const fn splitter_interval(config: &Config) -> u32 {
    if config.rasterizers == 1 { 2 } else { 1 }
}

/// Cycles that a copy takes on its way to its rasterizer: in the reorder stage, or until it has its payload again.
#[must_use]
pub fn copy_interval(config: &Config) -> u32 {
    let order = match config.reorder {
        Reordering::Heap => config.heap_interval,
        Reordering::Lists => LISTS_INTERVAL,
    };
    order.max(config.payload_beats)
}

/// Cycles that a sample takes.
pub(super) const fn sample_interval(config: &Config) -> u32 {
    if config.has_motion() { config.sample_interval } else { 1 }
}

/// Every resource of a frame that was run.
#[must_use]
pub fn bounds(config: &Config, fates: &Fates, counters: &SplatCounters) -> [FrameBound; 8] {
    let times = |count: u64, interval: u32| count * u64::from(interval);
    let by_rasterizer = |cycles: u64| cycles.div_ceil(config.rasterizers.into());
    [
        ("samples", by_rasterizer(times(counters.events.sample, sample_interval(config)))),
        ("copies in the splitter", times(fates.copies, splitter_interval(config))),
        ("copies on their way to a rasterizer", by_rasterizer(times(fates.copies, copy_interval(config)))),
        ("splats in transform", times(fates.total(), config.transform_interval)),
        ("splats in setup", times(fates.set_up, config.setup_interval)),
        ("reconstruction buffer", counters.buffer.busy_cycles),
        ("memory of payloads", counters.payloads.busy_cycles),
        ("memory of depths", counters.depths.busy_cycles),
    ]
    .map(|(name, cycles)| FrameBound { name, cycles })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::memory::Traffic;
    use crate::splat::EventCounts;

    #[test]
    fn every_resource_has_its_interval() {
        let config = Config {
            reorder: Reordering::Heap,
            heap_interval: 4,
            transform_interval: 3,
            setup_interval: 5,
            ..Config::default()
        };
        let fates = Fates { drawn: 10, copies: 30, set_up: 12, near: 4, ..Fates::default() };
        let counters = SplatCounters {
            events: EventCounts { sample: 100, ..EventCounts::default() },
            buffer: Traffic { busy_cycles: 64, ..Traffic::default() },
            payloads: Traffic { busy_cycles: 48, ..Traffic::default() },
            depths: Traffic { busy_cycles: 32, ..Traffic::default() },
            ..SplatCounters::default()
        };
        let cycles = |config: &Config| bounds(config, &fates, &counters).map(|bound| bound.cycles);
        assert_eq!(cycles(&config), [100, 60, 120, 42, 60, 64, 48, 32]);
        let two = Config { rasterizers: 2, ..config.clone() };
        assert_eq!(cycles(&two)[..3], [50, 30, 60]);
        let lists = Config { reorder: Reordering::Lists, ..config };
        assert_eq!(cycles(&lists)[2], 60);
        let moving = Config { time_bins: 4, sample_interval: 2, ..lists.clone() };
        assert_eq!(cycles(&Config { payload_beats: 4, ..lists })[2], 120);
        assert_eq!(cycles(&moving)[0], 200);
    }
}
