//! Ports of the search core's units in order, `rst` first; every unit also has `clk`. A *pulse* is a record with `valid` and without
//! `ready`: it is always taken.

use super::config::Config;
use super::records;
use crate::splat::Port;
use crate::splat::ports::Ports;

/// What every core does in a cycle, one output port each: the counters behind the bound of a run and the stalls by cause.
pub const EVENTS: [&str; 6] = [
    // A node was visited.
    "event_node",
    // A path was popped.
    "event_pop",
    // The priority queue unit was done with a beat of points.
    "event_beat",
    // A neighbor was inserted.
    "event_insert",
    // A beat stayed for one more insertion.
    "event_insert_wait",
    // A query waited for a free thread.
    "event_thread_wait",
];

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

fn outputs(ports: Ports, events: &[&'static str]) -> Vec<Port> {
    events.iter().fold(ports, |ports, event| ports.output(*event, 1)).list()
}

/// Ports of the thread control.
#[must_use]
pub fn threads(config: &Config) -> Vec<Port> {
    let thread = records::thread_only(config);
    Ports::new()
        .stream_in("query", &records::query(config))
        .pulse_out("start", &records::start(config))
        .stream_out("descend", &records::descent(config))
        .stream_out("pop", &thread)
        .stream_out("finish", &thread)
        .pulse_in("reached", &thread)
        .pulse_in("leaf_done", &thread)
        .pulse_in("skipped", &thread)
        .pulse_in("empty", &thread)
        .pulse_in("released", &thread)
        .output("event_thread_wait", 1)
        .list()
}

/// Ports of the node traversal.
#[must_use]
pub fn traversal(config: &Config) -> Vec<Port> {
    let mut path = records::thread_only(config);
    path.extend(records::path(config));
    let ports = match config.tree_cache {
        0 => Ports::new().pulse_in("tree", &records::tree_write(config)),
        _ => Ports::new()
            .stream_out("node", &records::descent(config))
            .stream_in("record", &records::node_record(config)),
    };
    ports
        .pulse_in("start", &records::start(config))
        .stream_in("descend", &records::descent(config))
        .stream_in("resume", &records::descent(config))
        .pulse_out("push", &path)
        .stream_out("leaf", &records::leaf(config))
        .pulse_out("reached", &records::thread_only(config))
        .output("event_node", 1)
        .list()
}

/// Ports of the multi-threaded stack.
#[must_use]
pub fn stack(config: &Config) -> Vec<Port> {
    let thread = records::thread_only(config);
    let mut path = thread.clone();
    path.extend(records::path(config));
    Ports::new()
        .pulse_in("push", &path)
        .pulse_in("pop", &thread)
        .output("top_empty", 1)
        .outputs("top_", &records::path(config))
        .list()
}

/// Ports of the stack recursion.
#[must_use]
pub fn recursion(config: &Config) -> Vec<Port> {
    let thread = records::thread_only(config);
    Ports::new()
        .pulse_in("start", &records::start(config))
        .pulse_in("radius", &records::radius(config))
        .stream_in("in", &thread)
        .pulse_out("pop", &thread)
        .input("top_empty", 1)
        .inputs("top_", &records::path(config))
        .stream_out("resume", &records::descent(config))
        .pulse_out("empty", &thread)
        .output("event_pop", 1)
        .list()
}

/// Ports of the leaf processing; with a tree cache, which knows the leaves, it only computes distances.
#[must_use]
pub fn leaf(config: &Config) -> Vec<Port> {
    let ports = match config.tree_cache {
        0 => Ports::new()
            .pulse_in("tree", &records::tree_write(config))
            .stream_in("leaf", &records::leaf(config))
            .stream_out("fetch", &records::fetch(config)),
        _ => Ports::new(),
    };
    ports
        .pulse_in("start", &records::start(config))
        .stream_in("beat", &records::beat(config))
        .stream_out("candidates", &records::candidates(config))
        .list()
}

/// Ports of the sieve.
#[must_use]
pub fn sieve(config: &Config) -> Vec<Port> {
    Ports::new()
        .pulse_in("start", &records::start(config))
        .pulse_in("radius", &records::radius(config))
        .stream_in("candidates", &records::candidates(config))
        .stream_out("kept", &records::candidates(config))
        .pulse_out("skipped", &records::thread_only(config))
        .list()
}

/// Ports of the point cache.
#[must_use]
pub fn point_cache(config: &Config) -> Vec<Port> {
    let ports = Ports::new()
        .stream_in("fetch", &records::fetch(config))
        .stream_out("beat", &records::beat(config))
        .stream_out("miss", &records::fetch(config))
        .stream_in("fill", &records::beat(config));
    outputs(ports, &POINT_CACHE_EVENTS)
}

/// Ports of the tree cache.
#[must_use]
pub fn tree_cache(config: &Config) -> Vec<Port> {
    let ports = Ports::new()
        .stream_in("node", &records::descent(config))
        .stream_in("leaf", &records::leaf(config))
        .stream_out("record", &records::node_record(config))
        .stream_out("fetch", &records::fetch(config))
        .stream_out("lookup", &records::lookup(config))
        .stream_in("fill", &records::tree_record(config));
    outputs(ports, &TREE_CACHE_EVENTS)
}

/// Ports of the coherent neighbor cache.
#[must_use]
pub fn neighbor_cache(config: &Config) -> Vec<Port> {
    let ports = Ports::new()
        .pulse_in("setup", &records::cache_setup(config))
        .stream_in("query", &records::cached_query(config))
        .stream_out("search", &records::query(config))
        .stream_in("found", &records::result(config))
        .stream_out("result", &records::cached_result(config));
    outputs(ports, &NEIGHBOR_CACHE_EVENTS)
}

/// Ports of the priority queues.
#[must_use]
pub fn queue(config: &Config) -> Vec<Port> {
    Ports::new()
        .pulse_in("start", &records::start(config))
        .stream_in("candidates", &records::candidates(config))
        .pulse_out("radius", &records::radius(config))
        .stream_in("finish", &records::thread_only(config))
        .pulse_out("released", &records::thread_only(config))
        .stream_out("result", &records::result(config))
        .output("event_beat", 1)
        .output("event_insert", 1)
        .output("event_insert_wait", 1)
        .list()
}

/// Ports of the whole core.
#[must_use]
pub fn top(config: &Config) -> Vec<Port> {
    let tree = match config.tree_cache {
        0 => Ports::new().pulse_in("tree", &records::tree_write(config)),
        _ => Ports::new()
            .stream_out("lookup", &records::lookup(config))
            .stream_in("record", &records::tree_record(config)),
    };
    let (query, result) = match config.neighbor_cache {
        0 => (tree.stream_in("query", &records::query(config)), records::result(config)),
        _ => {
            let setup = tree.pulse_in("setup", &records::cache_setup(config));
            (setup.stream_in("query", &records::cached_query(config)), records::cached_result(config))
        }
    };
    let ports = query
        .stream_out("fetch", &records::fetch(config))
        .stream_in("beat", &records::beat(config))
        .stream_out("result", &result);
    outputs(ports, &events(config))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn ports_have_unique_names_and_fit_a_word() {
        let units =
            [threads, traversal, stack, recursion, leaf, sieve, point_cache, tree_cache, queue, neighbor_cache, top];
        for (lanes, tree_cache) in [(1, 0), (8, 256)] {
            let config = Config { lanes, tree_cache, neighbor_cache: lanes, ..Config::default() };
            for unit in units {
                let ports = unit(&config);
                let names: HashSet<_> = ports.iter().map(|port| &port.name).collect();
                assert_eq!(names.len(), ports.len());
                assert!(ports.iter().all(|port| (1..=64).contains(&port.width)));
            }
        }
    }
}
