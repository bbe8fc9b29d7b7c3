//! The programs of the library, each a design of its own.

use super::{Case, agree};
use pointcore_contract::Format;
use pointcore_contract::process::Program;
use pointcore_contract::process::library::{PROGRAMS, program};
use pointcore_tb::lockstep::seed;

const F32: Format = Format::F32.flushed();

fn library(name: &str, format: Format, rate: u32) {
    let seed = seed().expect("the seed is a number");
    for (unit, counts) in agree(vec![Case { program: program(name), format, rate }], seed) {
        counts.check(&unit);
    }
}

macro_rules! programs {
    ($($name:ident: $format:expr, $rate:expr;)*) => {
        $(#[test]
        fn $name() {
            library(stringify!($name), $format, $rate);
        })*

        #[test]
        fn every_program_is_compared() {
            let compared = [$(stringify!($name)),*];
            assert!(PROGRAMS.iter().map(|(name, _)| *name).eq(compared), "{compared:?}");
        }
    };
}

programs! {
    covariance: F32, 1;
    normals: Format::F24.flushed(), 2;
    mls: F32, 1;
    apss: Format::F32, 1;
    smooth: F32, 2;
    resample: Format::F24, 1;
    sph_density: F32, 1;
    sph_forces: F32, 3;
}

/// Names of a text that mean something in Verilog, or are those of ports.
#[test]
fn any_name_of_a_text_can_become_hardware() {
    let names = ["module", "wire", "reg", "in_valid", "out_ready", "clk", "phase", "output_w", "begin", "table"];
    let chain = |first: &str| {
        let from = std::iter::once(&first).chain(&names);
        let lines = names.iter().zip(from).map(|(name, from)| format!("{name} = add {from}, 1.5\n"));
        lines.collect::<String>()
    };
    let text = format!(
        ".program endmodule\n.kernel\n{}accumulate input, table\n.final\n{}output w, table\noutput assign, input\n",
        chain("neighbor.position.x"),
        chain("input"),
    );
    let program = Program::parse("names.pasm", &text).unwrap_or_else(|error| panic!("{error}"));
    agree(vec![Case { program, format: Format::F24, rate: 1 }], 1);
}
