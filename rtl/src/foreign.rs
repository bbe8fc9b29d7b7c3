//! Modules that are rust-hdl blocks: a widget, or anything with `#[derive(LogicBlock)]`.
//!
//! rust-hdl says which ports there are and writes the text, which stands in ours as it is. What it does not say is taken
//! at its worst: every input reaches every output within the cycle, but for the registers that the block itself names as
//! such ([`rust_hdl_core::logic::Logic::timing`], of a `DFF` for one); and its area is not counted.

use std::fmt::Write as _;
use std::rc::Rc;

use rust_hdl_core::check_error::{CheckError, PathedName};
use rust_hdl_core::prelude::{AtomKind, Block, ModuleDefines, Verilog, check_all};

use super::atoms::{AtomPort, ports_of};
use super::emit::{Body, PortKind};
use super::error::FaultKind;
use super::instance::Child;
use super::module::{Module, PortDeclaration, Source};

/// What Verilator is to overlook in rust-hdl's text, which nobody can write otherwise.
const LINT_BEFORE: &str = "/* verilator lint_save */\n\
    // Literals of rust-hdl have 32 bits.\n\
    /* verilator lint_off WIDTH */\n\
    // Every output of a block inside has a signal, whether it is read or not.\n\
    /* verilator lint_off UNUSED */\n\
    // The modules of its blocks inside stand in its file.\n\
    /* verilator lint_off DECLFILENAME */\n";
/// Back to the rules of everybody else.
const LINT_AFTER: &str = "/* verilator lint_restore */\n";

/// A rust-hdl block behind a module.
pub(super) struct ForeignBlock {
    block: Box<dyn Block>,
    clock: Option<String>,
    ports: Vec<(String, u32, PortKind)>,
    /// Names in rust-hdl's text of the module's ports, which are without the clock.
    pins: Vec<String>,
}

impl Module {
    /// A rust-hdl block as a module. Its clock is our `clk`; it has no reset but those among its inputs, and its
    /// ports have an underscore where rust-hdl's interfaces have `$`.
    ///
    /// rust-hdl's own check of the block, an `inout` port and a second clock are faults of the module.
    #[must_use]
    #[track_caller]
    pub fn from_block(unit: &str, summary: &str, mut block: impl Block + 'static) -> Self {
        let mut module = Self::new(unit, summary);
        // Only what the block has is there.
        module.names.clear();
        block.connect_all();
        if let Err(error) = check_all(&block) {
            module.fault(FaultKind::Block(text_of(&error)));
        }
        if matches!(block.hdl(), Verilog::Blackbox(_)) {
            module.fault(FaultKind::Block("a black box is no module; a rust-hdl `Wrapper` around it is".into()));
        }
        let atoms = ports_of(&block);
        let (clocks, others): (Vec<_>, Vec<_>) = atoms.iter().partition(|atom| atom.is_clock && is_input(atom));
        if clocks.len() > 1 {
            let names: Vec<&str> = clocks.iter().map(|clock| clock.name.as_str()).collect();
            module.fault(FaultKind::Block(format!("one clock is all there is here, not {}", names.join(" and "))));
        }
        module.add_ports(&others, &registers(&block));
        module.foreign = Some(Rc::new(ForeignBlock {
            clock: clocks.first().map(|clock| clock.name.clone()),
            ports: atoms.iter().map(|atom| (atom.name.clone(), atom.width, port_kind(atom))).collect(),
            pins: others.iter().map(|atom| atom.name.clone()).collect(),
            block: Box::new(block),
        }));
        module
    }

    /// Declares the ports of a block.
    #[track_caller]
    fn add_ports(&mut self, atoms: &[&AtomPort], registers: &[String]) {
        let ours = |atom: &AtomPort| atom.name.replace('$', "_");
        for atom in atoms.iter().filter(|atom| is_input(atom)) {
            self.declare(&ours(atom), atom.width, Source::Input);
        }
        let inputs: Vec<usize> = (super::module::RESET + 1..self.signals.len()).collect();
        let mut next_input = inputs.iter();
        for atom in atoms {
            match atom.kind {
                AtomKind::InputParameter => {
                    self.ports.extend(next_input.next().map(|&signal| PortDeclaration::Input(signal)));
                }
                AtomKind::InOutParameter => {
                    self.fault(FaultKind::Block(format!("`{}` is an inout, which no module here has", atom.name)));
                }
                _ => {
                    let follows = if registers.contains(&atom.name) { vec![] } else { inputs.clone() };
                    let value = self.declare(&ours(atom), atom.width, Source::BlockOutput { follows });
                    self.output(&ours(atom), value);
                }
            }
        }
    }
}

impl ForeignBlock {
    /// The module as others see it; its text under the unit's name tells it from others of the unit.
    pub fn body(&self, unit: &str) -> Body {
        Body { ports: self.ports.clone(), before: self.text(unit), ..Body::default() }
    }

    /// It or something below it has state.
    pub fn is_clocked(&self) -> bool {
        self.clock.is_some()
    }

    /// Verilog text of the module under a name and of all below it, their names begun by its own and a `$`.
    pub fn verilog(&self, name: &str, header: &[String]) -> String {
        let mut out = String::new();
        for line in header {
            let _ = writeln!(out, "// {line}");
        }
        out + LINT_BEFORE + &self.text(name) + LINT_AFTER
    }

    fn text(&self, name: &str) -> String {
        let mut defines = ModuleDefines::default();
        self.block.accept(name, &mut defines);
        let lines: Vec<String> = defines.defines().lines().map(|line| line.trim_end().to_owned()).collect();
        lines.join("\n").trim().to_owned() + "\n"
    }
}

impl Child {
    /// The name of the child's clock in the child's text.
    pub(super) fn clock_pin(&self) -> String {
        let clock = self.module.foreign.as_ref().and_then(|foreign| foreign.clock.clone());
        clock.unwrap_or_else(|| "clk".into())
    }

    /// The name of a port of the child in the child's text.
    pub(super) fn pin(&self, port: usize) -> String {
        match &self.module.foreign {
            Some(foreign) => foreign.pins[port].clone(),
            None => self.module.ports[port].shape(&self.module).0.to_owned(),
        }
    }
}

fn is_input(atom: &AtomPort) -> bool {
    atom.kind == AtomKind::InputParameter
}

fn port_kind(atom: &AtomPort) -> PortKind {
    match atom.kind {
        AtomKind::InputParameter => PortKind::Input,
        AtomKind::OutputParameter => PortKind::OutputReg,
        _ => PortKind::OutputWire,
    }
}

/// The outputs that a block calls registers.
fn registers(block: &dyn Block) -> Vec<String> {
    block.timing().into_iter().flat_map(|timing| timing.outputs).collect()
}

/// What rust-hdl has against a block.
fn text_of(error: &CheckError) -> String {
    let listed = |names: &mut dyn Iterator<Item = &PathedName>| {
        let mut names: Vec<String> = names.map(|name| format!("`{}${}`", name.path, name.name)).collect();
        names.sort();
        names.join(", ")
    };
    match error {
        CheckError::OpenSignal(open) => format!("nothing drives {}", listed(&mut open.values())),
        CheckError::LogicLoops(names) => format!("a combinational loop through {}", listed(&mut names.iter())),
        CheckError::WritesToInputs(names) => format!("inputs are driven inside: {}", listed(&mut names.iter())),
    }
}
