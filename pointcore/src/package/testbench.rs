//! A self-checking test in SystemVerilog: it replays a recording and compares every output in every cycle.

use super::GENERATOR;
use crate::recording::Recording;
use pointcore_contract::{self as contract, Direction as Specified};
use pointcore_tb::lockstep::RESET_CYCLES;
use rtl::{Design, Direction, Port, StreamDeclaration};
use std::collections::HashMap;
use std::iter;

/// The field of a record that closes a frame and carries nothing else.
const END: &str = "end";

/// The bits of a port in a vector.
struct Place {
    low: u32,
    width: u32,
}

impl Place {
    fn of(recording: &Recording, name: &str) -> Option<Self> {
        let mut low = 0;
        for port in recording.ports() {
            let width = port.width;
            if port.name == name {
                return Some(Self { low, width });
            }
            low += width;
        }
        None
    }

    fn range(&self) -> String {
        if self.width == 1 {
            format!("[{}]", self.low)
        } else {
            format!("[{}:{}]", self.low + self.width - 1, self.low)
        }
    }
}

/// The connections of the design's ports, one a line.
fn connections(design: &Design, recording: &Recording) -> String {
    let line = |port: &Port| {
        let name = &port.name;
        match (name.as_str(), port.direction, Place::of(recording, name)) {
            ("clk" | "rst", ..) => format!("        .{name}({name})"),
            (_, Direction::Input, Some(place)) => format!("        .{name}(vector{})", place.range()),
            (_, Direction::Output, Some(place)) => format!("        .{name}(found{})", place.range()),
            (_, _, None) => unreachable!("the specification lists `{name}`"),
        }
    };
    design.ports().iter().map(line).collect::<Vec<_>>().join(",\n")
}

/// The streams that leave the core.
fn output_streams(design: &Design) -> impl Iterator<Item = &StreamDeclaration> {
    design.streams().iter().filter(|stream| stream.direction == Direction::Output)
}

/// A statement for each output that compares it: always, but a stream's fields only while it is valid, and of an end record no other.
fn comparisons(design: &Design, recording: &Recording) -> String {
    let place = |name: &str| Place::of(recording, name).expect("the recording has the design's ports").range();
    // What must be so for a port to count.
    let mut conditions: HashMap<String, Vec<String>> = HashMap::new();
    for stream in output_streams(design) {
        let valid = format!("vector{}", place(&stream.flag_port()));
        let end = stream.fields.iter().zip(stream.field_ports()).find(|(field, _)| *field == END).map(|(_, port)| port);
        for port in stream.field_ports() {
            let end = end.as_ref().filter(|end| **end != port).map(|end| format!("!vector{}", place(end)));
            conditions.insert(port, iter::once(valid.clone()).chain(end).collect());
        }
    }
    let line = |port: &contract::Port| {
        let (name, range) = (&port.name, place(&port.name));
        let mut conditions = conditions.remove(name).unwrap_or_default();
        conditions.push(format!("found{range} !== vector{range}"));
        format!("            if ({}) differ(\"{name}\");\n", conditions.join(" && "))
    };
    recording.ports().iter().filter(|port| port.direction == Specified::Output).map(line).collect()
}

/// The test's text. It reads `vectors` from the folder that it runs in.
pub fn text(name: &str, vectors: &str, design: &Design, recording: &Recording) -> String {
    let (top, cycles, high) = (design.top(), recording.cycles(), recording.width() - 1);
    let items: usize = output_streams(design).map(|stream| recording.transfers(stream)).sum();
    format!(
        r#"// Written by {GENERATOR}; do not edit.
// Replays {cycles} cycles of the bit-exact model at the ports of {top}, in which {items} items leave the core, and compares every output in every
// cycle; a stream's fields count while it is valid. For Verilator, whose registers start at random values: in a simulator with unknown
// values, what is not reset stays unknown longer than in hardware.

module {name};
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [{high}:0] vectors [0:{last}];
    reg [{high}:0] vector = 0;
    wire [{high}:0] found;
    integer cycle;
    integer differences = 0;

    {top} core (
{connections}
    );

    always #5 clk = !clk;

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("{vectors}", vectors);
        repeat ({RESET_CYCLES}) @(negedge clk);
        rst = 1'b0;
        repeat ({settling}) @(negedge clk);
        for (cycle = 0; cycle < {cycles} && differences == 0; cycle = cycle + 1) begin
            vector = vectors[cycle];
            #4;
{comparisons}            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("PASSED: {cycles} cycles, {items} items, every output as the model's");
        $finish;
    end
endmodule
"#,
        settling = recording.settling_cycles(),
        last = cycles - 1,
        connections = connections(design, recording),
        comparisons = comparisons(design, recording),
    )
}
