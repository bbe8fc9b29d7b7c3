//! The body of a module: declarations, wires, instances, clocked blocks, assertions.

use std::collections::{BTreeMap, HashSet};
use std::fmt::Write as _;

use super::canonical::{Graph, Need};
use super::expression::{Expr, Primitive};
use super::memory::{Content, Store, Style};
use super::module::{Assertion, Module, PortDeclaration, Source};
use super::text::{braced, literal, range};
use super::writer::Writer;

/// A module as text, but for its name and those of its children.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Body {
    /// Ports as `(name, width, kind)`, `clk` and `rst` first where there is state.
    pub ports: Vec<(String, u32, PortKind)>,
    /// What stands before the instances.
    pub before: String,
    /// By child: the instance's name and its connections.
    pub instances: Vec<(String, Vec<(String, String)>)>,
    /// What stands after the instances.
    pub after: String,
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

/// Something below needs `clk` and `rst`.
fn is_stateful(graph: &Graph, children_have_state: &[bool]) -> bool {
    let needed = |index: usize, source: &Source| {
        let clocked = matches!(source, Source::Reset | Source::Register { .. } | Source::Read { .. });
        clocked && graph.signals[index] != Need::Nobody
    };
    let module = graph.module;
    children_have_state.contains(&true)
        || !module.assertions.is_empty()
        || graph.stores.iter().any(|&need| need != Need::Nobody)
        || module.signals.iter().enumerate().any(|(index, signal)| needed(index, &signal.source))
}

/// Writes a module without faults; says also whether it has state, its own or a child's.
pub(super) fn body(graph: &Graph, children_have_state: &[bool]) -> (Body, bool) {
    let stateful = is_stateful(graph, children_have_state);
    let mut emitter = Emitter { module: graph.module, writer: Writer::new(graph, port_signals(graph.module)) };
    (emitter.body(children_have_state, stateful), stateful)
}

/// Signals that an output port of their own name shows.
fn port_signals(module: &Module) -> HashSet<usize> {
    let shown = module.ports.iter().filter_map(|port| match port {
        PortDeclaration::Output { name, value, .. } => shown_signal(name, *value),
        PortDeclaration::Input(_) => None,
    });
    shown.collect()
}

fn shown_signal(name: &str, value: Expr) -> Option<usize> {
    match &value.node().operation {
        Primitive::Signal(signal) if &*signal.name == name => Some(signal.index),
        _ => None,
    }
}

struct Emitter<'a> {
    module: &'a Module,
    writer: Writer<'a>,
}

impl Emitter<'_> {
    fn body(&mut self, children_have_state: &[bool], stateful: bool) -> Body {
        let ports = self.ports(stateful);
        let state = self.state_declarations(Need::Hardware);
        let outputs = self.child_outputs();
        let assigns = self.output_assignments();
        let instances = self.instances(children_have_state);
        let clocked = self.writer.clocked(Need::Hardware);
        if children_have_state.contains(&true) || !clocked.is_empty() {
            self.writer.read_all("clk");
        }
        let definitions = std::mem::take(&mut self.writer.definitions).join("\n");
        let unused = unused_sink("_unused", &self.writer.bits_read);
        let checks = self.checks();
        let sections = [state, outputs, definitions, assigns];
        Body { ports, before: join_sections(&sections), instances, after: join_sections(&[clocked, unused, checks]) }
    }

    fn ports(&mut self, stateful: bool) -> Vec<(String, u32, PortKind)> {
        let mut ports = vec![];
        if stateful {
            ports.extend([("clk".into(), 1, PortKind::Input), ("rst".into(), 1, PortKind::Input)]);
            ["clk", "rst"].into_iter().for_each(|name| self.writer.track(name, 1));
        }
        for port in &self.module.ports {
            let (name, width) = port.shape(self.module);
            let kind = match port {
                PortDeclaration::Input(_) => {
                    self.writer.track(name, width);
                    PortKind::Input
                }
                PortDeclaration::Output { value, .. } => {
                    let source = shown_signal(name, *value).map(|signal| &self.module.signals[signal].source);
                    match source {
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
        for (index, store) in self.module.stores.iter().enumerate() {
            if self.writer.graph.stores[index] == need {
                declare_store(store, &mut out);
            }
        }
        for (index, signal) in self.module.signals.iter().enumerate() {
            let clocked = matches!(signal.source, Source::Register { .. } | Source::Read { .. });
            if clocked && self.writer.graph.signals[index] == need && !self.writer.port_signals.contains(&index) {
                let width = signal.reference.width();
                let _ = writeln!(out, "reg {}{};", range(width), signal.name);
                self.writer.track(&signal.name, width);
            }
        }
        out
    }

    fn child_outputs(&mut self) -> String {
        let mut out = String::new();
        for (index, signal) in self.module.signals.iter().enumerate() {
            if matches!(signal.source, Source::ChildOutput { .. }) && !self.writer.port_signals.contains(&index) {
                let width = signal.reference.width();
                let _ = writeln!(out, "wire {}{};", range(width), signal.name);
                self.writer.track(&signal.name, width);
            }
        }
        out
    }

    fn output_assignments(&mut self) -> String {
        let mut out = String::new();
        for port in &self.module.ports {
            let PortDeclaration::Output { name, value, .. } = port else { continue };
            match shown_signal(name, *value) {
                Some(signal) => self.writer.define(signal),
                None => {
                    let value = self.writer.expression(*value);
                    let _ = writeln!(out, "assign {name} = {value};");
                }
            }
        }
        out
    }

    fn instances(&mut self, children_have_state: &[bool]) -> Vec<(String, Vec<(String, String)>)> {
        let module = self.module;
        let mut instances = vec![];
        for (child, &stateful) in module.children.iter().zip(children_have_state) {
            let mut connections = vec![];
            if stateful {
                let reset = match &child.reset {
                    Some(condition) => self.writer.expression(*condition),
                    None => self.writer.read_all("rst"),
                };
                connections.extend([("clk".into(), "clk".into()), ("rst".into(), reset)]);
            }
            for (index, port) in child.module.ports.iter().enumerate() {
                let value = match (&child.inputs[index], child.outputs[index]) {
                    (Some(driver), _) => self.writer.expression(*driver),
                    (None, Some(signal)) => module.signals[signal].name.to_string(),
                    (None, None) => unreachable!("an open input is a fault"),
                };
                connections.push((port.shape(&child.module).0.to_string(), value));
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
        let mut checks = String::from("always @(posedge clk) begin\n    if (!rst) begin\n");
        for Assertion { name, condition, .. } in &self.module.assertions {
            let condition = self.writer.expression(*condition);
            let _ = writeln!(checks, "        if (!({condition})) begin");
            let _ = writeln!(checks, "`ifdef FORMAL\n            {name}: assert (0);\n`else");
            let _ = writeln!(checks, "            $display(\"assertion failed: {name} in %m\");");
            checks += "            $stop;\n`endif\n        end\n";
        }
        checks += "    end\nend\n";
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
