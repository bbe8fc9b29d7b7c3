//! The body of a module: declarations, wires, instances, clocked blocks, assertions.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fmt::Write as _;

use super::canonical::{Graph, Need};
use super::expression::{Expr, Primitive};
use super::memory::{Content, Store, Style};
use super::memory_module::MemoryModule;
use super::module::{Assertion, Module, PortDeclaration, Source};
use super::text::{COMMENT, Declarations, LINE_CHARACTERS, braced, literal, range};
use super::writer::Writer;

/// A module as text, but for its name and those of its children.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Body {
    /// Ports as `(name, width, kind)`, `clk` and `rst` first where there is state.
    pub ports: Vec<(String, u32, PortKind)>,
    /// What stands before the instances.
    pub before: String,
    /// By child: the instance's name and its connections.
    pub instances: Vec<(String, Vec<(String, String)>)>,
    /// The modules of its memories, which stand with their names in `before`.
    pub memories: BTreeSet<MemoryModule>,
    /// What stands after the instances.
    pub after: String,
}

impl Body {
    /// It without what is said of registers.
    pub fn without_comments(&self) -> Self {
        let bare = self.before.lines().map(|line| line.split(COMMENT).next().unwrap_or(line).to_owned() + "\n");
        Self { before: bare.collect(), ..self.clone() }
    }
}

/// How a port is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum PortKind {
    Input,
    /// Assigned continuously.
    OutputWire,
    /// Assigned in a clocked or combinational block.
    OutputReg,
}

/// The ports that nobody declares.
#[derive(Clone, Copy, Default)]
pub(super) struct Implicit {
    /// It has state, its own or a child's.
    pub clk: bool,
    /// Something in it or below depends on the reset.
    pub rst: bool,
}

/// Something in the module or below needs `clk`.
fn has_state(graph: &Graph, children: &[Implicit]) -> bool {
    let needed = |index: usize, source: &Source| {
        let clocked = matches!(source, Source::Reset | Source::Register { .. } | Source::Read { .. });
        clocked && graph.signals[index] != Need::Nobody
    };
    let module = graph.module;
    children.iter().any(|child| child.clk)
        || !module.assertions.is_empty()
        || graph.stores.iter().any(|&need| need != Need::Nobody)
        || module.signals.iter().enumerate().any(|(index, signal)| needed(index, &signal.source))
}

/// Something in the module or below needs `rst`.
fn has_reset(graph: &Graph, children: &[Implicit]) -> bool {
    let module = graph.module;
    let resets = |source: &Source| matches!(source, Source::Reset | Source::Register { reset: Some(_), .. });
    let mut live = module.signals.iter().zip(&graph.signals).filter(|(_, need)| **need != Need::Nobody);
    children.iter().any(|child| child.rst)
        || !module.assertions.is_empty()
        || live.any(|(signal, _)| resets(&signal.source))
}

/// Writes a module without faults; says also which implicit ports it has. A top with state has both.
pub(super) fn body(graph: &Graph, children: &[Implicit], is_top: bool) -> (Body, Implicit) {
    let clk = has_state(graph, children);
    let implicit = Implicit { clk, rst: clk && (is_top || has_reset(graph, children)) };
    let mut emitter = Emitter { module: graph.module, writer: Writer::new(graph, port_names(graph)) };
    (emitter.body(children, implicit), implicit)
}

/// Signals that are output ports themselves, and which: those of their own name, and outputs of children that leave as they come.
fn port_names<'a>(graph: &'a Graph<'a>) -> HashMap<usize, &'a str> {
    let mut names = HashMap::new();
    for port in &graph.module.ports {
        let PortDeclaration::Output { name, value, .. } = port else { continue };
        let Primitive::Signal(signal) = &graph.outputs[&value.number()].node().operation else { continue };
        let is_childs = matches!(graph.module.signals[signal.index].source, Source::ChildOutput { .. });
        if is_childs || *signal.name == **name {
            names.entry(signal.index).or_insert(&**name);
        }
    }
    names
}

struct Emitter<'a> {
    module: &'a Module,
    writer: Writer<'a>,
}

impl Emitter<'_> {
    /// The signal that is the port of that name, if one is.
    fn shown_signal(&self, name: &str, value: Expr) -> Option<usize> {
        match &self.writer.graph.outputs[&value.number()].node().operation {
            Primitive::Signal(signal) if self.writer.port_names.get(&signal.index) == Some(&name) => Some(signal.index),
            _ => None,
        }
    }

    fn body(&mut self, children: &[Implicit], implicit: Implicit) -> Body {
        let ports = self.ports(implicit);
        let state = self.state_declarations(Need::Hardware);
        let outputs = self.child_outputs();
        let assigns = self.output_assignments();
        let (memories, memory_instances) = self.memories();
        let instances = self.instances(children);
        let clocked = self.writer.clocked(Need::Hardware);
        if children.iter().any(|child| child.clk) || !clocked.is_empty() {
            self.writer.read_all("clk");
        }
        let definitions = std::mem::take(&mut self.writer.definitions).join("\n");
        let unused = unused_sink("_unused", &self.writer.bits_read);
        let checks = self.checks();
        let before = join_sections(&[state, outputs, definitions, assigns, memory_instances]);
        Body { ports, before, instances, memories, after: join_sections(&[clocked, unused, checks]) }
    }

    fn ports(&mut self, implicit: Implicit) -> Vec<(String, u32, PortKind)> {
        let mut ports = vec![];
        for (name, _) in [("clk", implicit.clk), ("rst", implicit.rst)].into_iter().filter(|(_, there)| *there) {
            ports.push((name.into(), 1, PortKind::Input));
            self.writer.track(name, 1);
        }
        for port in &self.module.ports {
            let (name, width) = port.shape(self.module);
            let kind = match port {
                PortDeclaration::Input(_) => {
                    self.writer.track(name, width);
                    PortKind::Input
                }
                PortDeclaration::Output { value, .. } => {
                    let source = self.shown_signal(name, *value).map(|signal| &self.module.signals[signal].source);
                    match source {
                        Some(Source::Read { store, .. }) if self.writer.graph.memory_module(*store).is_some() => {
                            PortKind::OutputWire
                        }
                        Some(Source::Register { .. } | Source::Read { .. } | Source::Lookup { .. }) => {
                            PortKind::OutputReg
                        }
                        _ => PortKind::OutputWire,
                    }
                }
            };
            ports.push((name.to_string(), width, kind));
        }
        ports
    }

    /// Registers and memories that are there for `need`.
    fn state_declarations(&mut self, need: Need) -> String {
        let mut out = String::new();
        let mut declarations = Declarations::default();
        for (index, store) in self.module.stores.iter().enumerate() {
            if self.writer.graph.stores[index] == need && self.writer.graph.memory_module(index).is_none() {
                declare_store(store, &mut out);
            }
        }
        for (index, signal) in self.module.signals.iter().enumerate() {
            let clocked = matches!(signal.source, Source::Register { .. } | Source::Read { .. });
            if clocked && self.writer.graph.signals[index] == need && !self.writer.port_names.contains_key(&index) {
                let width = signal.reference.width();
                let kind = match signal.source {
                    Source::Read { store, .. } if self.writer.graph.memory_module(store).is_some() => "wire",
                    _ => "reg",
                };
                declarations.add(kind, width, &signal.name);
                self.writer.track(&signal.name, width);
            }
        }
        out + &declarations.text(&self.module.documents)
    }

    /// Memories that are instances of modules, and those modules.
    fn memories(&mut self) -> (BTreeSet<MemoryModule>, String) {
        let stores = 0..self.module.stores.len();
        let found: Vec<_> = stores.filter_map(|store| Some((store, self.writer.graph.memory_module(store)?))).collect();
        let instances: Vec<String> =
            found.iter().map(|(store, module)| self.writer.memory_instance(*store, *module)).collect();
        (found.into_iter().map(|(_, module)| module).collect(), join_sections(&instances))
    }

    fn child_outputs(&mut self) -> String {
        let mut declarations = Declarations::default();
        for (index, signal) in self.module.signals.iter().enumerate() {
            if matches!(signal.source, Source::ChildOutput { .. }) && !self.writer.port_names.contains_key(&index) {
                let width = signal.reference.width();
                declarations.add("wire", width, &signal.name);
                self.writer.track(&signal.name, width);
            }
        }
        declarations.text(&BTreeMap::new())
    }

    fn output_assignments(&mut self) -> String {
        let mut groups: Vec<(Vec<String>, Expr)> = vec![];
        for port in &self.module.ports {
            let PortDeclaration::Output { name, value, .. } = port else { continue };
            let shown = self.writer.graph.outputs[&value.number()];
            match self.shown_signal(name, *value) {
                Some(signal) => self.writer.define(signal),
                None => {
                    match groups.last_mut().and_then(|(names, above)| Some((names, above.adjoining(shown)?, above))) {
                        Some((names, both, value)) => {
                            names.push(name.clone());
                            *value = both;
                        }
                        None => groups.push((vec![name.clone()], shown)),
                    }
                }
            }
        }
        let mut out = String::new();
        for (names, value) in groups {
            let value = self.writer.bits(value);
            let target = if names.len() == 1 { names[0].clone() } else { braced(&names) };
            let _ = writeln!(out, "assign {target} = {value};");
        }
        out
    }

    fn instances(&mut self, children: &[Implicit]) -> Vec<(String, Vec<(String, String)>)> {
        let module = self.module;
        let mut instances = vec![];
        for (child, implicit) in module.children.iter().zip(children) {
            let mut connections = vec![];
            if implicit.clk {
                connections.push((child.clock_pin(), "clk".into()));
            }
            if implicit.rst {
                let reset = match &child.reset {
                    Some(condition) => self.writer.expression(*condition),
                    None => self.writer.read_all("rst"),
                };
                connections.push(("rst".into(), reset));
            }
            for index in 0..child.module.ports.len() {
                let value = match (&child.inputs[index], child.outputs[index]) {
                    (Some(driver), _) => self.writer.expression(*driver),
                    (None, Some(signal)) => self.writer.signal_name(signal).into(),
                    (None, None) => unreachable!("an open input is a fault"),
                };
                connections.push((child.pin(index), value));
            }
            instances.push((child.name.clone(), connections));
        }
        instances
    }

    /// The assertions and all that only they need.
    fn checks(&mut self) -> String {
        if self.module.assertions.is_empty() {
            return String::new();
        }
        // Only names that are new from here on are of interest to the sink inside the directive.
        self.writer.bits_read.clear();
        let state = self.state_declarations(Need::Assertions);
        let clocked = self.writer.clocked(Need::Assertions);
        // Proofs are told what holds; a simulation that finds something else says so and stops.
        let (mut proved, mut simulated) = (String::new(), String::new());
        for Assertion { name, condition, .. } in &self.module.assertions {
            let condition = self.writer.expression(*condition);
            let _ = writeln!(proved, "    {name}: assert ({condition});");
            let stop = format!("$display(\"assertion failed: {name} in %m\"); $stop;");
            let whole = format!("    if (!({condition})) begin {stop} end");
            let fits = whole.len() <= LINE_CHARACTERS && !whole.contains('\n');
            let broken = || format!("    if (!({condition})) begin\n        {stop}\n    end");
            let _ = writeln!(simulated, "{}", if fits { whole } else { broken() });
        }
        let head = "always @(posedge clk) if (!rst) begin";
        let checks = format!("{head}\n`ifdef FORMAL\n{proved}`else\n{simulated}`endif\nend\n");
        let definitions = std::mem::take(&mut self.writer.definitions).join("\n");
        let unused = unused_sink("_unused_by_checks", &self.writer.bits_read);
        let inside = join_sections(&[state, definitions, clocked, checks, unused]);
        format!("`ifdef RTL_ASSERT\n{inside}`endif\n")
    }
}

fn declare_store(store: &Store, out: &mut String) {
    out.push_str(match store.style {
        Style::Inferred => "",
        Style::Unordered => "(* no_rw_check *)\n",
        Style::Distributed => "(* ram_style = \"distributed\" *)\n",
    });
    let _ = writeln!(out, "reg {}{} [0:{}];", range(store.width), store.name, store.depth - 1);
    if let Content::Constant(values) = &store.content {
        out.push_str("initial begin\n");
        for (index, &value) in values.iter().enumerate() {
            let _ = writeln!(out, "    {}[{index}] = {};", store.name, literal(store.width, value));
        }
        out.push_str("end\n");
    }
}

/// A wire that reads what nothing else does, so that lint knows it is meant.
fn unused_sink(name: &str, bits_read: &BTreeMap<String, Vec<bool>>) -> String {
    let mut parts = vec!["1'b0".to_string()];
    for (signal, bits) in bits_read {
        let mut low = 0;
        while low < bits.len() {
            let end = (low..bits.len()).find(|&bit| bits[bit] != bits[low]).unwrap_or(bits.len());
            if !bits[low] {
                parts.push(match (end - low, bits.len()) {
                    (length, whole) if length == whole => signal.clone(),
                    (1, _) => format!("{signal}[{low}]"),
                    _ => format!("{signal}[{}:{low}]", end - 1),
                });
            }
            low = end;
        }
    }
    if parts.len() == 1 { String::new() } else { format!("wire {name} = &{};\n", braced(&parts)) }
}

/// Sections with an empty line between them.
fn join_sections(sections: &[String]) -> String {
    let full: Vec<&str> = sections.iter().map(|section| section.trim_end()).filter(|text| !text.is_empty()).collect();
    if full.is_empty() { String::new() } else { full.join("\n\n") + "\n" }
}
