//! Leaf processing (thesis 6.5.2): fetches the points of a leaf and computes their squared distances; golden twin:
//! `pointcore_golden::search::leaf`. With a tree cache, that fetches the points.

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;

use super::parts::coordinates::{AXES, coordinates};
use crate::compiler::{CompileError, Datapath, Options, Program, Value, compile};
use crate::units::datapath::{Inputs, dot};
use crate::units::records::{Record, pulse_in, queue_in, queue_out};
use crate::units::sliced::Sliced;
use rtl::Module;

const QUERY: [&str; 3] = ["query_x", "query_y", "query_z"];

/// A beat with the coordinates of its thread's query.
fn operands(config: &Config) -> Vec<Field> {
    let mut fields = records::beat(config);
    fields.extend(QUERY.map(|name| (name.to_owned(), config.geometry.width())));
    fields
}

/// The squared distances of a beat's points to the query.
fn distances(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("search_distance", "Squared distances of points to a query.");
    let beat = Inputs::new(&program, &operands(config));
    let query = QUERY.map(|name| beat.float(config.geometry, name));
    for name in ["thread", "address", "last"] {
        program.output(name, beat.bits(name));
    }
    for lane in 0..config.lanes {
        let point = ["x", "y", "z"].map(|axis| beat.float(config.geometry, &format!("{axis}{lane}")));
        let offset: [Value; 3] = std::array::from_fn(|axis| point[axis] - query[axis]);
        program.output(&format!("distance{lane}"), dot(&offset, &offset));
    }
    compile(&program, options)
}

/// The table of leaves, and requests for their points.
fn request_points(m: &mut Module, config: &Config) {
    let tree = pulse_in(m, "tree", &records::tree_write(config));
    let leaf = queue_in(m, "leaf", &records::leaf(config));
    let fetch = queue_out(m, "fetch", &records::fetch(config));
    let entry = records::bucket(config);
    let writes = m.wire("writes_leaf", tree.valid & tree.record.get("is_leaf"));
    let table = Sliced::new(m, "leaves", writes, tree.record.get("address"), tree.record.only(&entry).pack());
    m.assert("no_leaf_is_looked_up_while_one_is_written", !(writes & leaf.valid));
    // f0: the table shows the entry; f1: it is in a register, for a block RAM is slow to show it.
    let [f0_valid, f1_valid] = ["f0_valid", "f1_valid"].map(|name| m.reg_reset(name, 1, 0));
    let [f0_thread, f1_thread] = ["f0_thread", "f1_thread"].map(|name| m.reg(name, config.thread_bits()));
    let advance = m.wire("table_advance", !f1_valid | fetch.room);
    m.ready(&leaf, advance);
    m.next_if(f0_valid, advance, leaf.valid);
    m.next_if(f1_valid, advance, f0_valid);
    m.next_if(f0_thread, advance, leaf.field("thread"));
    m.next_if(f1_thread, advance, f0_thread);
    let found = table.read_if(m, "f0_found", advance, leaf.field("leaf"));
    let found = Record::unpack(&entry, found).register(m, "f1_", advance);
    let request = f1_valid & fetch.room;
    fetch.push(m, request, |name| match name {
        "thread" => f1_thread.expr(),
        "address" => found.get("begin"),
        field => found.get(field),
    });
}

/// The unit; ports as in `contract::search::ports::leaf`.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let mut m = Module::new("search_leaf", "Fetches leaves and computes the distances of their points.");
    m.parameter("threads", config.threads);
    m.parameter("lanes", config.lanes);
    if config.tree_cache == 0 {
        request_points(&mut m, config);
    }
    let start = pulse_in(&mut m, "start", &records::start(config));

    // Beats join the coordinates of their queries.
    let beat = queue_in(&mut m, "beat", &records::beat(config));
    let Datapath { module, manifest } = distances(config, options)?;
    let distance = m.instance("distance", module);
    let query_valid = m.reg_reset("query_valid", 1, 0);
    let accepts = m.out(distance, "in_ready");
    let query_advance = m.wire("query_advance", !query_valid | accepts);
    m.ready(&beat, query_advance);
    m.next_if(query_valid, query_advance, beat.valid);
    let points = Record::from(&beat).register(&mut m, "points_", query_advance);
    let query = coordinates(&mut m, config, &start, query_advance, beat.field("thread"));
    m.connect(distance, "in_valid", query_valid);
    points.connect(&mut m, distance, "in_");
    for (name, axis) in QUERY.iter().zip(AXES) {
        m.connect(distance, &format!("in_{name}"), query.get(axis));
    }
    let candidates = m.stream_from(distance, "out");
    m.stream_export("candidates", &candidates);
    Ok(Datapath { module: m, manifest })
}
