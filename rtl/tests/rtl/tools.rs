//! Verilator, Icarus and yosys take the text of a design with every feature, without a warning.

use std::collections::HashSet;

use rtl::{Module, bit, cat, elaborate, lit};

use crate::lint::{lint, run};

/// One module with every construct, two children of one unit that differ, and two that do not.
fn everything() -> Module {
    let mut m = Module::new("everything", "Uses every construct once.");
    m.parameter("width", 8);
    let (a, b) = (m.input("a", 8), m.input("b", 8));
    let (select_bit, wide) = (m.input("choose", 1), m.input("wide", 150));
    m.input("ignored", 3);

    let sum = m.wire("total", a.add_carry(b));
    let product = a.mul_signed(b);
    let shifted = a.shl_by(b.bits(2, 0)) ^ a.shr_by(b.bits(5, 3)) ^ a.sar(2);
    let reduced = cat([a.any(), b.all(), a.is_zero(), a.lt_signed(b), a.lt_lit(7), (a + b).bit(3)]);
    let picked = a.bits(1, 0).pick([a, b, (a - b)]);
    m.output("sum", sum);
    m.output("mixed", cat([product, (a * b), shifted, reduced, picked, wide.bits(149, 140)]));
    m.output("constant", lit(200, 5));

    let count = m.reg_reset("count", 4, 3);
    m.next_if(count, select_bit, count.add_lit(1));
    m.output("count", count);
    let data = m.reg("data", 8);
    m.next(data, select_bit.mux(a, !b | shifted));

    let memory = m.memory("entries", 12, 8);
    m.write(memory, select_bit, a.bits(3, 0), data);
    let q = m.read_if(memory, "q", a.bit(7), b.bits(3, 0));
    let unordered = m.memory_unordered("unordered_entries", 16, 8);
    m.write(unordered, bit(true), count, b);
    let any = m.read(unordered, "any", count ^ a.bits(3, 0));
    let any_if = m.read_if(unordered, "any_if", select_bit | a.bit(0), b.bits(3, 0));
    let local = m.memory_distributed("local_entries", 16, 8);
    m.write(local, bit(true), count, a);
    let now = m.read_now(local, "now", b.bits(7, 4));
    let later = m.read(local, "later", b.bits(7, 4));
    m.output("read", cat([q, now, later.bits(6, 2), any, any_if]));
    let sine = m.rom("sine", &[0, 3, 7, 9, 10], 4, a.bits(2, 0));
    let held = m.rom_if("cosine", &[10, 9, 7, 3], 4, select_bit, a.bits(1, 0));
    let code = m.lookup("code", &[1, 2, 4, 8], 4, a.bits(7, 6));
    m.output("tables", cat([sine, held, code]));

    for (index, width) in [8, 8, 5].into_iter().enumerate() {
        let child = m.instance(&format!("stage_{index}"), stage(width));
        m.connect(child, "d", a.trunc(width));
        if index != 1 {
            let q = m.out(child, "q");
            m.output(&format!("staged_{index}"), q.bits(3, 0));
        }
    }

    let seen = m.reg_reset("seen", 4, 0);
    m.next(seen, count);
    m.assert("count_moves_by_one", seen.eq(count) | seen.add_lit(1).eq(count));
    let only_checked = count ^ seen.expr();
    m.assert("low_bits_differ_little", !only_checked.bits(1, 0).all() | select_bit);
    m
}

/// A register as a module of its own, so wide.
fn stage(width: u32) -> Module {
    let mut m = Module::new("stage", "One register.");
    m.variant("width", width);
    let d = m.input("d", width);
    let q = m.reg_reset("q", width, 0);
    m.next(q, d);
    m.output("q", q);
    m
}

#[test]
fn tools_take_every_construct_without_warnings() {
    let design = elaborate(&everything()).expect("the module has no fault");
    lint(&design);
    assert!(design.verilog().lines().all(|line| line.len() <= 200), "{}", design.verilog());
}

#[test]
fn a_file_a_module_is_the_single_file_in_parts() {
    let design = elaborate(&everything()).expect("the module has no fault");
    let files = design.files();
    let names: HashSet<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names.len(), files.len(), "{names:?}");
    let modules = design.modules().iter().map(|module| &module.name).chain(design.memory_modules());
    assert_eq!(names, modules.map(String::as_str).collect());
    assert!(names.len() > 2 && files[0].0 == design.top(), "{names:?}");
    for (name, text) in files {
        assert_eq!(text.matches("endmodule").count(), 1, "{text}");
        assert!(text.contains(&format!("\nmodule {name} ")), "{text}");
    }
    let texts: Vec<&str> = files.iter().map(|(_, text)| text.as_str()).collect();
    let directive = "// The whole design is one file, named after its top.\n/* verilator lint_off DECLFILENAME */\n\n";
    assert_eq!(format!("{directive}{}", texts.join("\n")), design.verilog());
}

/// Two memories, both read where they are written, stepped by a test bench in Verilog: what each shows in the last of its cycles.
fn read_where_written(defines: &[&str]) -> String {
    let mut m = Module::new("collide", "Reads where it writes.");
    let data = m.input("data", 4);
    let address = lit(1, 0);
    for (name, ordered) in [("ordered", true), ("unordered", false)] {
        let entries = format!("{name}_entries");
        let memory = if ordered { m.memory(&entries, 2, 4) } else { m.memory_unordered(&entries, 2, 4) };
        m.write(memory, bit(true), address, data);
        let shown = m.read(memory, name, address);
        m.output(&format!("{name}_out"), shown);
    }
    let design = elaborate(&m).expect("the module has no fault");
    let bench = "module bench;
        reg clk = 0;
        reg [3:0] data = 4'b0011;
        wire [3:0] ordered, unordered;
        collide dut(.clk(clk), .rst(1'b0), .data(data), .ordered_out(ordered), .unordered_out(unordered));
        initial begin
            #1 clk = 1; #1 clk = 0; data = 4'b0101; #1 clk = 1;
            #1 $display(\"%b %b\", ordered, unordered);
        end
        endmodule";
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let text = format!("{}{bench}", design.verilog());
    std::fs::write(folder.path().join("bench.v"), text).expect("a temporary folder can be written");
    let built = run("iverilog", &[defines, &["-o", "bench", "bench.v"]].concat(), folder.path());
    assert!(built.status.success(), "{built:?}");
    String::from_utf8_lossy(&run("vvp", &["-n", "bench"], folder.path()).stdout).trim().to_owned()
}

#[test]
fn an_unordered_memory_shows_another_word_where_it_is_written_under_assertions_only() {
    assert_eq!(read_where_written(&[]), "0011 0011");
    assert_eq!(read_where_written(&["-DRTL_ASSERT"]), "0011 1100");
}

#[test]
fn two_builds_give_the_same_bytes() {
    let texts = [(); 2].map(|()| elaborate(&everything()).expect("the module has no fault").verilog().to_string());
    assert_eq!(texts[0], texts[1]);
}

#[test]
fn identical_modules_are_one_and_others_are_told_apart() {
    let design = elaborate(&everything()).expect("the module has no fault");
    let names: Vec<(&str, u64)> =
        design.modules().iter().map(|module| (module.name.as_str(), module.instances)).collect();
    assert_eq!(names, [("stage_w8", 2), ("stage_w5", 1), ("everything", 1)]);
    assert_eq!(design.modules()[0].area.register_bits, 8);
    let top = design.modules()[2].area;
    assert_eq!((top.multipliers, top.multiplier_bits), (2, 32));
    assert_eq!(top.memory_bits, 12 * 8 + 2 * 16 * 8 + 8 * 4 + 4 * 4);
}

#[test]
fn assertions_fire_where_they_are_switched_on() {
    let mut m = Module::new("counter", "Counts, and must not reach 3.");
    let count = m.reg_reset("count", 4, 0);
    m.next(count, count.add_lit(1));
    m.assert("below_three", count.lt_lit(3));
    m.output("count", count);
    let design = elaborate(&m).expect("the module has no fault");
    let bench = "module testbench;\nreg clk = 0, rst = 1;\ncounter uut (.clk(clk), .rst(rst), .count());\n\
        always #1 clk = ~clk;\ninitial begin #4 rst = 0; #20 $finish; end\nendmodule\n";
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    std::fs::write(folder.path().join("bench.v"), format!("{}{bench}", design.verilog())).expect("it can be written");
    for (define, fires) in [("-DRTL_ASSERT", true), ("-DNOTHING", false)] {
        let compiled = run("iverilog", &[define, "-s", "testbench", "-o", "bench", "bench.v"], folder.path());
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        let output = run("vvp", &["-n", "bench"], folder.path());
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(printed.contains("assertion failed: below_three in testbench.uut"), fires, "{printed}");
    }
}
