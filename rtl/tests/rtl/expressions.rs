//! Random expressions mean in Verilog what they mean in plain integers.

use std::fmt::Write as _;

use rtl::{Expr, Module, cat, elaborate, lit};

use crate::lint::{lint_but, run};

const INPUT_WIDTHS: [u32; 4] = [1, 3, 8, 13];
const TREES: usize = 80;
const VECTORS: usize = 40;
/// Trees wider than this are cut down, so that plain integers hold them.
const WIDEST: u32 = 48;

/// A small reproducible generator (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, bound: u32) -> u32 {
        (self.next() % u64::from(bound)) as u32
    }
}

fn mask(width: u32) -> u128 {
    (1 << width) - 1
}

fn signed(value: u128, width: u32) -> i128 {
    if value >> (width - 1) & 1 == 1 { value as i128 - (1 << width) } else { value as i128 }
}

/// An expression and its values for all test vectors, computed side by side.
#[derive(Clone)]
struct Tree {
    expr: Expr,
    values: Vec<u128>,
}

impl Tree {
    fn width(&self) -> u32 {
        self.expr.width()
    }

    fn map(&self, expr: Expr, value: impl Fn(u128) -> u128) -> Self {
        let values = self.values.iter().map(|&a| value(a) & mask(expr.width())).collect();
        Self { expr, values }
    }

    fn zip(&self, other: &Self, expr: Expr, value: impl Fn(u128, u128) -> u128) -> Self {
        let values = self.values.iter().zip(&other.values).map(|(&a, &b)| value(a, b) & mask(expr.width())).collect();
        Self { expr, values }
    }

    fn resized(&self, width: u32) -> Self {
        self.map(self.expr.resize(width), |a| a)
    }

    fn choose(&self, when_true: &Self, when_false: &Self) -> Self {
        let values = (0..self.values.len()).map(|i| if self.values[i] == 1 { when_true } else { when_false }.values[i]);
        Self { expr: self.expr.mux(when_true.expr, when_false.expr), values: values.collect() }
    }
}

fn leaf(random: &mut Random, inputs: &[Tree]) -> Tree {
    if random.below(5) > 0 {
        return inputs[random.below(inputs.len() as u32) as usize].clone();
    }
    let width = 1 + random.below(9);
    let value = [0, mask(width), u128::from(random.next()) & mask(width)][random.below(3) as usize];
    Tree { expr: lit(width, value), values: vec![value; VECTORS] }
}

fn tree(random: &mut Random, inputs: &[Tree], depth: usize) -> Tree {
    if depth == 0 {
        return leaf(random, inputs);
    }
    let a = tree(random, inputs, depth - 1);
    let b = tree(random, inputs, depth - 1);
    let built = if random.below(2) == 0 { one_operand(random, &a) } else { two_operands(random, inputs, &a, &b) };
    if built.width() > WIDEST { built.resized(WIDEST / 2) } else { built }
}

fn one_operand(random: &mut Random, a: &Tree) -> Tree {
    let width = a.width();
    let amount = random.below(width + 2);
    let high = random.below(width);
    let low = random.below(high + 1);
    match random.below(12) {
        0 => a.map(!a.expr, |a| !a),
        1 => a.map(a.expr << amount, |a| a << amount),
        2 => a.map(a.expr >> amount, |a| a >> amount),
        3 => a.map(a.expr.sar(amount), |a| (signed(a, width) >> amount) as u128),
        4 => a.map(a.expr.bits(high, low), |a| a >> low),
        5 => a.map(a.expr.sext(width + amount), |a| signed(a, width) as u128),
        6 => a.map(a.expr.zext(width + amount), |a| a),
        7 => a.map(a.expr.any(), |a| u128::from(a != 0)),
        8 => a.map(a.expr.all(), |a| u128::from(a == mask(width))),
        9 => a.map(a.expr.is_zero(), |a| u128::from(a == 0)),
        10 => a.map(a.expr.repeat(2), |a| a << width | a),
        _ => a.map(a.expr.add_lit(mask(width)), |a| a.wrapping_sub(1)),
    }
}

fn two_operands(random: &mut Random, inputs: &[Tree], a: &Tree, b: &Tree) -> Tree {
    let (width, b_width) = (a.width(), b.width());
    let same = b.resized(width);
    match random.below(19) {
        0 => a.zip(&same, a.expr + same.expr, u128::wrapping_add),
        1 => a.zip(&same, a.expr - same.expr, u128::wrapping_sub),
        2 => a.zip(&same, a.expr & same.expr, |a, b| a & b),
        3 => a.zip(&same, a.expr | same.expr, |a, b| a | b),
        4 => a.zip(&same, a.expr ^ same.expr, |a, b| a ^ b),
        5 => a.zip(b, a.expr * b.expr, |a, b| a * b),
        6 => a.zip(b, a.expr.mul_signed(b.expr), |a, b| (signed(a, width) * signed(b, b_width)) as u128),
        7 => a.zip(&same, a.expr.add_carry(same.expr), |a, b| a + b),
        8 => a.zip(&same, a.expr.eq(same.expr), |a, b| u128::from(a == b)),
        9 => a.zip(&same, a.expr.ne(same.expr), |a, b| u128::from(a != b)),
        10 => a.zip(&same, a.expr.lt(same.expr), |a, b| u128::from(a < b)),
        11 => a.zip(&same, a.expr.le(same.expr), |a, b| u128::from(a <= b)),
        12 => a.zip(&same, a.expr.gt(same.expr), |a, b| u128::from(a > b)),
        13 => a.zip(&same, a.expr.ge(same.expr), |a, b| u128::from(a >= b)),
        14 => a.zip(&same, a.expr.lt_signed(same.expr), |a, b| u128::from(signed(a, width) < signed(b, width))),
        15 => a.zip(b, a.expr.shl_by(b.expr), |a, b| if b < 64 { a << b } else { 0 }),
        16 => a.zip(b, a.expr.shr_by(b.expr), |a, b| if b < 64 { a >> b } else { 0 }),
        17 => a.zip(b, cat([a.expr, b.expr]), |a, b| a << b_width | b),
        _ => {
            let index = inputs[1].clone();
            let third = a.map(!a.expr, |a| !a);
            let entries = [a, &same, &third];
            let expr = index.expr.pick(entries.map(|entry| entry.expr));
            let values = (0..VECTORS).map(|i| entries[(index.values[i] as usize).min(2)].values[i]);
            let picked = Tree { expr, values: values.collect() };
            inputs[0].choose(&picked, &same)
        }
    }
}

/// A simulation that prints every output for every vector.
fn testbench(inputs: &[Tree], trees: &[Tree], top: &str) -> String {
    let mut text = String::from("module testbench;\n");
    let mut ports = vec![];
    for (index, input) in inputs.iter().enumerate() {
        let _ = writeln!(text, "reg [{}:0] i{index};", input.width() - 1);
        ports.push(format!(".i{index}(i{index})"));
    }
    for (index, tree) in trees.iter().enumerate() {
        let _ = writeln!(text, "wire [{}:0] o{index};", tree.width() - 1);
        ports.push(format!(".o{index}(o{index})"));
    }
    let _ = writeln!(text, "{top} uut ({});\ninitial begin", ports.join(", "));
    for vector in 0..VECTORS {
        for (index, input) in inputs.iter().enumerate() {
            let _ = writeln!(text, "i{index} = {};", input.values[vector]);
        }
        text += "#1;\n";
        for index in 0..trees.len() {
            let _ = writeln!(text, "$display(\"%h\", o{index});");
        }
    }
    text + "end\nendmodule\n"
}

#[test]
fn random_expressions_simulate_as_integers_say() {
    let seed = std::env::var("RTL_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let random = &mut Random(seed);
    let mut m = Module::new("random_expressions", "Random expressions over four inputs.");
    let inputs: Vec<Tree> = INPUT_WIDTHS
        .iter()
        .enumerate()
        .map(|(index, &width)| Tree {
            expr: m.input(&format!("i{index}"), width),
            values: (0..VECTORS).map(|_| u128::from(random.next()) & mask(width)).collect(),
        })
        .collect();
    let trees: Vec<Tree> = (0..TREES).map(|index| tree(random, &inputs, 1 + index % 5)).collect();
    for (index, tree) in trees.iter().enumerate() {
        m.output(&format!("o{index}"), tree.expr);
    }
    let design = elaborate(&m).unwrap_or_else(|error| panic!("{error}"));
    // By chance some comparisons always come out alike.
    lint_but(&design, &["-Wno-UNSIGNED", "-Wno-CMPCONST"]);

    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let text = format!("{}\n{}", design.verilog(), testbench(&inputs, &trees, design.top()));
    std::fs::write(folder.path().join("bench.v"), text).expect("a temporary folder can be written");
    let compiled = run("iverilog", &["-o", "bench", "bench.v"], folder.path());
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let output = run("vvp", &["-n", "bench"], folder.path());
    let printed = String::from_utf8(output.stdout).expect("a simulation prints ASCII");
    let printed: Vec<&str> = printed.lines().collect();
    assert_eq!(printed.len(), VECTORS * TREES);
    let again = format!("RTL_SEED={seed} cargo test -p rtl random_expressions");
    for (line, text) in printed.iter().enumerate() {
        let (vector, index) = (line / TREES, line % TREES);
        let value = u128::from_str_radix(text, 16).unwrap_or_else(|_| panic!("o{index} is `{text}`; {again}"));
        let expected = trees[index].values[vector];
        let expr = &trees[index].expr;
        assert_eq!(value, expected, "o{index} = {expr:?} in vector {vector}; {again}\n{}", design.verilog());
    }
}
