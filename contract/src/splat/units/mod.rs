//! The renderer's units at their ports, in the order in which a splat meets them.

mod copies;
mod events;
mod lanes;
mod motion;
mod samples;
mod splats;
mod whole;

pub use copies::{heap, lists, payloads, prefetch, reorder, splitter, tile_cache};
pub use events::{AccumulatorEvents, Events, LaneEvents, RasterizerEvents};
pub use lanes::{arbiter, collector, distributor, fragment_collector, lane};
pub use motion::{motion_evaluation, motion_setup};
pub use samples::{accumulator, depth_test, merge, normalizer, occlusion, rasterizer, weighting};
pub use splats::{setup, transform};
pub use whole::top;

use super::config::Config;
use crate::Unit;

/// Every unit of the renderer, the core itself last. Those of motion stand beside it.
pub static UNITS: [&Unit<Config>; 24] = [
    &transform::UNIT,
    &setup::UNIT,
    &splitter::UNIT,
    &distributor::UNIT,
    &payloads::UNIT,
    &heap::UNIT,
    &lists::UNIT,
    &reorder::UNIT,
    &prefetch::UNIT,
    &tile_cache::UNIT,
    &rasterizer::UNIT,
    &occlusion::UNIT,
    &weighting::UNIT,
    &depth_test::UNIT,
    &accumulator::UNIT,
    &lane::UNIT,
    &arbiter::UNIT,
    &collector::UNIT,
    &normalizer::UNIT,
    &merge::UNIT,
    &fragment_collector::UNIT,
    &motion_setup::UNIT,
    &motion_evaluation::UNIT,
    &top::UNIT,
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn ports_have_unique_names_and_fit_a_word() {
        let config = Config { cardinal: 1, ..Config::default() };
        for unit in UNITS {
            let ports = unit.ports(&config);
            let names: HashSet<_> = ports.iter().map(|port| &port.name).collect();
            assert_eq!(names.len(), ports.len(), "{}", unit.module);
            assert!(ports.iter().all(|port| (1..=64).contains(&port.width)), "{}", unit.module);
        }
    }

    #[test]
    fn modules_are_named_after_the_room() {
        assert!(UNITS.iter().all(|unit| unit.module.starts_with("splat_")));
    }
}
