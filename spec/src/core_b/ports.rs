//! Ports of core B's units in order, `rst` first; every unit also has `clk`. A *pulse* is a record with `valid` and without
//! `ready`: it is always taken.

use super::config::Config;
use super::records;
use crate::core_a::Port;
use crate::core_a::ports::Ports;

/// What the core does in a cycle, one output port each: the counters behind the bound of a run and the stalls by cause.
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
    Ports::new()
        .pulse_in("tree", &records::tree_write(config))
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

/// Ports of the leaf processing.
#[must_use]
pub fn leaf(config: &Config) -> Vec<Port> {
    Ports::new()
        .pulse_in("tree", &records::tree_write(config))
        .pulse_in("start", &records::start(config))
        .stream_in("leaf", &records::leaf(config))
        .stream_out("fetch", &records::fetch(config))
        .stream_in("beat", &records::beat(config))
        .stream_out("candidates", &records::candidates(config))
        .list()
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
    let ports = Ports::new()
        .pulse_in("tree", &records::tree_write(config))
        .stream_in("query", &records::query(config))
        .stream_out("fetch", &records::fetch(config))
        .stream_in("beat", &records::beat(config))
        .stream_out("result", &records::result(config));
    EVENTS.iter().fold(ports, |ports, event| ports.output(*event, 1)).list()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn ports_have_unique_names_and_fit_a_word() {
        let units = [threads, traversal, stack, recursion, leaf, queue, top];
        for lanes in [1, 8] {
            let config = Config { lanes, ..Config::default() };
            for unit in units {
                let ports = unit(&config);
                let names: HashSet<_> = ports.iter().map(|port| &port.name).collect();
                assert_eq!(names.len(), ports.len());
                assert!(ports.iter().all(|port| (1..=64).contains(&port.width)));
            }
        }
    }
}
