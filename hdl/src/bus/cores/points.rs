//! The point processor on AXI (`docs/interfaces.md`): queries and results as packets, positions and points in memory, the tree behind a
//! window or in memory, registers.

use std::rc::Rc;

use pointcore_contract::bus::Layout;
use pointcore_contract::bus::registers::{ErrorInputs, ErrorSources, PointsRegisters};
use pointcore_contract::bus::units::points_axi::Ports;
use pointcore_contract::bus::units::{self, ReadRequest};
use pointcore_contract::points::Config;
use pointcore_contract::points::units::Neighborhood;
use pointcore_contract::points::units::top::PORTS;
use pointcore_contract::process::queries::{Outcome, Query};
use pointcore_contract::process::records::{Neighbor, Settings};
use pointcore_contract::process::units::LINES_UNDER_WAY;
use pointcore_contract::search::records::CacheSetup;
use pointcore_contract::splat::config::index_bits;

use super::memory::Search;
use super::wiring::{Abort, feed, place, report, run, set_up};
use crate::bus::{Top, packet_in, packet_out, reader, registers};
use crate::compiler::{CompileError, Options};
use crate::points::top;
use crate::units::ports::{InputPorts, OutputPorts, StreamInPorts, StreamOutPorts, WordPort, export, pipe};
use rtl::{Expr, Instance, Module, bit, cat, lit};

/// The ports of what is placed.
const TOP: Ports = Ports::ALL;
const CONTROL: units::registers::Ports<PointsRegisters> = units::registers::Ports::ALL;
const QUERIES: units::packet_in::Ports<Query> = units::packet_in::Ports::ALL;
const RESULTS: units::packet_out::Ports<Outcome> = units::packet_out::Ports::ALL;
const LINES: units::reader::Ports<Neighbor> = units::reader::Ports::ALL;

/// Where errors come from: those of the search, and the reader of lines.
#[must_use]
pub const fn error_sources(config: &Config) -> ErrorSources {
    let search = super::search::error_sources(&config.search);
    ErrorSources { burst: search.burst + 1, memory: search.memory + 1, ..search }
}

/// Builds the core on its bus; ports as in `contract::bus::units::points_axi`.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Top, CompileError> {
    let top::Core { module: core_module, manifests } = top::core(config, options)?;
    let core_module = Rc::new(core_module);
    let (bus, sources) = (config.search.bus, error_sources(config));
    let mut m = Module::new("points_axi", "Point processor on AXI.");
    // First, so that its modules have the names that they have without a bus.
    let core = m.instance("core", core_module.clone());
    let control = m.instance("registers", registers::module::<PointsRegisters>(config, sources));
    let queries = m.instance("queries", packet_in::module::<Query>(&config.process, bus.stream_bits));
    let results = m.instance("results", packet_out::module::<Outcome>(&config.process, bus.stream_bits));
    export(&mut m, &(), (control, CONTROL.host), TOP.registers);
    export(&mut m, &bus.stream_bits, (queries, QUERIES.packets), TOP.queries);
    export(&mut m, &bus.stream_bits, (results, RESULTS.packets), TOP.results);

    let [start, core_reset] = [CONTROL.start, CONTROL.core_reset].map(|port| port.word_of(&mut m, control));
    let abort = Abort::place::<PointsRegisters>(&mut m, control);
    m.reset_by(core, core_reset | abort.drops);
    m.reset_by(queries, abort.drops);
    QUERIES.opens.feed_word(&mut m, queries, start);
    pipe(&mut m, &config.process, (queries, QUERIES.out), (core, PORTS.query));
    let search = constants(&mut m, config, core, control, start, abort);
    let result = PORTS.result.of(&mut m, &config.process, core);
    RESULTS.input.feed(&mut m, &config.process, results, result);
    let answered = m.wire("answered", result.transfer());
    let wanted = CONTROL.settings.of(&mut m, config, control).queries;
    let is_answered = run::<Query>(&mut m, wanted, queries, start, answered);
    let results_idle = RESULTS.idle.word_of(&mut m, results);

    let (points, tree) = (search.points(&mut m), search.tree(&mut m));
    let lines = lines(&mut m, config, core, control, abort);
    CONTROL.occupied.feed_word(&mut m, control, tree.occupied | abort.drops);
    let quiet = m.wire("quiet", (results_idle & lines.idle) & (points.idle & tree.idle));
    let finished = abort.finished(&mut m, is_answered & results_idle, quiet);
    CONTROL.finished.feed_word(&mut m, control, finished);
    let errors = ErrorInputs {
        busy_error: tree.busy.unwrap_or_default(),
        burst_error: cat([lines.misplaced, points.empty, points.misplaced, tree.burst]),
        packet_error: QUERIES.refused.word_of(&mut m, queries),
        memory_error: cat([lines.error, points.error].into_iter().chain(tree.memory)),
    };
    CONTROL.errors.feed(&mut m, &sources, control, errors);
    let events = (core, PORTS.events);
    let irq = report::<PointsRegisters, Query, Outcome>(&mut m, config, control, events, [queries, results]);
    TOP.irq.drive_word(&mut m, irq);
    Ok(Top { module: m, core: core_module, manifests })
}

/// Leads what holds for a run from the registers to the core; returns the search.
fn constants<'a>(
    m: &mut Module,
    config: &'a Config,
    core: Instance,
    control: Instance,
    start: Expr,
    abort: Abort,
) -> Search<'a> {
    let settings = CONTROL.settings.of(m, config, control);
    PORTS.settings.feed(m, &config.process, core, Settings { words: settings.program });
    PORTS.iterations_max.feed_word(m, core, settings.iterations_max);
    let neighborhood = Neighborhood { k: settings.k, radius2: settings.radius2, reach: settings.reach };
    PORTS.search.feed(m, &config.search, core, neighborhood);
    if config.search.neighbor_cache > 0 {
        let (far_scale, margin_scale) = (settings.cache_far_scale, settings.cache_margin_scale);
        let record = CacheSetup { ball: settings.cache_ball, far_scale, margin_scale };
        set_up(m, &config.search, (core, PORTS.setup), start, record);
    }
    Search {
        config: &config.search,
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
        busy: CONTROL.busy.word_of(m, control),
        abort,
    }
}

/// What the other parts hear of the lines.
struct LineSignals {
    /// A burst is misshapen.
    misplaced: Expr,
    /// Memory answers with an error.
    error: Expr,
    /// No point is awaited.
    idle: Expr,
}

/// Reads lines of points, which come in the order in which they are asked for.
fn lines(m: &mut Module, config: &Config, core: Instance, control: Instance, abort: Abort) -> LineSignals {
    let (bits, most) = (config.search.bus.memory_bits, config.process.line_points);
    let reads = m.instance("lines", reader::module::<Neighbor>(&config.process, bits, most));
    export(m, &bits, (reads, LINES.memory), TOP.lines);
    let base = CONTROL.settings.of(m, config, control).lines_base;
    let line = PORTS.line.of(m, &config.process, core);
    let stride = Layout::record::<Neighbor>(&config.process).stride(bits) * most;
    let address = m.wire("line_address", place(base, line.record.line, stride.ilog2()));
    let records = lit(index_bits(most + 1), most.into());
    feed(m, &most, (line.valid, line.ready), (reads, LINES.request), bit(true), ReadRequest { address, records });

    let record = LINES.record.of(m, &config.process, reads);
    let taken = PORTS.fill.offer(m, &config.process, core, record.valid, record.record) | abort.drops;
    m.drive(record.ready, taken);
    // What the core waits for, and what it has shown to ask for next.
    let width = index_bits((LINES_UNDER_WAY + 2) * most);
    let awaited = m.reg_reset("points_awaited", width, 0);
    let asked = line.transfer().repeat(width) & lit(width, most.into());
    m.next(awaited, (awaited + asked) - record.transfer().zext(width));
    let [misplaced, error] = [LINES.misplaced, LINES.error].map(|port| port.word_of(m, reads));
    LineSignals { misplaced, error, idle: awaited.is_zero() }
}
