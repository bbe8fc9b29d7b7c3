//! Random programs, as texts: every operation of the language on values of every kind.

use super::{Case, agree};
use fastrand::Rng;
use pointcore_contract::Format;
use pointcore_contract::process::Program;
use pointcore_tb::lockstep::{SEED_VARIABLE, seeds};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Operations with the types of their operands and of their results: float, vector, int, bool.
const OPERATIONS: &str = "add ff f, add vv v, add ii i, sub ff f, sub vv v, sub ii i, mul ff f, mul ii i, scale vf v, \
    fma fff f, div ff f, recip f f, sqrt f f, rsqrt f f, exp_neg f f, min ff f, min ii i, max ff f, max ii i, abs f f, \
    neg f f, neg v v, neg i i, dot vv f, cross vv v, length2 v f, length v f, vector fff v, less ff b, less ii b, \
    less_or_equal ff b, less_or_equal ii b, equal ff b, equal ii b, and bb b, and ii i, or bb b, or ii i, xor bb b, \
    xor ii i, not b b, not i i, select bff f, select bvv v, select bii i, select bbb b, to_float i f, to_int f i";

/// Programs that are compared.
const PROGRAMS: usize = 4;
/// Operations of each block.
const STATEMENTS: usize = 20;

/// Values by type, and which of them something uses.
struct Block<'a> {
    rng: &'a mut Rng,
    text: String,
    values: Vec<(char, String)>,
    used: BTreeSet<String>,
    /// Operations that no program has yet, which have their turn first.
    waiting: &'a mut Vec<&'static str>,
}

impl Block<'_> {
    fn of(&self, ty: char) -> Vec<String> {
        self.values.iter().filter(|(other, _)| *other == ty).map(|(_, name)| name.clone()).collect()
    }

    /// A value of a type, or a literal.
    fn operand(&mut self, ty: char) -> String {
        let literals: &[&str] = match ty {
            'f' => &["1.5", "-0.25", "0.0", "3.0e-3"],
            'i' => &["0", "7", "-2147483648"],
            'b' => &["true", "false"],
            _ => &[],
        };
        let names = self.of(ty);
        if names.is_empty() || !literals.is_empty() && self.rng.u32(..8) == 0 {
            return literals[self.rng.usize(..literals.len())].to_owned();
        }
        let name = names[self.rng.usize(..names.len())].clone();
        self.used.insert(name.clone());
        name
    }

    fn operation(&mut self, index: usize) {
        let all: Vec<&'static str> = OPERATIONS.split(',').map(str::trim).collect();
        let line = self.waiting.pop().unwrap_or_else(|| all[self.rng.usize(..all.len())]);
        let parts: Vec<&str> = line.split(' ').collect();
        let [name, operands, result] = parts[..] else { panic!("{line}") };
        let operands: Vec<String> = operands.chars().map(|ty| self.operand(ty)).collect();
        let value = format!("v{index}");
        writeln!(self.text, "{value} = {name} {}", operands.join(", ")).expect("texts can be written");
        self.values.push((result.chars().next().expect("a result has a type"), value));
    }

    /// Values that nothing uses.
    fn unused(&self) -> Vec<(char, String)> {
        let own = self.values.iter().filter(|(_, name)| name.starts_with('v') && !self.used.contains(name));
        own.cloned().collect()
    }
}

fn text(rng: &mut Rng, waiting: &mut Vec<&'static str>) -> String {
    let mut text = ".program random\n.setting sf: float\n.setting sv: float3\n.setting si: int\n.setting sb: bool\n\
        .query f: float\n.query i: int\n.query b: bool\n.neighbor v: float3\n.neighbor i: int\n\
        .neighbor b: bool\n.state tf: float\n.state tv: float3\n.state ti: int\n.state tb: bool\n"
        .to_owned();
    let common = "f sf, v sv, i si, b sb, f tf, v tv, i ti, b tb, v query.position, f query.f, i query.i, b query.b";
    let values = |more: &str| -> Vec<(char, String)> {
        let all = format!("{common}, {more}");
        let pair = |part: &str| {
            let (ty, name) = part.split_once(' ').expect("a type and a name");
            (ty.chars().next().expect("a type"), name.to_owned())
        };
        all.split(", ").map(pair).collect()
    };
    let mut sums = vec![];
    for (section, more) in [
        ("init", "v farthest.position, v farthest.v, i farthest.i, b farthest.b, i count"),
        ("kernel", "v neighbor.position, v neighbor.v, f neighbor.position.y, i neighbor.i, b neighbor.b"),
        ("final", "i count, i neighbors, f query.position.z"),
    ] {
        let mut values = values(more);
        if section == "final" {
            values.extend(std::mem::take(&mut sums));
        }
        let mut block = Block { rng, text: String::new(), values, used: BTreeSet::new(), waiting };
        (0..STATEMENTS).for_each(|index| block.operation(index));
        let mut end = String::new();
        if section == "kernel" {
            for (ty, name) in block.unused() {
                let is_truth = ty == 'b';
                if is_truth {
                    writeln!(end, "n{name} = select {name}, 1, 0").expect("texts can be written");
                }
                let value = if is_truth { format!("n{name}") } else { name.clone() };
                writeln!(end, "accumulate sum_{name}, {value}").expect("texts can be written");
                sums.push((if is_truth { 'i' } else { ty }, format!("sum_{name}")));
            }
        } else {
            for (ty, state) in [('f', "tf"), ('v', "tv"), ('i', "ti"), ('b', "tb")] {
                let (value, condition) = (block.operand(ty), block.operand('b'));
                let condition = if block.rng.bool() { format!(" if {condition}") } else { String::new() };
                writeln!(end, "store {state}, {value}{condition}").expect("texts can be written");
            }
        }
        if section == "final" {
            let [position, moves, done, search] = ['v', 'b', 'b', 'b'].map(|ty| block.operand(ty));
            writeln!(end, "move {position} if {moves}\ndone {done}\nsearch {search}").expect("texts can be written");
            for (_, name) in block.unused() {
                writeln!(end, "output {name}, {name}").expect("texts can be written");
            }
        }
        text += &format!(".{section}\n{}{end}", block.text);
    }
    text
}

#[test]
fn random_programs_agree_in_every_cycle() {
    let formats = [Format::F32, Format::F24, Format::F32.flushed(), Format::F24.flushed()];
    for seed in seeds(1).expect("the seed is a number") {
        println!("{SEED_VARIABLE}={seed} cargo test -p pointcore-tb --test units process::generator");
        let mut rng = Rng::with_seed(seed);
        let mut waiting: Vec<&'static str> = OPERATIONS.split(',').map(str::trim).collect();
        let case = |index: usize| {
            let text = text(&mut rng, &mut waiting);
            let program = Program::parse("random.pasm", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
            Case { program, format: formats[index % formats.len()], rate: 1 + index as u32 % 3 }
        };
        let cases = (0..PROGRAMS).map(case).collect();
        assert!(waiting.is_empty(), "no program has {waiting:?}");
        agree(cases, seed);
    }
}
