//! Which expressions get a wire of their own, what it is called, and in which order they are defined.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::fmt::Write as _;

use super::canonical::{Graph, Need};
use super::expression::{Expr, Primitive};
use super::module::Source;
use super::naming::Namer;
use super::text::{literal, range};

/// Writes the expressions of one module.
pub(super) struct Writer<'a> {
    pub graph: &'a Graph<'a>,
    /// Definitions of wires, in an order in which each uses only earlier ones.
    pub definitions: Vec<String>,
    /// By declared name: which of its bits are read.
    pub bits_read: BTreeMap<String, Vec<bool>>,
    /// Signals that are ports themselves, and which: they are assigned or connected, not declared.
    pub port_names: HashMap<usize, &'a str>,
    defined: HashSet<usize>,
    node_names: HashMap<usize, String>,
    /// By node: the live wire of the author's that shows it.
    author_names: HashMap<usize, usize>,
    namer: Namer,
}

impl<'a> Writer<'a> {
    pub fn new(graph: &'a Graph<'a>, port_names: HashMap<usize, &'a str>) -> Self {
        let mut author_names = HashMap::new();
        for (index, signal) in
            graph.module.signals.iter().enumerate().filter(|(index, _)| graph.signals[*index] != Need::Nobody)
        {
            if let Source::Wire(Some(driver)) = &signal.source {
                author_names.entry(graph.node_of(*driver)).or_insert(index);
            }
        }
        Self {
            graph,
            definitions: vec![],
            bits_read: BTreeMap::new(),
            port_names,
            defined: HashSet::new(),
            node_names: HashMap::new(),
            author_names,
            namer: Namer::new(graph),
        }
    }

    /// Makes a name known whose reading is of interest.
    pub fn track(&mut self, name: &str, width: u32) {
        self.bits_read.insert(name.into(), vec![false; width as usize]);
    }

    /// What a signal is called in the text.
    pub fn signal_name(&self, signal: usize) -> &'a str {
        signal_name(self.graph, &self.port_names, signal)
    }

    /// The whole of an expression, as the right side of an assignment.
    pub fn expression(&mut self, expr: Expr) -> String {
        let node = self.graph.node_of(expr);
        if self.wants_wire(node) {
            return self.whole(node);
        }
        self.compose(node).0
    }

    /// As [`Writer::expression`], where that may be bits of a signal that are not read together anywhere.
    pub fn bits(&mut self, expr: Expr) -> String {
        match &expr.node().operation {
            Primitive::Slice(low) if matches!(expr.node().operands[0].node().operation, Primitive::Signal(_)) => {
                let source = self.graph.node_of(expr.node().operands[0]);
                self.slice(source, *low, expr.width())
            }
            _ => self.expression(expr),
        }
    }

    /// Writes the definition of a live wire, after those of what it needs.
    pub fn define(&mut self, signal: usize) {
        if !self.defined.insert(signal) {
            return;
        }
        let module = self.graph.module;
        let Source::Wire(Some(driver)) = &module.signals[signal].source else {
            return self.define_special(signal);
        };
        let node = self.graph.node_of(*driver);
        let name = module.signals[signal].name.to_string();
        let value = match self.node_names.get(&node).cloned() {
            Some(other) => self.read_all(&other),
            None if self.author_names.get(&node) != Some(&signal) && self.wants_wire(node) => self.whole(node),
            None => self.compose(node).0,
        };
        if !self.is_leaf(node) {
            self.node_names.entry(node).or_insert_with(|| name.clone());
        }
        self.push_definition(signal, &value);
    }

    /// Definitions that are not a single expression: tables and unregistered reads.
    fn define_special(&mut self, signal: usize) {
        let module = self.graph.module;
        let (name, width) = (&module.signals[signal].name, module.signals[signal].reference.width());
        match &module.signals[signal].source {
            Source::ReadNow { store, address } => {
                let address = self.expression(*address);
                self.push_definition(signal, &format!("{}[{address}]", module.stores[*store].name));
            }
            Source::Lookup { values, address } => {
                let address_width = address.width();
                let address = self.expression(*address);
                let mut text = String::new();
                if !self.port_names.contains_key(&signal) {
                    let _ = writeln!(text, "reg {}{name};", range(width));
                    self.track(name, width);
                }
                let _ = writeln!(text, "always @(*) begin\n    case ({address})");
                for (index, &value) in values.iter().enumerate() {
                    let label = if index + 1 == values.len() {
                        "default".into()
                    } else {
                        literal(address_width, index as u128)
                    };
                    let _ = writeln!(text, "        {label}: {name} = {};", literal(width, value));
                }
                text += "    endcase\nend";
                self.definitions.push(text);
            }
            _ => {}
        }
    }

    fn push_definition(&mut self, signal: usize, value: &str) {
        let signal_record = &self.graph.module.signals[signal];
        let (name, width) = (&signal_record.name, signal_record.reference.width());
        if self.port_names.contains_key(&signal) {
            self.definitions.push(format!("assign {name} = {value};"));
        } else {
            self.definitions.push(format!("wire {}{name} = {value};", range(width)));
            self.track(name, width);
        }
    }

    pub fn is_leaf(&self, node: usize) -> bool {
        matches!(self.graph.nodes[node].operation, Primitive::Signal(_) | Primitive::Literal(_))
    }

    /// Cheap enough to be written again at every reader.
    fn is_cheap(&self, node: usize) -> bool {
        let description = &self.graph.nodes[node];
        match description.operation {
            Primitive::Signal(_) | Primitive::Literal(_) | Primitive::Slice(_) => true,
            Primitive::Not | Primitive::Any | Primitive::All | Primitive::Repeat(_) => {
                let operand = description.operands[0];
                self.is_leaf(operand) || matches!(self.graph.nodes[operand].operation, Primitive::Slice(_))
            }
            Primitive::Cat => {
                description.operands.len() == 2 && description.operands.iter().all(|&operand| self.is_leaf(operand))
            }
            _ => false,
        }
    }

    pub fn wants_wire(&self, node: usize) -> bool {
        self.node_names.contains_key(&node)
            || (!self.is_leaf(node) && self.author_names.contains_key(&node))
            || (self.graph.nodes[node].readers > 1 && !self.is_cheap(node))
    }

    /// The name that stands for a node, defined first where it has none.
    pub fn name_of(&mut self, node: usize) -> String {
        if let Primitive::Signal(signal) = &self.graph.nodes[node].operation {
            self.define(signal.index);
            return self.signal_name(signal.index).into();
        }
        if let Some(name) = self.node_names.get(&node).cloned() {
            return name;
        }
        if !self.is_leaf(node)
            && let Some(&signal) = self.author_names.get(&node)
        {
            self.define(signal);
            return self.graph.module.signals[signal].name.to_string();
        }
        let value = self.compose(node).0;
        self.name_value(node, &value)
    }

    /// A new wire for a node whose text is known.
    pub fn name_value(&mut self, node: usize, value: &str) -> String {
        let (graph, names, ports) = (self.graph, &self.node_names, &self.port_names);
        let known = |node: usize| match &graph.nodes[node].operation {
            Primitive::Signal(signal) => Some(signal_name(graph, ports, signal.index).into()),
            _ => names.get(&node).cloned(),
        };
        let name = self.namer.name(graph, node, known);
        let width = self.graph.nodes[node].width;
        self.definitions.push(format!("wire {}{name} = {value};", range(width)));
        self.track(&name, width);
        self.node_names.insert(node, name.clone());
        name
    }

    /// The name of a node whose bits are all read.
    pub fn whole(&mut self, node: usize) -> String {
        let name = self.name_of(node);
        self.read_all(&name)
    }

    pub fn read_all(&mut self, name: &str) -> String {
        if let Some(bits) = self.bits_read.get_mut(name) {
            bits.fill(true);
        }
        name.into()
    }
}

/// What a signal is called: as the port that it is, or as its author named it.
fn signal_name<'a>(graph: &'a Graph<'a>, ports: &HashMap<usize, &'a str>, signal: usize) -> &'a str {
    ports.get(&signal).copied().unwrap_or(&graph.module.signals[signal].name)
}
