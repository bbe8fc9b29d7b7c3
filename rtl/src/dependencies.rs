//! Which inputs reach which outputs without a register, and loops among them.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::rc::Rc;

use super::expression::{Expr, Primitive};
use super::module::{Module, PortDeclaration, RESET, Source};

/// By output port: the input signals (the reset among them) that reach it in the same cycle.
pub(super) type Reach = BTreeMap<usize, BTreeSet<usize>>;

/// The combinational dependencies of one module.
pub(super) struct Dependencies {
    pub reach: Reach,
    /// Loops, each as the names along it, and a signal of it.
    pub loops: Vec<(String, usize)>,
}

/// Calls `visit` for every distinct node below `root`, operands first.
pub(super) fn for_each_node(root: Expr, visit: &mut impl FnMut(Expr)) {
    fn descend(expr: Expr, seen: &mut HashSet<u64>, visit: &mut impl FnMut(Expr)) {
        if seen.insert(expr.number()) {
            expr.node().operands.iter().for_each(|&operand| descend(operand, seen, visit));
            visit(expr);
        }
    }
    descend(root, &mut HashSet::new(), visit);
}

/// The own signals an expression reads.
pub(super) fn leaves(module: &Module, root: Expr) -> BTreeSet<usize> {
    let mut found = BTreeSet::new();
    for_each_node(root, &mut |expr| {
        if let Primitive::Signal(signal) = &expr.node().operation
            && signal.module == module.identity
        {
            found.insert(signal.index);
        }
    });
    found
}

/// The signals that a signal follows within the cycle.
fn followed(module: &Module, signal: usize, children: &[Rc<Reach>]) -> BTreeSet<usize> {
    match &module.signals[signal].source {
        Source::Reset | Source::Input | Source::Register { .. } | Source::Read { .. } | Source::Wire(None) => {
            BTreeSet::new()
        }
        Source::Wire(Some(driver)) => leaves(module, *driver),
        Source::ReadNow { address, .. } | Source::Lookup { address, .. } => leaves(module, *address),
        Source::BlockOutput { follows } => follows.iter().copied().collect(),
        Source::ChildOutput { child, port } => {
            let instance = &module.children[*child];
            let mut found = BTreeSet::new();
            for &input in children[*child].get(port).into_iter().flatten() {
                if input == RESET {
                    match &instance.reset {
                        Some(condition) => found.extend(leaves(module, *condition)),
                        None => _ = found.insert(RESET),
                    }
                } else if let Some(driver) = instance.driver_of(input) {
                    found.extend(leaves(module, driver));
                }
            }
            found
        }
    }
}

struct Search<'a> {
    module: &'a Module,
    edges: Vec<BTreeSet<usize>>,
    /// The inputs that reach a signal, once it has been visited.
    inputs: Vec<Option<BTreeSet<usize>>>,
    path: Vec<usize>,
    loops: Vec<(String, usize)>,
}

impl Search<'_> {
    fn visit(&mut self, signal: usize) -> BTreeSet<usize> {
        if let Some(known) = &self.inputs[signal] {
            return known.clone();
        }
        if let Some(start) = self.path.iter().position(|&on_path| on_path == signal) {
            let around = self.path[start..].iter().chain([&signal]);
            // The path runs from reader to driver; a loop reads better along the flow.
            let names: Vec<&str> = around.rev().map(|&index| &*self.module.signals[index].name).collect();
            self.loops.push((names.join(" -> "), signal));
            return BTreeSet::new();
        }
        let mut inputs = BTreeSet::new();
        if matches!(self.module.signals[signal].source, Source::Input | Source::Reset) {
            inputs.insert(signal);
        }
        self.path.push(signal);
        for driver in self.edges[signal].clone() {
            inputs.extend(self.visit(driver));
        }
        self.path.pop();
        self.inputs[signal] = Some(inputs.clone());
        inputs
    }
}

/// The dependencies of `module`, given those of its children in their order.
pub(super) fn analyse(module: &Module, children: &[Rc<Reach>]) -> Dependencies {
    let count = module.signals.len();
    let edges = (0..count).map(|signal| followed(module, signal, children)).collect();
    let mut search = Search { module, edges, inputs: vec![None; count], path: vec![], loops: vec![] };
    for signal in 0..count {
        search.visit(signal);
    }
    let mut reach = Reach::new();
    for (port, declaration) in module.ports.iter().enumerate() {
        if let PortDeclaration::Output { value, .. } = declaration {
            let inputs = leaves(module, *value).into_iter().flat_map(|signal| search.visit(signal)).collect();
            reach.insert(port, inputs);
        }
    }
    Dependencies { reach, loops: search.loops }
}
