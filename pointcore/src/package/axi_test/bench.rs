//! The bench of a core on AXI: its parts, put together for a configuration.

use super::script::{FinishedScript, MAGIC};
use crate::package::GENERATOR;
use pointcore_contract::Field;
use pointcore_contract::bus::{Config, Layout};
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
const PIXELS: &str = include_str!("bench/pixels.sv");
const RECORD_MEMORY: &str = include_str!("bench/record_memory.sv");
const RECORD_WRITES: &str = include_str!("bench/record_writes.sv");
const RECORDS_ARE_READ: &str = include_str!("bench/records_are_read.sv");
const SCRIPT: &str = include_str!("bench/script.sv");
const WINDOW_OPERATIONS: &str = include_str!("bench/window_operations.sv");
const WINDOW_POSTED: &str = include_str!("bench/window_posted.sv");
const BUFFER_OPERATIONS: &str = include_str!("bench/buffer_operations.sv");
const RECORD_OPERATIONS: &str = include_str!("bench/record_operations.sv");

/// The renderer's buffer.
pub struct Buffer {
    /// Tiles it has room for.
    pub tiles: u32,
    /// Beats of a pixel.
    pub pixel_beats: u32,
    /// What a pixel holds.
    pub pixel: Vec<Field>,
    /// Ports by which the core asks for pixels, takes them and writes them.
    pub ports: Vec<[&'static str; 3]>,
}

impl Buffer {
    fn parameters(&self, memory_bits: u32) -> String {
        let Self { tiles, pixel_beats, pixel, .. } = self;
        let width = pixel_beats * memory_bits;
        let held = Layout::of(pixel).mask(width / 8, |_| u64::MAX);
        format!("    localparam TILES = {tiles}, PIXEL_BEATS = {pixel_beats};\n{}", mask("PIXEL_HELD", &held))
    }

    /// Looks at what passes the core's ports.
    fn text(&self) -> String {
        let bits: u32 = self.pixel.iter().map(|field| field.width).sum();
        let all = |port: &str| {
            let fields: Vec<_> = self.pixel.iter().map(|field| format!("dut.core.{port}_{}", field.name)).collect();
            format!("{{{}}}", fields.join(", "))
        };
        let mut text = format!("\n    localparam PIXEL_WIDTH = {bits};\n    reg [PIXEL_WIDTH-1:0] kept [int];\n");
        for [read, data, write] in &self.ports {
            text += &PIXELS
                .replace("WRITTEN", &all(write))
                .replace("TAKEN", &all(data))
                .replace("READ", read)
                .replace("DATA", data)
                .replace("WRITE", write);
        }
        text
    }
}

/// What a memory of records holds when it is placed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Placed {
    /// Nothing: what was not written must not be read.
    Nothing,
    /// In each record a depth of [`depth_at`].
    Depths,
}

/// The nearest of those depths; they end at 1.
const NEAREST_HELD: f32 = 0.75;
/// Multiples of it are spread evenly: the golden section.
const SPREAD: u32 = 0x9e37_79b9;
/// What is left of them are the bits between both ends.
const SPREAD_SHIFT: u32 = 10;

/// The depth in a record: all of them come, in no order.
pub const fn depth_at(place: u32) -> u32 {
    NEAREST_HELD.to_bits() + (place.wrapping_mul(SPREAD) >> SPREAD_SHIFT)
}

/// Records that the renderer has behind ports of their own.
pub struct RecordMemory {
    /// What the records are called.
    pub kind: &'static str,
    /// What their ports are called.
    pub ports: Vec<&'static str>,
    /// Whether each port has records of its own, one's behind the other's.
    pub is_apart: bool,
    /// Whether the renderer writes them, too.
    pub is_written: bool,
    /// Records that a port has.
    pub records: u32,
    /// Beats of a record.
    pub record_beats: u32,
    /// Bits of a beat.
    pub beat_bits: u32,
    /// What is there at first.
    pub placed: Placed,
    /// The operation of the script that places it.
    pub operation: u8,
}

impl RecordMemory {
    fn parameters(&self) -> String {
        let Self { kind, records, record_beats, beat_bits, .. } = self;
        let bytes = record_beats * beat_bits / 8;
        format!(
            "    localparam {kind}_RECORDS = {records}, {kind}_BEATS = {record_beats}, {kind}_BITS = {beat_bits}, {kind}_BYTES = {bytes};\n    \
             localparam {kind}_IS_EMPTY = 1'b{};\n",
            u8::from(self.placed == Placed::Nothing)
        )
    }

    fn text(&self) -> String {
        let unwritten = match self.placed {
            Placed::Nothing => "0".to_owned(),
            Placed::Depths => {
                format!("32'h{:x} + ((NAME_read_held * 32'h{SPREAD:x}) >> {SPREAD_SHIFT})", NEAREST_HELD.to_bits())
            }
        };
        let mut text = format!("\n    reg [31:0] {0}_base = 32'd0;\n    reg places_{0} = 1'b0;\n", self.kind);
        for (number, port) in self.ports.iter().enumerate() {
            let offset = if self.is_apart { number } else { 0 };
            text += &RECORD_MEMORY
                .replace("STORED_BY\n", if self.is_written { RECORD_WRITES } else { RECORDS_ARE_READ })
                .replace("UNWRITTEN", &unwritten)
                .replace("NAME", port)
                .replace("OFFSET", &offset.to_string())
                .replace("SEED_NUMBER", &number.to_string())
                .replace("KIND", self.kind);
        }
        text
    }

    fn operations(&self) -> String {
        RECORD_OPERATIONS.replace("OPERATION", &self.operation.to_string()).replace("KIND", self.kind)
    }
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
    /// Which bits of a packet that comes from the core name what it answers.
    pub name_mask: Vec<u8>,
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
    /// What else the renderer has in memory.
    pub records: Vec<RecordMemory>,
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

/// A parameter as wide as its bytes.
fn mask(name: &str, bytes: &[u8]) -> String {
    let digits: String = bytes.iter().rev().map(|byte| format!("{byte:02x}")).collect();
    let bits = 8 * bytes.len();
    format!("    localparam [{}:0] {name} = {bits}'h{digits};\n", bits - 1)
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

    fn record_ports(&self) -> impl Iterator<Item = &'static str> + '_ {
        self.records.iter().flat_map(|memory| memory.ports.iter().copied())
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
        for port in self.record_ports() {
            memories.push(port.to_owned());
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
        let Self { bus, name_mask, end_mask, .. } = self;
        let FinishedScript { words, answers, .. } = self.script;
        let name = self.top.top();
        let mut text = format!(
            "    localparam WORDS = {words}, ANSWERS = {answers};\n    localparam [31:0] MAGIC = 32'h{MAGIC:x};\n    \
             localparam FILE = \"{name}_test.hex\";\n    \
             localparam STREAM_BITS = {}, MEMORY_BITS = {}, PACKET_WORDS = {}, EVENTS = {}, EVENT_BITS = {};\n\
             {}    localparam [31:0] END_MASK = 32'h{end_mask:x};\n",
            bus.stream_bits,
            bus.memory_bits,
            name_mask.len() / 4,
            self.events.len(),
            self.event_bits(),
            mask("NAME_MASK", name_mask),
        );
        if let Some(buffer) = &self.buffer {
            text += &buffer.parameters(bus.memory_bits);
        }
        text.extend(self.records.iter().map(RecordMemory::parameters));
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
        for memory in &self.records {
            text += &memory.text();
            operations += &memory.operations();
        }
        text += &self.joints();
        text += &self.instance();
        text.extend(self.buffer.iter().map(Buffer::text));
        let posted = if self.has_window { WINDOW_POSTED } else { "" };
        text + &SCRIPT.replace("OPERATIONS\n", &operations).replace("POSTED\n", posted)
    }
}
