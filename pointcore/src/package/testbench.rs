//! A self-checking test in SystemVerilog: it replays a recording and compares every output in every cycle.

use super::GENERATOR;
use crate::recording::{BitSequence, Group, Recording};
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
            ("clk", ..) => format!("        .{name}({name})"),
            ("rst", _, Some(place)) => format!("        .{name}({name} || vector{})", place.range()),
            (_, Direction::Input, Some(place)) => match flag_of(design, recording, name) {
                None => format!("        .{name}(vector{})", place.range()),
                Some(flag) => {
                    let (flag, range) = (flag.range(), place.range());
                    format!("        .{name}(vector{flag} ? vector{range} : ~vector{range})")
                }
            },
            (_, Direction::Output, Some(place)) => format!("        .{name}(found{})", place.range()),
            (_, _, None) => unreachable!("the specification lists `{name}`"),
        }
    };
    design.ports().iter().map(line).collect::<Vec<_>>().join(",\n")
}

/// The flag of the stream that the port is a field of.
fn flag_of(design: &Design, recording: &Recording, name: &str) -> Option<Place> {
    let mut streams = design.streams().iter();
    let stream = streams.find(|stream| stream.field_ports().any(|port| port == name))?;
    Place::of(recording, &stream.flag_port())
}

/// Statements that take the words of each group that changes into the vector.
fn changes(recording: &Recording, groups: &[Group]) -> String {
    let take = |port: &usize| {
        let place = Place::of(recording, &recording.ports()[*port].name).expect("it is a port of the recording");
        format!("take({}, {});", place.low, place.width)
    };
    let group = |(index, group): (usize, &Group)| {
        let takes: Vec<_> = group.members.iter().map(take).collect();
        format!("            if (changed[{index}]) begin {} end\n", takes.join(" "))
    };
    groups.iter().enumerate().map(group).collect()
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

/// A part of the core, which may be all of it, and what its golden model did at its ports.
#[derive(Clone, Copy, Debug)]
pub struct Replayed<'a> {
    /// The part.
    pub design: &'a Design,
    /// At the ports of the design.
    pub recording: &'a Recording,
}

impl Replayed<'_> {
    /// The file with the recording.
    fn vectors(&self) -> String {
        format!("{}_test.hex", self.design.top().trim_end_matches("_top"))
    }

    /// The module that replays.
    fn module(&self) -> String {
        format!("{}_replay", self.design.top())
    }
}

/// The test's files: its text, and the recordings that it reads from the folder that it runs in. What stands `alone` is part of the
/// whole, or joins parts of it.
pub fn files(name: &str, whole: Replayed, alone: &[Replayed]) -> Vec<(String, String)> {
    let parts: Vec<_> = iter::once(whole).chain(alone.iter().copied()).collect();
    let (replays, vectors): (Vec<_>, Vec<_>) = parts.iter().map(replay).unzip();
    let joins = |part: &&Replayed| whole.design.files().iter().all(|(module, _)| module != part.design.top());
    let joining = alone.iter().filter(joins).filter_map(|part| part.design.files().first());
    let joining: String = joining.map(|(_, text)| format!("\n{text}")).collect();
    let instance = |(place, part): (usize, &Replayed)| {
        format!("    {} replay_{place} (.passed(passed[{place}]));\n", part.module())
    };
    let instances: String = parts.iter().enumerate().map(instance).collect();
    let high = parts.len() - 1;
    let text = format!(
        r#"// Written by {GENERATOR}; do not edit.
// Replays what bit-exact models did at their ports, and compares every output in every cycle; a stream's fields count while it is valid, and
// those that go in are spoilt while it is not. For Verilator, whose registers start at random values: in a simulator with unknown values,
// what is not reset stays unknown longer than in hardware.
//
// A recording is a sequence of bits: in every cycle one, whether anything changes, and if so one for each group of ports, whether it does,
// then the words of those that do.

module {name};
    wire [{high}:0] passed;

{instances}
    initial begin
        wait (&passed);
        $display("PASSED");
        $finish;
    end
endmodule
{}{joining}"#,
        replays.concat()
    );
    [(format!("{name}.sv"), text)].into_iter().chain(vectors).collect()
}

/// The module that replays a part, and the file with what it reads.
fn replay(part: &Replayed) -> (String, (String, String)) {
    let Replayed { design, recording } = part;
    let (top, cycles, high) = (design.top(), recording.cycles(), recording.width() - 1);
    let items: usize = output_streams(design).map(|stream| recording.transfers(stream)).sum();
    let groups = recording.groups(design.streams());
    let sequence = recording.encode(&groups);
    let vectors = part.vectors();
    let text = format!(
        r#"
// {cycles} cycles of {top}, which {items} items leave.
module {module}(output reg passed = 1'b0);
    reg clk = 1'b0;
    reg rst = 1'b1;
    reg [{word_high}:0] words [0:{last}];
    reg [{high}:0] vector = 0;
    reg [{high}:0] next = 0;
    wire [{high}:0] found;
    reg changes;
    reg [{group_high}:0] changed;
    integer place = 0;
    integer i;
    integer cycle;
    integer differences = 0;

    {top} replayed (
{connections}
    );

    always #5 clk = !clk;

    // The next bit of the recording.
    task take_bit(output result);
        begin
            result = words[place / {word_bits}][place % {word_bits}];
            place = place + 1;
        end
    endtask

    // The next bits of the recording become bits of the next vector.
    task take(input integer low, input integer width);
        for (i = low; i < low + width; i = i + 1) take_bit(next[i]);
    endtask

    task advance;
        begin
            take_bit(changes);
            for (i = 0; i <= {group_high}; i = i + 1) begin
                if (changes) take_bit(changed[i]);
                else changed[i] = 1'b0;
            end
{changes}            vector = next;
        end
    endtask

    task differ(input [8*32-1:0] port);
        begin
            differences = differences + 1;
            $display("{top}, cycle %0d: %0s differs from the model", cycle, port);
        end
    endtask

    initial begin
        $readmemh("{vectors}", words);
        repeat ({RESET_CYCLES}) @(negedge clk);
        rst = 1'b0;
        for (cycle = 0; cycle < {cycles} && differences == 0; cycle = cycle + 1) begin
            advance;
            #4;
{comparisons}            @(negedge clk);
        end
        if (differences != 0) $fatal(1, "FAILED");
        $display("{top}: {cycles} cycles, {items} items, every output as the model's");
        passed = 1'b1;
    end
endmodule
"#,
        module = part.module(),
        word_bits = BitSequence::WORD_BITS,
        word_high = BitSequence::WORD_BITS - 1,
        group_high = groups.len() - 1,
        changes = changes(recording, &groups),
        last = sequence.lines() - 1,
        connections = connections(design, recording),
        comparisons = comparisons(design, recording),
    );
    (text, (vectors, sequence.hexadecimal()))
}
