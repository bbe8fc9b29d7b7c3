//! The search and the process core behind it; golden twin: `pointcore_golden::points::top`.

use std::collections::BTreeMap;

use pointcore_contract::points::Config;
use pointcore_contract::points::units::Events;
use pointcore_contract::points::units::top::PORTS;
use pointcore_contract::process::config::ITERATION_BITS;
use pointcore_contract::process::queries::Found;
use pointcore_contract::process::records::Thread;
use pointcore_contract::process::stages::top::PORTS as PROCESS;
use pointcore_contract::search::records::{CachedQuery, Query};
use pointcore_contract::search::units::top::PORTS as SEARCH;

use crate::compiler::{CompileError, Manifest, Options};
use crate::units::ports::{InputPorts, OutputPorts, PulseInPorts, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::wires::Wires;
use crate::{process, search};
use rtl::{Instance, Module, bit};

/// The core's module and what the compiler decided about its datapaths.
pub struct Core {
    /// The top module, `points_top`.
    pub module: Module,
    /// By unit of the search, and by block of the program.
    pub manifests: BTreeMap<String, Manifest>,
}

/// The two cores.
#[derive(Clone, Copy)]
struct Cores {
    search: Instance,
    process: Instance,
}

impl Cores {
    /// Leads searches from the threads to the search, and what it finds back.
    fn searches(self, m: &mut Module, config: &Config) {
        let constants = PORTS.search.declare(m, &config.search);
        let wanted = PROCESS.wanted.of(m, &config.process, self.process);
        let asked = wanted.map(|wanted| {
            let number = wanted.thread.thread.zext(config.search.index_bits);
            let query = Query { number, k: constants.k, radius2: constants.radius2, point: wanted.position };
            CachedQuery { query, reach: constants.reach }
        });
        SEARCH.query.feed(m, &config.search, self.search, asked);
        let result = SEARCH.result.of(m, &config.search, self.search);
        let found = result.map(|cached| {
            let result = cached.result;
            let thread = Thread { thread: result.number.trunc(config.process.thread_bits()) };
            Found { thread, last: result.last, found: result.found, index: result.index }
        });
        PROCESS.found.feed(m, &config.process, self.process, found);
    }

    /// Leads the tree to the search.
    fn tree(self, m: &mut Module, config: &Config) {
        let (config, search) = (&config.search, self.search);
        if config.tree_cache == 0 {
            let tree = PORTS.tree.declare(m, config);
            SEARCH.tree.feed(m, config, search, tree);
        } else {
            let lookup = SEARCH.lookup.of(m, config, search);
            PORTS.lookup.export(m, config, lookup);
            let record = PORTS.record.declare(m, config);
            SEARCH.record.feed(m, config, search, record);
        }
        if config.neighbor_cache > 0 {
            let setup = PORTS.setup.declare(m, config);
            SEARCH.setup.feed(m, config, search, setup);
        }
    }

    /// Leads positions to the search.
    fn positions(self, m: &mut Module, config: &Config) {
        let (config, search) = (&config.search, self.search);
        let fetch = SEARCH.fetch.of(m, config, search);
        PORTS.fetch.export(m, config, fetch);
        let beat = PORTS.beat.declare(m, config);
        SEARCH.beat.feed(m, config, search, beat);
    }

    /// Leads what is asked to the program.
    fn queries(self, m: &mut Module, config: &Config) {
        let (config, process) = (&config.process, self.process);
        let settings = PORTS.settings.declare(m, config);
        PROCESS.settings.feed(m, config, process, settings);
        let iterations_max = PORTS.iterations_max.declare_word(m, ITERATION_BITS);
        PROCESS.iterations_max.feed_word(m, process, iterations_max);
        // Who changes the points resets the core, whose caches forget them.
        PROCESS.forget.feed_word(m, process, bit(false));
        let query = PORTS.query.declare(m, config);
        PROCESS.query.feed(m, config, process, query);
    }

    /// Leads points to the program, and results from it.
    fn program(self, m: &mut Module, config: &Config) {
        let (config, process) = (&config.process, self.process);
        let line = PROCESS.fetch.of(m, config, process);
        PORTS.line.export(m, config, line);
        let fill = PORTS.fill.declare(m, config);
        PROCESS.fill.feed(m, config, process, fill);
        let result = PROCESS.result.of(m, config, process);
        PORTS.result.export(m, config, result);
        let idle = PROCESS.idle.word_of(m, process);
        PORTS.idle.drive_word(m, idle);
    }
}

/// Builds the core.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Core, CompileError> {
    let mut m = Module::new("points_top", "Point processor: queries in, what a program makes of their neighbors out.");
    let search::top::Core { module: search, mut manifests } = search::top::core(&config.search, options)?;
    let process::top::Core { module: process, manifests: blocks } = process::top::core(&config.process, options)?;
    manifests.extend(blocks);
    let cores = Cores { search: m.instance("search_core", search), process: m.instance("process_core", process) };
    // Ports stand in the order of the contract.
    cores.tree(&mut m, config);
    cores.searches(&mut m, config);
    cores.queries(&mut m, config);
    cores.positions(&mut m, config);
    cores.program(&mut m, config);
    let events = Events::<Wires> {
        search: SEARCH.events.of(&mut m, &config.search, cores.search),
        process: PROCESS.events.of(&mut m, &config.process, cores.process),
    };
    PORTS.events.drive(&mut m, config, events);
    Ok(Core { module: m, manifests })
}
