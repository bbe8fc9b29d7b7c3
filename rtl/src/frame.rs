//! A module as text: what stands above it, its ports, its body.

use std::fmt::Write as _;

use super::emit::PortKind;
use super::text::{LINE_CHARACTERS, range};

/// A port of a module.
pub(super) struct FramePort {
    pub name: String,
    pub width: u32,
    pub kind: PortKind,
    /// What it is for.
    pub document: Option<String>,
}

impl FramePort {
    /// It is the `ready` of a stream, of which nothing is said, and that is its `valid`.
    fn answers(&self, other: &Self) -> bool {
        let stem = self.name.strip_suffix("ready");
        self.document.is_none() && stem.is_some() && stem == other.name.strip_suffix("valid")
    }

    /// `input  wire [7:0] name,  // What it is for.`, with the port that answers it in front of the comment.
    fn declaration(&self, answer: Option<&Self>, separator: &str) -> String {
        let kind = match self.kind {
            PortKind::Input => "input  wire",
            PortKind::OutputWire => "output wire",
            PortKind::OutputReg => "output reg ",
        };
        let answer =
            answer.map_or(String::new(), |answer| format!(", {}", answer.declaration(None, "").replacen("  ", " ", 1)));
        let comment = self.document.as_ref().map_or(String::new(), |text| format!("  // {text}"));
        format!("{kind} {}{}{answer}{separator}{comment}", range(self.width), self.name)
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
        for line in self.port_lines() {
            let _ = writeln!(out, "    {line}");
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

    /// The declarations of the ports: a line each where something is said of them, which a stream's `ready` shares with its `valid`; of
    /// others, those that begin alike share lines, and those of one direction that begin like no other.
    fn port_lines(&self) -> Vec<String> {
        let group = |port: &FramePort| {
            let first = port.name.split('_').next();
            let is_group = |other: &FramePort| other.name != port.name && other.name.split('_').next() == first;
            match first.filter(|_| self.ports.iter().any(is_group)) {
                Some(first) => first.to_owned(),
                None if port.kind == PortKind::Input => "input".into(),
                None => "output".into(),
            }
        };
        let mut lines: Vec<String> = vec![];
        // The group of a line that more can be put on.
        let mut open = None;
        let mut ports = self.ports.iter().peekable();
        while let Some(port) = ports.next() {
            let answer = ports.next_if(|next| next.answers(port));
            let separator = if ports.peek().is_some() { "," } else { "" };
            let declaration = port.declaration(answer, separator);
            let own = port.document.is_none().then(|| group(port));
            match lines.last_mut() {
                Some(line) if own.is_some() && own == open && line.len() + declaration.len() < LINE_CHARACTERS => {
                    *line += &format!(" {}", declaration.replacen("  ", " ", 1));
                }
                _ => lines.push(declaration),
            }
            open = own;
        }
        lines
    }
}
