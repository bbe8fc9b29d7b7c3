//! Every kind of fault is found, with the line that made it, the path of its module and the names of its signals.

use std::rc::Rc;

use rtl::{FaultKind, Module, bit, cat, elaborate, lit};

/// A module that is right but for what a test adds.
fn sound() -> Module {
    let mut m = Module::new("unit", "A unit.");
    let a = m.input("a", 8);
    m.output("y", a);
    m
}

/// The faults, as text, of a module two levels below the top.
fn faults_of(m: Module) -> Vec<String> {
    let mut middle = Module::new("middle", "Holds the unit.");
    let unit = m.into();
    let unit: Rc<Module> = unit;
    let inner = middle.instance("inner", unit);
    middle.connect(inner, "a", lit(8, 0));
    let mut top = Module::new("top", "Holds the middle.");
    top.instance("outer", middle);
    let error = elaborate(&top).expect_err("the module is faulty");
    error.faults.iter().map(|fault| format!("{}: {}", fault.path, fault.kind)).collect()
}

/// The lines of this file that made the faults of a module, in their order.
fn lines_of(m: &Module) -> Vec<u32> {
    let faults = elaborate(m).expect_err("the module is faulty").faults;
    assert!(faults.iter().all(|fault| fault.place.file() == file!()), "{faults:?}");
    faults.iter().map(|fault| fault.place.line()).collect()
}

#[test]
fn sound_modules_have_no_fault() {
    assert!(elaborate(&sound()).is_ok());
}

#[test]
fn width_mismatch_in_an_expression() {
    let mut m = sound();
    let b = m.input("b", 9);
    let a = m.input("c", 8);
    m.output("sum", a + b);
    let mismatch = "top/outer/inner: output `sum`: width mismatch in `c + b`: 8 and 9 bits";
    assert!(faults_of(m).contains(&mismatch.into()));
}

#[test]
fn width_mismatch_of_a_driver() {
    let mut m = sound();
    let wire = m.forward("late", 4);
    m.drive(wire, lit(5, 0));
    let mismatch = "top/outer/inner: width mismatch: `late` has 4 bits, its driver `5'd0` has 5";
    assert_eq!(faults_of(m), [mismatch]);
}

#[test]
fn impossible_bits_and_literals() {
    let mut m = sound();
    let c = m.wire("c", lit(8, 1));
    m.output("bits", c.bits(8, 1));
    m.output("literal", lit(3, 8));
    let expected = [
        "top/outer/inner: output `bits`: `c` has 8 bits and no [8:1]",
        "top/outer/inner: output `literal`: literal 8 does not fit 3 bits",
    ];
    assert_eq!(faults_of(m), expected);
}

#[test]
fn streams_that_are_not_declared() {
    let mut top = Module::new("top", "Asks for a stream.");
    let mut child = Module::new("child", "Has a port that looks like a stream's.");
    child.output("out_valid", bit(true));
    let child = top.instance("inner", child);
    top.stream_from(child, "out");
    let error = elaborate(&top).expect_err("the child declares no stream");
    let faults: Vec<_> = error.faults.iter().map(ToString::to_string).collect();
    let expected = "top: instance `inner` of `child` has no output stream `out`";
    assert!(faults[0].starts_with(file!()) && faults[0].ends_with(expected), "{faults:?}");
}

#[test]
fn undriven_wires_registers_and_memories() {
    let mut m = sound();
    m.forward("wire_1", 4);
    m.reg("register_1", 4);
    m.memory("memory_1", 4, 4);
    let faults = faults_of(m);
    for (fault, name) in faults.iter().zip(["wire_1", "register_1", "memory_1"]) {
        assert_eq!(*fault, format!("top/outer/inner: `{name}` is never driven"));
    }
    assert_eq!(faults.len(), 3);
}

#[test]
fn doubly_driven_wires_registers_memories_and_inputs() {
    let mut m = Module::new("top", "Drives everything twice.");
    let wire = m.forward("wire_1", 4);
    let register = m.reg("register_1", 4);
    let memory = m.memory("memory_1", 16, 4);
    let child = m.instance("child", sound());
    for _ in 0..2 {
        m.drive(wire, lit(4, 0));
        m.next(register, lit(4, 0));
        m.write(memory, bit(true), lit(4, 0), lit(4, 0));
        m.connect(child, "a", lit(8, 0));
    }
    let faults = elaborate(&m).expect_err("the module is faulty").faults;
    let expected = ["wire_1", "register_1", "memory_1", "child.a"].map(|name| FaultKind::DoublyDriven(name.into()));
    assert_eq!(faults.into_iter().map(|fault| fault.kind).collect::<Vec<_>>(), expected);
}

#[test]
fn unconnected_and_unknown_ports() {
    let mut m = Module::new("top", "Forgets an input.");
    let child = m.instance("child", sound());
    m.connect(child, "b", lit(8, 0));
    m.out(child, "a");
    let unknown = |direction, port: &str| FaultKind::UnknownPort {
        instance: "child".into(),
        unit: "unit".into(),
        direction,
        port: port.into(),
    };
    let open = FaultKind::Unconnected { instance: "child".into(), port: "a".into() };
    let faults = elaborate(&m).expect_err("the module is faulty").faults;
    let expected = [unknown("input", "b"), unknown("output", "a"), open];
    assert_eq!(faults.into_iter().map(|fault| fault.kind).collect::<Vec<_>>(), expected);
}

#[test]
fn clashing_and_unusable_names() {
    let mut m = sound();
    m.wire("twice", lit(1, 0));
    m.reg("twice", 1);
    m.wire("always", lit(1, 0));
    m.wire("9lives", lit(1, 0));
    let faults = faults_of(m);
    assert!(faults.contains(&"top/outer/inner: the name `twice` is used twice".into()));
    for name in ["always", "9lives"] {
        let start = format!("top/outer/inner: `{name}` cannot be a name: ");
        assert!(faults.iter().any(|fault| fault.starts_with(&start)), "{faults:?}");
    }
}

#[test]
fn signals_and_handles_of_another_module() {
    let mut other = Module::new("other", "Lends a signal.");
    let lent = other.input("lent", 8);
    let register = other.reg("register_1", 8);
    let mut m = Module::new("top", "Borrows it.");
    m.output("y", lent);
    m.next(register, lit(8, 0));
    let faults = elaborate(&m).expect_err("the module is faulty").faults;
    let borrowed = FaultKind::ForeignSignal { user: "output `y`".into(), signal: "lent".into() };
    let expected = [FaultKind::ForeignHandle("register_1".into()), borrowed];
    assert_eq!(faults.into_iter().map(|fault| fault.kind).collect::<Vec<_>>(), expected);
}

#[test]
fn loop_within_a_module() {
    let mut m = sound();
    let first = m.forward("first", 1);
    let second = m.wire("second", !first);
    m.drive(first, second & bit(true));
    assert_eq!(faults_of(m), ["top/outer/inner: combinational loop: first -> second -> first"]);
}

#[test]
fn loop_through_an_instance() {
    let mut m = Module::new("top", "Feeds a child its own output.");
    let child = m.instance("child", sound());
    let y = m.out(child, "y");
    let back = m.wire("back", !y);
    m.connect(child, "a", back);
    let faults = elaborate(&m).expect_err("the module is faulty").faults;
    assert_eq!(faults.len(), 1);
    assert_eq!(faults[0].kind, FaultKind::Loop("child_y -> back -> child_y".into()));
}

#[test]
fn registers_cut_loops_and_paths() {
    let mut m = Module::new("top", "Has one path and one cut path.");
    let (a, b) = (m.input("a", 1), m.input("b", 1));
    let register = m.reg_reset("register_1", 1, 0);
    m.next(register, !register ^ a);
    m.output("cut", register);
    m.output("path", register & b);
    m.output("gated", !m.rst());
    let design = elaborate(&m).expect("the module has no fault");
    let paths = [("b", "path"), ("rst", "gated")].map(|(input, output)| (input.to_string(), output.to_string()));
    assert_eq!(design.combinational_paths(), paths);
}

#[test]
fn all_faults_of_a_design_are_reported_together() {
    let mut m = sound();
    let open = line!() + 1;
    m.forward("open", 1);
    let mut top = Module::new("top", "Has a fault of its own.");
    let child = top.instance("child", m);
    top.connect(child, "a", lit(7, 0));
    top.reg("idle", 1);
    let text = elaborate(&top).expect_err("the design is faulty").to_string();
    let lines: Vec<&str> = text.lines().collect();
    let here = |line: u32| format!("  {}:{line}: ", file!());
    let expected = [
        "the design has 3 fault(s)".to_owned(),
        here(open) + "top/child: `open` is never driven",
        here(open + 3) + "top: width mismatch: `child.a` has 8 bits, its driver `7'd0` has 7",
        here(open + 4) + "top: `idle` is never driven",
    ];
    assert_eq!(lines, expected);
}

#[test]
fn faults_name_the_lines_that_made_them() {
    let mut m = sound();
    let c = m.input("c", 8);
    let first = line!();
    m.output("sum", c + lit(7, 0));
    m.output("method", c.eq(lit(9, 0)));
    m.output("slice", c.bits(9, 2));
    m.output("choice", c.mux(c, c));
    m.output("pick", c.pick([c, lit(8, 0)]) & cat([c, c]));
    m.output("negated", !(c ^ lit(3, 8)));
    m.wire("c", c);
    assert_eq!(lines_of(&m), [7, 1, 2, 3, 4, 5, 6].map(|lines| first + lines));
}

#[test]
fn what_is_open_is_named_where_it_was_declared() {
    let mut m = Module::new("top", "Leaves everything open.");
    let first = line!();
    m.forward("wire_1", 4);
    m.reg("register_1", 4);
    m.memory("memory_1", 4, 4);
    m.instance("child", sound());
    let around = m.forward("around", 1);
    m.drive(around, !around);
    let lines = lines_of(&m);
    assert_eq!(lines, [1, 2, 3, 4, 5].map(|lines| first + lines));
}

#[test]
fn an_expression_that_outlives_its_modules_is_a_fault() {
    let lent = Module::new("gone", "Lends a signal and goes.").input("lent", 8);
    let mut m = Module::new("top", "Borrows it.");
    let line = line!() + 1;
    m.output("y", lent);
    let faults = elaborate(&m).expect_err("the module is faulty").faults;
    assert_eq!(lines_of(&m), [line]);
    let message = "the expression was made for modules that are gone";
    assert!(faults[0].kind.to_string().contains(message), "{faults:?}");
}
