//! The search core on AXI (`docs/interfaces.md`): queries and results as packets, points in memory, the tree behind a window or in memory,
//! registers.

use std::rc::Rc;

use pointcore_contract::bus::config::TREE_WORD_BITS;
use pointcore_contract::bus::registers::{ErrorInputs, ErrorSources, SearchRegisters};
use pointcore_contract::bus::units::search_axi::Ports;
use pointcore_contract::bus::units::{self, ReadRequest, WindowWrite};
use pointcore_contract::bus::{Layout, packets};
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{
    Beat, BeatPlace, CacheSetup, CachedQuery, CachedResult, Fetch, Lookup, Points, TreeRecord, TreeWrite,
};
use pointcore_contract::search::units::top::PORTS;
use pointcore_contract::unit::In;
use pointcore_contract::{Record, record};

use super::wiring::{Abort, feed, place, report};
use crate::bus::{Top, packet_in, packet_out, reader, registers, window};
use crate::compiler::{CompileError, Options};
use crate::search::top;
use crate::stream::fifo;
use crate::units::passage::Passage;
use crate::units::ports::{
    Flow, InputPorts, OutputPorts, Pulse, PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort, export,
    pipe,
};
use crate::units::wires::{Bundle, Wired, layout};
use rtl::{Expr, Instance, Module, bit, cat, lit};

/// Requests to memory that may await their answer.
const REQUESTS_MAX: u32 = 16;

/// The ports of what is placed.
const TOP: Ports = Ports::ALL;
const CONTROL: units::registers::Ports<SearchRegisters> = units::registers::Ports::ALL;
const QUERIES: units::packet_in::Ports<CachedQuery> = units::packet_in::Ports::ALL;
const RESULTS: units::packet_out::Ports<CachedResult> = units::packet_out::Ports::ALL;
const POINTS: units::reader::Ports<Points> = units::reader::Ports::ALL;
const TREE: units::reader::Ports<TreeWord> = units::reader::Ports::ALL;
const WINDOW: units::window::Ports = units::window::Ports::ALL;

/// Where errors come from: the window or the reader of the tree beside the reader of points.
#[must_use]
pub const fn error_sources(config: &Config) -> ErrorSources {
    let (busy, memory) = if config.tree_cache == 0 { (1, 1) } else { (0, 2) };
    ErrorSources { busy, burst: 3, packet: 1, memory }
}

/// A word of the tree as it lies in the window and in memory.
#[record(config: Config)]
struct TreeWord {
    /// What a node or a leaf holds.
    #[bits(TREE_WORD_BITS)]
    word: u64,
}

/// A record that lies in a word of the tree.
fn in_word<B: Bundle>(config: &B::Config, word: Expr) -> B {
    let layout = Layout::record::<B>(config);
    B::from_values(config, layout.places.iter().map(|place| word.bits((place.bit() + place.width) - 1, place.bit())))
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
    if config.neighbor_cache > 0 {
        setup(&mut m, config, core, control, start);
    }
    let run = run(&mut m, config, core, control, queries, results, start);

    let points = points(&mut m, config, core, control, abort);
    let tree = match config.tree_cache {
        0 => tree_window(&mut m, config, core, control, abort),
        _ => tree_memory(&mut m, config, core, control, abort),
    };
    let quiet = m.wire("quiet", run.results_idle & (points.idle & tree.idle));
    let finished = abort.finished(&mut m, run.answered & run.results_idle, quiet);
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

/// Hands the neighbor cache its constants, after the cycle in which a start may reset the core.
fn setup(m: &mut Module, config: &Config, core: Instance, control: Instance, start: Expr) {
    let valid = m.reg_reset("sets_up", 1, 0);
    m.next(valid, start);
    let settings = CONTROL.settings.of(m, config, control);
    let (far_scale, margin_scale) = (settings.cache_far_scale, settings.cache_margin_scale);
    let record = CacheSetup { ball: settings.cache_ball, far_scale, margin_scale };
    PORTS.setup.feed(m, config, core, Pulse { valid: valid.expr(), record });
}

/// How far a run is.
struct Run {
    /// All queries are answered.
    answered: Expr,
    /// No result is on its way.
    results_idle: Expr,
}

/// Counts queries in, and the last results of queries out.
fn run(
    m: &mut Module,
    config: &Config,
    core: Instance,
    control: Instance,
    queries: Instance,
    results: Instance,
    start: Expr,
) -> Run {
    let wanted = CONTROL.settings.of(m, config, control).queries;
    let width = wanted.width();
    let countdown = |m: &mut Module, name: &str, goes: Expr| {
        let left = m.reg_reset(name, width, 0);
        m.next(left, start.mux(wanted, left - goes.zext(width)));
        left
    };
    // The pulse comes a cycle after its packet, in which the next one may already end.
    let taken = QUERIES.taken.word_of(m, queries);
    let queries_left = countdown(m, "queries_left", taken);
    let few = queries_left.bits(width - 1, 2).is_zero();
    let last = taken.mux(queries_left.trunc(2).eq_lit(2), queries_left.trunc(2).eq_lit(1));
    QUERIES.last.feed_word(m, queries, few & last);

    let result = PORTS.result.of(m, config, core);
    RESULTS.input.feed(m, config, results, result);
    let answered = m.wire("answered", result.transfer() & result.record.result.last);
    let answers_left = countdown(m, "answers_left", answered);
    Run { answered: !answers_left.any() & !start, results_idle: RESULTS.idle.word_of(m, results) }
}

/// What the other parts hear of the points.
struct PointSignals {
    /// A leaf without beats is read: as one of one beat.
    empty: Expr,
    /// A burst is misshapen.
    misplaced: Expr,
    /// Memory answers with an error.
    error: Expr,
    /// None are awaited.
    idle: Expr,
}

/// Reads points.
fn points(m: &mut Module, config: &Config, core: Instance, control: Instance, abort: Abort) -> PointSignals {
    let bits = config.bus.memory_bits;
    let most = units::beats_max(config);
    let reads = m.instance("points", reader::module::<Points>(config, bits, most));
    export(m, &bits, (reads, POINTS.memory), TOP.points);
    let base = CONTROL.settings.of(m, config, control).points_base;
    let mut fetch = PORTS.fetch.of(m, config, core);
    let is_empty = m.wire("is_empty", fetch.record.beats.is_zero());
    let empty = m.reg_reset("empty_leaf", 1, 0);
    m.next(empty, fetch.transfer() & is_empty);
    fetch.record.beats = m.wire("beats", fetch.record.beats | is_empty.zext(config.beats_bits()));
    let stride_bits = Layout::record::<Points>(config).stride(bits).ilog2();
    let address = m.wire("points_address", place(base, fetch.record.address, stride_bits));
    let asked = Asked { name: "fetches", address, records: fetch.record.beats, records_max: most };
    let head = asked.remembered::<Fetch>(m, config, fetch, (reads, POINTS.request));

    let record = POINTS.record.of(m, config, reads);
    let place_bits = config.beats_bits();
    let place = m.reg_reset("beat", place_bits, 0);
    let last = m.wire("last_beat", place.add_lit(1).eq(head.record.beats));
    let gives = m.wire("gives_beat", record.valid & head.valid);
    let address = head.record.address + place.resize(config.beat_bits());
    let beat = Beat { place: BeatPlace { thread: head.record.thread, address, last }, points: record.record };
    let taken = PORTS.beat.offer(m, config, core, gives, beat) | abort.drops;
    m.drive(record.ready, taken & head.valid);
    let moves = m.wire("beat_moves", gives & taken);
    m.drive(head.ready, moves & last);
    m.next_if(place, moves, last.mux(lit(place_bits, 0), place.add_lit(1)));
    let [misplaced, error] = [POINTS.misplaced, POINTS.error].map(|port| port.word_of(m, reads));
    PointSignals { empty: empty.expr(), misplaced, error, idle: !head.valid }
}

/// What the other parts hear of the tree.
struct TreeSignals {
    /// The tree is written while a run is under way, where it can be written.
    busy: Option<Expr>,
    /// A burst is refused or misshapen.
    burst: Expr,
    /// Memory answers with an error, where the tree lies in memory.
    memory: Option<Expr>,
    /// Nothing of it is awaited.
    idle: Expr,
}

/// Lets the host write the tree.
fn tree_window(m: &mut Module, config: &Config, core: Instance, control: Instance, abort: Abort) -> TreeSignals {
    let index_bits = units::window_index_bits(config);
    let window = m.instance("tree", window::module(index_bits));
    export(m, &units::window_bits(index_bits), (window, WINDOW.host), TOP.window);
    let Pulse { valid, record: WindowWrite { index, data: word } } = WINDOW.write.of(m, &index_bits, window);
    let (node, bucket) = (in_word(config, word), in_word(config, word));
    let record = TreeWrite { is_leaf: index.msb(), address: index.trunc(config.tree_depth), node, bucket };
    PORTS.tree.feed(m, config, core, Pulse { valid, record });
    let busy = CONTROL.busy.word_of(m, control);
    WINDOW.locked.feed_word(m, window, busy);
    let occupied = WINDOW.occupied.word_of(m, window);
    CONTROL.occupied.feed_word(m, control, occupied | abort.drops);
    let [refused_busy, burst] = [WINDOW.refused_busy, WINDOW.refused_burst].map(|port| port.word_of(m, window));
    TreeSignals { busy: Some(refused_busy), burst, memory: None, idle: bit(true) }
}

/// Reads the tree.
fn tree_memory(m: &mut Module, config: &Config, core: Instance, control: Instance, abort: Abort) -> TreeSignals {
    let bits = config.bus.memory_bits;
    let reads = m.instance("tree", reader::module::<TreeWord>(config, bits, 1));
    export(m, &bits, (reads, TREE.memory), TOP.tree);
    CONTROL.occupied.feed_word(m, control, abort.drops);
    let base = CONTROL.settings.of(m, config, control).tree_base;
    let lookup = PORTS.lookup.of(m, config, core);
    let stride_bits = packets::tree_stride(config, bits).ilog2();
    let address = m.wire("tree_address", place(base, lookup.record.address, stride_bits));
    let asked = Asked { name: "lookups", address, records: bit(true), records_max: 1 };
    let head = asked.remembered::<Lookup>(m, config, lookup, (reads, TREE.request));

    let record = TREE.record.of(m, config, reads);
    let gives = m.wire("gives_record", record.valid & head.valid);
    let TreeWord { word } = record.record;
    let (node, bucket) = (in_word(config, word), in_word(config, word));
    let answer = TreeRecord { lookup: head.record, node, bucket };
    let taken = PORTS.record.offer(m, config, core, gives, answer) | abort.drops;
    m.drive(record.ready, taken & head.valid);
    m.drive(head.ready, taken & record.valid);
    let [burst, error] = [TREE.misplaced, TREE.error].map(|port| port.word_of(m, reads));
    TreeSignals { busy: None, burst, memory: Some(error), idle: !head.valid }
}

/// A request of the core's to memory.
struct Asked {
    name: &'static str,
    address: Expr,
    records: Expr,
    records_max: u32,
}

impl Asked {
    /// Hands the request to a reader and remembers whose it is; returns the oldest that is not answered.
    fn remembered<R: Record>(
        self,
        m: &mut Module,
        config: &R::Config,
        stream: Flow<Wired<R>>,
        (reads, port): (Instance, In<ReadRequest>),
    ) -> Flow<Wired<R>> {
        let queue = Passage::<R>::place(m, self.name, fifo(REQUESTS_MAX, &layout::<R>(config)));
        let room = queue.room(m);
        let reader_ready = port.room(m, reads);
        queue.push(m, config, stream.valid & reader_ready, stream.record);
        let request = ReadRequest { address: self.address, records: self.records };
        feed(m, &self.records_max, (stream.valid, stream.ready), (reads, port), room, request);
        queue.out(m, config)
    }
}
