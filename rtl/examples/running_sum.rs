//! Streams and modules inside modules: a queue of a depth chosen at run time, and behind it a unit that adds up packets.
//!
//! `cargo run -p rtl --example running_sum -- 16 24` prints Verilog for queues of so many items of so many bits.

use std::process::ExitCode;

use rtl::{Module, address_width, elaborate, lit};

/// A queue of `depth` items of `width` bits with a mark on the last one of a packet; a power of two keeps it short.
fn queue(depth: u32, width: u32) -> Module {
    let mut m = Module::new("queue", "A queue in a memory of look-up tables.");
    m.parameter("depth", depth);
    m.parameter("width", width);
    let input = m.stream_in("in", &[("value", width), ("last", 1)]);
    let place_bits = address_width(depth);
    let [write_place, read_place] = ["write_place", "read_place"].map(|name| m.reg_reset(name, place_bits, 0));
    let held = m.reg_reset("held", place_bits + 1, 0);

    // A power of two is held where the count's top bit is set.
    let (full, valid) = (held.msb(), m.wire("some_held", held.any()));
    m.ready(&input, !full);
    let push = m.wire("push", input.transfer());
    let items = m.memory_distributed("items", depth, width + 1);
    let item = rtl::cat([input.field("value"), input.field("last")]);
    m.write(items, push, write_place, item);
    let shown = m.read_now(items, "shown", read_place);

    let ready = m.stream_out("out", valid, [("value", shown.bits(width, 1)), ("last", shown.bit(0))]);
    let pop = m.wire("pop", valid & ready);
    m.next_if(write_place, push, write_place.add_lit(1));
    m.next_if(read_place, pop, read_place.add_lit(1));
    m.next(held, held + push.zext(place_bits + 1) - pop.zext(place_bits + 1));
    m.assert("no_more_than_fit", held.le(lit(place_bits + 1, depth.into())));
    m
}

/// Adds up packets: an item goes in, and after the last one of a packet their sum comes out, so many bits wider.
fn running_sum(depth: u32, width: u32, growth: u32) -> Module {
    let mut m = Module::new("running_sum", "Sums of packets.");
    m.parameter("growth", growth);
    let input = m.stream_in("in", &[("value", width), ("last", 1)]);
    let queue = m.instance("input_queue", queue(depth, width));
    m.stream_into(queue, "in", &input);
    let item = m.stream_from(queue, "out");

    let sum = m.reg_reset("sum", width + growth, 0);
    let done = m.reg_reset("done", 1, 0);
    let total = m.wire("total", sum + item.field("value").zext(width + growth));
    let shown = m.reg("shown", width + growth);
    let ready = m.stream_out("out", done, [("sum", shown)]);
    m.ready(&item, !done | ready);
    let takes = m.wire("takes", item.transfer());
    let ends = m.wire("ends", takes & item.field("last"));
    m.next_if(sum, takes, ends.mux(lit(sum.width(), 0), total));
    m.next_if(shown, ends, total);
    m.next(done, ends | (done & !ready));
    m
}

fn main() -> ExitCode {
    let arguments: Result<Vec<u32>, _> = std::env::args().skip(1).map(|text| text.parse()).collect();
    let (depth, width) = match arguments.as_deref() {
        Ok([]) => (16, 24),
        Ok(&[depth, width]) if depth.is_power_of_two() && depth > 1 && width > 0 => (depth, width),
        _ => {
            eprintln!("usage: running_sum [items, a power of two, and their bits]");
            return ExitCode::FAILURE;
        }
    };
    match elaborate(&running_sum(depth, width, 8)) {
        Ok(design) => print!("{}", design.verilog()),
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
