//! The search core on AXI (`docs/interfaces.md`): queries and results as packets, points in memory, the tree behind a window or in memory,
//! registers.

use std::rc::Rc;

use pointcore_contract::bus::config::TREE_WORD_BITS;
use pointcore_contract::bus::{Layout, packets, ports, registers as maps};
use pointcore_contract::search::ports::events;
use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::{Field, Port};

use super::wiring::{export, feed, place, report, request};
use crate::bus::{Top, packet_in, packet_out, reader, registers, window};
use crate::compiler::{CompileError, Options};
use crate::search::top;
use crate::stream::fifo;
use crate::units::records::{Record, layout};
use rtl::{Expr, Instance, Module, Stream, bit, cat, lit};

/// Requests to memory that may await their answer.
const REQUESTS_MAX: u32 = 16;

/// Where errors come from: the window or the reader of the tree beside the reader of points.
#[must_use]
pub const fn error_sources(config: &Config) -> ports::ErrorSources {
    if config.tree_cache == 0 { [1, 2, 1, 1] } else { [0, 2, 1, 2] }
}

/// The tree's words as they lie in the window and in memory.
fn tree_word() -> Vec<Field> {
    vec![("word".to_owned(), TREE_WORD_BITS)]
}

/// A field of a node or a leaf in a word of the tree.
fn field_of(config: &Config, word: Expr, name: &str) -> Expr {
    let fields = if records::node(config).iter().any(|(field, _)| field == name) {
        records::node(config)
    } else {
        records::bucket(config)
    };
    let layout = Layout::of(&fields);
    let place = layout.places.iter().find(|place| place.name == name).expect("a word holds a node or a leaf");
    word.bits((place.bit() + place.width) - 1, place.bit())
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
    export(&mut m, control, &ports::registers(&map, sources), "s_axil", "s_axil");
    export(&mut m, queries, &ports::packet_in(&query, bus.stream_bits), "s_axis", "s_axis_query");
    export(&mut m, results, &ports::packet_out(&result, bus.stream_bits), "m_axis", "m_axis_result");

    let [start, core_reset] = ["start", "core_reset"].map(|name| m.out(control, name));
    m.reset_by(core, core_reset);
    m.connect(queries, "opens", start);
    m.pipe((queries, "out"), (core, "query"));
    if config.neighbor_cache > 0 {
        setup(&mut m, config, core, control, start);
    }
    run(&mut m, core, control, queries, results, start);

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
    m.connect(core, "setup_valid", valid);
    for (name, _) in records::cache_setup(config) {
        let value = m.out(control, &format!("cache_{name}"));
        m.connect(core, &format!("setup_{name}"), value);
    }
}

/// Counts queries in, and the last results of queries out.
fn run(m: &mut Module, core: Instance, control: Instance, queries: Instance, results: Instance, start: Expr) {
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

    let result = m.stream_from(core, "result");
    m.stream_into(results, "in", &result);
    let answered = m.wire("answered", result.transfer() & result.field("last"));
    let answers_left = countdown(m, "answers_left", answered);
    let idle = m.out(results, "idle");
    m.connect(control, "finished", (!answers_left.any() & !start) & idle);
}

/// Reads points; returns the reader.
fn points(m: &mut Module, config: &Config, core: Instance, control: Instance) -> Instance {
    let bits = config.bus.memory_bits;
    let fields = packets::points(config);
    let most = ports::beats_max(config);
    let reads = m.instance("points", reader::module(&fields, bits, most));
    export(m, reads, &ports::reader(&fields, bits, most), "m_axi", "m_axi");
    let base = m.out(control, "points_base");
    let fetch = m.stream_from(core, "fetch");
    let stride_bits = Layout::of(&fields).stride(bits).ilog2();
    let address = m.wire("points_address", place(base, fetch.field("address"), stride_bits));
    let asked = Asked { name: "fetches", fields: records::fetch(config), address, records: fetch.field("beats") };
    let head = asked.remembered(m, &fetch, reads);

    let record = m.stream_from(reads, "record");
    let place_bits = config.beats_bits();
    let place = m.reg_reset("beat", place_bits, 0);
    let last = m.wire("last_beat", place.add_lit(1).eq(head.field("beats")));
    let gives = m.wire("gives_beat", record.valid & head.valid);
    let beat = Record::new(&records::beat(config), |name| match name {
        "thread" => head.field("thread"),
        "address" => head.field("address") + place.resize(config.beat_bits()),
        "last" => last,
        _ => record.field(name),
    });
    let taken = give(m, core, "beat", gives, &beat);
    m.ready(&record, taken & head.valid);
    let moves = m.wire("beat_moves", gives & taken);
    m.ready(&head, moves & last);
    m.next_if(place, moves, last.mux(lit(place_bits, 0), place.add_lit(1)));
    reads
}

/// Lets the host write the tree; returns the window.
fn tree_window(m: &mut Module, config: &Config, core: Instance, control: Instance) -> Instance {
    let index_bits = ports::window_index_bits(config);
    let window = m.instance("tree", window::module(index_bits));
    export(m, window, &ports::window(index_bits), "s_axi", "s_axi");
    let [valid, index, word] = ["write_valid", "write_index", "write_data"].map(|name| m.out(window, name));
    m.connect(core, "tree_valid", valid);
    let write = Record::new(&records::tree_write(config), |name| match name {
        "is_leaf" => index.msb(),
        "address" => index.trunc(config.tree_depth),
        _ => field_of(config, word, name),
    });
    write.connect(m, core, "tree_");
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
    let fields = tree_word();
    let reads = m.instance("tree", reader::module(&fields, bits, 1));
    let unit_ports: Vec<Port> = ports::reader(&fields, bits, 1);
    export(m, reads, &unit_ports, "m_axi", "m_axi_tree");
    m.connect(control, "occupied", bit(false));
    let base = m.out(control, "tree_base");
    let lookup = m.stream_from(core, "lookup");
    let stride_bits = packets::tree_stride(config, bits).ilog2();
    let address = m.wire("tree_address", place(base, lookup.field("address"), stride_bits));
    let asked = Asked { name: "lookups", fields: records::lookup(config), address, records: bit(true) };
    let head = asked.remembered(m, &lookup, reads);

    let record = m.stream_from(reads, "record");
    let gives = m.wire("gives_record", record.valid & head.valid);
    let word = record.field("word");
    let answer = Record::new(&records::tree_record(config), |name| match name {
        "thread" | "address" => head.field(name),
        _ => field_of(config, word, name),
    });
    let taken = give(m, core, "record", gives, &answer);
    m.ready(&record, taken & head.valid);
    m.ready(&head, taken & record.valid);
    reads
}

/// A request of the core's to memory.
struct Asked {
    name: &'static str,
    fields: Vec<Field>,
    address: Expr,
    records: Expr,
}

impl Asked {
    /// Hands the request to a reader and remembers whose it is; returns the oldest that is not answered.
    fn remembered(self, m: &mut Module, stream: &Stream, reads: Instance) -> Stream {
        let queue = m.instance(self.name, fifo(REQUESTS_MAX, &layout(&self.fields)));
        let room = m.out(queue, "in_ready");
        let reader_ready = m.out(reads, "request_ready");
        m.connect(queue, "in_valid", stream.valid & reader_ready);
        Record::from(stream).connect(m, queue, "in_");
        feed(m, stream, (reads, "request"), room, &request(self.address, self.records));
        m.stream_from(queue, "out")
    }
}

/// Shows a record to the core; returns whether it would be taken.
fn give(m: &mut Module, core: Instance, name: &str, valid: Expr, record: &Record) -> Expr {
    m.connect(core, &format!("{name}_valid"), valid);
    record.connect(m, core, &format!("{name}_"));
    m.out(core, &format!("{name}_ready"))
}
