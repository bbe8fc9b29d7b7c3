//! Ports of the search core's units in order, `rst` first; every unit also has `clk`.

use super::config::Config;
use super::units;
use crate::Port;

macro_rules! lists {
    ($($unit:ident),* $(,)?) => {
        $(
            /// Ports of that unit.
            #[must_use]
            pub fn $unit(config: &Config) -> Vec<Port> {
                units::$unit::UNIT.ports(config)
            }
        )*
    };
}

lists!(threads, traversal, stack, recursion, leaf, sieve, queue, point_cache, tree_cache, neighbor_cache, top);

/// What every core does in a cycle.
pub const EVENTS: [&str; 6] =
    ["event_node", "event_pop", "event_beat", "event_insert", "event_insert_wait", "event_thread_wait"];
/// Leaves served by the point cache and not.
pub const POINT_CACHE_EVENTS: [&str; 2] = ["event_point_hit", "event_point_miss"];
/// Records served by the tree cache and not.
pub const TREE_CACHE_EVENTS: [&str; 2] = ["event_tree_hit", "event_tree_miss"];
/// Queries served by the neighbor cache and not.
pub const NEIGHBOR_CACHE_EVENTS: [&str; 2] = ["event_cache_hit", "event_cache_miss"];

/// The events of a core with the parts it has.
#[must_use]
pub fn events(config: &Config) -> Vec<&'static str> {
    let caches = [
        (config.point_cache, POINT_CACHE_EVENTS),
        (config.tree_cache, TREE_CACHE_EVENTS),
        (config.neighbor_cache, NEIGHBOR_CACHE_EVENTS),
    ];
    let present = caches.into_iter().filter(|(lines, _)| *lines > 0);
    EVENTS.into_iter().chain(present.flat_map(|(_, events)| events)).collect()
}
