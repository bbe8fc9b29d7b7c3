//! A module beside another version of itself, as a prover compares them: the rules of lockstep in Verilog.

use super::modules::Instance;
use pointcore_tb::verilated::{Direction, ModuleInterface, Port, RESET, StreamDeclaration};
use rtl::address_width;
use std::fmt::Write;

/// Name of the module that holds both.
pub const MODULE: &str = "side_by_side";
/// Names of the two versions in it.
pub const VERSIONS: [&str; 2] = ["gold", "gate"];

/// What goes in and out of a module, and of modules that were taken out of it: what they put out comes in then.
#[derive(Clone, Debug, Default)]
pub struct Border {
    ports: Vec<Port>,
    streams: Vec<Stream>,
}

/// Ports that mean something while a flag is set.
#[derive(Clone, Debug)]
struct Stream {
    direction: Direction,
    flag: String,
    ready: Option<String>,
    fields: Vec<String>,
}

impl From<&StreamDeclaration> for Stream {
    fn from(stream: &StreamDeclaration) -> Self {
        let fields = stream.field_ports().collect();
        Self { direction: stream.direction, flag: stream.flag_port(), ready: stream.ready_port(), fields }
    }
}

impl From<&ModuleInterface> for Border {
    fn from(interface: &ModuleInterface) -> Self {
        Self { ports: interface.ports.clone(), streams: interface.streams.iter().map(Stream::from).collect() }
    }
}

impl Border {
    /// That of a memory, by its module's name and its parameters: what it neither writes nor reads means nothing.
    pub fn memory(instance: &Instance<'_>) -> Option<Self> {
        let [width, depth] = instance.memory_size()?;
        let reads: u32 = instance.of.strip_prefix("memory_1w")?.split_once('r')?.0.parse().ok()?;
        let address = address_width(depth);
        let port = |name: &str, width, direction| Port { name: name.to_owned(), width, direction };
        let mut border = Self { ports: vec![port("clk", 1, Direction::Input)], streams: vec![] };
        let access = |border: &mut Self, name: &str, data: Direction| {
            let [address_port, data_port] = ["address", "data"].map(|field| format!("{name}_{field}"));
            border.ports.extend([
                port(name, 1, Direction::Input),
                port(&address_port, address, Direction::Input),
                port(&data_port, width, data),
            ]);
            let given = [address_port].into_iter().chain((data == Direction::Input).then_some(data_port));
            let (flag, fields) = (name.to_owned(), given.collect());
            border.streams.push(Stream { direction: Direction::Input, flag, ready: None, fields });
        };
        access(&mut border, "write", Direction::Input);
        for read in 0..reads {
            let name = if reads == 1 { "read".to_owned() } else { format!("read_{read}") };
            access(&mut border, &name, Direction::Output);
        }
        Some(border)
    }

    /// Adds that of an instance that was taken out.
    pub fn take_out(&mut self, instance: &str, inner: &Self) {
        let turned = |direction| match direction {
            Direction::Input => Direction::Output,
            Direction::Output => Direction::Input,
        };
        let outer = |name: &String| format!("{instance}.{name}");
        self.ports.extend(inner.ports.iter().map(|port| Port {
            name: outer(&port.name),
            width: port.width,
            direction: turned(port.direction),
        }));
        self.streams.extend(inner.streams.iter().map(|stream| Stream {
            direction: turned(stream.direction),
            flag: outer(&stream.flag),
            ready: stream.ready.as_ref().map(outer),
            fields: stream.fields.iter().map(outer).collect(),
        }));
    }

    /// A module that gives both versions the same inputs, whose output `differ` says that a neighbor could tell them
    /// apart. As in lockstep, the fields of a stream that offers nothing mean nothing, and what comes in on a stream is
    /// assumed to hold until it is taken; everything else about the inputs is open.
    pub fn side_by_side(&self) -> String {
        let [gold, gate] = VERSIONS;
        let of = |direction| self.ports.iter().filter(move |port| port.direction == direction);
        let range = |width: u32| format!("[{}:0]", width - 1);
        let inputs =
            of(Direction::Input).map(|port| format!("input wire {} {}, ", range(port.width), escaped(&port.name)));
        let mut text = format!("module {MODULE}({}output wire differ);\n", inputs.collect::<String>());
        for Port { name, width, .. } in of(Direction::Output) {
            let [gold, gate] = VERSIONS.map(|version| shown(version, name));
            _ = writeln!(text, "wire {} {gold}, {gate};", range(*width));
        }
        for version in VERSIONS {
            let inputs = of(Direction::Input).map(|Port { name, .. }| format!(".{0}({0})", escaped(name)));
            let outputs =
                of(Direction::Output).map(|Port { name, .. }| format!(".{}({})", escaped(name), shown(version, name)));
            _ = writeln!(text, "{version} {version}({});", inputs.chain(outputs).collect::<Vec<_>>().join(", "));
        }
        let streams = |direction| self.streams.iter().filter(move |stream| stream.direction == direction);
        let difference = |name: &str| {
            let flag = streams(Direction::Output).find(|stream| stream.fields.iter().any(|field| field == name));
            let offered = flag.map_or(String::new(), |stream| format!("{} && ", shown(gold, &stream.flag)));
            format!("({offered}{} != {})", shown(gold, name), shown(gate, name))
        };
        let differences: Vec<_> = of(Direction::Output).map(|port| difference(&port.name)).collect();
        let running = if self.has_reset() { "!rst && " } else { "" };
        _ = writeln!(text, "assign differ = {running}({});", differences.join(" || "));
        if self.ports.iter().any(|port| port.name == "clk") {
            streams(Direction::Input).enumerate().for_each(|(place, stream)| text += &self.held(place, stream));
        }
        text + "endmodule\n"
    }

    /// It has a reset, while which nothing counts: what comes in is anything then.
    fn has_reset(&self) -> bool {
        self.ports.iter().any(|port| port.name == RESET)
    }

    /// What comes in on a stream holds until it is taken.
    fn held(&self, place: usize, stream: &Stream) -> String {
        let Stream { flag, ready: Some(ready), fields, .. } = stream else { return String::new() };
        let [flag, ready] = [escaped(flag), shown(VERSIONS[0], ready)];
        let names = fields.iter().map(|field| escaped(field));
        let item = format!("{{{}}}", [flag.clone()].into_iter().chain(names).collect::<Vec<_>>().join(", "));
        let bits: u32 = self.ports.iter().filter(|port| fields.contains(&port.name)).map(|port| port.width).sum();
        let in_reset = if self.has_reset() { " && !rst" } else { "" };
        format!(
            "reg waits_{place} = 0;\nreg [{bits}:0] item_{place};\nalways @(posedge clk) begin\n    \
             waits_{place} <= {flag} && !{ready}{in_reset};\n    item_{place} <= {item};\nend\n\
             always @* assume (!waits_{place} || {item} == item_{place});\n"
        )
    }
}

/// A name as Verilog has it: of a port that was taken out, with what ends it.
fn escaped(name: &str) -> String {
    if name.contains('.') { format!("\\{name} ") } else { name.to_owned() }
}

/// What a version puts out at a port.
fn shown(version: &str, name: &str) -> String {
    escaped(&format!("{version}_{name}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interface() -> ModuleInterface {
        let port = |name: &str, width, direction| Port { name: name.into(), width, direction };
        ModuleInterface {
            name: "unit".into(),
            ports: vec![
                port("clk", 1, Direction::Input),
                port("rst", 1, Direction::Input),
                port("in_valid", 1, Direction::Input),
                port("in_x", 8, Direction::Input),
                port("in_ready", 1, Direction::Output),
                port("out_valid", 1, Direction::Output),
                port("out_x", 8, Direction::Output),
            ],
            streams: vec![
                StreamDeclaration::stream("in", Direction::Input, ["x"]),
                StreamDeclaration::pulse("out", "valid", Direction::Output, ["x"]),
            ],
        }
    }

    #[test]
    fn fields_count_while_they_are_offered_and_what_waits_is_held() {
        let text = Border::from(&interface()).side_by_side();
        let difference = "assign differ = !rst && ((gold_in_ready != gate_in_ready) || \
            (gold_out_valid != gate_out_valid) || (gold_out_valid && gold_out_x != gate_out_x));";
        assert!(text.contains(difference), "{text}");
        assert!(
            text.contains("gate gate(.clk(clk), .rst(rst), .in_valid(in_valid), .in_x(in_x), .in_ready(gate_in_ready)")
        );
        assert!(text.contains("waits_0 <= in_valid && !gold_in_ready && !rst;"), "{text}");
        assert!(text.contains("assume (!waits_0 || {in_valid, in_x} == item_0);"), "{text}");
    }

    #[test]
    fn what_is_taken_out_is_turned_round() {
        let mut border = Border::from(&interface());
        let memory = Instance { of: "memory_1w1r", name: "words", parameters: ".WIDTH(9), .DEPTH(5)" };
        border.take_out("inner", &Border::from(&interface()));
        border.take_out("words", &Border::memory(&memory).unwrap_or_default());
        let text = border.side_by_side();
        assert!(text.contains("input wire [7:0] \\inner.out_x , "), "{text}");
        assert!(text.contains("(\\gold_inner.in_valid  && \\gold_inner.in_x  != \\gate_inner.in_x )"), "{text}");
        assert!(text.contains("(\\gold_words.read  && \\gold_words.read_address  != \\gate_words.read_address )"));
        assert!(text.contains("wire [2:0] \\gold_words.write_address , \\gate_words.write_address ;"), "{text}");
        assert!(text.contains("input wire [8:0] \\words.read_data , "), "{text}");
    }
}
