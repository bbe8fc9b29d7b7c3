//! A design as a rust-hdl block: what its `hdl` returns, whether its signals are the design's ports, and its Rust text.
//!
//! The block is a `Wrapper`: rust-hdl instantiates and lowers it with everything around it, and its own simulator, which
//! knows no Verilog, takes it as it is, with outputs that do not move.

use std::collections::BTreeSet;
use std::fmt::{self, Write as _};

use rust_hdl_core::prelude::{AtomKind, Block, Verilog, Wrapper};
use thiserror::Error;

use super::atoms::{AtomPort, ports_of};
use super::elaborate::{Design, Direction, Port};

/// The implicit clock, which rust-hdl has a type for.
const CLOCK: &str = "clk";

/// The ports of a rust-hdl block in declaration order; an interface's fields have a `$` before their own name, and what goes both ways
/// counts as an output.
#[must_use]
pub fn block_ports(block: &dyn Block) -> Vec<Port> {
    let port = |atom: AtomPort| {
        let direction = if atom.kind == AtomKind::InputParameter { Direction::Input } else { Direction::Output };
        Port { name: atom.name, width: atom.width, direction }
    };
    ports_of(block).into_iter().map(port).collect()
}

/// The signals of a rust-hdl block are not the ports of a design.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub struct BlockError {
    /// The design's top.
    pub top: String,
    /// What differs, a line for each port.
    pub differences: Vec<String>,
}

impl fmt::Display for BlockError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the rust-hdl block does not have the ports of `{}`", self.top)?;
        self.differences.iter().try_for_each(|difference| write!(f, "\n  {difference}"))
    }
}

impl Design {
    /// What `hdl` of a rust-hdl block with these ports returns. rust-hdl writes the modules once for each block of the
    /// kind, so a rust-hdl design has one of them.
    #[must_use]
    pub fn wrapper(&self) -> Verilog {
        Verilog::Wrapper(Wrapper { code: self.instantiation(), cores: self.verilog().to_owned() })
    }

    /// Compares the signals of a rust-hdl block with the ports of the design: names, widths, directions.
    ///
    /// # Errors
    /// Every port and every signal that is not the same in both.
    pub fn check_block(&self, block: &dyn Block) -> Result<(), BlockError> {
        let signals: BTreeSet<_> = ports_of(block).iter().map(signal_text).collect();
        let ports: BTreeSet<_> = self.ports().iter().map(port_text).collect();
        let missing = ports.difference(&signals).map(|port| format!("the design has {port}"));
        let unknown = signals.difference(&ports).map(|signal| format!("the block has {signal}"));
        let differences: Vec<String> = missing.chain(unknown).collect();
        if differences.is_empty() { Ok(()) } else { Err(BlockError { top: self.top().to_owned(), differences }) }
    }

    /// Rust text of a rust-hdl block of that name with these ports, which includes the design's Verilog from a file beside it.
    #[must_use]
    pub fn rust_hdl_struct(&self, name: &str) -> String {
        let top = self.top();
        let mut out = format!("// `{top}` as a rust-hdl block; generated, with `{top}.v` beside it.\n\n");
        out += "use rust_hdl::prelude::*;\n\n";
        let _ = writeln!(out, "/// The generated core `{top}`.\n#[derive(LogicBlock, Default)]\npub struct {name} {{");
        for port in self.ports() {
            let plural = if port.width == 1 { "" } else { "s" };
            let _ = writeln!(out, "    /// `{}`, {} bit{plural}.", port.name, port.width);
            let _ = writeln!(out, "    pub {}: {},", port.name, signal_type(port));
        }
        let _ = write!(out, "}}\n\nimpl Logic for {name} {{\n    fn update(&mut self) {{}}\n\n");
        out += "    fn connect(&mut self) {\n";
        for port in self.ports().iter().filter(|port| port.direction == Direction::Output) {
            let _ = writeln!(out, "        self.{}.connect();", port.name);
        }
        out += "    }\n\n    fn hdl(&self) -> Verilog {\n";
        let _ = writeln!(out, "        let code = \"{}\";", self.instantiation());
        let _ = writeln!(out, "        let cores = include_str!(\"{top}.v\");");
        out += "        Verilog::Wrapper(Wrapper { code: code.into(), cores: cores.into() })\n    }\n}\n";
        out
    }

    /// The top inside a module that has its ports.
    fn instantiation(&self) -> String {
        let pins: Vec<String> = self.ports().iter().map(|port| format!("    .{0}({0})", port.name)).collect();
        format!("{0} {0}_core (\n{1}\n);", self.top(), pins.join(",\n"))
    }
}

/// The rust-hdl type of a port.
fn signal_type(port: &Port) -> String {
    let direction = if port.direction == Direction::Input { "In" } else { "Out" };
    match (port.name.as_str(), port.width) {
        (CLOCK, _) => format!("Signal<{direction}, Clock>"),
        (_, 1) => format!("Signal<{direction}, Bit>"),
        (_, width) => format!("Signal<{direction}, Bits<{width}>>"),
    }
}

fn port_text(port: &Port) -> String {
    let direction = if port.direction == Direction::Input { "input" } else { "output" };
    described(direction, &port.name, port.width, port.name == CLOCK)
}

fn signal_text(atom: &AtomPort) -> String {
    let direction = match atom.kind {
        AtomKind::InputParameter => "input",
        AtomKind::InOutParameter => "inout",
        _ => "output",
    };
    described(direction, &atom.name, atom.width, atom.is_clock)
}

/// `input`, name and width, in words that are alike where the ports are.
fn described(direction: &str, name: &str, width: u32, is_clock: bool) -> String {
    let clock = if is_clock { ", a clock" } else { "" };
    format!("the {direction} `{name}` of {width} bits{clock}")
}
