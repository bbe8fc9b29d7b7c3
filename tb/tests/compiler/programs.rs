//! Programs written by hand.

use super::interpreter::interpret;
use super::model::{build, compile_all, run};
use fastrand::Rng;
use pointcore_contract::{Fixed, Format, Signedness};
use pointcore_hdl::compiler::{CompileError, Datapath, OperatorUse, Options, Program, Type, Value, compile};
use pointcore_tb::lockstep::{Stall, seed};
use rtl::{Design, elaborate};

const F32: Type = Type::Float(Format::F32);

fn at(program: &Program, initiation_interval: u32) -> Datapath {
    compile(program, &Options::default().with_interval(initiation_interval)).unwrap_or_else(|error| panic!("{error}"))
}

fn design(datapath: &Datapath) -> Design {
    elaborate(&datapath.module).unwrap_or_else(|error| panic!("{error}"))
}

/// Runs a program at some intervals; returns how many tokens of `tokens` came out of each.
fn transfers(program: &Program, intervals: &[u32], tokens: usize) -> Vec<u64> {
    let graph = program.graph().unwrap_or_else(|error| panic!("{error}"));
    let seed = seed().expect("the seed is a number");
    let programs = intervals.iter().map(|&interval| (graph.clone(), interval)).collect();
    let (design, compiled) = compile_all(programs, &mut Rng::with_seed(seed));
    let report = run(&build(&design), &compiled, &[], tokens, seed, Stall::Random(0.4));
    (0..intervals.len()).map(|index| report.transfers(&format!("out_{index}"))).collect()
}

/// Eight products and their sum.
fn dot8() -> Program {
    let p = Program::new("dot8", "Eight products and their sum.");
    let inputs = |prefix: &str| -> Vec<Value> { (0..8).map(|i| p.input(&format!("{prefix}{i}"), F32)).collect() };
    let (a, b) = (inputs("a"), inputs("b"));
    let sum = a.iter().zip(&b).map(|(&a, &b)| a * b).reduce(|sum, product| sum + product);
    p.output("y", sum.expect("there are eight products"));
    p
}

#[test]
fn operators_write_the_program_they_look_like() {
    let p = Program::new("host", "");
    let (a, b, m) = (p.input("a", F32), p.input("b", F32), p.uniform("m", F32));
    p.output("y", (a * m + b).sqrt() - (-b).abs() / a);
    p.output("z", a.lt(b).mux(a.fma(b, p.float(Format::F32, 0.1)), a.max(b)));
    let graph = p.graph().unwrap();
    for (a, b, m) in [(1.5_f32, 2.5, 3.0), (7.0, -0.25, 0.1), (1e-3, 1e3, 1e-30)] {
        let bits = |x: f32| u64::from(x.to_bits());
        let y = (a * m + b).sqrt() - b.abs() / a;
        let z = if a < b { a.mul_add(b, 0.1) } else { a.max(b) };
        let result = interpret(&graph, &[], &[bits(a), bits(b)], &[bits(m)]).unwrap();
        let expected = if y.is_nan() { Format::F32.quiet_nan() } else { bits(y) };
        assert_eq!(result, [expected, bits(z)], "a = {a}, b = {b}, m = {m}");
    }
}

#[test]
fn operations_share_operators_as_the_interval_allows() {
    for (interval, multipliers, adders) in [(1, 8, 7), (2, 4, 4), (3, 3, 3), (4, 2, 2), (8, 1, 1)] {
        let datapath = at(&dot8(), interval);
        let operators = &datapath.manifest.operators;
        assert_eq!(operators["mul.f32"], OperatorUse { instances: multipliers, operations: 8 }, "interval {interval}");
        assert_eq!(operators["add.f32"], OperatorUse { instances: adders, operations: 7 }, "interval {interval}");
        let design = design(&datapath);
        assert_eq!(instances(&design, "float_mul"), u64::from(multipliers), "interval {interval}");
        assert_eq!(instances(&design, "float_add"), u64::from(adders), "interval {interval}");
    }
    assert_eq!(transfers(&dot8(), &[1, 2, 5, 8], 100), [100; 4]);
}

/// Instances of a unit in a design.
fn instances(design: &Design, unit: &str) -> u64 {
    design.modules().iter().filter(|module| module.unit == unit).map(|module| module.instances).sum()
}

#[test]
fn sums_and_their_products_share_operators() {
    // Complex products: half of the sums are differences.
    let p = Program::new("rotation", "Points in the plane, turned.");
    let [cosine, sine] = ["cosine", "sine"].map(|name| p.input(name, F32));
    for point in 0..4 {
        let [x, y] = ["x", "y"].map(|axis| p.input(&format!("{axis}{point}"), F32));
        p.output(&format!("turned_x{point}"), x * cosine - y * sine);
        p.output(&format!("turned_y{point}"), x * sine + y * cosine);
    }
    let compounds = |program: &Program, interval: u32| {
        let design = design(&at(program, interval));
        ["float_mul", "float_add", "mul_mul_add", "mul_add"].map(|unit| instances(&design, unit))
    };
    assert_eq!(compounds(&p, 1), [16, 8, 0, 0]);
    assert_eq!(compounds(&p, 2), [8, 4, 4, 0]);
    assert_eq!(compounds(&p, 8), [2, 1, 1, 0]);
    assert_eq!(transfers(&p, &[2, 3, 8], 200), [200; 3]);

    // A ninth sum would take operators of its own.
    let p = Program::new("matrices", "Three vectors, each through a matrix.");
    let vector = |name: &str| -> Vec<Value> { (0..3).map(|axis| p.input(&format!("{name}{axis}"), F32)).collect() };
    let rows = ["row0_", "row1_", "row2_"].map(vector);
    for name in ["a", "b", "c"] {
        let vector = vector(name);
        for (axis, row) in rows.iter().enumerate() {
            let products = row.iter().zip(&vector).map(|(&left, &right)| left * right);
            p.output(&format!("turned_{name}{axis}"), products.reduce(|sum, product| sum + product).expect("three"));
        }
    }
    assert_eq!(compounds(&p, 8), [4, 3, 1, 1]);
    assert_eq!(transfers(&p, &[2, 5, 8], 200), [200; 3]);

    // A product that is shown as well is not its sum's alone.
    let p = Program::new("shown", "Sums, and one of each one's products.");
    for term in 0..2 {
        let [a, b, c] = ["a", "b", "c"].map(|name| p.input(&format!("{name}{term}"), F32));
        p.output(&format!("product{term}"), a * b);
        p.output(&format!("sum{term}"), a * b + c);
    }
    assert_eq!(compounds(&p, 2), [1, 1, 0, 0]);
}

#[test]
fn tokens_that_fail_the_condition_are_dropped() {
    let p = Program::new("cull", "Keeps odd numbers below 12.");
    let n = p.input("n", Type::Unsigned(4));
    p.keep_if(n.bits(0, 0));
    p.keep_if(n.lt(p.lit(4, 12)));
    p.output("n", n);
    let kept = transfers(&p, &[1, 3], 400);
    assert!(kept.iter().all(|&kept| (100..200).contains(&kept)), "three in eight of 400 on average, not {kept:?}");
}

#[test]
fn uniforms_are_not_delayed() {
    let transform = |declare: fn(&Program, &str) -> Value| {
        let p = Program::new("transform", "");
        let x = p.input("x", F32);
        let (m, n) = (declare(&p, "m"), declare(&p, "n"));
        p.output("y", x * m - n);
        at(&p, 1).manifest
    };
    let uniform = transform(|p, name| p.uniform(name, F32));
    let input = transform(|p, name| p.input(name, F32));
    assert_eq!(uniform.latency, input.latency);
    assert_eq!(uniform.register_bits, u64::from(uniform.latency), "only the token's validity is held");
    assert!(input.register_bits > uniform.register_bits);
}

#[test]
fn long_delays_become_memory_and_agree() {
    let p = Program::new("waiting", "A value that waits for a quotient.");
    let (a, b) = (p.input("a", F32), p.input("b", F32));
    p.output("y", ((a / b).sqrt() + a).sqrt() * b);
    let delayed = at(&p, 1).manifest;
    assert!(delayed.delay_memory_bits > u64::from(delayed.latency) * 16, "{delayed:?}");
    assert!(delayed.register_bits < u64::from(delayed.latency) * 8, "{delayed:?}");
    let shared = at(&p, 2).manifest;
    assert!(shared.delay_memory_bits < delayed.delay_memory_bits, "a register holds a value for two cycles");
    assert_eq!(transfers(&p, &[1, 2, 3], 200), [200; 3]);
}

#[test]
fn a_program_without_operations_is_a_queue() {
    let p = Program::new("pass", "Nothing.");
    let x = p.input("x", Type::Signed(7));
    let _unused = p.input("unused", F32);
    p.output("x", x);
    p.output("m", p.uniform("m", Type::BOOL));
    p.output("c", p.lit(3, 5));
    assert_eq!((at(&p, 1).manifest.latency, at(&p, 4).manifest.latency), (1, 1));
    assert_eq!(transfers(&p, &[1, 4], 100), [100; 2]);
}

#[test]
fn integers_of_every_kind_agree() {
    let p = Program::new("integers", "Sums, products and comparisons of integers, chained.");
    let (a, b) = (p.input("a", Type::Signed(31)), p.input("b", Type::Signed(31)));
    let (c, d) = (p.input("c", Type::Unsigned(32)), p.input("d", Type::Unsigned(16)));
    p.output("product", a * b);
    p.output("wide", c * d);
    p.output("chain", -(a + b).min(a - b).max(b) + (a >> 3));
    p.output("flags", a.lt(b).cat(c.le(d.zext(32))).cat(a.eq(b)));
    p.output("sum64", c.zext(64) + (d.zext(64) << 40));
    p.output(
        "float",
        (a * b).to_float(Format::F32, 20).to_fixed(Fixed { width: 20, fraction: 3, signed: Signedness::Signed }),
    );
    assert_eq!(transfers(&p, &[1, 2], 300), [300; 2]);
}

#[test]
fn the_same_program_gives_the_same_bytes() {
    let text = || design(&at(&dot8(), 3)).verilog().to_owned();
    assert_eq!(text(), text());
}

#[test]
fn stages_can_be_chosen() {
    let p = Program::new("square", "");
    let x = p.input("x", F32);
    p.output("y", x * x);
    let latency = |stages| {
        let mut options = Options::default();
        options.stages = options.stages.with("mul.f32", stages);
        compile(&p, &options).unwrap().manifest.latency
    };
    assert_eq!((latency(2), latency(3)), (2, 3));
}

#[test]
fn mistakes_are_reported_with_names() {
    let mistake = |build: fn(&Program)| {
        let p = Program::new("unit", "");
        build(&p);
        compile(&p, &Options::default()).err().expect("the program is wrong").to_string()
    };
    let text = mistake(|p| p.output("y", p.input("a", F32) + p.input("b", Type::Float(Format::F16))));
    assert_eq!(text, "unit: `add` of a: f32, b: f16: operands must have one type");
    let text = mistake(|p| p.output("y", p.input("n", Type::Unsigned(40)).cat(p.input("m", F32)).sqrt()));
    assert_eq!(text, "unit: `concat` would be 72 bits wide; values have 1 to 64 bits");
    let text = mistake(|p| p.keep_if(p.input("n", Type::Unsigned(2)).named("flag")));
    assert_eq!(text, "unit: `keep_if` of n: u2: the condition must be u1");
    let text = mistake(|p| p.output("y", p.input("a", F32).bits(32, 0)));
    assert_eq!(text, "unit: `bits` of a: f32: bits must lie within the operand");
    let text = mistake(|p| p.output("y", p.lit(3, 8)));
    assert_eq!(text, "unit: constant 0x8 does not fit type u3");
    let text = mistake(|p| p.output("y", p.input("a", F32) & p.input("a", F32)));
    assert_eq!(text, "unit: `a` cannot name a port: it is taken");
    let text = mistake(|p| p.output("Y", p.input("a", F32)));
    assert!(text.contains("`Y` cannot name a port: it must be lower-case"), "{text}");
    let text = mistake(|p| p.output("y", p.input("a", F32) + Program::new("other", "").float(Format::F32, 1.0)));
    assert_eq!(text, "unit: `add` takes a value of another program, `other`");
    let text = mistake(|p| _ = p.input("a", F32));
    assert_eq!(text, "unit: the program has no output; call `output`");
    let p = dot8();
    let error = compile(&p, &Options::default().with_interval(0)).err();
    assert!(matches!(error, Some(CompileError::InitiationInterval { initiation_interval: 0, .. })));
}
