//! From a module and everything below it to a design: checked, lowered, measured.

use super::area::Area;
use super::error::ElaborationError;
use super::module::Module;

/// Which way a port goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Into the module.
    Input,
    /// Out of the module.
    Output,
}

/// A port of the top module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Its name.
    pub name: String,
    /// Its bits.
    pub width: usize,
    /// Which way it goes.
    pub direction: Direction,
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
    /// How many times the design contains it.
    pub instances: usize,
}

/// A checked design and its Verilog.
#[derive(Clone, Debug)]
pub struct Design {
    top: String,
    verilog: String,
    ports: Vec<Port>,
    modules: Vec<ModuleSummary>,
    combinational_paths: Vec<(String, String)>,
}

impl Design {
    /// Verilog-2005 text of all modules, children before parents, the top last.
    #[must_use]
    pub fn verilog(&self) -> &str {
        &self.verilog
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

    /// Every module of the design, in the order of the Verilog.
    #[must_use]
    pub fn modules(&self) -> &[ModuleSummary] {
        &self.modules
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
    let _ = top;
    todo!("lowering")
}
