//! rust-hdl blocks as children of our modules.

use rtl::{FaultKind, Module, elaborate};
use rust_hdl::prelude::*;

use crate::lint::{lint, run};

/// A strobe every `CYCLES` cycles in which it is enabled.
const CYCLES: u64 = 4;

/// A rust-hdl widget that is a hierarchy of its own.
fn pacer() -> Module {
    Module::from_block("pacer", "rust-hdl's strobe.", Strobe::<8>::new(1000 * CYCLES, 1000.0))
}

/// Counts the strobes of a rust-hdl widget, beside the same count in rust-hdl's own register.
fn counter() -> Module {
    let mut m = Module::new("counter", "Counts strobes.");
    let enable = m.input("enable", 1);
    let strobe = m.instance("pace", pacer());
    m.connect(strobe, "enable", enable);
    let fires = m.out(strobe, "strobe");
    let count = m.reg_reset("count", 8, 0);
    m.next_if(count, fires, count.add_lit(1));
    m.output("count", count);

    let register = m.instance("held", Module::from_block("dff", "rust-hdl's register.", DFF::<Bits<8>>::default()));
    m.connect(register, "d", count);
    let delayed = m.out(register, "q");
    m.output("delayed", delayed);
    m
}

/// A queue of rust-hdl's, a hierarchy with a memory, between our streams.
fn queue() -> Module {
    let fifo = SynchronousFIFO::<Bits<8>, 3, 4, 1>::default();
    Module::from_block("fifo", "rust-hdl's queue.", fifo)
}

#[test]
fn tools_take_widgets_in_our_modules_without_warnings() {
    lint(&elaborate(&counter()).expect("the module has no fault"));
    lint(&elaborate(&pacer()).expect("the module has no fault"));
    lint(&elaborate(&queue()).expect("the module has no fault"));
}

/// What a module with the ports of [`counter`] shows, run in Icarus: count and delayed count in each cycle.
fn run_counter(module: &str, verilog: &str) -> Vec<[u64; 2]> {
    let bench = format!(
        "module bench;
        reg clk = 0, rst = 1, enable = 0;
        wire [7:0] count, delayed;
        {module} dut (.clk(clk), .rst(rst), .enable(enable), .count(count), .delayed(delayed));
        integer cycle;
        initial begin
            #1 clk = 1; #1 clk = 0; rst = 0; enable = 1;
            for (cycle = 0; cycle < 42; cycle = cycle + 1) begin
                #1 clk = 1; #1 clk = 0;
                $display(\"%0d %0d\", count, delayed);
            end
        end
        endmodule"
    );
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    std::fs::write(folder.path().join("bench.v"), format!("{verilog}\n{bench}")).expect("it can be written");
    let built = run("iverilog", &["-s", "bench", "-o", "bench", "bench.v"], folder.path());
    assert!(built.status.success(), "{built:?}");
    let printed = String::from_utf8_lossy(&run("vvp", &["-n", "bench"], folder.path()).stdout).into_owned();
    let number = |word: &str| word.parse().unwrap_or_else(|_| panic!("{word} is no number in {printed}"));
    let row = |line: &str| line.split_once(' ').map(|(count, delayed)| [number(count), number(delayed)]);
    printed.lines().filter_map(row).collect()
}

/// From the first on, one strobe in so many cycles is counted, and the delayed count is that of the cycle before.
fn check_counts(seen: &[[u64; 2]], first: u64) {
    assert_eq!(seen.len(), 42);
    for (cycle, row) in seen.iter().enumerate() {
        let strobes = (cycle as u64 + CYCLES).saturating_sub(first) / CYCLES;
        let before = if cycle == 0 { 0 } else { seen[cycle - 1][0] };
        assert_eq!(*row, [strobes, before], "cycle {cycle}");
    }
}

#[test]
fn a_widget_in_our_module_runs() {
    let design = elaborate(&counter()).expect("the module has no fault");
    check_counts(&run_counter(design.top(), design.verilog()), CYCLES);
}

/// The counter as a block of rust-hdl.
#[derive(LogicBlock, Default)]
struct Counter {
    pub clk: Signal<In, Clock>,
    pub rst: Signal<In, Bit>,
    pub enable: Signal<In, Bit>,
    pub count: Signal<Out, Bits<8>>,
    pub delayed: Signal<Out, Bits<8>>,
}

impl Logic for Counter {
    fn update(&mut self) {}

    fn connect(&mut self) {
        self.count.connect();
        self.delayed.connect();
    }

    fn hdl(&self) -> Verilog {
        elaborate(&counter()).expect("the module has no fault").wrapper()
    }
}

/// A rust-hdl design that enables the counter when it is told to, a cycle later.
#[derive(LogicBlock, Default)]
struct Around {
    pub clk: Signal<In, Clock>,
    pub rst: Signal<In, Bit>,
    pub enable: Signal<In, Bit>,
    pub count: Signal<Out, Bits<8>>,
    pub delayed: Signal<Out, Bits<8>>,
    late: DFF<Bit>,
    counter: Counter,
}

impl Logic for Around {
    #[hdl_gen]
    fn update(&mut self) {
        self.late.clock.next = self.clk.val();
        self.late.d.next = self.enable.val();
        self.counter.clk.next = self.clk.val();
        self.counter.rst.next = self.rst.val();
        self.counter.enable.next = self.late.q.val();
        self.count.next = self.counter.count.val();
        self.delayed.next = self.counter.delayed.val();
    }
}

#[test]
fn our_module_in_a_rust_hdl_design_runs() {
    let design = elaborate(&counter()).expect("the module has no fault");
    assert_eq!(design.check_block(&Counter::default()), Ok(()));
    let mut around = Around::default();
    around.connect_all();
    check_counts(&run_counter("top", &generate_verilog(&around)), CYCLES + 1);
}

#[test]
fn widths_and_ports_of_blocks_are_checked() {
    let mut m = Module::new("wrong", "Connects a widget wrongly.");
    let wide = m.input("wide", 3);
    let pace = m.instance("pace", pacer());
    m.connect(pace, "enable", wide);
    m.connect(pace, "clock", wide);
    m.reset_by(pace, wide.bit(0));
    let kinds: Vec<FaultKind> =
        elaborate(&m).expect_err("it has faults").faults.into_iter().map(|fault| fault.kind).collect();
    assert!(matches!(kinds[0], FaultKind::Width { width: 1, driver_width: 3, .. }), "{kinds:?}");
    assert!(matches!(&kinds[1], FaultKind::UnknownPort { port, .. } if port == "clock"), "{kinds:?}");
    assert!(matches!(&kinds[2], FaultKind::UnknownPort { port, .. } if port == "rst"), "{kinds:?}");
    assert_eq!(kinds.len(), 3);
}

#[test]
fn registers_of_blocks_end_combinational_paths() {
    let design = elaborate(&Module::from_block("dff", "A register.", DFF::<Bit>::default())).expect("it has no fault");
    assert_eq!(design.combinational_paths(), []);
    let design = elaborate(&pacer()).expect("the module has no fault");
    assert_eq!(design.combinational_paths(), [("enable".to_owned(), "strobe".to_owned())]);
}

/// Leaves the input of its register open.
#[derive(LogicBlock, Default)]
struct Open {
    pub clock: Signal<In, Clock>,
    pub q: Signal<Out, Bit>,
    register: DFF<Bit>,
}

impl Logic for Open {
    #[hdl_gen]
    fn update(&mut self) {
        self.register.clock.next = self.clock.val();
        self.q.next = self.register.q.val();
    }
}

/// Has two clocks.
#[derive(LogicBlock, Default)]
struct Crossing {
    pub write_clock: Signal<In, Clock>,
    pub read_clock: Signal<In, Clock>,
    pub d: Signal<In, Bit>,
    pub q: Signal<Out, Bit>,
    write: DFF<Bit>,
    read: DFF<Bit>,
}

impl Logic for Crossing {
    #[hdl_gen]
    fn update(&mut self) {
        self.write.clock.next = self.write_clock.val();
        self.read.clock.next = self.read_clock.val();
        self.write.d.next = self.d.val();
        self.read.d.next = self.write.q.val();
        self.q.next = self.read.q.val();
    }
}

#[test]
fn what_rust_hdl_has_against_a_block_is_a_fault() {
    let faults = |module: Module| elaborate(&module).expect_err("it has faults").to_string();
    let open = faults(Module::from_block("open", "Leaves an input open.", Open::default()));
    assert!(open.contains("nothing drives `uut$register$d`"), "{open}");
    let crossing = faults(Module::from_block("crossing", "Has two clocks.", Crossing::default()));
    assert!(crossing.contains("one clock is all there is here, not write_clock and read_clock"), "{crossing}");
}

#[test]
fn blocks_that_differ_are_told_apart_and_others_are_one() {
    let mut m = Module::new("registers", "Registers of two widths.");
    for (name, wide) in [("first", false), ("second", false), ("third", true)] {
        let width = if wide { 8 } else { 4 };
        let d = m.input(&format!("{name}_d"), width);
        let mut register = match wide {
            true => Module::from_block("dff", "rust-hdl's register.", DFF::<Bits<8>>::default()),
            false => Module::from_block("dff", "rust-hdl's register.", DFF::<Bits<4>>::default()),
        };
        register.variant("width", width);
        let child = m.instance(name, register);
        m.connect(child, "d", d);
        let q = m.out(child, "q");
        m.output(&format!("{name}_out"), q);
    }
    let design = elaborate(&m).expect("the module has no fault");
    let names: Vec<(&str, u64)> = design.modules().iter().map(|part| (part.name.as_str(), part.instances)).collect();
    assert_eq!(names, [("dff_w4", 2), ("dff_w8", 1), ("registers", 1)]);
    lint(&design);
}
