//! A design beside another version of itself, as a prover compares them: the rules of lockstep in Verilog.

use std::fmt::Write;

use super::{Direction, VerilogSource};

/// Name of the module that holds both.
pub const MODULE: &str = "side_by_side";
/// Names of the two versions in it.
pub const VERSIONS: [&str; 2] = ["gold", "gate"];

/// A module that gives both versions of `source` the same inputs, whose output `differ` says that a neighbor could tell
/// them apart. As in lockstep, the fields of a stream that offers nothing mean nothing, and what comes in on a stream is
/// assumed to hold until it is taken; everything else about the inputs is open.
#[must_use]
pub fn side_by_side(source: &VerilogSource) -> String {
    let [gold, gate] = VERSIONS;
    let of = |direction| source.ports.iter().filter(move |port| port.direction == direction);
    let range = |width: u32| format!("[{}:0]", width - 1);
    let inputs: String =
        of(Direction::Input).map(|port| format!("input wire {} {}, ", range(port.width), port.name)).collect();
    let mut text = format!("module {MODULE}({inputs}output wire differ);\n");
    for port in of(Direction::Output) {
        let (range, name) = (range(port.width), &port.name);
        _ = writeln!(text, "wire {range} {gold}_{name}, {gate}_{name};");
    }
    for version in VERSIONS {
        let inputs = of(Direction::Input).map(|port| format!(".{0}({0})", port.name));
        let outputs = of(Direction::Output).map(|port| format!(".{0}({version}_{0})", port.name));
        _ = writeln!(text, "{version} {version}({});", inputs.chain(outputs).collect::<Vec<_>>().join(", "));
    }
    let streams = |direction| source.streams.iter().filter(move |stream| stream.direction == direction);
    let offered: Vec<(String, String)> = streams(Direction::Output)
        .flat_map(|stream| stream.field_ports().map(|field| (field, stream.flag_port())).collect::<Vec<_>>())
        .collect();
    let difference = |name: &str| match offered.iter().find(|(field, _)| field == name) {
        Some((_, flag)) => format!("{gold}_{flag} && {gold}_{name} != {gate}_{name}"),
        None => format!("{gold}_{name} != {gate}_{name}"),
    };
    let differences: Vec<_> = of(Direction::Output).map(|port| format!("({})", difference(&port.name))).collect();
    _ = writeln!(text, "assign differ = {};", differences.join(" || "));
    let resets = source.ports.iter().any(|port| port.name == super::RESET);
    for stream in streams(Direction::Input) {
        let Some(ready) = stream.ready_port() else { continue };
        let (name, flag) = (&stream.name, stream.flag_port());
        let fields: Vec<_> = stream.field_ports().collect();
        let item = format!("{{{}}}", [vec![flag.clone()], fields.clone()].concat().join(", "));
        let bits: u32 = of(Direction::Input).filter(|port| fields.contains(&port.name)).map(|port| port.width).sum();
        let in_reset = if resets { format!(" && !{}", super::RESET) } else { String::new() };
        _ = write!(
            text,
            "reg waits_{name} = 0;\nreg {} item_{name};\nalways @(posedge clk) begin\n    \
             waits_{name} <= {flag} && !{gold}_{ready}{in_reset};\n    item_{name} <= {item};\nend\n\
             always @* assume (!waits_{name} || {item} == item_{name});\n",
            range(1 + bits)
        );
    }
    text + "endmodule\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verilated::{Port, StreamDeclaration};

    #[test]
    fn fields_count_while_they_are_offered_and_what_waits_is_held() {
        let port = |name: &str, width, direction| Port { name: name.into(), width, direction };
        let source = VerilogSource {
            verilog: String::new(),
            top: "unit".into(),
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
        };
        let text = side_by_side(&source);
        let difference = "assign differ = (gold_in_ready != gate_in_ready) || (gold_out_valid != gate_out_valid) || \
            (gold_out_valid && gold_out_x != gate_out_x);";
        assert!(text.contains(difference), "{text}");
        assert!(
            text.contains("gate gate(.clk(clk), .rst(rst), .in_valid(in_valid), .in_x(in_x), .in_ready(gate_in_ready)")
        );
        assert!(text.contains("waits_in <= in_valid && !gold_in_ready && !rst;"), "{text}");
        assert!(text.contains("assume (!waits_in || {in_valid, in_x} == item_in);"), "{text}");
    }
}
