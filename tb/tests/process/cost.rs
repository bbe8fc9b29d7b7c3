//! What operators the programs of the thesis' table 6.2 take.

use pointcore_contract::Format;
use pointcore_contract::process::{Section, library};
use pointcore_hdl::compiler::{Manifest, Options};
use pointcore_hdl::process::program::{datapath, interval};

const FORMAT: Format = Format::F32;

/// Operators by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Operators {
    add: u32,
    mul: u32,
    /// Quotients and reciprocals.
    div: u32,
    /// Roots and their reciprocals.
    sqrt: u32,
}

/// Operators of all blocks at a rate, and the adders that accumulate the sums, shared as the kernel's are.
fn operators(name: &str, rate: u32) -> Operators {
    let program = library::program(name);
    let sums = program.sums.len() as u32;
    let mut all = Operators { add: sums.div_ceil(rate), mul: 0, div: 0, sqrt: 0 };
    for section in Section::ALL.into_iter().filter(|&section| !program.results(section).is_empty()) {
        let datapath = datapath(&program, section, FORMAT, rate, &Options::default());
        let Manifest { initiation_interval, operators, .. } =
            datapath.unwrap_or_else(|error| panic!("{error}")).manifest;
        assert_eq!(initiation_interval, interval(section, rate));
        for (class, used) in operators {
            let kind = match class.split_once('.').expect("a class is a kind and a format").0 {
                "add" => &mut all.add,
                "mul" => &mut all.mul,
                "div" | "recip" => &mut all.div,
                "sqrt" | "rsqrt" => &mut all.sqrt,
                "lt" | "le" | "equal" | "min" | "max" => continue,
                other => panic!("{name}: the table has no {other}"),
            };
            *kind += used.instances;
        }
    }
    all
}

#[test]
fn programs_take_no_more_operators_than_the_thesis() {
    let covariance = Operators { add: 38, mul: 49, div: 2, sqrt: 2 };
    let mls = Operators { add: 29, mul: 32, div: 3, sqrt: 2 };
    for (name, thesis) in [("covariance", covariance), ("mls", mls)] {
        for rate in [1, 2] {
            let own = operators(name, rate);
            let is_within = |own: u32, thesis: u32| rate * own <= thesis;
            let within = is_within(own.add, thesis.add) && is_within(own.mul, thesis.mul);
            let within = within && is_within(own.div, thesis.div) && is_within(own.sqrt, thesis.sqrt);
            assert!(within, "{name} takes {own:?} at a neighbor in {rate} cycles, table 6.2 {thesis:?} at one a cycle");
        }
    }
}

/// More is a change to know of, and so is less.
#[test]
fn the_page_has_the_operators_that_there_are() {
    let page = include_str!("../../../docs/programs.md");
    for (name, shown) in [("covariance", "covariance"), ("mls", "`mls`")] {
        for (rate, pace) in [(1, "a neighbor a cycle"), (2, "one in two cycles")] {
            let Operators { add, mul, div, sqrt } = operators(name, rate);
            let row = format!("| {shown}, {pace} | {add} | {mul} | {div} | {sqrt} |");
            assert!(page.contains(&row), "docs/programs.md has not: {row}");
        }
    }
}
