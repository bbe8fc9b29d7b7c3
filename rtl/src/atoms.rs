//! The ports of a rust-hdl block, asked of the block itself.

use rust_hdl_core::prelude::{Atom, AtomKind, Block, Clock, Probe, Synth};

/// A port of a block as rust-hdl knows it.
pub(super) struct AtomPort {
    /// Its name in rust-hdl's Verilog; fields of an interface have a `$` before their own name.
    pub name: String,
    pub width: u32,
    pub kind: AtomKind,
    /// It carries a rust-hdl `Clock`.
    pub is_clock: bool,
}

/// The ports of a block in declaration order, without those of the blocks inside it.
pub(super) fn ports_of(block: &dyn Block) -> Vec<AtomPort> {
    let mut visitor = TopAtoms::default();
    block.accept("block", &mut visitor);
    visitor.ports
}

/// Visits a hierarchy and keeps the ports of its root.
#[derive(Default)]
struct TopAtoms {
    depth: usize,
    namespace: Vec<String>,
    ports: Vec<AtomPort>,
}

impl Probe for TopAtoms {
    fn visit_start_scope(&mut self, _name: &str, _node: &dyn Block) {
        self.depth += 1;
    }

    fn visit_end_scope(&mut self, _name: &str, _node: &dyn Block) {
        self.depth -= 1;
    }

    fn visit_start_namespace(&mut self, name: &str, _node: &dyn Block) {
        self.namespace.push(name.into());
    }

    fn visit_end_namespace(&mut self, _name: &str, _node: &dyn Block) {
        self.namespace.pop();
    }

    fn visit_atom(&mut self, name: &str, atom: &dyn Atom) {
        let kind = atom.kind();
        if self.depth == 1 && kind.is_parameter() {
            let path: Vec<&str> = self.namespace.iter().map(String::as_str).chain([name]).collect();
            let is_clock = atom.descriptor().name == Clock::descriptor().name;
            self.ports.push(AtomPort { name: path.join("$"), width: atom.bits() as u32, kind, is_clock });
        }
    }
}
