//! A lamp that blinks while it is enabled: a counter of a width chosen at run time.
//!
//! `cargo run -p rtl --example blink -- 50000000` prints Verilog for a lamp that changes every so many cycles.

use std::process::ExitCode;

use rtl::{Module, address_width, elaborate, lit};

/// A lamp that changes every `period` enabled cycles.
fn blink(period: u32) -> Module {
    let mut m = Module::new("blink", "A lamp that blinks while it is enabled.");
    m.parameter("period", period);
    let enable = m.input("enable", 1);
    let count = m.reg_reset("count", address_width(period), 0);
    let lamp = m.reg_reset("lamp", 1, 0);

    let last = m.wire("last", count.eq_lit((period - 1).into()));
    m.next_if(count, enable, last.mux(lit(count.width(), 0), count.add_lit(1)));
    m.next(lamp, lamp ^ (enable & last));
    m.output("lamp", lamp);
    m
}

fn main() -> ExitCode {
    let period = std::env::args().nth(1).map_or(Ok(1000), |text| text.parse());
    let Ok(period @ 2..) = period else {
        eprintln!("usage: blink [cycles, at least 2]");
        return ExitCode::FAILURE;
    };
    match elaborate(&blink(period)) {
        Ok(design) => print!("{}", design.verilog()),
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
