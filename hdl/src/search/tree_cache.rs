//! Tree cache (thesis table 6.3, second column): keeps records of a tree in external memory, nodes and leaves alike;
//! golden twin: `pointcore_golden::search::tree_cache`.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{
    Bucket, Descent, Fetch, LeafVisit, Lookup, Node, NodeRecord, Thread, TreeRecord,
};
use pointcore_contract::search::units::tree_cache::PORTS;
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::unit::In;
use pointcore_contract::{Record, record, width};

use crate::stream::fifo;
use crate::units::ports::{Flow, OutputPorts, StreamInPorts, StreamOutPorts};
use crate::units::wires::{Bundle, Wired, Wires, layout};
use rtl::{Expr, Module, bit, cat};

/// Bits that number the lines.
const fn line_bits(config: &Config) -> u32 {
    index_bits(config.tree_cache)
}

/// The number of the line that holds a record, the low bits of its address.
fn line_of(config: &Config, address: Expr) -> Expr {
    address.resize(line_bits(config))
}

/// Bits of an address that are not the line's number; none where there is a line for every record.
fn tag_bits(config: &Config) -> u32 {
    config.node_bits().saturating_sub(line_bits(config))
}

/// A line.
#[record(config: Config)]
struct Line {
    /// It holds a record.
    valid: bool,
    /// What tells its record from others of the line.
    #[when(tag_bits(config) > 0)]
    #[bits(tag_bits(config))]
    tag: u32,
    /// What a node or a leaf holds.
    #[bits(width::<Node>(config).max(width::<Bucket>(config)))]
    word: u64,
}

/// The bits of an address that are not the line's number; the others are known from the line.
fn tag_of(config: &Config, address: Expr) -> Expr {
    address.bits(address.width() - 1, line_bits(config))
}

/// Whether a line holds the record of an address.
fn holds(config: &Config, line: &Line<Wires>, address: Expr) -> Expr {
    match tag_bits(config) {
        0 => line.valid,
        _ => line.valid & line.tag.eq(tag_of(config, address)),
    }
}

/// The line of a record that comes from the memory.
fn filled(config: &Config, filling: &TreeRecord<Wires>) -> Line<Wires> {
    let address = filling.lookup.address;
    let (node, leaf) = (filling.node.pack(config), filling.bucket.pack(config));
    let bits = node.width().max(leaf.width());
    let word = address.msb().mux(leaf.zext(bits), node.zext(bits));
    let tag = if tag_bits(config) > 0 { tag_of(config, address) } else { Expr::default() };
    Line { valid: bit(true), tag, word }
}

/// What is looked up: a leaf where there is one, else a node.
fn sought(config: &Config, leaf: &Flow<LeafVisit<Wires>>, node: &Flow<Descent<Wires>>) -> Lookup<Wires> {
    let LeafVisit { thread, leaf: number } = leaf.record;
    let of_leaf = Lookup { thread, address: cat([bit(true), number]) };
    let Descent { thread, node } = node.record;
    Lookup::choose(config, leaf.valid, of_leaf, Lookup { thread, address: node })
}

/// The request for the points of a leaf.
const fn request(thread: Thread<Wires>, bucket: Bucket<Wires>) -> Fetch<Wires> {
    Fetch { thread, address: bucket.begin, beats: bucket.beats }
}

/// A stream that comes in through a queue as long as everything that can be under way.
fn long_queue_in<R: Record>(m: &mut Module, config: &R::Config, ports: In<R>, depth: u32) -> Flow<Wired<R>> {
    let queue = fifo(depth.max(2), &layout::<R>(config));
    ports.declare(m, config).through(m, config, &format!("{}_queue", ports.name), queue)
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("search_tree_cache", "Keeps records of a tree in external memory.");
    m.parameter("lines", config.tree_cache);
    m.parameter("threads", config.threads);
    let node = long_queue_in(&mut m, config, PORTS.node, config.threads);
    let leaf = long_queue_in(&mut m, config, PORTS.leaf, config.threads * config.leaves_in_flight);
    let record = PORTS.record.queue(&mut m, config);
    let fetch = PORTS.fetch.queue(&mut m, config);
    let lookup = PORTS.lookup.queue(&mut m, config);
    let fill = PORTS.fill.queue(&mut m, config);

    let cleared_lines = m.reg_reset("cleared_lines", line_bits(config) + 1, 0);
    let cleared = m.wire("cleared", cleared_lines.msb());
    m.next_if(cleared_lines, !cleared, cleared_lines.add_lit(1));

    // What comes from the memory goes straight on, and into its line.
    let filling = fill.record;
    let fill_address = filling.lookup.address;
    let fill_is_leaf = fill_address.msb();
    m.drive(fill.ready, cleared & fill_is_leaf.mux(fetch.room, record.room));
    let fills = m.wire("fills", fill.transfer());
    let fills_fetch = m.wire("fills_fetch", fills & fill_is_leaf);
    let fills_record = m.wire("fills_record", fills & !fill_is_leaf);
    let lines = m.memory("lines", config.tree_cache, width::<Line>(config));
    let filled = filled(config, &filling);
    let written = cleared.mux(line_of(config, fill_address), cleared_lines.trunc(line_bits(config)));
    let line = Line::choose(config, cleared, filled, Line::zeros(config));
    m.write(lines, fills | !cleared, written, line.pack(config));

    // A lookup, leaves first.
    let advance = m.forward("advance", 1);
    let [b_valid, c_valid] = ["b_valid", "c_valid"].map(|name| m.reg_reset(name, 1, 0));
    m.next_if(b_valid, advance, cleared & (leaf.valid | node.valid));
    m.next_if(c_valid, advance, b_valid);
    m.drive(leaf.ready, advance & cleared);
    m.drive(node.ready, advance & (cleared & !leaf.valid));
    let sought = sought(config, &leaf, &node);
    let b = sought.register(&mut m, config, "b_", advance);
    let c = b.register(&mut m, config, "c_", advance);
    let [b_is_leaf, c_is_leaf] = ["b_is_leaf", "c_is_leaf"].map(|name| m.reg(name, 1));
    m.next_if(b_is_leaf, advance, leaf.valid);
    m.next_if(c_is_leaf, advance, b_is_leaf);
    let line = m.read_if(lines, "b_line", advance, line_of(config, sought.address));
    let line = Line::<Wires>::unpack(config, line).register(&mut m, config, "line_", advance);

    // Nobody looks at the record of a node of the deepest level.
    let Lookup { thread, address } = c;
    let deepest = m.wire("deepest", address.msb() & !c_is_leaf);
    let hit = m.wire("hit", deepest | holds(config, &line, address));
    let free = c_is_leaf.mux(fetch.room & !fills_fetch, record.room & !fills_record);
    let hits = m.wire("hits", c_valid & (hit & free));
    let misses = m.wire("misses", c_valid & (!hit & lookup.room));
    m.drive(advance, !c_valid | (hits | misses));

    let found_bucket = Bucket::unpack(config, line.word.trunc(width::<Bucket>(config)));
    let found_node = Node::unpack(config, line.word.trunc(width::<Node>(config)));
    let found_node = Node::choose(config, deepest, Node::zeros(config), found_node);
    let TreeRecord { lookup: filled, node, bucket } = filling;
    let filled_record = NodeRecord { descent: Descent { thread: filled.thread, node: fill_address }, node };
    let found_record = NodeRecord { descent: Descent { thread, node: address }, node: found_node };
    let next_record = NodeRecord::choose(config, fills_record, filled_record, found_record);
    record.push(&mut m, config, fills_record | (hits & !c_is_leaf), next_record);
    let (filled, found) = (request(filled.thread, bucket), request(thread, found_bucket));
    fetch.push(&mut m, config, fills_fetch | (hits & c_is_leaf), Fetch::choose(config, fills_fetch, filled, found));
    lookup.push(&mut m, config, misses, c);
    PORTS.events.event(&mut m, config, |events| events.hit, hits & !deepest);
    PORTS.events.event(&mut m, config, |events| events.miss, misses);
    m
}
