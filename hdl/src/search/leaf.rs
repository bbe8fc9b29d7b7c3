//! Leaf processing (thesis 6.5.2): fetches the points of a leaf and computes their squared distances; golden twin:
//! `pointcore_golden::search::leaf`. With a tree cache, that fetches the points.

use pointcore_contract::record;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{AXES, Beat, Bucket, Candidates, Fetch, Thread};
use pointcore_contract::search::units::leaf::PORTS;

use super::parts::coordinates::coordinates;
use crate::compiler::{CompileError, Datapath, Options, Program, Value, compile};
use crate::units::datapath::dot;
use crate::units::passage::Passage;
use crate::units::ports::{PulseInPorts, StreamInPorts, StreamOutPorts};
use crate::units::sliced::Sliced;
use crate::units::twins::{next_twins, twins};
use crate::units::values::{Terms, Values};
use crate::units::wires::{Bundle, Wires};
use rtl::Module;

/// A beat with the coordinates of its thread's query.
#[record(config: Config)]
struct Operands {
    /// The points.
    beat: Beat,
    /// Where the query is.
    #[name(format!("query_{}", AXES[i]))]
    #[bits(config.geometry.width())]
    query: [u32; 3],
}

/// The squared distances of a beat's points to the query.
fn distances(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("search_distance", "Squared distances of points to a query.");
    let Operands { beat, query } = Operands::<Values>::inputs(&program, config);
    let numbers = |point: [Value; 3]| point.map(|coordinate| coordinate.as_float(config.geometry));
    let query = numbers(query);
    let mut candidates = Candidates { place: beat.place, ..Candidates::default() };
    for (distance, point) in candidates.distances.iter_mut().zip(beat.points.lane).take(config.lanes as usize) {
        let point = numbers(point);
        let offset: [Value; 3] =
            std::array::from_fn(|axis| (point[axis] - query[axis]).named(&format!("offset_{}", AXES[axis])));
        *distance = dot(&offset, &offset).bits(config.square_bits() - 1, 0);
    }
    candidates.outputs(&program, config);
    compile(&program, options)
}

/// The table of leaves, and requests for their points.
fn request_points(m: &mut Module, config: &Config) {
    let tree = PORTS.tree.declare(m, config);
    let leaf = PORTS.leaf.queue(m, config);
    let fetch = PORTS.fetch.queue(m, config);
    let writes = m.wire("writes_leaf", tree.valid & tree.record.is_leaf);
    let table = Sliced::new(m, "leaves", writes, tree.record.address, tree.record.bucket.pack(config));
    m.assert("no_leaf_is_looked_up_while_one_is_written", !(writes & leaf.valid));
    // f0: the table shows the entry; f1: it is in a register, for a block RAM is slow to show it.
    let [f0_valid, f1_valid] = ["f0_valid", "f1_valid"].map(|name| m.reg_reset(name, 1, 0));
    let [f0_thread, f1_thread] = ["f0_thread", "f1_thread"].map(|name| m.reg(name, config.thread_bits()));
    let advance = m.wire("table_advance", !f1_valid | fetch.room);
    m.drive(leaf.ready, advance);
    m.next_if(f0_valid, advance, leaf.valid);
    m.next_if(f1_valid, advance, f0_valid);
    m.next_if(f0_thread, advance, leaf.record.thread.thread);
    m.next_if(f1_thread, advance, f0_thread);
    let found = table.read_if(m, "f0_found", advance, leaf.record.leaf);
    let Bucket { begin, beats } = Bucket::<Wires>::unpack(config, found).register(m, config, "f1_", advance);
    let thread = Thread { thread: *f1_thread };
    fetch.push(m, config, f1_valid, Fetch { thread, address: begin, beats });
}

/// The unit.
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
    let start = PORTS.start.declare(&mut m, config);

    // Beats join the coordinates of their queries.
    let beat = PORTS.beat.queue(&mut m, config);
    let Datapath { module, manifest } = distances(config, options)?;
    let distance = Passage::<Operands, Candidates>::place(&mut m, "distance", module);
    // `query_advance` moves a beat and its query; the queue before them hangs on another register.
    let [query_valid, query_empty] = twins(&mut m, ["query_valid", "query_empty"]);
    let accepts = distance.room(&mut m);
    let query_advance = m.wire("query_advance", !query_valid | accepts);
    m.drive(beat.ready, query_empty | accepts);
    let query_next = query_advance.mux(beat.valid, query_valid);
    next_twins(&mut m, "query_valid_or_empty", [query_valid, query_empty], query_next);
    let points = beat.record.register(&mut m, config, "points_", query_advance);
    let query = coordinates(&mut m, config, start, query_advance, beat.record.place.thread.thread);
    distance.push(&mut m, config, query_valid, Operands { beat: points, query });
    let candidates = distance.out(&mut m, config);
    PORTS.candidates.export(&mut m, config, candidates);
    Ok(Datapath { module: m, manifest })
}
