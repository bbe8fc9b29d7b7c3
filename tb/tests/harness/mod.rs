//! The harness itself, on a small queue written by hand.

mod builds;
mod lockstep;

use std::collections::VecDeque;
use std::sync::Arc;

use pointcore::verilated::{Builder, Library, Options, Port, Source};

/// The queue's Verilog.
const FIFO: &str = include_str!("fifo.v");

/// The queue, or a broken one, with its ports.
fn source(verilog: &str) -> Source {
    let ports = vec![
        Port::input("clk", 1),
        Port::input("rst", 1),
        Port::input("in_valid", 1),
        Port::output("in_ready", 1),
        Port::input("in_value", 16),
        Port::input("in_last", 1),
        Port::output("out_valid", 1),
        Port::input("out_ready", 1),
        Port::output("out_value", 17),
        Port::output("out_last", 1),
    ];
    Source { verilog: verilog.to_owned(), top: "fifo".to_owned(), ports }
}

fn library(verilog: &str) -> Arc<Library> {
    let builder = Builder::new().expect("verilator and g++ are installed");
    builder.build(&source(verilog), Options::default()).expect("the Verilog is clean")
}

/// The queue's model: `rst, in_valid, in_value, in_last, out_ready` to `in_ready, out_valid, out_value, out_last`.
fn golden() -> impl FnMut(&[u64], &mut [u64]) {
    let mut queue = VecDeque::new();
    move |inputs, outputs| {
        let &[rst, in_valid, in_value, in_last, out_ready] = inputs else { panic!("five inputs, not {inputs:?}") };
        let (value, last) = queue.front().copied().unwrap_or_default();
        let in_ready = queue.len() < 4;
        outputs.copy_from_slice(&[u64::from(in_ready), u64::from(!queue.is_empty()), 2 * value + 1, last]);
        if out_ready != 0 {
            queue.pop_front();
        }
        if in_valid != 0 && in_ready {
            queue.push_back((in_value, in_last));
        }
        if rst != 0 {
            queue.clear();
        }
    }
}
