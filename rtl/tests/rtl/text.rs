//! The Verilog reads as a person would write it.

use rtl::{Direction, Module, StreamDeclaration, bit, elaborate, lit};

fn accumulator() -> Module {
    let mut m = Module::new("accumulator", "Adds up what comes in, up to a limit.");
    m.parameter("limit", 200);
    let (enable, value) = (m.input("enable", 1), m.input("value", 8));
    let total = m.reg_reset("total", 8, 0);
    let sum = m.wire("sum", total.add_carry(value));
    let over = m.wire("over", sum.ge_lit(200));
    m.next_if(total, enable, over.mux(total, sum.trunc(8)));
    m.output("total", total);
    m.output("over", over);
    m
}

const ACCUMULATOR: &str = "\
// Adds up what comes in, up to a limit.
// limit = 200
module accumulator (
    input  wire clk, input wire rst, input wire enable, input wire [7:0] value,
    output reg  [7:0] total, output wire over
);
    wire [8:0] sum = {1'd0, total} + {1'd0, value};
    assign over = 9'd200 <= sum;

    always @(posedge clk) begin
        if (rst) total <= 8'd0;
        else if (enable) total <= over ? total : sum[7:0];
    end
endmodule
";

#[test]
fn a_small_module_reads_well() {
    let design = elaborate(&accumulator()).expect("the module has no fault");
    assert_eq!(design.verilog(), ACCUMULATOR);
}

/// Comments stand behind the ports that they are of; without them the text is what it was.
#[test]
fn what_is_said_of_ports_stands_behind_them() {
    let mut m = accumulator();
    m.document("enable", "Whether a value\n  comes in.");
    m.document("value", "");
    m.document("over", "The limit is reached.");
    let design = elaborate(&m).expect("the module has no fault");
    let text = design.verilog();
    assert!(
        text.contains("    input  wire enable,  // Whether a value comes in.\n    input  wire [7:0] value,\n"),
        "{text}"
    );
    assert!(text.contains("    output wire over  // The limit is reached.\n);\n"), "{text}");
    let words = |text: &str| {
        let bare = text.lines().skip(2).map(|line| line.split("  //").next().unwrap_or(line));
        bare.flat_map(str::split_whitespace).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(words(text), words(ACCUMULATOR));
}

/// An output that shows a child's as it comes is connected to it; the next that does shows the first.
#[test]
fn outputs_of_children_leave_without_a_wire_between() {
    let mut m = Module::new("outer", "Shows what is inside.");
    let inside = m.instance("part", accumulator());
    let (enable, value) = (m.input("enable", 1), m.input("value", 8));
    m.connect(inside, "enable", enable);
    m.connect(inside, "value", value);
    let (total, over) = (m.out(inside, "total"), m.out(inside, "over"));
    m.output("sum", total);
    m.output("again", total);
    m.output("below", !over);
    let design = elaborate(&m).expect("the module has no fault");
    let text = design.verilog();
    for expected in [".total(sum), .over(part_over)", "    assign again = sum;\n    assign below = ~part_over;\n"] {
        assert!(text.contains(expected), "{text}");
    }
    assert!(!text.contains("part_total"), "{text}");
}

#[test]
fn a_streams_ready_stands_beside_its_valid() {
    let mut m = Module::new("gate", "Lets all through.");
    let stream = m.stream_in("in", &[("data", 8)]);
    m.stream_export("out", &stream);
    m.document("in_valid", "What comes.");
    let design = elaborate(&m).expect("the module has no fault");
    let expected = "    input  wire in_valid, output wire in_ready,  // What comes.\n    input  wire [7:0] in_data,\n";
    assert!(design.verilog().contains(expected), "{}", design.verilog());
}

#[test]
fn what_is_said_of_registers_stands_behind_them() {
    let mut m = Module::new("three", "Three in a row.");
    let mut value = m.input("value", 1);
    for name in ["first", "second", "third"] {
        let register = m.reg(name, 1);
        m.next(register, value);
        value = register.expr();
    }
    m.document("second", "The one in the middle.");
    m.output("last", value);
    let design = elaborate(&m).expect("the module has no fault");
    let expected = "    reg first;\n    reg second;  // The one in the middle.\n    reg third;\n";
    assert!(design.verilog().contains(expected), "{}", design.verilog());
}

#[test]
fn wires_without_a_name_are_called_by_what_they_are_made_of_or_for() {
    let mut m = Module::new("nameless", "Uses everything twice.");
    let (a, b, swap) = (m.input("a", 4), m.input("b", 4), m.input("swap", 1));
    let difference = a - b;
    let chosen = swap.mux(difference, a & b);
    m.output("twice", chosen + chosen);
    m.output("same", difference ^ chosen);
    let design = elaborate(&m).expect("the module has no fault");
    for expected in ["wire [3:0] a_minus_b = a - b;", "wire [3:0] same_choice = swap ? a_minus_b : (a & b);"] {
        assert!(design.verilog().contains(expected), "{}", design.verilog());
    }
}

#[test]
fn modules_that_differ_in_comments_alone_are_one() {
    let mut m = Module::new("pair", "Two of a kind.");
    for (name, text) in [("first", "One word."), ("second", "Another.")] {
        let mut part = Module::new("inverter", "Inverts.");
        let input = part.input("in", 1);
        part.output("out", !input);
        part.document("in", text);
        let part = m.instance(name, part);
        let input = m.input(&format!("{name}_in"), 1);
        m.connect(part, "in", input);
        let out = m.out(part, "out");
        m.output(&format!("{name}_out"), out);
    }
    let design = elaborate(&m).expect("the module has no fault");
    assert_eq!(design.modules().len(), 2);
    assert!(design.verilog().contains("input  wire in,  // One word.") && !design.verilog().contains("Another."));
}

#[test]
fn only_declared_ports_can_be_spoken_of() {
    let mut m = accumulator();
    m.document("totals", "Nothing is called so.");
    let faults = elaborate(&m).expect_err("there is no such port").to_string();
    assert!(faults.contains("`accumulator` has no port `totals` to say anything of"), "{faults}");
}

#[test]
fn what_is_used_twice_becomes_a_wire_and_what_is_not_used_goes() {
    let mut m = Module::new("shared", "Uses a sum three times.");
    let (a, b) = (m.input("a", 4), m.input("b", 4));
    m.wire("dead", a ^ b);
    let dead_register = m.reg("dead_register", 4);
    m.next(dead_register, dead_register.add_lit(1));
    // Built twice, and still one adder.
    m.output("x", (a + b) & a);
    m.output("y", (a + b) | b);
    let design = elaborate(&m).expect("the module has no fault");
    assert_eq!(design.modules()[0].area.adder_bits, 4);
    assert_eq!(design.verilog().matches("a + b").count(), 1);
    assert!(!design.verilog().contains("dead") && !design.verilog().contains("clk"), "{}", design.verilog());
}

#[test]
fn what_is_never_picked_takes_no_choice() {
    let mut m = Module::new("top", "Picks.");
    let (index, a, b) = (m.input("index", 2), m.input("a", 8), m.input("b", 8));
    let parts = [(3, 0), (7, 4)].map(|(high, low)| [a, b].map(|source| source.bits(high, low)));
    for (place, [a, b]) in parts.into_iter().enumerate() {
        m.output(&format!("only_{place}"), index.pick_some([None, Some(a)]));
        m.output(&format!("two_{place}"), index.pick_some([None, Some(a), Some(b)]));
        m.output(&format!("twice_{place}"), index.pick_some([Some(a), Some(a), Some(b), Some(a)]));
        m.output(&format!("last_{place}"), index.pick([a, b]));
    }
    let design = elaborate(&m).unwrap();
    let text = design.verilog();
    for line in [
        "assign only_0 = a[3:0];",
        "assign two_0 = index[1] ? b[3:0] : a[3:0];",
        "assign twice_1 = index[1] ? (index[0] ? a[7:4] : b[7:4]) : a[7:4];",
        "assign last_1 = index[1] ? b[7:4] : index[0] ? b[7:4] : a[7:4];",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
}

#[test]
fn ports_are_listed_as_declared() {
    let design = elaborate(&accumulator()).expect("the module has no fault");
    let ports: Vec<(&str, u32)> = design.ports().iter().map(|port| (port.name.as_str(), port.width)).collect();
    assert_eq!(ports, [("clk", 1), ("rst", 1), ("enable", 1), ("value", 8), ("total", 8), ("over", 1)]);
}

#[test]
fn streams_are_listed_as_declared_and_taken_from_there() {
    let mut child = Module::new("child", "Adds one.");
    let input = child.stream_in("in", &[("value", 8)]);
    let ready = child.stream_out("out", input.valid, [("value", input.field("value").add_lit(1)), ("last", lit(1, 1))]);
    child.ready(&input, ready);
    // Begins like the stream and is none of it.
    child.output("out_other", lit(1, 0));
    child.pulse_out("done", "enable", ready, [("code", lit(2, 3))]);

    let mut top = Module::new("top", "Holds the child.");
    let (start, count) = top.pulse_in("start", "valid", &[("count", 3)]);
    top.output("started", start & count[0].any());
    let input = top.stream_in("in", &[("value", 8)]);
    let unit = top.instance("unit", child);
    top.stream_into(unit, "in", &input);
    let out = top.stream_from(unit, "out");
    assert_eq!(out.fields.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["value", "last"]);
    top.stream_export("out", &out);
    let design = elaborate(&top).unwrap_or_else(|error| panic!("{error}"));
    let expected = [
        StreamDeclaration::pulse("start", "valid", Direction::Input, ["count"]),
        StreamDeclaration::stream("in", Direction::Input, ["value"]),
        StreamDeclaration::stream("out", Direction::Output, ["value", "last"]),
    ];
    assert_eq!(design.streams(), expected);
    let ports: Vec<_> = design.ports().iter().map(|port| port.name.as_str()).collect();
    for stream in design.streams() {
        assert!(ports.contains(&stream.flag_port().as_str()));
        assert!(
            stream
                .ready_port()
                .iter()
                .chain(&stream.field_ports().collect::<Vec<_>>())
                .all(|port| ports.contains(&port.as_str()))
        );
    }
}

#[test]
fn constants_go_through_wires_and_registers_and_renaming_wires_go() {
    let mut m = Module::new("folded", "Has registers that never change.");
    let (moves, rival) = (m.input("moves", 1), m.input("rival", 1));
    let never = m.reg_reset("never", 1, 0);
    m.next(never, never);
    let stays = m.wire("stays", never);
    let done = m.wire("done", moves & !stays);
    m.output("out", done ^ rival);
    let held = m.reg_reset("held", 1, 1);
    m.next_if(held, rival, bit(true));
    m.output("constant", held);
    let text = elaborate(&m).expect("the module has no fault").verilog().to_owned();
    assert!(text.contains("assign constant = 1'd1;") && !text.contains("held"), "{text}");
    assert!(!text.contains("stays") && !text.contains("done"), "{text}");
}

#[test]
fn fields_of_a_packed_stream_are_connected_one_by_one() {
    let layout = [("high", 3), ("low", 5)];
    let mut queue = Module::new("queue", "Passes items on.");
    let input = queue.packed_in("in", &layout);
    let ready = queue.packed_out("out", input.valid, input.data, &layout);
    queue.drive(input.ready, ready);
    let mut m = Module::new("user", "Leads a stream through a queue.");
    let items = m.stream_in("items", &layout);
    let queue = m.instance("queue", queue);
    m.stream_into(queue, "in", &items);
    let passed = m.stream_from(queue, "out");
    m.stream_export("passed", &passed);
    let text = elaborate(&m).expect("the module has no fault").verilog().to_owned();
    assert!(text.contains(".in_data({items_high, items_low})"), "{text}");
    assert!(text.contains("assign {passed_high, passed_low} = queue_out_data;"), "{text}");
}
