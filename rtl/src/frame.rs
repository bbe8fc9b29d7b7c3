//! A module as text: what stands above it, its ports, its body.

use std::fmt::Write as _;

use super::emit::PortKind;
use super::text::range;

/// A port of a module.
pub(super) struct FramePort {
    pub name: String,
    pub width: u32,
    pub kind: PortKind,
    /// What it is for.
    pub document: Option<String>,
}

impl FramePort {
    /// `input  wire [7:0] name,  // What it is for.`
    fn declaration(&self, separator: &str) -> String {
        let kind = match self.kind {
            PortKind::Input => "input  wire",
            PortKind::OutputWire => "output wire",
            PortKind::OutputReg => "output reg ",
        };
        let comment = self.document.as_ref().map_or(String::new(), |text| format!("  // {text}"));
        format!("{kind} {}{}{separator}{comment}", range(self.width), self.name)
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
        let _ = writeln!(out, "module {} (", self.name);
        // A module without ports has an empty line between its parentheses.
        let none = if self.ports.is_empty() { "\n" } else { "" };
        out.push_str(none);
        for (index, port) in self.ports.iter().enumerate() {
            let separator = if index + 1 < self.ports.len() { "," } else { "" };
            let _ = writeln!(out, "    {}", port.declaration(separator));
        }
        out.push_str(");\n");
        for line in self.body.lines() {
            // Directives stand at the left margin.
            let indent = if line.is_empty() || line.starts_with('`') { "" } else { "    " };
            let _ = writeln!(out, "{indent}{line}");
        }
        out.push_str("endmodule\n");
        out
    }
}
