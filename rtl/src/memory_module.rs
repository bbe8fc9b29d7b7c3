//! Memories as instances of one module, which has their depth and width as parameters of Verilog's.

use std::fmt::Write as _;

use super::canonical::{Graph, Need};
use super::expression::Expr;
use super::memory::{Content, Style};
use super::module::Source;
use super::text::filled;
use super::writer::Writer;

/// The module of memories with so many read ports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct MemoryModule {
    reads: u32,
    /// A word that is read while it is written is the old one.
    ordered: bool,
}

impl Graph<'_> {
    /// The module of a memory; none where it stands in the module that has it: constants, look-up tables, and what only assertions need.
    pub fn memory_module(&self, store: usize) -> Option<MemoryModule> {
        let described = &self.module.stores[store];
        let written = matches!(described.content, Content::Written(_)) && described.style != Style::Distributed;
        if !written || self.stores[store] != Need::Hardware {
            return None;
        }
        let readers = self.readers(store);
        let for_hardware = readers.iter().all(|&signal| self.signals[signal] == Need::Hardware);
        let module = MemoryModule { reads: readers.len() as u32, ordered: described.style != Style::Unordered };
        for_hardware.then_some(module)
    }

    /// The signals that show what is read from a memory.
    pub fn readers(&self, memory: usize) -> Vec<usize> {
        let reads = |signal: &usize| match self.module.signals[*signal].source {
            Source::Read { store, .. } => store == memory && self.signals[*signal] != Need::Nobody,
            _ => false,
        };
        (0..self.module.signals.len()).filter(reads).collect()
    }
}

impl Writer<'_> {
    /// A memory as an instance of its module.
    pub fn memory_instance(&mut self, store: usize, module: MemoryModule) -> String {
        let described = &self.graph.module.stores[store];
        let mut connections = vec![(String::from("clk"), self.read_all("clk"))];
        if let Content::Written(Some(port)) = &described.content {
            connections.push(("write".into(), self.enable(Some(port.enable))));
            connections.push(("write_address".into(), self.expression(port.address)));
            connections.push(("write_data".into(), self.expression(port.data)));
        }
        for (index, signal) in self.graph.readers(store).into_iter().enumerate() {
            let record = &self.graph.module.signals[signal];
            let Source::Read { enable, address, .. } = &record.source else { continue };
            let port = module.read_port(index as u32);
            connections.push((port.clone(), self.enable(*enable)));
            connections.push((format!("{port}_address"), self.expression(*address)));
            connections.push((format!("{port}_data"), record.name.to_string()));
        }
        let mut parameters = vec![("WIDTH", described.width), ("DEPTH", described.depth)];
        if described.slice < described.width {
            parameters.push(("SLICE", described.slice));
        }
        let parameters: Vec<String> = parameters.iter().map(|(name, value)| format!(".{name}({value})")).collect();
        let head = format!("{} #({}) {}", module.name(), parameters.join(", "), described.name);
        format!("{head} {}\n", filled(&connections))
    }

    fn enable(&mut self, enable: Option<Expr>) -> String {
        enable.and_then(|enable| self.condition(enable)).unwrap_or_else(|| "1'd1".into())
    }
}

impl MemoryModule {
    /// `memory_1w2r`, by its ports.
    pub fn name(self) -> String {
        format!("memory_1w{}r{}", self.reads, if self.ordered { "" } else { "_unordered" })
    }

    /// What a read port is called.
    fn read_port(self, index: u32) -> String {
        if self.reads == 1 { "read".into() } else { format!("read_{index}") }
    }

    fn read_ports(self) -> impl Iterator<Item = String> {
        (0..self.reads).map(move |index| self.read_port(index))
    }

    /// Its text, with the header above it.
    pub fn verilog(self) -> String {
        let mut out =
            String::from("// Memory with registered reads, in slices that are memories of the device each.\n");
        out += match self.ordered {
            true => "// A word that is read while it is written is the old one.\n",
            false => "// A word that is read while it is written is anything: with assertions, the old one inverted.\n",
        };
        let _ = writeln!(out, "module {} #(", self.name());
        out += "    parameter WIDTH = 8,\n    parameter DEPTH = 2,\n    parameter SLICE = WIDTH\n) (\n";
        out += "    input  wire clk,\n    input  wire write,\n    input  wire [$clog2(DEPTH)-1:0] write_address,\n";
        out += "    input  wire [WIDTH-1:0] write_data";
        for port in self.read_ports() {
            let _ = write!(out, ",\n    input  wire {port},\n    input  wire [$clog2(DEPTH)-1:0] {port}_address");
            let _ = write!(out, ",\n    output wire [WIDTH-1:0] {port}_data");
        }
        out += "\n);\n    genvar low;\n    generate\n        for (low = 0; low < WIDTH; low = low + SLICE) begin : slice\n";
        let _ = write!(out, "{}        end\n    endgenerate\nendmodule\n", self.slice());
        out
    }

    /// One slice of it.
    fn slice(self) -> String {
        let mut lines = vec!["localparam BITS = low + SLICE <= WIDTH ? SLICE : WIDTH - low;".to_string()];
        lines.extend((!self.ordered).then(|| "(* no_rw_check *)".to_string()));
        lines.push("reg [BITS-1:0] words [0:DEPTH-1];".into());
        for port in self.read_ports() {
            lines.push(format!("reg [BITS-1:0] {port}_word;"));
            lines.push(format!("assign {port}_data[low +: BITS] = {port}_word;"));
        }
        lines.push("always @(posedge clk) begin".into());
        lines.push("    if (write) words[write_address] <= write_data[low +: BITS];".into());
        for port in self.read_ports() {
            lines.push(format!("    if ({port}) {port}_word <= words[{port}_address];"));
        }
        if !self.ordered {
            lines.push("`ifdef RTL_ASSERT".into());
            for port in self.read_ports() {
                let meet = format!("{port} && write && {port}_address == write_address");
                lines.push(format!("    if ({meet}) {port}_word <= ~words[{port}_address];"));
            }
            lines.push("`endif".into());
        }
        lines.push("end".into());
        let margin = |line: &String| if line.starts_with('`') { "" } else { "            " };
        lines.iter().fold(String::new(), |text, line| text + margin(line) + line + "\n")
    }
}
