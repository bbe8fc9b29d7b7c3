//! `proof_units DIR` writes the units that are proved (`formal/`): of each its Verilog `<proof>.v`, and the sizes that its
//! harness needs in `<proof>.vh`. The sizes are small, so that a solver can go through all of a unit's states.

mod bus;
mod splat;

use pointcore_contract::Format;
use pointcore_contract::search::Config;
use pointcore_hdl::{search, stream};
use rtl::{Module, elaborate};
use std::error::Error;
use std::path::Path;

/// A unit to be proved.
struct Proof {
    name: &'static str,
    unit: Module,
    sizes: Vec<(&'static str, u32)>,
    /// What the harness asks for with `ifdef`.
    flags: Vec<&'static str>,
}

impl Proof {
    fn new(name: &'static str, unit: Module, sizes: &[(&'static str, u32)]) -> Self {
        Self { name, unit, sizes: sizes.to_vec(), flags: vec![] }
    }
}

/// A core with threads that compete and a row with a front and an end. Distances and indices have fewer bits than operators
/// and memories call for: the units proved store and compare them and do nothing else.
fn small_core() -> Config {
    let geometry = Format { exponent: 1, mantissa: 1, ..Format::F24.flushed() };
    Config { geometry, threads: 2, neighbors: 2, lanes: 1, tree_depth: 3, index_bits: 2, ..Config::default() }
}

fn proofs() -> Vec<Proof> {
    const WIDTH: u32 = 2;
    // A depth that is a power of two and one that is not: their addresses go round differently.
    let fifo = |name, depth: u32| {
        Proof::new(name, stream::fifo(depth, &[("data", WIDTH)]), &[("DEPTH", depth), ("WIDTH", WIDTH)])
    };
    let skid = Proof::new("stream_skid", stream::skid(&[("data", WIDTH)]), &[("DEPTH", 2), ("WIDTH", WIDTH)]);
    let half_buffer =
        Proof::new("stream_half_buffer", stream::half_buffer(&[("data", WIDTH)]), &[("DEPTH", 1), ("WIDTH", WIDTH)]);
    let core = small_core();
    let sizes = [
        ("THREADS", core.threads),
        ("THREAD_BITS", core.thread_bits()),
        ("DEPTH", core.tree_depth),
        ("NODE_BITS", core.node_bits()),
        ("SQUARE_BITS", core.square_bits()),
    ];
    let stack = Proof::new("search_stack", search::stack::module(&core), &sizes);
    let queue = |name, core: &Config| {
        let sizes = [
            ("THREADS", core.threads),
            ("THREAD_BITS", core.thread_bits()),
            ("NEIGHBORS", core.neighbors),
            ("RANK_BITS", core.rank_bits()),
            ("LANES", core.lanes),
            ("INDEX_BITS", core.index_bits),
            ("BEAT_BITS", core.beat_bits()),
            ("SQUARE_BITS", core.square_bits()),
        ];
        Proof::new(name, search::queue::module(core), &sizes)
    };
    // Rows that are written back and read again, and beats that stay for several insertions into a longer row.
    let queues = [
        queue("search_queue_threads", &core),
        queue("search_queue_lanes", &Config { threads: 1, neighbors: 3, lanes: 2, ..core.clone() }),
    ];
    [fifo("stream_fifo_3", 3), fifo("stream_fifo_4", 4), skid, half_buffer, stack]
        .into_iter()
        .chain(queues)
        .chain(bus::proofs())
        .chain(splat::proofs())
        .collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: proof_units DIR")?;
    let folder = Path::new(&folder);
    std::fs::create_dir_all(folder)?;
    for Proof { name, unit, sizes, flags } in proofs() {
        let design = elaborate(&unit)?;
        let sizes = sizes.iter().map(|(size, value)| format!("localparam {size} = {value};\n"));
        let flags = flags.iter().map(|flag| format!("`define {flag}\n"));
        let header: String =
            std::iter::once(format!("`define UNIT {}\n", design.top())).chain(flags).chain(sizes).collect();
        std::fs::write(folder.join(format!("{name}.v")), design.verilog())?;
        std::fs::write(folder.join(format!("{name}.vh")), header)?;
    }
    Ok(())
}
