//! The whole neighbor search: queries in, neighbors out, points behind a memory port; golden twin:
//! `pointcore_golden::search::top`.

use std::collections::BTreeMap;

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{CachedQuery, CachedResult, Fetch};
use pointcore_contract::search::units::top::PORTS;
use pointcore_contract::search::units::{self, Events};

use super::neighbor_cache::NeighborCache;
use super::{leaf, neighbor_cache, point_cache, queue, recursion, sieve, stack, threads, traversal, tree_cache};
use crate::compiler::{CompileError, Manifest, Options};
use crate::units::ports::{
    Flow, InputPorts, OutputPorts, Pulse, PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort, pipe,
    pulse,
};
use crate::units::wires::Wires;
use rtl::{Instance, Module};

/// The core's module and what the compiler decided about its datapaths.
pub struct Core {
    /// The top module, `search_top`.
    pub module: Module,
    /// By unit.
    pub manifests: BTreeMap<String, Manifest>,
}

/// The units of every core.
struct Units {
    threads: Instance,
    traversal: Instance,
    stack: Instance,
    recursion: Instance,
    leaf: Instance,
    sieve: Instance,
    queue: Instance,
}

impl Units {
    /// Places the units and leads what goes round a search from one to the next; what comes from the host and the memory
    /// is left to do.
    fn connected(m: &mut Module, config: &Config, [traversal, leaf]: [Module; 2]) -> Self {
        let placed = Self {
            threads: m.instance("threads", threads::module(config)),
            traversal: m.instance("traversal", traversal),
            stack: m.instance("stack", stack::module(config)),
            recursion: m.instance("recursion", recursion::module(config)),
            leaf: m.instance("leaf", leaf),
            sieve: m.instance("sieve", sieve::module(config)),
            queue: m.instance("queue", queue::module(config)),
        };
        let Self { threads, traversal, recursion, leaf, sieve, queue, .. } = placed;
        let start = units::threads::PORTS.start.of(m, config, threads);
        units::traversal::PORTS.start.feed(m, config, traversal, start);
        units::recursion::PORTS.start.feed(m, config, recursion, start);
        units::leaf::PORTS.start.feed(m, config, leaf, start);
        units::sieve::PORTS.start.feed(m, config, sieve, start);
        units::queue::PORTS.start.feed(m, config, queue, start);
        placed.streams(m, config);
        placed.pulses(m, config);
        placed
    }

    /// Leads streams from one unit to the next.
    fn streams(&self, m: &mut Module, config: &Config) {
        let Self { threads, traversal, recursion, leaf, sieve, queue, .. } = *self;
        let (from_threads, to_queue) = (units::threads::PORTS, units::queue::PORTS);
        pipe(m, config, (threads, from_threads.descend), (traversal, units::traversal::PORTS.descend));
        pipe(m, config, (threads, from_threads.pop), (recursion, units::recursion::PORTS.input));
        pipe(m, config, (threads, from_threads.finish), (queue, to_queue.finish));
        pipe(m, config, (recursion, units::recursion::PORTS.resume), (traversal, units::traversal::PORTS.resume));
        pipe(m, config, (leaf, units::leaf::PORTS.candidates), (sieve, units::sieve::PORTS.candidates));
        pipe(m, config, (sieve, units::sieve::PORTS.kept), (queue, to_queue.candidates));
    }

    /// Leads what is always taken from one unit to others.
    fn pulses(&self, m: &mut Module, config: &Config) {
        let Self { threads, traversal, stack, recursion, sieve, queue, .. } = *self;
        let to_threads = units::threads::PORTS;
        pulse(m, config, (traversal, units::traversal::PORTS.push), (stack, units::stack::PORTS.push));
        pulse(m, config, (recursion, units::recursion::PORTS.pop), (stack, units::stack::PORTS.pop));
        let top_empty = units::stack::PORTS.top_empty.word_of(m, stack);
        units::recursion::PORTS.top_empty.feed_word(m, recursion, top_empty);
        let top = units::stack::PORTS.top.of(m, config, stack);
        units::recursion::PORTS.top.feed(m, config, recursion, top);

        let radius = units::queue::PORTS.radius.of(m, config, queue);
        units::recursion::PORTS.radius.feed(m, config, recursion, radius);
        units::sieve::PORTS.radius.feed(m, config, sieve, radius);
        let leaf_done = Pulse { valid: radius.valid, record: radius.record.thread };
        to_threads.leaf_done.feed(m, config, threads, leaf_done);
        pulse(m, config, (traversal, units::traversal::PORTS.reached), (threads, to_threads.reached));
        pulse(m, config, (sieve, units::sieve::PORTS.skipped), (threads, to_threads.skipped));
        pulse(m, config, (recursion, units::recursion::PORTS.empty), (threads, to_threads.empty));
        pulse(m, config, (queue, units::queue::PORTS.released), (threads, to_threads.released));
    }

    /// Leads the tree to the units, from the host or through the cache of a tree in external memory; returns the requests
    /// for points, and the cache.
    fn tree(&self, m: &mut Module, config: &Config) -> (Flow<Fetch<Wires>>, Option<Instance>) {
        let Self { traversal, leaf, .. } = *self;
        let (of_traversal, of_leaf, of_cache) = (units::traversal::PORTS, units::leaf::PORTS, units::tree_cache::PORTS);
        if config.tree_cache == 0 {
            let tree = PORTS.tree.declare(m, config);
            of_traversal.tree.feed(m, config, traversal, tree);
            of_leaf.tree.feed(m, config, leaf, tree);
            pipe(m, config, (traversal, of_traversal.leaf), (leaf, of_leaf.leaf));
            return (of_leaf.fetch.of(m, config, leaf), None);
        }
        let cache = m.instance("tree_cache", tree_cache::module(config));
        let lookup = of_cache.lookup.of(m, config, cache);
        PORTS.lookup.export(m, config, lookup);
        let record = PORTS.record.declare(m, config);
        of_cache.fill.feed(m, config, cache, record);
        pipe(m, config, (traversal, of_traversal.node), (cache, of_cache.node));
        pipe(m, config, (traversal, of_traversal.leaf), (cache, of_cache.leaf));
        pipe(m, config, (cache, of_cache.record), (traversal, of_traversal.record));
        (of_cache.fetch.of(m, config, cache), Some(cache))
    }

    /// Leads queries in, through the neighbor cache where there is one.
    fn queries(&self, m: &mut Module, config: &Config, cache: Option<Instance>) {
        let (of_threads, of_cache) = (units::threads::PORTS, units::neighbor_cache::PORTS);
        let Some(cache) = cache else {
            let query = PORTS.query.declare(m, config).map(|CachedQuery { query, .. }| query);
            of_threads.query.feed(m, config, self.threads, query);
            return;
        };
        let setup = PORTS.setup.declare(m, config);
        of_cache.setup.feed(m, config, cache, setup);
        let query = PORTS.query.declare(m, config);
        of_cache.query.feed(m, config, cache, query);
        pipe(m, config, (cache, of_cache.search), (self.threads, of_threads.query));
    }

    /// Leads requests for points to the memory and beats back, through the point cache where there is one; returns it.
    fn points(&self, m: &mut Module, config: &Config, fetch: Flow<Fetch<Wires>>) -> Option<Instance> {
        let (of_leaf, of_cache) = (units::leaf::PORTS, units::point_cache::PORTS);
        if config.point_cache == 0 {
            PORTS.fetch.export(m, config, fetch);
            let beat = PORTS.beat.declare(m, config);
            of_leaf.beat.feed(m, config, self.leaf, beat);
            return None;
        }
        let cache = m.instance("point_cache", point_cache::module(config));
        of_cache.fetch.feed(m, config, cache, fetch);
        let miss = of_cache.miss.of(m, config, cache);
        PORTS.fetch.export(m, config, miss);
        let beat = PORTS.beat.declare(m, config);
        of_cache.fill.feed(m, config, cache, beat);
        pipe(m, config, (cache, of_cache.beat), (self.leaf, of_leaf.beat));
        Some(cache)
    }

    /// Leads results out, through the neighbor cache where there is one.
    fn results(&self, m: &mut Module, config: &Config, cache: Option<Instance>) {
        let (of_queue, of_cache) = (units::queue::PORTS, units::neighbor_cache::PORTS);
        let result = match cache {
            Some(cache) => {
                pipe(m, config, (self.queue, of_queue.result), (cache, of_cache.found));
                of_cache.result.of(m, config, cache)
            }
            None => {
                of_queue.result.of(m, config, self.queue).map(|result| CachedResult { result, ..Default::default() })
            }
        };
        PORTS.result.export(m, config, result);
    }

    /// What happened in the units and in those caches that there are.
    fn events(&self, m: &mut Module, config: &Config, caches: Caches) -> Events<Wires> {
        let Caches { point, tree, neighbor } = caches;
        let point_cache = point.map(|cache| units::point_cache::PORTS.events.of(m, config, cache));
        let tree_cache = tree.map(|cache| units::tree_cache::PORTS.events.of(m, config, cache));
        let neighbor_cache = neighbor.map(|cache| units::neighbor_cache::PORTS.events.of(m, config, cache));
        Events {
            node: units::traversal::PORTS.event_node.word_of(m, self.traversal),
            pop: units::recursion::PORTS.event_pop.word_of(m, self.recursion),
            queue: units::queue::PORTS.events.of(m, config, self.queue),
            thread_wait: units::threads::PORTS.event_thread_wait.word_of(m, self.threads),
            point_cache: point_cache.unwrap_or_default(),
            tree_cache: tree_cache.unwrap_or_default(),
            neighbor_cache: neighbor_cache.unwrap_or_default(),
        }
    }
}

/// The caches that a core has.
struct Caches {
    point: Option<Instance>,
    tree: Option<Instance>,
    neighbor: Option<Instance>,
}

/// Builds the core.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Core, CompileError> {
    let mut m = Module::new("search_top", "Neighbor search: queries in, nearest neighbors out.");
    let [traversal, leaf] = [traversal::datapath(config, options)?, leaf::datapath(config, options)?];
    let mut manifests =
        BTreeMap::from([("traversal".to_owned(), traversal.manifest), ("leaf".to_owned(), leaf.manifest)]);
    let neighbor_cache = match config.neighbor_cache {
        0 => None,
        _ => {
            let NeighborCache { module, check, cover } = neighbor_cache::unit(config, options)?;
            manifests.extend([("check".to_owned(), check), ("cover".to_owned(), cover)]);
            Some(m.instance("neighbor_cache", module))
        }
    };
    let placed = Units::connected(&mut m, config, [traversal.module, leaf.module]);
    let (fetch, tree) = placed.tree(&mut m, config);
    placed.queries(&mut m, config, neighbor_cache);
    let point = placed.points(&mut m, config, fetch);
    placed.results(&mut m, config, neighbor_cache);
    let events = placed.events(&mut m, config, Caches { point, tree, neighbor: neighbor_cache });
    PORTS.events.drive(&mut m, config, events);
    Ok(Core { module: m, manifests })
}
