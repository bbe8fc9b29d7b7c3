//! What passes between the children of a module: the design as a picture shows it.

use std::collections::BTreeSet;

use super::dependencies::leaves;
use super::module::{Module, PortDeclaration, Source};

/// Where a wire begins or ends.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Terminal {
    /// The child, by its unit; none for the module's own port.
    pub unit: Option<String>,
    /// The port.
    pub port: String,
}

/// A port that follows another within a cycle, or from a register of the module.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Link {
    /// An output of a child, or an input of the module.
    pub from: Terminal,
    /// An input of a child, or an output of the module.
    pub to: Terminal,
}

impl Module {
    /// What passes between the children of this module and its ports, through whatever logic lies between.
    #[must_use]
    pub fn links(&self) -> BTreeSet<Link> {
        let mut links = BTreeSet::new();
        for child in &self.children {
            for (port, driver) in child.module.ports.iter().zip(&child.inputs) {
                let to = Terminal { unit: Some(child.module.unit.clone()), port: port.shape(&child.module).0.into() };
                let sources = driver.iter().flat_map(|driver| self.sources(leaves(self, *driver)));
                links.extend(sources.map(|from| Link { from, to: to.clone() }));
            }
        }
        for port in &self.ports {
            if let PortDeclaration::Output { name, value, .. } = port {
                let to = Terminal { unit: None, port: name.clone() };
                let sources = self.sources(leaves(self, *value));
                links.extend(sources.into_iter().map(|from| Link { from, to: to.clone() }));
            }
        }
        links
    }

    /// The inputs and the children's outputs that signals are made of.
    fn sources(&self, signals: BTreeSet<usize>) -> Vec<Terminal> {
        let (mut found, mut seen) = (vec![], BTreeSet::new());
        let mut pending: Vec<usize> = signals.into_iter().collect();
        while let Some(index) = pending.pop() {
            if !seen.insert(index) {
                continue;
            }
            let signal = &self.signals[index];
            match &signal.source {
                Source::Input => found.push(Terminal { unit: None, port: signal.name.to_string() }),
                Source::ChildOutput { child, port } => {
                    let module = &self.children[*child].module;
                    let port = module.ports[*port].shape(module).0.to_owned();
                    found.push(Terminal { unit: Some(module.unit.clone()), port });
                }
                Source::Wire(Some(driver)) => pending.extend(leaves(self, *driver)),
                Source::Register { next: Some(next), .. } => pending.extend(leaves(self, next.data)),
                _ => {}
            }
        }
        found
    }
}
