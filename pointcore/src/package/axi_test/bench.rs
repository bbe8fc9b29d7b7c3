//! The bench of a core on AXI: its parts, put together for a configuration.

use super::script::{FinishedScript, MAGIC};
use crate::package::GENERATOR;
use pointcore_contract::Field;
use pointcore_contract::bus::Config;
use rtl::{Design, Port};
use std::fmt::Write as _;

const CHANNELS: &str = include_str!("bench/channels.sv");
const READS: &str = include_str!("bench/reads.sv");
const WRITES: &str = include_str!("bench/writes.sv");
const MAIN: &str = include_str!("bench/main.sv");
const WINDOW: &str = include_str!("bench/window.sv");
const IMAGES: &str = include_str!("bench/images.sv");
const READ_MEMORY: &str = include_str!("bench/read_memory.sv");
const BUFFER: &str = include_str!("bench/buffer.sv");
const PAYLOAD: &str = include_str!("bench/payload.sv");
const SCRIPT: &str = include_str!("bench/script.sv");
const WINDOW_OPERATIONS: &str = include_str!("bench/window_operations.sv");
const WINDOW_POSTED: &str = include_str!("bench/window_posted.sv");
const BUFFER_OPERATIONS: &str = include_str!("bench/buffer_operations.sv");
const PAYLOAD_OPERATIONS: &str = include_str!("bench/payload_operations.sv");

/// The renderer's buffer.
pub struct Buffer {
    /// Tiles it has room for.
    pub tiles: u32,
    /// Beats of a pixel.
    pub pixel_beats: u32,
}

/// The renderer's payloads.
pub struct Payloads {
    /// What their ports are called, one a rasterizer.
    pub ports: Vec<&'static str>,
    /// Words that one of them has room for.
    pub words: u32,
    /// Beats of a word.
    pub word_beats: u32,
}

/// A port by which the core reads.
pub struct BenchMemory {
    /// The port.
    pub name: &'static str,
    /// Which image is behind it.
    image: u32,
    /// Names of the channels whose pauses it has.
    channels: [&'static str; 2],
}

impl BenchMemory {
    /// The points.
    pub const POINTS: Self = Self { name: "m_axi", image: 0, channels: ["READ_ADDRESS", "READ_DATA"] };
    /// The tree.
    pub const TREE: Self = Self { name: "m_axi_tree", image: 1, channels: ["TREE_ADDRESS", "TREE_DATA"] };
    /// The points as the program reads them, in the image of the points.
    pub const LINES: Self = Self { name: "m_axi_line", ..Self::POINTS };
}

/// What a bench hangs on.
pub struct Bench<'a> {
    /// The core on AXI.
    pub top: &'a Design,
    /// Its buses' widths.
    pub bus: Config,
    /// What it plays.
    pub script: &'a FinishedScript,
    /// Bytes of a packet that comes from the core.
    pub packet_bytes: u32,
    /// Bits of its first two words that name what it answers.
    pub name_mask: u64,
    /// The bit of its first word that closes a frame.
    pub end_mask: u32,
    /// The core's events.
    pub events: Vec<Field>,
    /// Ports by which images are read.
    pub memories: Vec<BenchMemory>,
    /// The host writes the tree through a window.
    pub has_window: bool,
    /// The buffer.
    pub buffer: Option<Buffer>,
    /// The payloads, where they are in memory.
    pub payloads: Option<Payloads>,
}

/// What the bench calls what is at a port.
fn net(port: &str) -> String {
    for (begin, name) in [("s_axis_", "send"), ("m_axis_", "receive")] {
        if let Some(rest) = port.strip_prefix(begin) {
            return format!("{name}_{}", rest.rsplit('_').next().unwrap_or_default());
        }
    }
    // A window's address may have fewer bits than a bus.
    match port {
        "s_axi_awaddr" => "window_awaddr".to_owned(),
        "s_axi_araddr" => "window_araddr".to_owned(),
        _ => port.to_owned(),
    }
}

fn range(width: u32) -> String {
    if width == 1 { String::new() } else { format!("[{}:0] ", width - 1) }
}

impl Bench<'_> {
    fn ports(&self) -> impl Iterator<Item = &Port> {
        self.top.ports().iter().filter(|port| !["clk", "rst"].contains(&port.name.as_str()))
    }

    fn nets(&self) -> String {
        let line = |port: &Port| {
            let name = net(&port.name);
            let width = if name.starts_with("window_") { 32 } else { port.width };
            format!("    wire {}{name};\n", range(width))
        };
        self.ports().map(line).collect()
    }

    fn instance(&self) -> String {
        let connection = |port: &Port| {
            let name = net(&port.name);
            let part = if name.starts_with("window_") { format!("[{}:0]", port.width - 1) } else { String::new() };
            format!(",\n        .{}({name}{part})", port.name)
        };
        let connections: String = self.ports().map(connection).collect();
        let top = self.top.top();
        let events: Vec<_> = self.events.iter().rev().map(|event| format!("dut.core.{}", event.name)).collect();
        format!(
            "    {top} dut (\n        .clk(clk), .rst(rst){connections}\n    );\n    assign events = {{{}}};\n\n",
            events.join(", ")
        )
    }

    fn payload_ports(&self) -> &[&'static str] {
        self.payloads.as_ref().map_or(&[], |payloads| &payloads.ports)
    }

    /// Bits of each event: several rasterizers are counted.
    fn event_bits(&self) -> u32 {
        self.events.iter().map(|event| event.width).max().unwrap_or(1)
    }

    /// What the parts know of each other.
    fn joints(&self) -> String {
        let mut moves = vec!["b_moves", "r_moves", "send_take", "receive_moves", "waits_by_script"];
        let mut memories: Vec<String> = self.memories.iter().map(|memory| memory.name.to_owned()).collect();
        let mut text = String::new();
        let mut errors = String::new();
        if self.has_window {
            moves.extend(["window_w_take", "window_r_moves"]);
        } else {
            text += "    wire window_idle = 1'b1;\n";
        }
        if self.buffer.is_some() {
            memories.push("m_axi".to_owned());
            moves.push("stores");
            errors += " + write_errors";
        }
        let mut stores = vec![];
        for port in self.payload_ports() {
            memories.push((*port).to_owned());
            stores.push(format!("{port}_stores"));
            errors += &format!(" + {port}_write_errors");
        }
        moves.extend(stores.iter().map(String::as_str));
        let each = |what: &str, operator: &str| {
            memories.iter().map(|name| format!("{name}_{what}")).collect::<Vec<_>>().join(operator)
        };
        writeln!(text, "    assign something_moves = {} || {};", moves.join(" || "), each("gives", " || "))
            .expect("a string");
        writeln!(text, "    assign memory_idle = {};", each("idle", " && ")).expect("a string");
        writeln!(text, "    assign all_memory_errors = {}{errors};", each("errors", " + ")).expect("a string");
        writeln!(text, "    assign all_misplaced = {};", each("misplaced", " + ")).expect("a string");
        text + "\n"
    }

    fn parameters(&self) -> String {
        let Self { bus, packet_bytes, end_mask, .. } = self;
        let FinishedScript { words, answers, .. } = self.script;
        let name = self.top.top();
        let [first, second] = [self.name_mask as u32, (self.name_mask >> 32) as u32];
        let mut text = format!(
            "    localparam WORDS = {words}, ANSWERS = {answers};\n    localparam [31:0] MAGIC = 32'h{MAGIC:x};\n    \
             localparam FILE = \"{name}_test.hex\";\n    \
             localparam STREAM_BITS = {}, MEMORY_BITS = {}, PACKET_WORDS = {}, EVENTS = {}, EVENT_BITS = {};\n    \
             localparam [31:0] NAME_MASK = 32'h{first:x}, SECOND_NAME_MASK = 32'h{second:x}, END_MASK = 32'h{end_mask:x};\n",
            bus.stream_bits,
            bus.memory_bits,
            packet_bytes / 4,
            self.events.len(),
            self.event_bits(),
        );
        if let Some(Buffer { tiles, pixel_beats }) = &self.buffer {
            text += &format!("    localparam TILES = {tiles}, PIXEL_BEATS = {pixel_beats};\n");
        }
        if let Some(Payloads { words, word_beats, .. }) = &self.payloads {
            text += &format!(
                "    localparam PAYLOAD_WORDS = {words}, WORD_BEATS = {word_beats}, WORD_BYTES = {};\n",
                word_beats * bus.memory_bits / 8
            );
        }
        text
    }

    /// The whole text.
    pub fn text(&self) -> String {
        let name = self.top.top();
        let mut text = format!(
            "// Written by {GENERATOR}; do not edit.\n\
             // Plays a script at the ports of {name}, with models of the buses around it that pause, and compares every answer with what\n\
             // the contract and the bit-exact model say. For Verilator, whose registers start at random values.\n\n\
             // verilator lint_off WIDTH\n// verilator lint_off UNUSED\n// verilator lint_off BLKSEQ\n\n"
        );
        text += CHANNELS;
        text += READS;
        if self.buffer.is_some() {
            text += WRITES;
        }
        text += &format!("module {name}_test;\n{}", self.parameters());
        text += &self.nets();
        text += "    wire something_moves, memory_idle;\n    wire [31:0] all_memory_errors, all_misplaced;\n    \
                 wire [EVENTS*EVENT_BITS-1:0] events;\n\n";
        text += MAIN;
        let mut operations = String::new();
        if self.has_window {
            text += WINDOW;
            operations += WINDOW_OPERATIONS;
        }
        if !self.memories.is_empty() {
            text += IMAGES;
        }
        for BenchMemory { name, image, channels } in &self.memories {
            let part = READ_MEMORY.replace("NAME", name).replace("NUMBER", &image.to_string());
            text += &part
                .replace("share[ADDRESS]", &format!("share[{}]", channels[0]))
                .replace("share[DATA]", &format!("share[{}]", channels[1]));
        }
        if self.buffer.is_some() {
            text += BUFFER;
            operations += BUFFER_OPERATIONS;
        }
        if self.payloads.is_some() {
            text += "\n    reg [31:0] payload_base = 32'd0;\n    reg places_payloads = 1'b0;\n";
            operations += PAYLOAD_OPERATIONS;
        }
        for (number, port) in self.payload_ports().iter().enumerate() {
            text += &PAYLOAD.replace("NAME", port).replace("NUMBER", &number.to_string());
        }
        text += &self.joints();
        text += &self.instance();
        let posted = if self.has_window { WINDOW_POSTED } else { "" };
        text + &SCRIPT.replace("OPERATIONS\n", &operations).replace("POSTED\n", posted)
    }
}
