//! Several compiled programs side by side in one design, and the golden model of that.

use super::generator::sample;
use super::interpreter::interpret;
use fastrand::Rng;
use pointcore_golden::datapath::{Datapath, Token};
use pointcore_golden::float::Table;
use pointcore_hdl::compiler::{self, Graph, Manifest, Operation, Type};
use pointcore_tb::lockstep::{Golden, Lockstep, LockstepReport, Stall, StreamTestbench};
use pointcore_tb::verilated::{BuildOptions, Builder, Library, Port, VerilogSource};
use rtl::{Design, Module, elaborate};
use std::sync::Arc;

/// A program, what the compiler made of it, and the values of its uniforms.
pub struct Compiled {
    pub graph: Graph,
    pub manifest: Manifest,
    pub uniforms: Vec<u64>,
    /// What its results are compared with: the interpreter of graphs, or a model of what the graph was made from.
    pub golden: Option<Box<dyn Source>>,
}

/// A model of what a graph was made from, and tokens for it. Inputs and uniforms are in order of declaration.
pub trait Source {
    /// A random token.
    fn token(&self, rng: &mut Rng) -> Vec<u64>;
    /// Its results.
    fn results(&self, inputs: &[u64], uniforms: &[u64]) -> Vec<u64>;
}

impl Compiled {
    /// Types of the ports of one kind.
    fn types(&self, kind: &Operation) -> Vec<Type> {
        types(&self.graph, kind)
    }

    fn token(&self, rng: &mut Rng) -> Vec<u64> {
        match &self.golden {
            Some(golden) => golden.token(rng),
            None => self.types(&Operation::Input).into_iter().map(|ty| sample(rng, ty)).collect(),
        }
    }

    fn results(&self, tables: &[Table], token: &[u64]) -> Option<Vec<u64>> {
        match &self.golden {
            Some(golden) => Some(golden.results(token, &self.uniforms)),
            None => interpret(&self.graph, tables, token, &self.uniforms),
        }
    }
}

fn types(graph: &Graph, kind: &Operation) -> Vec<Type> {
    graph.nodes().iter().filter(|node| node.operation == *kind).map(|node| node.ty).collect()
}

/// Names of the ports of one kind.
fn names(graph: &Graph, kind: &Operation) -> Vec<String> {
    let nodes = graph.nodes().iter().filter(|node| node.operation == *kind);
    nodes.map(|node| node.name.clone().expect("ports have names")).collect()
}

/// Compiles programs, each at its initiation interval, into one module with streams `in_<n>` and `out_<n>`.
pub fn compile_all(programs: Vec<(Graph, u32)>, rng: &mut Rng) -> (Design, Vec<Compiled>) {
    let mut top = Module::new("programs", "Several datapaths side by side.");
    let mut compiled = Vec::new();
    for (index, (graph, interval)) in programs.into_iter().enumerate() {
        let options = compiler::Options::default().with_interval(interval);
        let datapath = compiler::compile_graph(&graph, &options).expect("the program is well formed");
        let instance = top.instance(&format!("program_{index}"), datapath.module);
        let fields = names(&graph, &Operation::Input).into_iter().zip(types(&graph, &Operation::Input));
        let layout: Vec<(String, u32)> = fields.map(|(name, ty)| (name, ty.width())).collect();
        let input = top.stream_in(&format!("in_{index}"), &layout);
        top.stream_into(instance, "in", &input);
        for (name, ty) in names(&graph, &Operation::Uniform).iter().zip(types(&graph, &Operation::Uniform)) {
            let port = top.input(&format!("uniform_{index}_{name}"), ty.width());
            top.connect(instance, name, port);
        }
        let output = top.stream_from(instance, "out");
        top.stream_export(&format!("out_{index}"), &output);
        let uniforms = types(&graph, &Operation::Uniform).into_iter().map(|ty| sample(rng, ty)).collect();
        compiled.push(Compiled { graph, manifest: datapath.manifest, uniforms, golden: None });
    }
    (elaborate(&top).unwrap_or_else(|error| panic!("{error}")), compiled)
}

/// The verilated design.
pub fn build(design: &Design) -> Arc<Library> {
    let builder = Builder::new().unwrap_or_else(|error| panic!("{error}"));
    builder.build(&VerilogSource::from(design), BuildOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Positions of a datapath's ports among the words of its design.
struct Unit {
    program: usize,
    datapath: Datapath<Vec<u64>>,
    in_valid: usize,
    inputs: Vec<usize>,
    out_ready: usize,
    in_ready: usize,
    out_valid: usize,
    outputs: Vec<usize>,
}

/// Golden model of the design of [`compile_all`].
struct Model<'a> {
    compiled: &'a [Compiled],
    tables: &'a [Table],
    units: Vec<Unit>,
    rst: usize,
}

impl<'a> Model<'a> {
    fn new(library: &Library, compiled: &'a [Compiled], tables: &'a [Table]) -> Self {
        let position = |ports: &[Port], name: &str| {
            ports.iter().position(|port| port.name == name).unwrap_or_else(|| panic!("the design has a port {name}"))
        };
        let input = |name: String| position(library.inputs(), &name);
        let output = |name: String| position(library.outputs(), &name);
        let unit = |(index, program): (usize, &Compiled)| Unit {
            program: index,
            datapath: Datapath::new(program.manifest.latency, program.manifest.initiation_interval),
            in_valid: input(format!("in_{index}_valid")),
            inputs: names(&program.graph, &Operation::Input).iter().map(|n| input(format!("in_{index}_{n}"))).collect(),
            out_ready: input(format!("out_{index}_ready")),
            in_ready: output(format!("in_{index}_ready")),
            out_valid: output(format!("out_{index}_valid")),
            outputs: program.graph.outputs().iter().map(|(n, _)| output(format!("out_{index}_{n}"))).collect(),
        };
        Self { compiled, tables, units: compiled.iter().enumerate().map(unit).collect(), rst: input("rst".to_owned()) }
    }
}

impl Golden for Model<'_> {
    fn step(&mut self, inputs: &[u64], outputs: &mut [u64]) {
        for unit in &mut self.units {
            let program = &self.compiled[unit.program];
            let ready = unit.datapath.in_ready();
            outputs[unit.in_ready] = ready.into();
            outputs[unit.out_valid] = unit.datapath.out().is_some().into();
            if let Some(results) = unit.datapath.out() {
                unit.outputs.iter().zip(results).for_each(|(&port, &value)| outputs[port] = value);
            }
            if inputs[self.rst] != 0 {
                unit.datapath = Datapath::new(program.manifest.latency, program.manifest.initiation_interval);
                continue;
            }
            let accepted = ready && inputs[unit.in_valid] != 0;
            let token: Vec<u64> = unit.inputs.iter().map(|&port| inputs[port]).collect();
            let accepted = accepted.then(|| Token::from(program.results(self.tables, &token)));
            unit.datapath.step(accepted, inputs[unit.out_ready] != 0);
        }
    }
}

/// Sends `tokens` random tokens through every program, hardware and model in lockstep.
pub fn run(
    library: &Arc<Library>,
    compiled: &[Compiled],
    tables: &[Table],
    tokens: usize,
    seed: u64,
    stall: Stall,
) -> LockstepReport {
    let mut rng = Rng::with_seed(seed);
    let mut testbench = StreamTestbench::new(library, seed);
    let mut longest = 0;
    for (index, program) in compiled.iter().enumerate() {
        let items = (0..tokens).map(|_| program.token(&mut rng)).collect();
        let fits = "the testbench offers what the program takes";
        testbench = testbench.source(&format!("in_{index}"), items, stall).expect(fits);
        testbench = testbench.sink(&format!("out_{index}"), stall).expect(fits);
        for (name, &value) in names(&program.graph, &Operation::Uniform).iter().zip(&program.uniforms) {
            testbench = testbench.constant(&format!("uniform_{index}_{name}"), value).expect(fits);
        }
        longest = longest.max(program.manifest.latency);
    }
    let testbench = testbench.quiet_cycles(u64::from(4 * longest + 64));
    let lockstep = Lockstep::new(library, Model::new(library, compiled, tables), seed);
    lockstep.run(testbench).unwrap_or_else(|error| panic!("{error}")).report
}
