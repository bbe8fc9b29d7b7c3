//! The live part of a module as a graph in which equal expressions are one node.

use std::collections::HashMap;

use super::expression::{Expr, Primitive};
use super::memory::Content;
use super::module::{Module, PortDeclaration, Source};
use super::resolve::Resolver;

/// A node of the graph; operands are indices.
pub(super) struct GraphNode {
    pub operation: Primitive,
    pub width: u32,
    pub operands: Vec<usize>,
    /// How many nodes and signals read it.
    pub readers: usize,
}

type Key = (Primitive, u32, Vec<usize>);

/// Who needs a signal or a memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Need {
    Nobody,
    /// Assertions only.
    Assertions,
    /// Outputs or children.
    Hardware,
}

/// What a module computes, without what nobody reads.
pub(super) struct Graph<'a> {
    pub module: &'a Module,
    pub nodes: Vec<GraphNode>,
    /// Nodes before this one are hardware, the others serve assertions only.
    pub hardware_nodes: usize,
    /// By signal.
    pub signals: Vec<Need>,
    /// By memory.
    pub stores: Vec<Need>,
    /// On whose behalf nodes are being added.
    need: Need,
    /// What outputs show, by the expressions that drive them.
    pub outputs: HashMap<u64, Expr>,
    resolver: Resolver<'a>,
    by_key: HashMap<Key, usize>,
    by_number: HashMap<u64, usize>,
    /// Signals whose drivers have not been followed yet.
    pending: Vec<usize>,
}

impl<'a> Graph<'a> {
    /// All that the outputs and the children of the module need, then what its assertions need besides.
    pub fn of(module: &'a Module) -> Self {
        let mut graph = Self {
            module,
            nodes: vec![],
            hardware_nodes: 0,
            signals: vec![Need::Nobody; module.signals.len()],
            stores: vec![Need::Nobody; module.stores.len()],
            need: Need::Hardware,
            outputs: HashMap::new(),
            resolver: Resolver::new(module),
            by_key: HashMap::new(),
            by_number: HashMap::new(),
            pending: vec![],
        };
        for port in &module.ports {
            if let PortDeclaration::Output { value, .. } = port {
                graph.output(*value);
            }
        }
        module
            .children
            .iter()
            .flat_map(|child| child.reset.iter().chain(child.inputs.iter().flatten()))
            .for_each(|&input| graph.root(input));
        graph.follow();
        graph.hardware_nodes = graph.nodes.len();
        graph.need = Need::Assertions;
        module.assertions.iter().for_each(|assertion| graph.root(assertion.condition));
        graph.follow();
        graph
    }

    /// The node of an expression that is in the graph.
    pub fn node_of(&self, expr: Expr) -> usize {
        self.by_number[&expr.number()]
    }

    /// The node of an expression, if it is in the graph.
    pub fn find(&self, expr: Expr) -> Option<usize> {
        self.by_number.get(&expr.number()).copied()
    }

    /// An output shows the bits that a wire names, without the wire.
    fn output(&mut self, value: Expr) {
        let bits = self.resolver.bits(value);
        self.root(bits);
        self.outputs.insert(value.number(), bits);
    }

    fn root(&mut self, expr: Expr) {
        let node = self.intern(expr);
        self.nodes[node].readers += 1;
    }

    fn intern(&mut self, expr: Expr) -> usize {
        if let Some(&known) = self.by_number.get(&expr.number()) {
            return known;
        }
        let resolved = self.resolver.resolve(expr);
        if resolved.number() != expr.number() {
            let index = self.intern(resolved);
            self.by_number.insert(expr.number(), index);
            return index;
        }
        let node = expr.node();
        let operands: Vec<usize> = node.operands.iter().map(|&operand| self.intern(operand)).collect();
        let key = (node.operation.clone(), node.width, operands);
        let index = match self.by_key.get(&key) {
            Some(&index) => index,
            None => self.insert(key),
        };
        self.by_number.insert(expr.number(), index);
        index
    }

    fn insert(&mut self, key: Key) -> usize {
        let (operation, width, operands) = key.clone();
        operands.iter().for_each(|&operand| self.nodes[operand].readers += 1);
        if let Primitive::Signal(signal) = &operation
            && self.signals[signal.index] == Need::Nobody
        {
            self.signals[signal.index] = self.need;
            self.pending.push(signal.index);
        }
        self.nodes.push(GraphNode { operation, width, operands, readers: 0 });
        self.by_key.insert(key, self.nodes.len() - 1);
        self.nodes.len() - 1
    }

    /// Follows live signals to what drives them until nothing new turns up.
    fn follow(&mut self) {
        let module = self.module;
        while let Some(signal) = self.pending.pop() {
            match &module.signals[signal].source {
                Source::Reset | Source::Input | Source::ChildOutput { .. } | Source::BlockOutput { .. } => {}
                Source::Wire(driver) => driver.iter().for_each(|&driver| self.root(driver)),
                Source::Register { next, .. } => {
                    if let Some(next) = next {
                        next.enable.iter().for_each(|&enable| self.root(enable));
                        self.root(next.data);
                    }
                }
                Source::Read { store, enable, address } => {
                    enable.iter().for_each(|&enable| self.root(enable));
                    self.read_store(*store, *address);
                }
                Source::ReadNow { store, address } => self.read_store(*store, *address),
                Source::Lookup { address, .. } => self.root(*address),
            }
        }
    }

    fn read_store(&mut self, store: usize, address: Expr) {
        self.root(address);
        if self.stores[store] != Need::Nobody {
            return;
        }
        self.stores[store] = self.need;
        if let Content::Written(Some(port)) = &self.module.stores[store].content {
            [port.enable, port.address, port.data].into_iter().for_each(|part| self.root(part));
        }
    }
}
