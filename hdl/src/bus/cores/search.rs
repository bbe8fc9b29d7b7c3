//! The search core on AXI (`docs/interfaces.md`): queries and results as packets, points in memory, the tree behind a window or in memory,
//! registers.

use std::rc::Rc;

use pointcore_contract::bus::registers::{ErrorInputs, ErrorSources, SearchRegisters};
use pointcore_contract::bus::units;
use pointcore_contract::bus::units::search_axi::Ports;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{CacheSetup, CachedQuery, CachedResult};
use pointcore_contract::search::units::top::PORTS;

use super::memory::Search;
use super::wiring::{Abort, report, run, set_up};
use crate::bus::{Top, packet_in, packet_out, registers};
use crate::compiler::{CompileError, Options};
use crate::search::top;
use crate::units::ports::{InputPorts, OutputPorts, StreamInPorts, StreamOutPorts, WordPort, export, pipe};
use rtl::{Module, cat};

/// The ports of what is placed.
const TOP: Ports = Ports::ALL;
const CONTROL: units::registers::Ports<SearchRegisters> = units::registers::Ports::ALL;
const QUERIES: units::packet_in::Ports<CachedQuery> = units::packet_in::Ports::ALL;
const RESULTS: units::packet_out::Ports<CachedResult> = units::packet_out::Ports::ALL;

/// Where errors come from: the window or the reader of the tree beside the reader of points.
#[must_use]
pub const fn error_sources(config: &Config) -> ErrorSources {
    let (busy, memory) = if config.tree_cache == 0 { (1, 1) } else { (0, 2) };
    ErrorSources { busy, burst: 3, packet: 1, memory }
}

/// Builds the core on its bus; ports as in `contract::bus::units::search_axi`.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Top, CompileError> {
    let top::Core { module: core_module, manifests } = top::core(config, options)?;
    let core_module = Rc::new(core_module);
    let bus = config.bus;
    let sources = error_sources(config);
    let mut m = Module::new("search_axi", "Neighbor search on AXI.");
    // First, so that its modules have the names that they have without a bus.
    let core = m.instance("core", core_module.clone());
    let control = m.instance("registers", registers::module::<SearchRegisters>(config, sources));
    let queries = m.instance("queries", packet_in::module::<CachedQuery>(config, bus.stream_bits));
    let results = m.instance("results", packet_out::module::<CachedResult>(config, bus.stream_bits));
    export(&mut m, &(), (control, CONTROL.host), TOP.registers);
    export(&mut m, &bus.stream_bits, (queries, QUERIES.packets), TOP.queries);
    export(&mut m, &bus.stream_bits, (results, RESULTS.packets), TOP.results);

    let [start, core_reset] = [CONTROL.start, CONTROL.core_reset].map(|port| port.word_of(&mut m, control));
    let abort = Abort::place::<SearchRegisters>(&mut m, control);
    m.reset_by(core, core_reset | abort.drops);
    m.reset_by(queries, abort.drops);
    QUERIES.opens.feed_word(&mut m, queries, start);
    pipe(&mut m, config, (queries, QUERIES.out), (core, PORTS.query));
    let settings = CONTROL.settings.of(&mut m, config, control);
    if config.neighbor_cache > 0 {
        let (far_scale, margin_scale) = (settings.cache_far_scale, settings.cache_margin_scale);
        let record = CacheSetup { ball: settings.cache_ball, far_scale, margin_scale };
        set_up(&mut m, config, (core, PORTS.setup), start, record);
    }
    let result = PORTS.result.of(&mut m, config, core);
    RESULTS.input.feed(&mut m, config, results, result);
    let answered = m.wire("answered", result.transfer() & result.record.result.last);
    let is_answered = run::<CachedQuery>(&mut m, settings.queries, queries, start, answered);
    let results_idle = RESULTS.idle.word_of(&mut m, results);

    let search = Search {
        config,
        core,
        tree: PORTS.tree,
        lookup: PORTS.lookup,
        record: PORTS.record,
        fetch: PORTS.fetch,
        beat: PORTS.beat,
        points_bus: TOP.points,
        window_bus: TOP.window,
        tree_bus: TOP.tree,
        points_base: settings.points_base,
        tree_base: settings.tree_base,
        busy: CONTROL.busy.word_of(&mut m, control),
        abort,
    };
    let (points, tree) = (search.points(&mut m), search.tree(&mut m));
    CONTROL.occupied.feed_word(&mut m, control, tree.occupied | abort.drops);
    let quiet = m.wire("quiet", results_idle & (points.idle & tree.idle));
    let finished = abort.finished(&mut m, is_answered & results_idle, quiet);
    CONTROL.finished.feed_word(&mut m, control, finished);
    let errors = ErrorInputs {
        busy_error: tree.busy.unwrap_or_default(),
        burst_error: cat([points.empty, points.misplaced, tree.burst]),
        packet_error: QUERIES.refused.word_of(&mut m, queries),
        memory_error: cat(std::iter::once(points.error).chain(tree.memory)),
    };
    CONTROL.errors.feed(&mut m, &sources, control, errors);
    let events = (core, PORTS.events);
    let irq = report::<SearchRegisters, CachedQuery, CachedResult>(&mut m, config, control, events, [queries, results]);
    TOP.irq.drive_word(&mut m, irq);
    Ok(Top { module: m, core: core_module, manifests })
}
