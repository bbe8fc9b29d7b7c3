//! From a module and everything below it to a design: checked, lowered, measured.

use super::area::{Area, Storage};
use super::check::Checker;
use super::dependencies::Reach;
use super::emit::PortKind;
use super::error::ElaborationError;
use super::interface::StreamDeclaration;
use super::lower::{Library, single_file};
use super::memory_module::MemoryModule;
use super::module::Module;
use serde::{Deserialize, Serialize};

/// Which way a port goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Direction {
    /// Into the module.
    Input,
    /// Out of the module.
    Output,
}

/// A port of a module.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Port {
    /// Its name.
    pub name: String,
    /// Its bits.
    pub width: u32,
    /// Which way it goes.
    pub direction: Direction,
}

impl Port {
    fn of((name, width, kind): &(String, u32, PortKind)) -> Self {
        let direction = if *kind == PortKind::Input { Direction::Input } else { Direction::Output };
        Self { name: name.clone(), width: *width, direction }
    }
}

/// What a module's surroundings see of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ModuleInterface {
    /// Its name in the Verilog.
    pub name: String,
    /// Its ports.
    pub ports: Vec<Port>,
    /// Which of them form streams and pulses.
    pub streams: Vec<StreamDeclaration>,
}

/// One module of a design.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModuleSummary {
    /// Its name in the Verilog.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Names and values of its parameters.
    pub parameters: Vec<(String, String)>,
    /// What it holds, without its children.
    pub area: Area,
    /// Its memories and tables.
    pub memories: Vec<Storage>,
    /// How many times the design contains it.
    pub instances: u64,
}

/// A checked design and its Verilog.
#[derive(Clone, Debug)]
pub struct Design {
    top: String,
    verilog: String,
    files: Vec<(String, String)>,
    ports: Vec<Port>,
    streams: Vec<StreamDeclaration>,
    modules: Vec<ModuleSummary>,
    interfaces: Vec<ModuleInterface>,
    memory_modules: Vec<String>,
    combinational_paths: Vec<(String, String)>,
}

impl Design {
    /// Verilog-2005 text of all modules (beside another file, of those it does not have), the top first, parents before children.
    #[must_use]
    pub fn verilog(&self) -> &str {
        &self.verilog
    }

    /// The modules of [`Design::verilog`] one by one, in its order: each one's name, and the text of a file of that name. The whole text is
    /// these with an empty line between, below a directive where they are several.
    #[must_use]
    pub fn files(&self) -> &[(String, String)] {
        &self.files
    }

    /// Name of the top module.
    #[must_use]
    pub fn top(&self) -> &str {
        &self.top
    }

    /// The top's ports in declaration order, `clk` and `rst` first where it has state.
    #[must_use]
    pub fn ports(&self) -> &[Port] {
        &self.ports
    }

    /// Which of the top's ports form streams and pulses, in declaration order.
    #[must_use]
    pub fn streams(&self) -> &[StreamDeclaration] {
        &self.streams
    }

    /// Every module of the design, children before parents, the top last.
    #[must_use]
    pub fn modules(&self) -> &[ModuleSummary] {
        &self.modules
    }

    /// What each of its modules shows to the others, in the same order.
    #[must_use]
    pub fn interfaces(&self) -> &[ModuleInterface] {
        &self.interfaces
    }

    /// Names of the modules that its larger memories are instances of, with their sizes as parameters.
    #[must_use]
    pub fn memory_modules(&self) -> &[String] {
        &self.memory_modules
    }

    /// Pairs of a top input and a top output that it reaches without a register.
    #[must_use]
    pub fn combinational_paths(&self) -> &[(String, String)] {
        &self.combinational_paths
    }
}

/// Checks a module and everything below it and lowers it to Verilog.
///
/// # Errors
/// Every fault of the whole hierarchy, each with the path of the module it is in.
pub fn elaborate(top: &Module) -> Result<Design, ElaborationError> {
    lower(top, None)
}

/// As [`elaborate`], for a top whose file is to lie beside that of `part`, a module inside it: the text has only what the other file
/// does not, and both together are the design.
///
/// # Errors
/// Every fault of the whole hierarchy, each with the path of the module it is in.
pub fn elaborate_beside(top: &Module, part: &Module) -> Result<Design, ElaborationError> {
    lower(top, Some(part))
}

fn lower(top: &Module, part: Option<&Module>) -> Result<Design, ElaborationError> {
    let mut checker = Checker::default();
    let reach = checker.check(top, top.unit.clone());
    if !checker.faults.is_empty() {
        return Err(ElaborationError { faults: checker.faults });
    }
    let mut library = Library::default();
    let beside = part.map_or(0, |part| library.add_top(part) + 1);
    let index = library.add_top(top);
    let names = library.names(beside);
    let counts = library.instance_counts();
    let modules = library.modules.iter().zip(&names).zip(counts).map(|((module, name), instances)| ModuleSummary {
        name: name.clone(),
        unit: module.unit.clone(),
        parameters: module.parameters.clone(),
        area: module.area,
        memories: module.memories.clone(),
        instances,
    });
    let ports = |index| library.ports(index).iter().map(Port::of).collect::<Vec<_>>();
    let interface = |(place, name): (usize, &String)| {
        let streams = library.modules[place].streams.clone();
        ModuleInterface { name: name.clone(), ports: ports(place), streams }
    };
    let files = library.files(&names, beside);
    Ok(Design {
        top: names[index].clone(),
        verilog: single_file(&files),
        files,
        ports: ports(index),
        streams: top.streams.clone(),
        modules: modules.collect(),
        interfaces: names.iter().enumerate().map(interface).collect(),
        memory_modules: library.memory_modules(0..index + 1).into_iter().map(MemoryModule::name).collect(),
        combinational_paths: paths(top, &reach),
    })
}

/// The inputs and outputs of a reach by name.
fn paths(module: &Module, reach: &Reach) -> Vec<(String, String)> {
    let output = |port: usize| module.ports[port].shape(module).0;
    let pairs = reach.iter().flat_map(|(&port, inputs)| inputs.iter().map(move |&input| (input, port)));
    pairs.map(|(input, port)| (module.signals[input].name.to_string(), output(port).to_string())).collect()
}
