//! The search core on AXI (`docs/interfaces.md`): queries and results as packets, points in memory, the tree behind a window or in memory,
//! registers.

use std::rc::Rc;

use pointcore_contract::bus::config::TREE_WORD_BITS;
use pointcore_contract::bus::{Bus, Layout, packets, ports, registers as maps};
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Beat, BeatPlace, CacheSetup, Fetch, Lookup, Points, TreeRecord, TreeWrite};
use pointcore_contract::search::units::events;
use pointcore_contract::search::units::top::PORTS;
use pointcore_contract::unit::In;
use pointcore_contract::{Record, fields, record};

use super::wiring::{export, feed, place, report};
use crate::bus::reader::Request;
use crate::bus::{Top, packet_in, packet_out, reader, registers, window};
use crate::compiler::{CompileError, Options};
use crate::search::top;
use crate::stream::fifo;
use crate::units::ports::{Flow, Pulse, PulseInPorts, StreamOutPorts};
use crate::units::wires::{Bundle, Wired, Wires, layout};
use rtl::{Expr, Instance, Module, bit, cat, lit};

/// Requests to memory that may await their answer.
const REQUESTS_MAX: u32 = 16;

/// Where errors come from: the window or the reader of the tree beside the reader of points.
#[must_use]
pub const fn error_sources(config: &Config) -> ports::ErrorSources {
    if config.tree_cache == 0 { [1, 2, 1, 1] } else { [0, 2, 1, 2] }
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

/// Builds the core on its bus; ports as in `contract::bus::ports::search`.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Top, CompileError> {
    let top::Core { module: core_module, manifests } = top::core(config, options)?;
    let core_module = Rc::new(core_module);
    let bus = config.bus;
    let map = maps::search(config);
    let sources = error_sources(config);
    let [query, result] = packets::query_and_result(config);
    let mut m = Module::new("search_axi", "Neighbor search on AXI.");
    // First, so that its modules have the names that they have without a bus.
    let core = m.instance("core", core_module.clone());
    let control = m.instance("registers", registers::module(&map, sources));
    let range = packets::query_range(config);
    let queries = m.instance("queries", packet_in::module(&query, bus.stream_bits, Some(&range)));
    let results = m.instance("results", packet_out::module(&result, bus.stream_bits));
    export(&mut m, control, Bus::Registers, "s_axil", "s_axil");
    export(&mut m, queries, Bus::StreamIn(bus.stream_bits), "s_axis", "s_axis_query");
    export(&mut m, results, Bus::StreamOut(bus.stream_bits), "m_axis", "m_axis_result");

    let [start, core_reset] = ["start", "core_reset"].map(|name| m.out(control, name));
    m.reset_by(core, core_reset);
    m.connect(queries, "opens", start);
    m.pipe((queries, "out"), (core, "query"));
    if config.neighbor_cache > 0 {
        setup(&mut m, config, core, control, start);
    }
    run(&mut m, config, core, control, queries, results, start);

    let points = points(&mut m, config, core, control);
    let tree = match config.tree_cache {
        0 => tree_window(&mut m, config, core, control),
        _ => tree_memory(&mut m, config, core, control),
    };
    let bursts = [(&points, "misplaced"), (&tree, if config.tree_cache == 0 { "refused_burst" } else { "misplaced" })];
    let bursts = bursts.map(|(unit, name)| m.out(*unit, name));
    m.connect(control, "burst_error", cat([bursts[0], bursts[1]]));
    let answers = m.out(points, "error");
    let answers = match config.tree_cache {
        0 => answers,
        _ => cat([answers, m.out(tree, "error")]),
    };
    m.connect(control, "memory_error", answers);
    report(&mut m, control, core, [queries, results], events(config));
    Ok(Top { module: m, core: core_module, manifests })
}

/// Hands the neighbor cache its constants, after the cycle in which a start may reset the core.
fn setup(m: &mut Module, config: &Config, core: Instance, control: Instance, start: Expr) {
    let valid = m.reg_reset("sets_up", 1, 0);
    m.next(valid, start);
    let record = CacheSetup::<Wires>::shown_by(m, config, control, "cache_");
    PORTS.setup.feed(m, config, core, Pulse { valid: valid.expr(), record });
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
) {
    let wanted = m.out(control, "queries");
    let width = wanted.width();
    let countdown = |m: &mut Module, name: &str, goes: Expr| {
        let left = m.reg_reset(name, width, 0);
        m.next(left, start.mux(wanted, left - goes.zext(width)));
        left
    };
    // The pulse comes a cycle after its packet, in which the next one may already end.
    let taken = m.out(queries, "taken");
    let queries_left = countdown(m, "queries_left", taken);
    let few = queries_left.bits(width - 1, 2).is_zero();
    let last = taken.mux(queries_left.trunc(2).eq_lit(2), queries_left.trunc(2).eq_lit(1));
    m.connect(queries, "last", few & last);

    let result = PORTS.result.of(m, config, core);
    result.into(m, config, results, "in");
    let answered = m.wire("answered", result.transfer() & result.record.result.last);
    let answers_left = countdown(m, "answers_left", answered);
    let idle = m.out(results, "idle");
    m.connect(control, "finished", (!answers_left.any() & !start) & idle);
}

/// Reads points; returns the reader.
fn points(m: &mut Module, config: &Config, core: Instance, control: Instance) -> Instance {
    let bits = config.bus.memory_bits;
    let fields = fields::<Points>(config);
    let most = ports::beats_max(config);
    let reads = m.instance("points", reader::module(&fields, bits, most));
    export(m, reads, Bus::ReadMaster(bits), "m_axi", "m_axi");
    let base = m.out(control, "points_base");
    let fetch = PORTS.fetch.of(m, config, core);
    let stride_bits = Layout::of(&fields).stride(bits).ilog2();
    let address = m.wire("points_address", place(base, fetch.record.address, stride_bits));
    let asked = Asked { name: "fetches", address, records: fetch.record.beats, records_max: most };
    let head = asked.remembered::<Fetch<Wires>>(m, config, fetch, reads);

    let record = Flow::<Points<Wires>>::from(m, config, reads, "record");
    let place_bits = config.beats_bits();
    let place = m.reg_reset("beat", place_bits, 0);
    let last = m.wire("last_beat", place.add_lit(1).eq(head.record.beats));
    let gives = m.wire("gives_beat", record.valid & head.valid);
    let address = head.record.address + place.resize(config.beat_bits());
    let beat = Beat { place: BeatPlace { thread: head.record.thread, address, last }, points: record.record };
    let taken = give(m, config, (core, PORTS.beat), gives, beat);
    m.drive(record.ready, taken & head.valid);
    let moves = m.wire("beat_moves", gives & taken);
    m.drive(head.ready, moves & last);
    m.next_if(place, moves, last.mux(lit(place_bits, 0), place.add_lit(1)));
    reads
}

/// Lets the host write the tree; returns the window.
fn tree_window(m: &mut Module, config: &Config, core: Instance, control: Instance) -> Instance {
    let index_bits = ports::window_index_bits(config);
    let window = m.instance("tree", window::module(index_bits));
    export(m, window, Bus::Slave(TREE_WORD_BITS), "s_axi", "s_axi");
    let [valid, index, word] = ["write_valid", "write_index", "write_data"].map(|name| m.out(window, name));
    let (node, bucket) = (in_word(config, word), in_word(config, word));
    let record = TreeWrite { is_leaf: index.msb(), address: index.trunc(config.tree_depth), node, bucket };
    PORTS.tree.feed(m, config, core, Pulse { valid, record });
    let [busy, refused, occupied] =
        [(control, "busy"), (window, "refused_busy"), (window, "occupied")].map(|(unit, name)| m.out(unit, name));
    m.connect(window, "locked", busy);
    m.connect(control, "busy_error", refused);
    m.connect(control, "occupied", occupied);
    window
}

/// Reads the tree; returns the reader.
fn tree_memory(m: &mut Module, config: &Config, core: Instance, control: Instance) -> Instance {
    let bits = config.bus.memory_bits;
    let fields = fields::<TreeWord>(config);
    let reads = m.instance("tree", reader::module(&fields, bits, 1));
    export(m, reads, Bus::ReadMaster(bits), "m_axi", "m_axi_tree");
    m.connect(control, "occupied", bit(false));
    let base = m.out(control, "tree_base");
    let lookup = PORTS.lookup.of(m, config, core);
    let stride_bits = packets::tree_stride(config, bits).ilog2();
    let address = m.wire("tree_address", place(base, lookup.record.address, stride_bits));
    let asked = Asked { name: "lookups", address, records: bit(true), records_max: 1 };
    let head = asked.remembered::<Lookup<Wires>>(m, config, lookup, reads);

    let record = Flow::<TreeWord<Wires>>::from(m, config, reads, "record");
    let gives = m.wire("gives_record", record.valid & head.valid);
    let TreeWord { word } = record.record;
    let (node, bucket) = (in_word(config, word), in_word(config, word));
    let answer = TreeRecord { lookup: head.record, node, bucket };
    let taken = give(m, config, (core, PORTS.record), gives, answer);
    m.drive(record.ready, taken & head.valid);
    m.drive(head.ready, taken & record.valid);
    reads
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
    fn remembered<B: Bundle>(self, m: &mut Module, config: &B::Config, stream: Flow<B>, reads: Instance) -> Flow<B> {
        let queue = m.instance(self.name, fifo(REQUESTS_MAX, &layout::<B>(config)));
        let room = m.out(queue, "in_ready");
        let reader_ready = m.out(reads, "request_ready");
        m.connect(queue, "in_valid", stream.valid & reader_ready);
        stream.record.connect(m, config, queue, "in_");
        let request = Request { address: self.address, records: self.records };
        let (request, stream) = (request.named(&self.records_max), (stream.valid, stream.ready));
        feed(m, stream, (reads, "request"), room, request);
        Flow::from(m, config, queue, "out")
    }
}

/// Shows a record to the core; returns whether it would be taken.
fn give<R: Record>(
    m: &mut Module,
    config: &R::Config,
    (core, ports): (Instance, In<R>),
    valid: Expr,
    record: Wired<R>,
) -> Expr {
    m.connect(core, &format!("{}_valid", ports.name), valid);
    record.connect(m, config, core, &format!("{}_", ports.name));
    m.out(core, &format!("{}_ready", ports.name))
}
