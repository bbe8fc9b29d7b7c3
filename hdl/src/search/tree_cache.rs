//! Tree cache (thesis table 6.3, second column): keeps records of a tree in external memory, nodes and leaves alike;
//! golden twin: `pointcore_golden::search::tree_cache`.

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;
use pointcore_contract::splat::config::index_bits;

use crate::stream::fifo;
use crate::units::records::{Record, event_out, layout, queue_in, queue_out, stream_in, width};
use rtl::{Expr, Module, Stream, bit, cat};

/// Bits that number the lines.
const fn line_bits(config: &Config) -> u32 {
    index_bits(config.tree_cache)
}

/// The number of the line that holds a record, the low bits of its address.
fn line_of(config: &Config, address: Expr) -> Expr {
    address.resize(line_bits(config))
}

/// A line; without a tag where there is one for every record.
fn line_fields(config: &Config) -> Vec<Field> {
    let tag = config.node_bits().saturating_sub(line_bits(config));
    let word = width(&records::node(config)).max(width(&records::bucket(config))) as u32;
    let fields = [("valid", 1), ("tag", tag), ("word", word)];
    fields.into_iter().filter(|(_, width)| *width > 0).map(|(name, width)| (name.to_owned(), width)).collect()
}

/// The bits of an address that are not the line's number; the others are known from the line.
fn tag_of(config: &Config, address: Expr) -> Expr {
    address.bits(address.width() - 1, line_bits(config))
}

/// Whether a line holds the record of an address.
fn holds(config: &Config, line: &Record, address: Expr) -> Expr {
    match config.node_bits() > line_bits(config) {
        true => line.get("valid") & line.get("tag").eq(tag_of(config, address)),
        false => line.get("valid"),
    }
}

/// The line of a record that comes from the memory.
fn filled(config: &Config, filling: &Record) -> Record {
    let address = filling.get("address");
    let [node, leaf] = [records::node(config), records::bucket(config)].map(|fields| filling.only(&fields).pack());
    Record::new(&line_fields(config), |name| match name {
        "valid" => bit(true),
        "tag" => tag_of(config, address),
        _ => {
            let bits = node.width().max(leaf.width());
            address.msb().mux(leaf.zext(bits), node.zext(bits))
        }
    })
}

/// What is looked up: a leaf where there is one, else a node.
fn sought(config: &Config, leaf: &Stream, node: &Stream) -> Record {
    Record::new(&records::lookup(config), |name| match name {
        "thread" => leaf.valid.mux(leaf.field("thread"), node.field("thread")),
        _ => leaf.valid.mux(cat([bit(true), leaf.field("leaf")]), node.field("node")),
    })
}

/// A stream that comes in through a queue as long as everything that can be under way.
fn long_queue_in(m: &mut Module, name: &str, depth: u32, fields: &[Field]) -> Stream {
    let ports = stream_in(m, name, fields);
    let queue = m.instance(&format!("{name}_queue"), fifo(depth.max(2), &layout(fields)));
    m.stream_into(queue, "in", &ports);
    m.stream_from(queue, "out")
}

/// The unit; ports as in `contract::search::ports::tree_cache`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let (node_fields, leaf_fields) = (records::node(config), records::bucket(config));
    let line_fields = line_fields(config);
    let mut m = Module::new("search_tree_cache", "Keeps records of a tree in external memory.");
    m.parameter("lines", config.tree_cache);
    m.parameter("threads", config.threads);
    let node = long_queue_in(&mut m, "node", config.threads, &records::descent(config));
    let leaf = long_queue_in(&mut m, "leaf", config.threads * config.leaves_in_flight, &records::leaf(config));
    let record = queue_out(&mut m, "record", &records::node_record(config));
    let fetch = queue_out(&mut m, "fetch", &records::fetch(config));
    let lookup = queue_out(&mut m, "lookup", &records::lookup(config));
    let fill = queue_in(&mut m, "fill", &records::tree_record(config));

    let cleared_lines = m.reg_reset("cleared_lines", line_bits(config) + 1, 0);
    let cleared = m.wire("cleared", cleared_lines.msb());
    m.next_if(cleared_lines, !cleared, cleared_lines.add_lit(1));

    // What comes from the memory goes straight on, and into its line.
    let fill_address = fill.field("address");
    let fill_is_leaf = fill_address.msb();
    m.ready(&fill, cleared & fill_is_leaf.mux(fetch.room, record.room));
    let fills = m.wire("fills", fill.transfer());
    let fills_fetch = m.wire("fills_fetch", fills & fill_is_leaf);
    let fills_record = m.wire("fills_record", fills & !fill_is_leaf);
    let filling = Record::from(&fill);
    let lines = m.memory("lines", config.tree_cache, width(&line_fields));
    let filled = filled(config, &filling);
    let written = cleared.mux(line_of(config, fill_address), cleared_lines.trunc(line_bits(config)));
    let nothing = Record::zeros(&line_fields);
    m.write(lines, fills | !cleared, written, filled.mux(cleared, &nothing).pack());

    // A lookup, leaves first.
    let advance = m.forward("advance", 1);
    let [b_valid, c_valid] = ["b_valid", "c_valid"].map(|name| m.reg_reset(name, 1, 0));
    m.next_if(b_valid, advance, cleared & (leaf.valid | node.valid));
    m.next_if(c_valid, advance, b_valid);
    m.ready(&leaf, advance & cleared);
    m.ready(&node, advance & (cleared & !leaf.valid));
    let sought = sought(config, &leaf, &node);
    let b = sought.register(&mut m, "b_", advance);
    let c = b.register(&mut m, "c_", advance);
    let [b_is_leaf, c_is_leaf] = ["b_is_leaf", "c_is_leaf"].map(|name| m.reg(name, 1));
    m.next_if(b_is_leaf, advance, leaf.valid);
    m.next_if(c_is_leaf, advance, b_is_leaf);
    let line = m.read_if(lines, "b_line", advance, line_of(config, sought.get("address")));
    let line = Record::unpack(&line_fields, line).register(&mut m, "line_", advance);

    // Nobody looks at the record of a node of the deepest level.
    let address = c.get("address");
    let deepest = m.wire("deepest", address.msb() & !c_is_leaf);
    let hit = m.wire("hit", deepest | holds(config, &line, address));
    let free = c_is_leaf.mux(fetch.room & !fills_fetch, record.room & !fills_record);
    let hits = m.wire("hits", c_valid & (hit & free));
    let misses = m.wire("misses", c_valid & (!hit & lookup.room));
    m.drive(advance, !c_valid | (hits | misses));

    let word = line.get("word");
    let found_leaf = Record::unpack(&leaf_fields, word.trunc(width(&leaf_fields)));
    let found_node = Record::unpack(&node_fields, word.trunc(width(&node_fields)));
    let found_node = Record::zeros(&node_fields).mux(deepest, &found_node);
    let hits_record = hits & !c_is_leaf;
    record.push(&mut m, fills_record | hits_record, |name| match name {
        "thread" => fills_record.mux(filling.get("thread"), c.get("thread")),
        "node" => fills_record.mux(fill_address, address),
        field => fills_record.mux(filling.get(field), found_node.get(field)),
    });
    let hits_fetch = hits & c_is_leaf;
    fetch.push(&mut m, fills_fetch | hits_fetch, |name| match name {
        "thread" => fills_fetch.mux(filling.get("thread"), c.get("thread")),
        "address" => fills_fetch.mux(filling.get("begin"), found_leaf.get("begin")),
        field => fills_fetch.mux(filling.get(field), found_leaf.get(field)),
    });
    lookup.push(&mut m, misses, |name| c.get(name));
    event_out(&mut m, "event_tree_hit", hits & !deepest);
    event_out(&mut m, "event_tree_miss", misses);
    m
}
