//! Proofs about small designs.

use super::*;
use crate::mutation::campaign::Tests;
use crate::mutation::schemata::Schemata;
use pointcore_tb::verilated::Direction::{self, Input as In, Output as Out};
use pointcore_tb::verilated::{ModuleInterface, Port, StreamDeclaration, VerilogSource};
use rtl::{Module, elaborate};

const COUNTER: &str = "module counter(input clk, input rst, output reg [3:0] count);\n\
    wire never = count == 4'd12;\n\
    always @(posedge clk) if (rst || count == 4'd9 || never) count <= 0; else count <= count + 4'd1;\n\
    endmodule\n";

fn yosys() -> Option<Tool> {
    let yosys = Tool::yosys().ok();
    if yosys.is_none() {
        pointcore_tb::skipped::skipped("no yosys that is new enough: `make setup-fpga` installs it");
    }
    yosys
}

/// A mutation that has a wire, or a bit of it, at zero.
fn stuck_at_zero(wire: &str) -> String {
    // It must exist: of none, there would be no mutation.
    let name = wire.split(' ').next().unwrap_or(wire);
    format!("select -assert-count 1 w:{name}\nmutate -list 1 -mode const0 -wire {wire} -o chosen\nscript chosen\n")
}

/// What a prover says of a mutation, if there is a yosys.
fn proof(subject: &Subject, mutation: &str) -> Option<Proof> {
    Some(prove(&yosys()?, subject, mutation, 10).unwrap_or_else(|error| panic!("{error}")))
}

/// What it says where some modules inside the top may do anything.
fn open_proof(yosys: &Tool, subject: &Subject, open: &[&str], wire: &str) -> Proof {
    let modules = Modules::of(&subject.verilog);
    let (mutation, mutated, cell) = (&stuck_at_zero(wire), "top", None);
    let prover = Prover { yosys, subject, mutation, mutated, cell, seconds: 10, modules };
    prover.compare("top", &open.iter().copied().collect()).unwrap_or_else(|error| panic!("{error}"))
}

fn port((name, width, direction): (&str, u32, Direction)) -> Port {
    Port { name: name.to_owned(), width, direction }
}

fn interface(name: &str, ports: &[(&str, u32, Direction)], streams: Vec<StreamDeclaration>) -> ModuleInterface {
    ModuleInterface { name: name.to_owned(), ports: ports.iter().copied().map(port).collect(), streams }
}

fn subject(verilog: &str, others: &str, core: Option<&str>, top: &str) -> Subject {
    Subject {
        verilog: verilog.to_owned(),
        others: others.to_owned(),
        core: core.map(str::to_owned),
        top: top.to_owned(),
        modules: Modules::of(verilog).names().map(str::to_owned).collect(),
        interfaces: Vec::new(),
        tests: Tests::default(),
        substitute: "unused".into(),
    }
}

#[test]
fn a_condition_that_never_holds_is_equivalent_and_another_is_not() {
    let subject = subject(COUNTER, "", None, "counter");
    let stuck = |wire: &str| proof(&subject, &stuck_at_zero(wire));
    let Some(never) = stuck("never") else { return };
    assert_eq!((never, stuck("count")), (Proof::Equivalent, Some(Proof::Different)));
}

#[test]
fn a_core_may_do_anything_and_may_not_see_a_difference() {
    let core = "module core(input clk, input [1:0] a, output y);\nassign y = a[0];\nendmodule\n";
    let top = "module top(input clk, input [2:0] x, output y);\n\
        reg [2:0] kept;\nalways @(posedge clk) kept <= x;\n\
        core core(.clk(clk), .a(kept[1:0]), .y(y));\nendmodule\n";
    let subject = subject(top, core, Some("core"), "top");
    let stuck = |bit: u32| proof(&subject, &stuck_at_zero(&format!("kept -wirebit {bit}")));
    let Some(unused) = stuck(2) else { return };
    assert_eq!((unused, stuck(1), stuck(0)), (Proof::Equivalent, Some(Proof::Different), Some(Proof::Different)));
}

#[test]
fn a_module_is_compared_alone_whatever_those_in_it_do() {
    let inner = "module inner #(\n    parameter W = 2, parameter V = 2\n) (input clk, input [W-1:0] a, output y);\n\
        assign y = a[0];\nendmodule\n";
    let top = "module top(input clk, input [2:0] x, output z);\nreg [2:0] kept;\nwire y;\n\
        wire never = kept[0] && kept[2] && !kept[0];\nalways @(posedge clk) kept <= x;\n\
        inner #(.W(3), .V(3)) inner(\n.clk(clk), .a(kept), .y(y));\nassign z = y ^ never;\nendmodule\n";
    let subject = subject(&format!("{inner}{top}"), "", None, "top");
    let Some(yosys) = yosys() else { return };
    let stuck = |wire: &str, open: &[&str]| open_proof(&yosys, &subject, open, wire);
    // Open, the inner module could look at all of what it is given, but for what a stream says.
    assert_eq!((stuck("never", &["inner"]), stuck("never", &[])), (Proof::Equivalent, Proof::Equivalent));
    let unused = "kept -wirebit 1";
    assert_eq!((stuck(unused, &["inner"]), stuck(unused, &[])), (Proof::Different, Proof::Equivalent));
}

#[test]
fn what_is_neither_offered_nor_written_does_not_count_inside_either() {
    let sink =
        "module sink(input clk, input in_valid, input in_x, output y);\nassign y = in_valid && in_x;\nendmodule\n";
    let memory = "module memory_1w1r #(\n    parameter WIDTH = 8,\n    parameter DEPTH = 2\n) (input clk, input write, \
        input [$clog2(DEPTH)-1:0] write_address, input [WIDTH-1:0] write_data, input read, \
        input [$clog2(DEPTH)-1:0] read_address, output [WIDTH-1:0] read_data);\nassign read_data = 0;\nendmodule\n";
    let top = "module top(input clk, input v, input [3:0] x, output y, output [3:0] z);\n\
        wire idle = x[1] ^ x[2];\nwire data = v ? x[0] : idle;\nwire [3:0] word = v ? x : {4{idle}};\n\
        sink sink (\n.clk(clk), .in_valid(v), .in_x(data), .y(y));\n\
        memory_1w1r #(.WIDTH(4), .DEPTH(3)) words (\n.clk(clk), .write(v), .write_address(x[1:0]), .write_data(word), \
        .read(1'd1), .read_address(x[1:0]), .read_data(z));\nendmodule\n";
    let pulse = StreamDeclaration::pulse("in", "valid", In, ["x"]);
    let interfaces = vec![
        interface("sink", &[("clk", 1, In), ("in_valid", 1, In), ("in_x", 1, In), ("y", 1, Out)], vec![pulse]),
        interface("top", &[("clk", 1, In), ("v", 1, In), ("x", 4, In), ("y", 1, Out), ("z", 4, Out)], Vec::new()),
    ];
    let strict = subject(&format!("{sink}{memory}{top}"), "", None, "top");
    let tolerant = Subject { interfaces, ..strict.clone() };
    let Some(yosys) = yosys() else { return };
    let stuck = |subject, wire: &str| open_proof(&yosys, subject, &["sink", "memory_1w1r"], wire);
    assert_eq!((stuck(&strict, "idle"), stuck(&tolerant, "idle")), (Proof::Different, Proof::Equivalent));
    assert_eq!((stuck(&tolerant, "data"), stuck(&tolerant, "word")), (Proof::Different, Proof::Different));
}

#[test]
fn what_an_operator_is_given_counts_where_its_answer_does() {
    let operator = "module float_neg_s1_f8(input clk, input enable, input [1:0] a, output reg [1:0] y);\n\
        always @(posedge clk) if (enable) y <= ~a;\nendmodule\n";
    let top = "module top(input clk, input [1:0] x, output [1:0] z);\nreg phase;\nwire [1:0] idle = x ^ 2'd1;\n\
        wire [1:0] data = phase ? x : idle;\nwire [1:0] y;\nalways @(posedge clk) phase <= !phase;\n\
        float_neg_s1_f8 negation (\n.clk(clk), .enable(1'd1), .a(data), .y(y));\nassign z = phase ? 2'd0 : y;\nendmodule\n";
    let interfaces = vec![
        interface("float_neg_s1_f8", &[("clk", 1, In), ("enable", 1, In), ("a", 2, In), ("y", 2, Out)], Vec::new()),
        interface("top", &[("clk", 1, In), ("x", 2, In), ("z", 2, Out)], Vec::new()),
    ];
    let subject = Subject { interfaces, ..subject(&format!("{operator}{top}"), "", None, "top") };
    let Some(yosys) = yosys() else { return };
    let stuck = |wire: &str| open_proof(&yosys, &subject, &["float_neg_s1_f8"], wire);
    assert_eq!((stuck("idle"), stuck("data")), (Proof::Equivalent, Proof::Different));
}

/// A register after each of two comparisons of a number, of which one never holds where that is asserted.
fn comparisons(asserts: bool) -> Subject {
    let mut m = Module::new("unit", "Sees numbers.");
    let x = m.input("x", 2);
    let [never, zero] = [("never", 3), ("zero", 0)].map(|(name, value)| m.wire(name, x.eq_lit(value)));
    for (name, seen) in [("never_seen", never), ("zero_seen", zero)] {
        let register = m.reg_reset(name, 1, 0);
        m.next(register, seen);
        m.output(&format!("{name}_before"), register);
    }
    if asserts {
        m.assert("in_range", !never);
    }
    let design = elaborate(&m).unwrap_or_else(|error| panic!("{error}"));
    subject(&VerilogSource::from(&design).verilog, "", None, "unit")
}

#[test]
fn what_an_assertion_rules_out_does_not_count() {
    let [open, ruled] = [false, true].map(comparisons);
    let stuck = |subject, wire: &str| proof(subject, &stuck_at_zero(wire));
    let Some(anything) = stuck(&open, "never") else { return };
    assert_eq!((anything, stuck(&ruled, "never")), (Proof::Different, Some(Proof::Equivalent)));
    assert_eq!(stuck(&ruled, "zero"), Some(Proof::Different));
}

#[test]
fn a_mutant_is_where_it_was_listed() {
    let Some(yosys) = yosys() else { return };
    let subject = comparisons(true);
    let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("{error}"));
    let schemata = Schemata::new(&yosys, folder.path(), &subject, 8, 1, 1);
    let schemata = schemata.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(schemata.mutations.len(), 8);
    for mutation in &schemata.mutations {
        assert_ne!(proof(&subject, mutation), Some(Proof::Open), "{mutation}");
    }
}

/// The mutation of a module that has all these words.
fn listed(yosys: &Tool, subject: &Subject, mutated: &str, words: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("{error}"));
    let listed = Schemata::new(yosys, folder.path(), subject, 200, 1, 1).unwrap_or_else(|error| panic!("{error}"));
    let module = format!("-module {mutated} ");
    let is_it = |mutation: &String| mutation.contains(&module) && words.iter().all(|word| mutation.contains(word));
    listed.mutations.into_iter().find(is_it).expect("it is one of them")
}

/// The prover of a mutation.
fn prover<'a>(yosys: &'a Tool, subject: &'a Subject, mutated: &'a str, mutation: &'a str) -> Prover<'a> {
    let modules = Modules::of(&subject.verilog);
    Prover { yosys, subject, mutation, mutated, cell: argument(mutation, "-cell"), seconds: 10, modules }
}

/// What the proofs near a fault and in turns say, in a module inside the top or in the top itself.
fn proof_near(yosys: &Tool, text: &str, mutated: &str, words: &[&str]) -> Proof {
    let subject = &subject(text, "", None, "top");
    let mutation = &listed(yosys, subject, mutated, words);
    let prover = prover(yosys, subject, mutated, mutation);
    let cell = &prover.name_in("top", prover.cell.expect("it has a cell"));
    let around = Around { cell: Some(cell), operators: Operators::Strict, near: NEAR, begins_set: false };
    let [near, in_turns] = [Way::Around(around), Way::InTurns(None)]
        .map(|way| prover.compare_as("top", &BTreeSet::new(), way).unwrap_or_else(|error| panic!("{error}")));
    assert_eq!(near, in_turns, "{mutation}");
    near
}

/// The words of a mutation that inverts what a register shows.
fn inverts(wire: &str) -> [&str; 4] {
    ["-mode inv", "-cell $procdff", "-port Q", wire]
}

/// What that proof says where the output of a register is inverted.
fn inverted(yosys: &Tool, text: &str, mutated: &str, wire: &str) -> Proof {
    proof_near(yosys, text, mutated, &inverts(&format!("-wire {wire}")))
}

#[test]
fn what_a_register_holds_may_be_inverted_twice() {
    let Some(yosys) = yosys() else { return };
    // It holds for four cycles, and is looked at in one of them.
    let text = |reset: &str, phase: u32| {
        format!(
            "module top (input clk, input rst, input x, output reg shown);\nreg [1:0] phase;\nreg kept;\n\
             always @(posedge clk) if (rst) phase <= 0; else phase <= phase + 2'd1;\n\
             always @(posedge clk) {reset}if (phase == 2'd0) kept <= x;\n\
             always @(posedge clk) if (phase == 2'd{phase}) shown <= kept;\nendmodule\n"
        )
    };
    for reset in ["", "if (rst) kept <= 0; else "] {
        let proofs = [1, 2, 3].map(|phase| inverted(&yosys, &text(reset, phase), "top", "kept"));
        assert_eq!(proofs, [Proof::Different, Proof::Equivalent, Proof::Different], "{reset}");
    }
    // What a register holds after a reset is known where the reset gets to it.
    assert_eq!(inverted(&yosys, &text("", 2), "top", "phase"), Proof::Different);
    let unset = ["-mode const0", "-cell $procmux", "-port S", "-wire rst"];
    assert_eq!(proof_near(&yosys, &text("", 2), "top", &unset), Proof::Open);
}

#[test]
fn what_an_operator_is_given_out_of_turn_may_be_inverted() {
    let Some(yosys) = yosys() else { return };
    let operator = "module float_neg_s1_f8(input clk, input enable, input [1:0] a, output reg [1:0] y);\n\
        always @(posedge clk) if (enable) y <= ~a;\nendmodule\n";
    let interfaces = vec![
        interface("float_neg_s1_f8", &[("clk", 1, In), ("enable", 1, In), ("a", 2, In), ("y", 2, Out)], Vec::new()),
        interface("top", &[("clk", 1, In), ("rst", 1, In), ("x", 2, In), ("z", 2, Out)], Vec::new()),
    ];
    let is_hidden = |loaded: u32, taken: u32| {
        let top = format!(
            "module top (input clk, input rst, input [1:0] x, output reg [1:0] z);\nreg [1:0] phase, kept;\n\
             wire [1:0] y;\nalways @(posedge clk) if (rst) phase <= 0; else phase <= phase + 2'd1;\n\
             always @(posedge clk) if (phase == 2'd{loaded}) kept <= x;\n\
             float_neg_s1_f8 negation (\n.clk(clk), .enable(1'd1), .a(kept), .y(y));\n\
             always @(posedge clk) if (phase == 2'd{taken}) z <= y;\nendmodule\n"
        );
        let text = format!("{operator}{top}");
        let subject = &Subject { interfaces: interfaces.clone(), ..subject(&text, "", None, "top") };
        let hidden = ["-wirebit 0 ", "-wirebit 1 "].map(|bit| {
            let words = [inverts("-wire kept ").as_slice(), &[bit]].concat();
            let mutation = &listed(&yosys, subject, "top", &words);
            let prover = prover(&yosys, subject, "top", mutation);
            let open = BTreeSet::from(["float_neg_s1_f8"]);
            let hidden = prover.is_hidden_near("top", &open, Operators::Tolerant);
            hidden.unwrap_or_else(|error| panic!("{error}"))
        });
        assert_eq!(hidden[0], hidden[1]);
        hidden[0]
    };
    // The operator takes a cycle. Loaded in the second phase, what it holds before that has to begin the other way.
    assert_eq!(
        [(0, 3), (0, 0), (1, 2), (1, 1)].map(|(loaded, taken)| is_hidden(loaded, taken)),
        [true, false, true, false]
    );
}

#[test]
fn what_a_comparison_makes_the_same_of_does_not_count() {
    let Some(yosys) = yosys() else { return };
    let text = "module float_le_s1_f4(input clk, input enable, input [3:0] a, output reg y);\n\
        always @(posedge clk) if (enable) y <= a >= 4'd8;\nendmodule\n\
        module top (input clk, input rst, input [3:0] x, output reg z);\nreg [3:0] kept;\nwire y;\n\
        float_le_s1_f4 comparison (\n.clk(clk), .enable(1'd1), .a(kept), .y(y));\n\
        always @(posedge clk) begin kept <= x; z <= y; end\nendmodule\n";
    let interfaces = vec![
        interface("float_le_s1_f4", &[("clk", 1, In), ("enable", 1, In), ("a", 4, In), ("y", 1, Out)], Vec::new()),
        interface("top", &[("clk", 1, In), ("rst", 1, In), ("x", 4, In), ("z", 1, Out)], Vec::new()),
    ];
    let subject = &Subject { interfaces, ..subject(text, "", None, "top") };
    let open = &BTreeSet::from(["float_le_s1_f4"]);
    let hidden = ["-wirebit 2 ", "-wirebit 3 "].map(|bit| {
        let mutation = &listed(&yosys, subject, "top", &[inverts("-wire kept ").as_slice(), &[bit]].concat());
        let prover = prover(&yosys, subject, "top", mutation);
        let near = prover.is_hidden_near("top", open, Operators::Tolerant);
        let compared = prover.is_hidden_by_comparisons("top", open);
        [near, compared].map(|hidden| hidden.unwrap_or_else(|error| panic!("{error}")))
    });
    assert_eq!(hidden, [[false, true], [false, false]]);
}

#[test]
fn what_a_register_inside_holds_is_looked_at_outside() {
    let Some(yosys) = yosys() else { return };
    let text = |phase: u32| {
        format!(
            "module inner (input clk, input load, input x, output reg kept);\n\
             always @(posedge clk) if (load) kept <= x;\nendmodule\n\
             module top (input clk, input rst, input x, output reg shown);\nreg [1:0] phase;\nwire kept;\n\
             inner inner (\n.clk(clk), .load(phase == 2'd0), .x(x), .kept(kept));\n\
             always @(posedge clk) if (rst) phase <= 0; else phase <= phase + 2'd1;\n\
             always @(posedge clk) if (phase == 2'd{phase}) shown <= kept;\nendmodule\n"
        )
    };
    let proofs = [1, 2].map(|phase| inverted(&yosys, &text(phase), "inner", "kept"));
    assert_eq!(proofs, [Proof::Different, Proof::Equivalent]);
}

#[test]
fn a_port_of_what_stands_inside_counts_where_something_looks_at_it() {
    let Some(yosys) = yosys() else { return };
    let text = "module inner (input clk, input x, input ignored, output reg kept, output ready);\n\
        always @(posedge clk) kept <= x;\nassign ready = x;\nendmodule\n\
        module top (input clk, input rst, input x, output shown);\nwire ready;\n\
        inner within (\n.clk(clk), .x(x), .ignored(x), .kept(shown), .ready(ready));\nendmodule\n";
    let subject = &subject(text, "", None, "top");
    for (port, is_seen) in [("x", true), ("kept", true), ("ignored", false), ("ready", false)] {
        let mutation = &listed(&yosys, subject, "top", &["-mode inv", "-cell within", &format!("-port {port} ")]);
        let prover = prover(&yosys, subject, "top", mutation);
        let hidden = prover.is_hidden_near("top", &BTreeSet::new(), Operators::Strict);
        assert_eq!(hidden.unwrap_or_else(|error| panic!("{error}")), !is_seen, "{mutation}");
        let expected = if is_seen { Proof::Different } else { Proof::Equivalent };
        assert_eq!(proof(subject, mutation), Some(expected), "{mutation}");
    }
}

#[test]
fn a_stuck_bit_is_seen_where_it_alone_led() {
    let Some(yosys) = yosys() else { return };
    let text = "module top (input clk, input rst, input [1:0] x, output reg low, output reg high);\n\
        wire [1:0] sum = x + 2'd1;\n\
        always @(posedge clk) begin low <= sum[0]; high <= sum[1]; end\nendmodule\n";
    for bit in [0, 1] {
        let stuck = ["-mode const1", "-cell $add", "-port Y", &format!("-wirebit {bit}")];
        assert_eq!(proof_near(&yosys, text, "top", &stuck), Proof::Different, "{bit}");
    }
}

#[test]
fn what_nothing_drives_any_more_is_seen_where_it_led() {
    let Some(yosys) = yosys() else { return };
    let modules = "module float_neg_s1_f8(input clk, input enable, input [1:0] a, output reg [1:0] y);\n\
        always @(posedge clk) if (enable) y <= ~a;\nendmodule\n\
        module inner (input clk, input x, output reg kept);\nalways @(posedge clk) kept <= x;\nendmodule\n";
    let top = "module top (input clk, input rst, input [1:0] x, output shown, output [1:0] z);\n\
        wire both = x[0] & x[1];\nfloat_neg_s1_f8 negation (\n.clk(clk), .enable(1'd1), .a(x), .y(z));\n\
        inner inner (\n.clk(clk), .x(both), .kept(shown));\nendmodule\n";
    let interfaces = vec![
        interface("float_neg_s1_f8", &[("clk", 1, In), ("enable", 1, In), ("a", 2, In), ("y", 2, Out)], Vec::new()),
        interface("inner", &[("clk", 1, In), ("x", 1, In), ("kept", 1, Out)], Vec::new()),
        interface("top", &[("clk", 1, In), ("rst", 1, In), ("x", 2, In), ("shown", 1, Out), ("z", 2, Out)], Vec::new()),
    ];
    let subject = &Subject { interfaces, ..subject(&format!("{modules}{top}"), "", None, "top") };
    let mutation = &listed(&yosys, subject, "top", &["-mode const1", "-cell $and", "-port Y"]);
    let open = BTreeSet::from(["float_neg_s1_f8", "inner"]);
    let hidden = prover(&yosys, subject, "top", mutation).is_hidden_near("top", &open, Operators::Tolerant);
    assert!(!hidden.unwrap_or_else(|error| panic!("{error}")), "{mutation}");
}

#[test]
fn what_no_stream_offers_does_not_count_and_what_waits_is_held() {
    let unit = "module unit(input clk, input rst, input in_valid, input in_x, output in_ready, output out_valid,\n\
        output out_x, output broken);\n\
        reg full, waited, kept;\nassign in_ready = full;\nassign out_valid = full;\nwire idle = in_x ^ waited;\n\
        assign out_x = full ? kept : idle;\nassign broken = waited && in_x != kept;\n\
        always @(posedge clk) begin\nwaited <= in_valid && !full && !rst;\nkept <= in_x;\n\
        full <= in_valid && !full && !rst;\nend\nendmodule\n";
    let streams =
        vec![StreamDeclaration::stream("in", In, ["x"]), StreamDeclaration::pulse("out", "valid", Out, ["x"])];
    let inputs = ["clk", "rst", "in_valid", "in_x"].map(|name| (name, 1, In));
    let outputs = ["in_ready", "out_valid", "out_x", "broken"].map(|name| (name, 1, Out));
    let interface = interface("unit", &[inputs, outputs].concat(), streams);
    let strict = subject(unit, "", None, "unit");
    let tolerant = Subject { interfaces: vec![interface], ..strict.clone() };
    let stuck = |subject, wire: &str| proof(subject, &stuck_at_zero(wire));
    for (wire, expected) in [("idle", Proof::Equivalent), ("broken", Proof::Equivalent), ("kept", Proof::Different)] {
        let Some(strictly) = stuck(&strict, wire) else { return };
        assert_eq!((strictly, stuck(&tolerant, wire)), (Proof::Different, Some(expected)), "{wire}");
    }
}

#[test]
fn an_operator_of_one_operand_is_compared_on_all_of_them() {
    let operator = "module float_root_s2_f8(input clk, input enable, input [7:0] a, output reg [7:0] y);\n\
        reg [7:0] kept;\nwire [15:0] square = kept * kept;\nwire never = square[1:0] == 2'd2;\nwire odd = kept[0] ^ kept[3];\n\
        wire holds = !enable;\nalways @(posedge clk) if (!holds) begin\n\
        kept <= a;\ny <= never ? 8'd0 : odd ? square[15:8] : square[7:0];\nend\nendmodule\n";
    let ports = [("clk", 1, In), ("enable", 1, In), ("a", 8, In), ("y", 8, Out)];
    let top = "float_root_s2_f8";
    let subject = Subject { interfaces: vec![interface(top, &ports, Vec::new())], ..subject(operator, "", None, top) };
    let Some(yosys) = &yosys() else { return };
    let exhausted = |wire: &str| {
        let (modules, mutation) = (Modules::of(&subject.verilog), &stuck_at_zero(wire));
        let prover = Prover { yosys, subject: &subject, mutation, mutated: top, cell: None, seconds: 10, modules };
        prover.exhaust(top).unwrap_or_else(|error| panic!("{error}"))
    };
    assert_eq!([exhausted("never"), exhausted("odd")], [Some(Proof::Equivalent), Some(Proof::Different)]);
    assert_eq!(exhausted("holds"), None, "it does not hold what it has, and may answer anything");
}

#[test]
fn what_is_followed_from_the_reset_on_is_known_when_it_is_looked_at() {
    let Some(yosys) = yosys() else { return };
    // A buffer of four places and its register delay by five turns of three cycles; `kept` is looked at two cycles after it was loaded.
    let text = "module top (input clk, input rst, input [3:0] x, output reg [3:0] z, output reg [3:0] delayed);\n\
        reg [1:0] phase, delay_5_from_0_pointer;\nreg [3:0] kept;\nreg [3:0] delay_5_from_0 [0:3];\n\
        always @(posedge clk) if (rst) begin phase <= 0; delay_5_from_0_pointer <= 0; end else begin\n\
        phase <= (phase == 2'd2) ? 2'd0 : phase + 2'd1;\n\
        if (phase == 2'd0) delay_5_from_0_pointer <= delay_5_from_0_pointer - 2'd1;\nend\n\
        always @(posedge clk) if (phase == 2'd0) begin kept <= x;\n\
        delay_5_from_0[delay_5_from_0_pointer] <= x;\ndelayed <= delay_5_from_0[delay_5_from_0_pointer];\nend\n\
        always @(posedge clk) if (phase == 2'd2) z <= kept;\nendmodule\n";
    let ports = [("clk", 1, In), ("rst", 1, In), ("x", 4, In), ("z", 4, Out), ("delayed", 4, Out)];
    let subject = &Subject { interfaces: vec![interface("top", &ports, Vec::new())], ..subject(text, "", None, "top") };
    let is_followed = |words: &[&str]| {
        let mutation = &listed(&yosys, subject, "top", words);
        let followed = prover(&yosys, subject, "top", mutation).is_followed("top", &BTreeSet::new());
        followed.unwrap_or_else(|error| panic!("{error}"))
    };
    let of_register = ["-cell $procdff", "-port Q", "-wire kept ", "-wirebit 0 "];
    let inverted = |mode| is_followed(&[of_register.as_slice(), &[mode]].concat());
    // In all cycles, or where another bit is set: twice until it is looked at.
    assert_eq!(["-mode inv", "-mode cnot1", "-mode const0"].map(inverted), [true, true, false]);
    // Its pointer may go the other way round.
    let subtracted = |mode, bit| is_followed(&[mode, "-cell $sub", "-port B", bit]);
    assert!(subtracted("-mode const1", "-portbit 1 ") && !subtracted("-mode const0", "-portbit 0 "));
}

#[test]
fn what_differs_only_while_another_bit_is_zero_is_followed_to_where_that_hides_it() {
    let Some(yosys) = yosys() else { return };
    let text = "module top (input clk, input rst, input [1:0] x, output reg z);\nreg [1:0] kept, later;\n\
        always @(posedge clk) if (rst) z <= 0; else begin kept <= x; later <= kept; z <= later[1] & later[0];\nend\n\
        endmodule\n";
    let ports = [("clk", 1, In), ("rst", 1, In), ("x", 2, In), ("z", 1, Out)];
    let subject = &Subject { interfaces: vec![interface("top", &ports, Vec::new())], ..subject(text, "", None, "top") };
    let is_followed = |mode: &str| {
        let mutation =
            &listed(&yosys, subject, "top", &[mode, "-cell $procdff", "-port Q", "-wire kept ", "-wirebit 0 "]);
        let followed = prover(&yosys, subject, "top", mutation).is_followed("top", &BTreeSet::new());
        followed.unwrap_or_else(|error| panic!("{error}"))
    };
    assert_eq!(["-mode cnot0", "-mode inv"].map(is_followed), [true, false]);
}

#[test]
fn a_buffer_in_a_memory_of_its_own_may_begin_anywhere_and_stays_in_where_memories_are_taken_out() {
    let Some(yosys) = yosys() else { return };
    let memory = "module memory_1w1r #(parameter WIDTH = 1, parameter DEPTH = 2) (input clk, input write,\n\
        input [$clog2(DEPTH)-1:0] write_address, input [WIDTH-1:0] write_data, input read,\n\
        input [$clog2(DEPTH)-1:0] read_address, output reg [WIDTH-1:0] read_data);\nreg [WIDTH-1:0] words [0:DEPTH-1];\n\
        always @(posedge clk) begin if (write) words[write_address] <= write_data;\n\
        if (read) read_data <= words[read_address]; end\nendmodule\n";
    // What was in the buffer before is not looked at.
    let top = "module top (input clk, input rst, input [1:0] x, output reg [1:0] z);\n\
        reg [1:0] delay_6_from_0_pointer;\nreg [5:0] filled;\nwire [1:0] delayed;\n\
        memory_1w1r #(.WIDTH(2), .DEPTH(4)) delay_6_from_0 (\n.clk(clk), .write(1'd1),\n\
        .write_address(delay_6_from_0_pointer), .write_data(x), .read(1'd1),\n\
        .read_address(delay_6_from_0_pointer), .read_data(delayed)\n);\n\
        always @(posedge clk) begin filled <= {filled[4:0], 1'd1} & {6{!rst}}; z <= delayed & {2{filled[5]}};\n\
        if (rst) delay_6_from_0_pointer <= 0; else delay_6_from_0_pointer <= delay_6_from_0_pointer + 2'd1;\nend\n\
        endmodule\n";
    let ports = [("clk", 1, In), ("rst", 1, In), ("x", 2, In), ("z", 2, Out)];
    let interfaces = vec![interface("top", &ports, Vec::new())];
    let subject = &Subject { interfaces, ..subject(&format!("{memory}{top}"), "", None, "top") };
    let is_followed = |words: &[&str]| {
        let mutation = &listed(&yosys, subject, "top", words);
        let followed = prover(&yosys, subject, "top", mutation).is_followed("top", &BTreeSet::from(["memory_1w1r"]));
        followed.unwrap_or_else(|error| panic!("{error}"))
    };
    let begins_elsewhere = ["-mode const1", "-cell $procmux", "-port B", "-portbit 1 "];
    let stands_still = ["-mode const0", "-cell $add", "-port B", "-portbit 0 "];
    assert_eq!([begins_elsewhere.as_slice(), &stands_still].map(is_followed), [true, false]);
}
