//! The search core's units at their ports. The core's own order: what a query meets first comes first.

mod caches;
mod events;
mod queries;
mod tree;
mod whole;

pub use caches::{neighbor_cache, point_cache, tree_cache};
pub use events::{Events, NeighborCacheEvents, PointCacheEvents, QueueEvents, TreeCacheEvents};
pub use queries::{leaf, queue, sieve, threads};
pub use tree::{recursion, stack, traversal};
pub use whole::top;

use super::config::Config;
use crate::Unit;

/// Every unit of the search core, the core itself last.
pub static UNITS: [&Unit<Config>; 11] = [
    &threads::UNIT,
    &traversal::UNIT,
    &stack::UNIT,
    &recursion::UNIT,
    &leaf::UNIT,
    &sieve::UNIT,
    &queue::UNIT,
    &point_cache::UNIT,
    &tree_cache::UNIT,
    &neighbor_cache::UNIT,
    &top::UNIT,
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn ports_have_unique_names_and_fit_a_word() {
        for (lanes, tree_cache) in [(1, 0), (8, 256)] {
            let config = Config { lanes, tree_cache, neighbor_cache: lanes, ..Config::default() };
            for unit in UNITS {
                let ports = unit.ports(&config);
                let names: HashSet<_> = ports.iter().map(|port| &port.name).collect();
                assert_eq!(names.len(), ports.len(), "{}", unit.module);
                assert!(ports.iter().all(|port| (1..=64).contains(&port.width)), "{}", unit.module);
            }
        }
    }

    #[test]
    fn modules_are_named_after_the_room() {
        assert!(UNITS.iter().all(|unit| unit.module.starts_with("search_")));
    }
}
