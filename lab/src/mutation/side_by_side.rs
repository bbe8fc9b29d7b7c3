//! A module beside another version of itself, as a prover compares them: the rules of lockstep in Verilog.

use super::modules::Instance;
use pointcore_contract::{Format, Subnormals};
use pointcore_tb::verilated::{Direction, ModuleInterface, Port, RESET, StreamDeclaration};
use rtl::address_width;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Name of the module that holds both.
pub const MODULE: &str = "side_by_side";
/// Names of the two versions in it.
pub const VERSIONS: [&str; 2] = ["gold", "gate"];

/// What the names of operators begin with, and how two of their ports are called.
const OPERATORS: [&str; 2] = ["float_", "integer_"];
const ENABLE: &str = "enable";
const RESULT: &str = "y";

/// What the names of an AMBA channel's ports begin with, behind the bus's; the rest follows at once, as in `m_axi_awvalid`.
const CHANNELS: [&str; 6] = ["_aw", "_w", "_b", "_ar", "_r", "_t"];

/// What goes in and out of a module, and of modules that were taken out of it: what they put out comes in then.
#[derive(Clone, Debug, Default)]
pub struct Border {
    ports: Vec<Port>,
    streams: Vec<Stream>,
    /// What it is itself, if it is an operator.
    operator: Option<Operator>,
    /// Those that were taken out of it.
    operators: Vec<Operator>,
    /// The outputs that are compared, where the others are known to be the same; else all are.
    compared: Option<BTreeSet<String>>,
}

/// An operator that was taken out: what it answers depends on the operands some enabled cycles before, and on nothing else.
#[derive(Clone, Debug)]
pub struct Operator {
    /// Its ports.
    pub enable: String,
    pub operands: Vec<String>,
    pub result: String,
    stages: usize,
    /// What it answers in, if that is floating point.
    format: Option<Format>,
}

impl Operator {
    /// That of an interface, by its name and ports: `float_add_s4_f24` has four stages.
    pub fn of(interface: &ModuleInterface) -> Option<Self> {
        let ModuleInterface { name, ports, .. } = interface;
        let stages =
            name.split('_').find_map(|word| word.strip_prefix('s')?.parse().ok()).filter(|&stages| stages > 0)?;
        let is_operand = |port: &&Port| port.direction == Direction::Input && !["clk", ENABLE].contains(&&*port.name);
        let operands = ports.iter().filter(is_operand).map(|port| port.name.clone()).collect();
        let has = |name: &str| ports.iter().any(|port| port.name == name);
        let is_operator = OPERATORS.iter().any(|prefix| name.starts_with(prefix)) && has(ENABLE);
        let result = ports.iter().find(|port| port.name == RESULT)?;
        let mut formats = name.split('_').filter_map(|word| word.replace("ftz", "-ftz").parse().ok());
        let format = formats.rfind(|format: &Format| format.width() == result.width);
        is_operator.then(|| Self { enable: ENABLE.into(), operands, result: RESULT.into(), stages, format })
    }

    /// What else it may answer where it was given something else.
    fn other(&self) -> String {
        format!("{}.other", self.result)
    }

    /// Where it was given something else, by stages.
    fn strayed(&self) -> String {
        format!("{}.strayed", self.result)
    }

    /// Says whether it was given what it answers: what an operator holds first, nobody looks at.
    fn given(&self) -> String {
        let Self { enable, stages, .. } = self;
        format!(
            "reg [{stages}:0] given = 0;\nalways @(posedge clk) if ({enable}) given <= {{1'd1, given[{stages}:1]}};\n"
        )
    }

    /// What is answered, and what else may be, as numbers of its format are written: there is one NaN, and what is flushed is zero.
    fn written(&self) -> [String; 2] {
        [&self.result, &self.other()].map(|name| {
            let raw = escaped(name);
            let Some(format) = self.format else { return raw };
            let (sign, top) = (format.width() - 1, format.mantissa);
            let [exponent, mantissa] = [format!("{raw}[{}:{top}]", sign - 1), format!("{raw}[{}:0]", top - 1)];
            let flushed = match format.subnormals {
                Subnormals::Keep => raw.clone(),
                Subnormals::Flush => format!("|{exponent} ? {raw} : {{{raw}[{sign}], {sign}'d0}}"),
            };
            format!("(&{exponent} && |{mantissa} ? {}'d{} : {flushed})", format.width(), format.quiet_nan())
        })
    }

    /// What each version is answered.
    fn answers(&self) -> [String; 2] {
        let [result, other] = self.written();
        let strayed = escaped(&self.strayed());
        let second = format!("({strayed}[{}] ? {other} : {result})", self.stages - 1);
        [result, second]
    }
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

impl Stream {
    /// The channels of AMBA buses among ports: streams that no interface declares as such.
    fn channels(ports: &[Port]) -> impl Iterator<Item = Self> {
        ports.iter().filter_map(|flag| {
            let channel = flag.name.strip_suffix("valid")?;
            let ready = format!("{channel}ready");
            let is_channel = CHANNELS.iter().any(|ending| channel.ends_with(ending));
            let is_field = |port: &&Port| port.direction == flag.direction && port.name != flag.name;
            let of_channel = ports.iter().filter(is_field).filter(|port| port.name.starts_with(channel));
            let fields = of_channel.map(|port| port.name.clone()).collect();
            (is_channel && ports.iter().any(|port| port.name == ready)).then(|| Self {
                direction: flag.direction,
                flag: flag.name.clone(),
                ready: Some(ready.clone()),
                fields,
            })
        })
    }
}

impl From<&ModuleInterface> for Border {
    fn from(interface: &ModuleInterface) -> Self {
        let streams = interface.streams.iter().map(Stream::from).chain(Stream::channels(&interface.ports)).collect();
        Self { ports: interface.ports.clone(), streams, operator: Operator::of(interface), ..Self::default() }
    }
}

impl Border {
    /// That of a memory, by its module's name and its parameters: what it neither writes nor reads means nothing.
    pub fn memory(instance: &Instance<'_>) -> Option<Self> {
        let [width, depth] = instance.memory_size()?;
        let reads: u32 = instance.of.strip_prefix("memory_1w")?.split_once('r')?.0.parse().ok()?;
        let address = address_width(depth);
        let port = |name: &str, width, direction| Port { name: name.to_owned(), width, direction };
        let mut border = Self { ports: vec![port("clk", 1, Direction::Input)], ..Self::default() };
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
        self.operators.extend(inner.operator.iter().map(|operator| Operator {
            enable: outer(&operator.enable),
            operands: operator.operands.iter().map(outer).collect(),
            result: outer(&operator.result),
            stages: operator.stages,
            format: operator.format,
        }));
    }

    /// With all ports that yosys lists of a module, of registers, too: `input [3:0] sum.y` is one.
    pub fn with_ports(self, listed: &str) -> Self {
        let port = |line: &str| {
            let (direction, rest) = line.split_once(" [")?;
            let (range, name) = rest.split_once(":0] ")?;
            let direction = if direction == "input" { Direction::Input } else { Direction::Output };
            Some(Port { name: name.to_owned(), width: range.parse::<u32>().ok()? + 1, direction })
        };
        Self { ports: listed.lines().filter_map(port).collect(), operator: None, ..self }
    }

    /// The same where only these outputs are compared, as yosys lists them: `gate/sum.y` is one. All have to be there.
    pub fn with_compared(self, listed: &str) -> Option<Self> {
        let name = |line| listed_name(line).map(str::to_owned);
        let compared: BTreeSet<String> = listed.lines().map(name).collect::<Option<_>>()?;
        let is_there = |name: &String| self.ports.iter().any(|port| port.name == *name);
        compared.iter().all(is_there).then_some(Self { compared: Some(compared), ..self })
    }

    /// Whether operators were taken out.
    pub const fn has_operators(&self) -> bool {
        !self.operators.is_empty()
    }

    /// The same where operators are nothing special: what they are given may not differ.
    pub fn without_operators(&self) -> Self {
        Self { operators: vec![], ..self.clone() }
    }

    /// The same after its reset, which does not come again.
    pub fn after_reset(&self) -> Self {
        let mut border = self.clone();
        border.ports.retain(|port| port.name != RESET);
        border
    }

    /// What those operators answer that are given something these outputs say, as yosys lists them: `gate/sum.a` is one.
    pub fn answers(&self, listed: &str) -> Vec<String> {
        let is_listed = |name: &str| listed.lines().filter_map(listed_name).any(|listed| listed == name);
        let is_given = |operator: &&Operator| {
            is_listed(&operator.enable) || operator.operands.iter().any(|operand| is_listed(operand))
        };
        self.operators.iter().filter(is_given).map(|operator| operator.result.clone()).collect()
    }

    /// The same where only operators with one of these answers may be given something else.
    pub fn with_operators(self, answers: &[String]) -> Self {
        let operators = self.operators.into_iter().filter(|operator| answers.contains(&operator.result)).collect();
        Self { operators, ..self }
    }

    /// The operator whose port this is.
    fn operator(&self, port: &str) -> Option<&Operator> {
        let has = |operator: &&Operator| {
            let mut ports = operator.operands.iter().chain([&operator.enable, &operator.result]);
            ports.any(|name| name == port)
        };
        self.operators.iter().find(has)
    }

    /// A module that gives both versions the same inputs, whose output `differ` says that a neighbor could tell them
    /// apart. As in lockstep, the fields of a stream that offers nothing mean nothing, and what comes in on a stream is
    /// assumed to hold until it is taken; everything else about the inputs is open. What an operator is given may differ: what it
    /// answers may then do so, too.
    pub fn side_by_side(&self) -> String {
        let [gold, gate] = VERSIONS;
        let of = |direction| self.ports.iter().filter(move |port| port.direction == direction);
        let range = |width: u32| format!("[{}:0]", width - 1);
        let inputs =
            of(Direction::Input).map(|port| format!("input wire {} {}, ", range(port.width), escaped(&port.name)));
        let others = of(Direction::Input).filter_map(|port| {
            let operator = self.operator(&port.name)?;
            Some(format!("input wire {} {}, ", range(port.width), escaped(&operator.other())))
        });
        let inputs: String = inputs.chain(others).collect();
        let mut text = format!("module {MODULE}({inputs}output wire differ);\n");
        for Port { name, width, .. } in of(Direction::Output) {
            let [gold, gate] = VERSIONS.map(|version| shown(version, name));
            _ = writeln!(text, "wire {} {gold}, {gate};", range(*width));
        }
        self.operators.iter().for_each(|operator| text += &strays(operator));
        for version in VERSIONS {
            let given = |name: &str| match self.operator(name) {
                Some(operator) => operator.answers()[usize::from(version == gate)].clone(),
                None => escaped(name),
            };
            let inputs = of(Direction::Input).map(|Port { name, .. }| format!(".{}({})", escaped(name), given(name)));
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
        let is_compared = |name: &String| self.compared.as_ref().is_none_or(|compared| compared.contains(name));
        let seen = of(Direction::Output).filter(|port| self.operator(&port.name).is_none() && is_compared(&port.name));
        let mut differences: Vec<_> = seen.map(|port| difference(&port.name)).collect();
        if differences.is_empty() {
            differences.push("1'd0".to_owned());
        }
        let mut running = if self.has_reset() { "!rst && " } else { "" };
        if let Some(operator) = &self.operator {
            text += &operator.given();
            running = "given[0] && ";
        }
        // One operator for all: there may be thousands.
        _ = writeln!(text, "assign differ = {running}(|{{{}}});", differences.join(", "));
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

/// The name in a line that yosys lists of the second version.
fn listed_name(line: &str) -> Option<&str> {
    line.strip_prefix(VERSIONS[1])?.strip_prefix('/')
}

/// Says in which stages an operator of the second version has something else: it was given that, or it did not go on with the other.
fn strays(operator: &Operator) -> String {
    let Operator { enable, operands, stages, .. } = operator;
    let strayed = escaped(&operator.strayed());
    let [gold, gate] = VERSIONS.map(|version| shown(version, enable));
    let differ = |name: &String| format!("{} != {}", shown(VERSIONS[0], name), shown(VERSIONS[1], name));
    let given = operands.iter().map(differ).collect::<Vec<_>>().join(" || ");
    format!(
        "reg [{stages}:0] {strayed} = 0;\nalways @(posedge clk)\n    if ({gold} != {gate}) {strayed} <= ~0;\n    \
         else if ({gold}) {strayed} <= {{{strayed}[{}:0], {given}}};\n",
        stages - 1
    )
}

/// A name as Verilog has it: of a port that was taken out or a register that was shown, with what ends it.
fn escaped(name: &str) -> String {
    let is_plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if is_plain { name.to_owned() } else { format!("\\{name} ") }
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
        let difference = "assign differ = !rst && (|{(gold_in_ready != gate_in_ready), \
            (gold_out_valid != gate_out_valid), (gold_out_valid && gold_out_x != gate_out_x)});";
        assert!(text.contains(difference), "{text}");
        assert!(
            text.contains("gate gate(.clk(clk), .rst(rst), .in_valid(in_valid), .in_x(in_x), .in_ready(gate_in_ready)")
        );
        assert!(text.contains("waits_0 <= in_valid && !gold_in_ready && !rst;"), "{text}");
        assert!(text.contains("assume (!waits_0 || {in_valid, in_x} == item_0);"), "{text}");
    }

    #[test]
    fn channels_of_buses_are_streams() {
        let port = |name: &str, direction| Port { name: name.into(), width: 8, direction };
        let (out, back) = (Direction::Output, Direction::Input);
        let address = [("m_axi_awvalid", out), ("m_axi_awready", back), ("m_axi_awaddr", out)];
        let data = [("m_axi_wvalid", out), ("m_axi_wready", back), ("m_axi_wdata_0", out), ("m_axi_wdata_1", out)];
        let others = [("is_valid", out), ("is_ready", back), ("is_wide", out)];
        let ports = address.into_iter().chain(data).chain(others).map(|(name, direction)| port(name, direction));
        let bus = ModuleInterface { name: "bus_writer".into(), ports: ports.collect(), streams: vec![] };
        let text = Border::from(&bus).side_by_side();
        for counts in ["awvalid && gold_m_axi_awaddr", "wvalid && gold_m_axi_wdata_0", "wvalid && gold_m_axi_wdata_1"] {
            assert!(text.contains(&format!("(gold_m_axi_{counts} != ")), "{counts}: {text}");
        }
        assert!(text.contains("(gold_is_wide != gate_is_wide)"), "{text}");
    }

    #[test]
    fn an_operator_that_was_given_something_else_may_answer_so() {
        let port = |name: &str, width, direction| Port { name: name.into(), width, direction };
        let operands =
            ["enable", "a", "b"].map(|name| port(name, if name == "enable" { 1 } else { 24 }, Direction::Input));
        let ports = [port("clk", 1, Direction::Input), port("y", 24, Direction::Output)].into_iter().chain(operands);
        let adder = ModuleInterface { name: "float_add_s4_f24".into(), ports: ports.collect(), streams: vec![] };
        let mut border = Border::from(&interface());
        border.take_out("sum", &Border::from(&adder));
        let text = border.side_by_side();
        let strayed = "if (\\gold_sum.enable  != \\gate_sum.enable ) \\sum.y.strayed  <= ~0;\n    \
            else if (\\gold_sum.enable ) \\sum.y.strayed  <= {\\sum.y.strayed [3:0], \
            \\gold_sum.a  != \\gate_sum.a  || \\gold_sum.b  != \\gate_sum.b };";
        assert!(text.contains(strayed), "{text}");
        let written = |name: &str| format!("(&{name}[22:15] && |{name}[14:0] ? 24'd8372224 : {name})");
        let [result, other] = ["\\sum.y ", "\\sum.y.other "].map(written);
        assert!(text.contains(&format!(".\\sum.y ({result}), .in_ready(gold_in_ready)")), "{text}");
        assert!(text.contains(&format!(".\\sum.y ((\\sum.y.strayed [3] ? {other} : {result})), ")), "{text}");
        assert!(text.contains("input wire [23:0] \\sum.y.other , "), "{text}");
        assert!(!text.contains("\\gold_sum.a  != \\gate_sum.a ),"), "{text}");
    }

    #[test]
    fn what_an_operator_answers_counts_once_it_was_given_something() {
        let port = |name: &str, width, direction| Port { name: name.into(), width, direction };
        let [clk, enable] = ["clk", "enable"].map(|name| port(name, 1, Direction::Input));
        let ports = vec![clk, enable, port("a", 8, Direction::Input), port("y", 8, Direction::Output)];
        let root = ModuleInterface { name: "float_sqrt_s3_f8".into(), ports, streams: vec![] };
        let text = Border::from(&root).side_by_side();
        assert!(text.contains("if (enable) given <= {1'd1, given[3:1]};"), "{text}");
        assert!(text.contains("assign differ = given[0] && (|{(gold_y != gate_y)});"), "{text}");
        assert!(!Border::from(&root).with_ports("input [7:0] a").side_by_side().contains("given"));
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
