//! The bridge to rust-hdl: a lowered module is a rust-hdl block, its ports are atoms, its body is custom Verilog.
//! rust-hdl frames the modules; what comes back is brought into the form of one port per line.

use std::fmt::Write as _;

use rust_hdl_core::prelude::{
    Atom, AtomKind, Block, Logic, ModuleDefines, PinConstraint, Probe, Synth, TypeDescriptor, TypeKind, VCDValue,
    Verilog, VerilogLiteral,
};

use super::emit::PortKind;

/// A port as rust-hdl sees it.
pub(super) struct FramePort {
    pub name: String,
    pub width: u32,
    pub kind: PortKind,
}

impl Atom for FramePort {
    fn bits(&self) -> usize {
        self.width as usize
    }

    fn connected(&self) -> bool {
        true
    }

    fn changed(&self) -> bool {
        false
    }

    fn kind(&self) -> AtomKind {
        match self.kind {
            PortKind::Input => AtomKind::InputParameter,
            PortKind::OutputWire => AtomKind::OutputPassthrough,
            PortKind::OutputReg => AtomKind::OutputParameter,
        }
    }

    fn descriptor(&self) -> TypeDescriptor {
        TypeDescriptor { name: format!("Bits::<{}>", self.width), kind: TypeKind::Bits(self.width as usize) }
    }

    fn vcd(&self) -> VCDValue {
        false.vcd()
    }

    fn id(&self) -> usize {
        0
    }

    fn verilog(&self) -> VerilogLiteral {
        0u64.into()
    }

    fn constraints(&self) -> Vec<PinConstraint> {
        vec![]
    }
}

/// A module with its final name and text; its instances name other modules, so it has no blocks inside.
pub(super) struct Frame {
    pub name: String,
    /// Comment lines that stand above the module.
    pub header: Vec<String>,
    pub ports: Vec<FramePort>,
    pub body: String,
}

impl Logic for Frame {
    fn update(&mut self) {}

    fn hdl(&self) -> Verilog {
        Verilog::Custom(self.body.clone())
    }
}

impl Block for Frame {
    fn connect_all(&mut self) {}

    fn update_all(&mut self) {}

    fn has_changed(&self) -> bool {
        false
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        probe.visit_start_scope(name, self);
        self.ports.iter().for_each(|port| probe.visit_atom(&port.name, port));
        probe.visit_end_scope(name, self);
    }
}

impl Frame {
    /// Verilog text of the module, its header above it.
    pub fn verilog(&self) -> String {
        let mut defines = ModuleDefines::default();
        self.accept(&self.name, &mut defines);
        let mut out = String::new();
        for line in &self.header {
            let _ = writeln!(out, "// {line}");
        }
        plain(&self.name, &defines.defines(), &mut out);
        out
    }
}

/// Rewrites a module of rust-hdl's: ports in the header, no section comments, no spaces at line ends.
fn plain(name: &str, framed: &str, out: &mut String) {
    let is_port = |line: &&str| line.starts_with("input ") || line.starts_with("output ");
    let mut lines = framed.lines().map(str::trim_end);
    let declarations = lines.by_ref().take_while(|line| !line.ends_with("// Update code (custom)"));
    let ports: Vec<String> = declarations.map(|line| line.trim()).filter(is_port).map(port_line).collect();
    let _ = writeln!(out, "module {name} (\n{}\n);", ports.join(",\n"));
    for line in lines.take_while(|line| !line.starts_with("endmodule")) {
        // Directives stand at the left margin.
        let line = if line.trim_start().starts_with('`') { line.trim_start() } else { line };
        let _ = writeln!(out, "{line}");
    }
    out.push_str("endmodule\n");
}

/// `    input  wire [7:0] name`, from `input wire  [7:0] name;`.
fn port_line(declaration: &str) -> String {
    let words: Vec<&str> = declaration.trim_end_matches(';').split_whitespace().collect();
    format!("    {:<6} {:<4} {}", words[0], words[1], words[2..].join(" "))
}
