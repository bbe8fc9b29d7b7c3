//! The whole neighbor search: queries in, neighbors out, points behind a memory port; golden twin:
//! `pointcore_golden::search::top`.

use std::collections::BTreeMap;

use pointcore_contract::search::ports::{EVENTS, NEIGHBOR_CACHE_EVENTS, POINT_CACHE_EVENTS, TREE_CACHE_EVENTS};
use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;

use super::neighbor_cache::NeighborCache;
use super::{leaf, neighbor_cache, point_cache, queue, recursion, sieve, stack, threads, traversal, tree_cache};
use crate::compiler::{CompileError, Manifest, Options};
use crate::units::records::{Pulse, Record, pulse_in, stream_in};
use rtl::{Instance, Module, Stream};

/// The core's module and what the compiler decided about its datapaths.
pub struct Core {
    /// The top module, `search_top`.
    pub module: Module,
    /// By unit.
    pub manifests: BTreeMap<String, Manifest>,
}

/// A pulse that a unit puts out.
fn pulse_from(m: &mut Module, from: Instance, name: &str, fields: &[Field]) -> Pulse {
    let valid = m.out(from, &format!("{name}_valid"));
    Pulse { valid, record: Record::new(fields, |field| m.out(from, &format!("{name}_{field}"))) }
}

/// Leads a pulse into a unit.
fn pulse_into(m: &mut Module, to: Instance, name: &str, pulse: &Pulse) {
    m.connect(to, &format!("{name}_valid"), pulse.valid);
    pulse.record.connect(m, to, &format!("{name}_"));
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
        let units = Self {
            threads: m.instance("threads", threads::module(config)),
            traversal: m.instance("traversal", traversal),
            stack: m.instance("stack", stack::module(config)),
            recursion: m.instance("recursion", recursion::module(config)),
            leaf: m.instance("leaf", leaf),
            sieve: m.instance("sieve", sieve::module(config)),
            queue: m.instance("queue", queue::module(config)),
        };
        let Self { threads, traversal, stack, recursion, leaf, sieve, queue } = units;
        let start = pulse_from(m, threads, "start", &records::start(config));
        for unit in [traversal, recursion, leaf, sieve, queue] {
            pulse_into(m, unit, "start", &start);
        }
        m.pipe((threads, "descend"), (traversal, "descend"));
        m.pipe((threads, "pop"), (recursion, "in"));
        m.pipe((threads, "finish"), (queue, "finish"));
        m.pipe((recursion, "resume"), (traversal, "resume"));
        m.pipe((leaf, "candidates"), (sieve, "candidates"));
        m.pipe((sieve, "kept"), (queue, "candidates"));

        let thread_only = records::thread_only(config);
        let path = records::path(config);
        let pushed: Vec<_> = thread_only.iter().chain(&path).cloned().collect();
        let push = pulse_from(m, traversal, "push", &pushed);
        pulse_into(m, stack, "push", &push);
        let pop = pulse_from(m, recursion, "pop", &thread_only);
        pulse_into(m, stack, "pop", &pop);
        let top_empty = m.out(stack, "top_empty");
        m.connect(recursion, "top_empty", top_empty);
        Record::new(&path, |field| m.out(stack, &format!("top_{field}"))).connect(m, recursion, "top_");

        let radius = pulse_from(m, queue, "radius", &records::radius(config));
        for unit in [recursion, sieve] {
            pulse_into(m, unit, "radius", &radius);
        }
        let leaf_done = Pulse { valid: radius.valid, record: radius.record.only(&thread_only) };
        pulse_into(m, threads, "leaf_done", &leaf_done);
        for (unit, name) in [(traversal, "reached"), (sieve, "skipped"), (recursion, "empty"), (queue, "released")] {
            let pulse = pulse_from(m, unit, name, &thread_only);
            pulse_into(m, threads, name, &pulse);
        }
        units
    }

    /// Leads the tree to the units, from the host or through the cache of a tree in external memory; returns the requests
    /// for points, and the cache.
    fn tree(&self, m: &mut Module, config: &Config) -> (Stream, Option<Instance>) {
        let Self { traversal, leaf, .. } = *self;
        if config.tree_cache == 0 {
            let tree = pulse_in(m, "tree", &records::tree_write(config));
            for unit in [traversal, leaf] {
                pulse_into(m, unit, "tree", &tree);
            }
            m.pipe((traversal, "leaf"), (leaf, "leaf"));
            return (m.stream_from(leaf, "fetch"), None);
        }
        let cache = m.instance("tree_cache", tree_cache::module(config));
        let lookup = m.stream_from(cache, "lookup");
        m.stream_export("lookup", &lookup);
        let record = stream_in(m, "record", &records::tree_record(config));
        m.stream_into(cache, "fill", &record);
        m.pipe((traversal, "node"), (cache, "node"));
        m.pipe((traversal, "leaf"), (cache, "leaf"));
        m.pipe((cache, "record"), (traversal, "record"));
        (m.stream_from(cache, "fetch"), Some(cache))
    }

    /// Leads queries in, through the neighbor cache where there is one.
    fn queries(&self, m: &mut Module, config: &Config, cache: Option<Instance>) {
        let Some(cache) = cache else {
            let query = stream_in(m, "query", &records::query(config));
            m.stream_into(self.threads, "query", &query);
            return;
        };
        let setup = pulse_in(m, "setup", &records::cache_setup(config));
        pulse_into(m, cache, "setup", &setup);
        let query = stream_in(m, "query", &records::cached_query(config));
        m.stream_into(cache, "query", &query);
        m.pipe((cache, "search"), (self.threads, "query"));
    }

    /// Leads requests for points to the memory and beats back, through the point cache where there is one; returns it.
    fn points(&self, m: &mut Module, config: &Config, fetch: &Stream) -> Option<Instance> {
        let beat_fields = records::beat(config);
        if config.point_cache == 0 {
            m.stream_export("fetch", fetch);
            let beat = stream_in(m, "beat", &beat_fields);
            m.stream_into(self.leaf, "beat", &beat);
            return None;
        }
        let cache = m.instance("point_cache", point_cache::module(config));
        m.stream_into(cache, "fetch", fetch);
        let miss = m.stream_from(cache, "miss");
        m.stream_export("fetch", &miss);
        let beat = stream_in(m, "beat", &beat_fields);
        m.stream_into(cache, "fill", &beat);
        m.pipe((cache, "beat"), (self.leaf, "beat"));
        Some(cache)
    }

    /// Leads results out, through the neighbor cache where there is one.
    fn results(&self, m: &mut Module, cache: Option<Instance>) {
        if let Some(cache) = cache {
            m.pipe((self.queue, "result"), (cache, "found"));
        }
        let result = m.stream_from(cache.unwrap_or(self.queue), "result");
        m.stream_export("result", &result);
    }
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
    let units = Units::connected(&mut m, config, [traversal.module, leaf.module]);
    let (fetch, tree_cache) = units.tree(&mut m, config);
    units.queries(&mut m, config, neighbor_cache);
    let point_cache = units.points(&mut m, config, &fetch);
    units.results(&mut m, neighbor_cache);

    let Units { threads, traversal, recursion, queue, .. } = units;
    let own = EVENTS.into_iter().zip([traversal, recursion, queue, queue, queue, threads]);
    let point_events = point_cache.into_iter().flat_map(|cache| POINT_CACHE_EVENTS.map(|event| (event, cache)));
    let tree_events = tree_cache.into_iter().flat_map(|cache| TREE_CACHE_EVENTS.map(|event| (event, cache)));
    let neighbor_events =
        neighbor_cache.into_iter().flat_map(|cache| NEIGHBOR_CACHE_EVENTS.map(|event| (event, cache)));
    for (name, unit) in own.chain(point_events).chain(tree_events).chain(neighbor_events) {
        let event = m.out(unit, name);
        m.output(name, event);
    }
    Ok(Core { module: m, manifests })
}
