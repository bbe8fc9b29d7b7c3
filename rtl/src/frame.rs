//! A module as text: what stands above it, its ports, its body.

use std::fmt::Write as _;

use super::emit::PortKind;
use super::text::range;

/// A port of a module.
pub(super) struct FramePort {
    pub name: String,
    pub width: u32,
    pub kind: PortKind,
}

impl FramePort {
    /// `input  wire [7:0] name`.
    fn declaration(&self) -> String {
        let kind = match self.kind {
            PortKind::Input => "input  wire",
            PortKind::OutputWire => "output wire",
            PortKind::OutputReg => "output reg ",
        };
        format!("{kind} {}{}", range(self.width), self.name)
    }
}

/// A module with its final name and text; its instances name other modules.
pub(super) struct Frame {
    pub name: String,
    /// Comment lines that stand above the module.
    pub header: Vec<String>,
    pub ports: Vec<FramePort>,
    pub body: String,
}

impl Frame {
    /// Verilog text of the module, its header above it.
    pub fn verilog(&self) -> String {
        let mut out = String::new();
        for line in &self.header {
            let _ = writeln!(out, "// {line}");
        }
        let ports: Vec<String> = self.ports.iter().map(|port| format!("    {}", port.declaration())).collect();
        let _ = writeln!(out, "module {} (\n{}\n);", self.name, ports.join(",\n"));
        for line in self.body.lines() {
            // Directives stand at the left margin.
            let indent = if line.is_empty() || line.starts_with('`') { "" } else { "    " };
            let _ = writeln!(out, "{indent}{line}");
        }
        out.push_str("endmodule\n");
        out
    }
}
