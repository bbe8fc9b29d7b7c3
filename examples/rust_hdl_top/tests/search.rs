//! The rust-hdl design, lowered by rust-hdl, checked by Verilator and run: its answers are those of brute force.

use std::sync::Arc;

use pointcore::number::encode;
use pointcore::search::samples::{point_sets, queries_near};
use pointcore::search::{PointSet, Query, Splitting, Tree};
use pointcore_golden::reference::neighbors::nearest;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::search::top;
use pointcore_tb::lockstep::seed;
use pointcore_tb::verilated::{BuildOptions, Builder, Library, VerilatedModel, VerilogSource};
use rtl::{Design, block_ports, elaborate};
use rust_hdl::prelude::*;
use rust_hdl_top::SearchInRom;
use rust_hdl_top::config::config;
use rust_hdl_top::search_top::SearchTop;

const POINTS: usize = 200;
const QUERIES: usize = 60;
/// Far more cycles than the queries take.
const CYCLES_MAX: usize = 100_000;

/// The lowered design. rust-hdl's literals have 32 bits whatever they meet, and it has a signal for every output of a block, read or not.
fn library(block: &SearchInRom) -> Arc<Library> {
    let verilog = generate_verilog(block);
    let verilog = format!("/* verilator lint_off WIDTH */\n/* verilator lint_off UNUSED */\n{verilog}");
    let source = VerilogSource {
        verilog,
        top: "top".to_owned(),
        ports: block_ports(block),
        streams: vec![],
        interfaces: vec![],
    };
    let builder = Builder::new().unwrap_or_else(|error| panic!("{error}"));
    builder.build(&source, BuildOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The design at work, its ports by their names.
struct Bench {
    library: Arc<Library>,
    model: VerilatedModel,
    inputs: Vec<u64>,
    outputs: Vec<u64>,
}

impl Bench {
    fn new(library: Arc<Library>, seed: u64) -> Self {
        let mut model = library.instantiate(seed);
        model.reset(4).expect("no assertion fails");
        let [inputs, outputs] = [library.inputs(), library.outputs()].map(|ports| vec![0; ports.len()]);
        Self { library, model, inputs, outputs }
    }

    fn set(&mut self, fields: &[(&str, u64)]) {
        for (name, value) in fields {
            let place = self.library.inputs().iter().position(|port| port.name == *name);
            self.inputs[place.unwrap_or_else(|| panic!("no input {name}"))] = *value;
        }
    }

    fn get(&self, name: &str) -> u64 {
        let place = self.library.outputs().iter().position(|port| port.name == name);
        self.outputs[place.unwrap_or_else(|| panic!("no output {name}"))]
    }

    fn step(&mut self) {
        self.model.step(&self.inputs, &mut self.outputs).expect("no assertion fails");
    }

    fn load(&mut self, tree: &Tree) {
        for write in tree.writes() {
            self.set(&[
                ("tree_valid", 1),
                ("tree_is_leaf", write.is_leaf.into()),
                ("tree_address", write.address.into()),
                ("tree_split", write.node.split.into()),
                ("tree_dimension", write.node.dimension.into()),
                ("tree_internal_leaf", write.node.internal_leaf.into()),
                ("tree_begin", write.bucket.begin.into()),
                ("tree_beats", write.bucket.beats.into()),
            ]);
            self.step();
        }
        self.set(&[("tree_valid", 0)]);
        self.step();
    }

    /// Neighbors by query: place and distance.
    fn search(&mut self, queries: &[Asked], random: &mut fastrand::Rng) -> Vec<Vec<(usize, u32)>> {
        let mut answers = vec![vec![]; queries.len()];
        let (mut sent, mut answered) = (0, 0);
        for _ in 0..CYCLES_MAX {
            if answered == queries.len() {
                return answers;
            }
            if let Some(query) = queries.get(sent) {
                let [x, y, z] = query.point.map(u64::from);
                let (number, k, radius2) = (sent as u64, query.k as u64, query.radius2.into());
                self.set(&[("query_valid", 1), ("query_number", number), ("query_k", k), ("query_radius2", radius2)]);
                self.set(&[("query_x", x), ("query_y", y), ("query_z", z)]);
            } else {
                self.set(&[("query_valid", 0)]);
            }
            let takes = random.bool();
            self.set(&[("result_ready", takes.into())]);
            self.step();
            sent += usize::from(sent < queries.len() && self.get("query_ready") == 1);
            if takes && self.get("result_valid") == 1 {
                let number = self.get("result_number") as usize;
                if self.get("result_found") == 1 {
                    answers[number].push((self.get("result_index") as usize, self.get("result_distance2") as u32));
                }
                answered += self.get("result_last") as usize;
            }
        }
        panic!("{answered} of {} queries are answered after {CYCLES_MAX} cycles", queries.len());
    }
}

/// A query in the core's numbers.
struct Asked {
    point: [u32; 3],
    k: usize,
    radius2: u32,
}

impl Asked {
    fn new(query: &Query) -> Self {
        let format = config().geometry;
        Self {
            point: query.point.map(|number| encode(format, number)),
            k: query.k as usize,
            radius2: query.radius.map_or(format.infinity() as u32, |radius| encode(format, radius * radius)),
        }
    }
}

#[test]
fn searches_in_a_rust_hdl_design_agree_with_brute_force() {
    let config = config();
    let seed = seed().expect("POINTCORE_SEED is a number");
    let mut random = fastrand::Rng::with_seed(seed);
    let (_, points) = point_sets(POINTS, &mut random).swap_remove(0);
    let queries = queries_near(&points, config.neighbors, QUERIES, &mut random);
    let points = PointSet::new(config.geometry, &points).unwrap_or_else(|error| panic!("{error}"));
    let tree = Tree::build(&config, &points, Splitting::Median).unwrap_or_else(|error| panic!("{error}"));
    let mut bench = Bench::new(library(&SearchInRom::new(tree.memory())), seed);
    bench.load(&tree);
    let asked: Vec<Asked> = queries.iter().map(Asked::new).collect();
    let answers = bench.search(&asked, &mut random);
    let mut neighbors = 0;
    for (query, found) in asked.iter().zip(&answers) {
        let expected = nearest(config.geometry, tree.memory(), query.point, query.k, query.radius2);
        let expected: Vec<u32> = expected.iter().map(|neighbor| neighbor.distance2).collect();
        let distances: Vec<u32> = found.iter().map(|(_, distance2)| *distance2).collect();
        assert_eq!(distances, expected, "POINTCORE_SEED={seed}");
        for (place, distance2) in found {
            let own = nearest(config.geometry, &tree.memory()[*place..=*place], query.point, 1, u32::MAX);
            assert_eq!(own[0].distance2, *distance2, "POINTCORE_SEED={seed}");
        }
        neighbors += found.len();
    }
    assert!(neighbors > QUERIES, "{neighbors} neighbors of {QUERIES} queries");
}

fn core() -> Design {
    let core = top::core(&config(), &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    elaborate(&core.module).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_generated_block_has_the_ports_of_the_core() {
    assert_eq!(core().check_block(&SearchTop::default()), Ok(()));
}

/// Differs from the core in a width, a direction and the clock, and lacks the rest.
#[derive(LogicBlock, Default)]
struct Wrong {
    pub clk: Signal<In, Bit>,
    pub rst: Signal<In, Bit>,
    pub query_ready: Signal<In, Bit>,
    pub query_k: Signal<In, Bits<5>>,
}

impl Logic for Wrong {
    fn update(&mut self) {}
}

#[test]
fn a_block_with_other_ports_is_told_what_differs() {
    let core = core();
    let error = core.check_block(&Wrong::default()).expect_err("the block has other ports");
    // All of the core's but `rst`, and all of the block's but `rst`.
    assert_eq!(error.differences.len(), core.ports().len() - 1 + 3, "{error}");
    for difference in [
        "the design has the input `clk` of 1 bits, a clock",
        "the block has the input `clk` of 1 bits",
        "the design has the output `query_ready` of 1 bits",
        "the block has the input `query_ready` of 1 bits",
        "the design has the input `query_k` of 4 bits",
        "the block has the input `query_k` of 5 bits",
    ] {
        assert!(error.differences.iter().any(|other| other == difference), "{difference} is not in {error}");
    }
}
