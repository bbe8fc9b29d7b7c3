//! Finds every fault of a hierarchy before anything is written.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use super::dependencies::{self, Reach};
use super::error::{Fault, FaultKind, Place};
use super::expression::{Expr, Primitive};
use super::memory::Content;
use super::module::{Module, PortDeclaration, Source};

/// Checks each module once, at the first place where it occurs.
#[derive(Default)]
pub(super) struct Checker {
    pub faults: Vec<Fault>,
    known: HashMap<*const Module, Rc<Reach>>,
}

impl Checker {
    /// Checks a module and all below it; returns which inputs reach which outputs.
    pub fn check(&mut self, module: &Module, path: String) -> Rc<Reach> {
        if let Some(reach) = self.known.get(&std::ptr::from_ref(module)) {
            return reach.clone();
        }
        let children: Vec<Rc<Reach>> =
            module.children.iter().map(|child| self.check(&child.module, format!("{path}/{}", child.name))).collect();
        let dependencies = dependencies::analyse(module, &children);
        let mut kinds = module.faults.clone();
        kinds.extend(undriven(module));
        kinds.extend(wrong_expressions(module));
        let loops = dependencies.loops.into_iter();
        kinds.extend(loops.map(|(names, signal)| (FaultKind::Loop(names), module.signals[signal].place)));
        self.faults.extend(kinds.into_iter().map(|(kind, place)| Fault { place, path: path.clone(), kind }));
        let reach = Rc::new(dependencies.reach);
        self.known.insert(std::ptr::from_ref(module), reach.clone());
        reach
    }
}

/// Wires, registers, memories and inputs of children without a driver.
fn undriven(module: &Module) -> Vec<(FaultKind, Place)> {
    let mut faults = vec![];
    for signal in &module.signals {
        if matches!(signal.source, Source::Wire(None) | Source::Register { next: None, .. }) {
            faults.push((FaultKind::Undriven(signal.name.to_string()), signal.place));
        }
    }
    let unwritten = module.stores.iter().filter(|store| matches!(store.content, Content::Written(None)));
    faults.extend(unwritten.map(|store| (FaultKind::Undriven(store.name.clone()), store.place)));
    for child in &module.children {
        for (index, (port, driver)) in child.module.ports.iter().zip(&child.inputs).enumerate() {
            if matches!(port, PortDeclaration::Input(_)) && driver.is_none() {
                let port = child.module.missing_field(port.shape(&child.module).0, child.parts.get(&index));
                faults.push((FaultKind::Unconnected { instance: child.name.clone(), port }, child.place));
            }
        }
    }
    faults
}

/// Every expression that a module keeps, with what it is for.
fn expressions(module: &Module) -> Vec<(String, Place, Expr)> {
    let mut all = vec![];
    for signal in &module.signals {
        let user = format!("`{}`", signal.name);
        let parts: Vec<Expr> = match &signal.source {
            Source::Reset | Source::Input | Source::ChildOutput { .. } | Source::BlockOutput { .. } => vec![],
            Source::Wire(driver) => driver.iter().copied().collect(),
            Source::Register { next, .. } => {
                next.iter().flat_map(|next| next.enable.into_iter().chain([next.data])).collect()
            }
            Source::Read { enable, address, .. } => enable.iter().copied().chain([*address]).collect(),
            Source::ReadNow { address, .. } | Source::Lookup { address, .. } => vec![*address],
        };
        all.extend(parts.into_iter().map(|part| (user.clone(), signal.place, part)));
    }
    for store in &module.stores {
        if let Content::Written(Some(port)) = &store.content {
            all.extend(
                [port.enable, port.address, port.data].map(|part| (format!("`{}`", store.name), store.place, part)),
            );
        }
    }
    for child in &module.children {
        all.extend(child.reset.iter().map(|&reset| (format!("`{}.rst`", child.name), child.place, reset)));
        for (port, driver) in child.module.ports.iter().zip(&child.inputs) {
            let name = port.shape(&child.module).0;
            all.extend(driver.iter().map(|&driver| (format!("`{}.{name}`", child.name), child.place, driver)));
        }
    }
    for port in &module.ports {
        if let PortDeclaration::Output { name, value, place } = port {
            all.push((format!("output `{name}`"), *place, *value));
        }
    }
    let stated = module.assertions.iter();
    all.extend(stated.map(|stated| (format!("assertion `{}`", stated.name), stated.place, stated.condition)));
    all
}

/// Poison and signals from elsewhere, each once, at its first user.
fn wrong_expressions(module: &Module) -> Vec<(FaultKind, Place)> {
    let mut seen = HashSet::new();
    let mut faults = vec![];
    for (user, place, root) in expressions(module) {
        dependencies::for_each_node(root, &mut |expr| match &expr.node().operation {
            Primitive::Poison(mistake) if seen.insert(mistake.clone()) => {
                let message = mistake.message.to_string();
                faults.push((FaultKind::Expression { user: user.clone(), message }, mistake.place.unwrap_or(place)));
            }
            Primitive::Signal(signal) if signal.module != module.identity => {
                let signal = signal.name.to_string();
                faults.push((FaultKind::ForeignSignal { user: user.clone(), signal }, place));
            }
            _ => {}
        });
    }
    faults
}
