//! The harness itself, on a small queue written by hand, and on a renderer.

mod builds;
mod fault;
mod lockstep;

use std::collections::VecDeque;
use std::sync::Arc;

use pointcore_tb::verilated::{BuildOptions, Builder, Direction, Library, Port, StreamDeclaration, VerilogSource};

/// The queue's Verilog.
const FIFO: &str = include_str!("fifo.v");

fn port(name: &str, width: u32, direction: Direction) -> Port {
    Port { name: name.to_owned(), width, direction }
}

/// The queue, or a broken one, with its ports.
fn source(verilog: &str) -> VerilogSource {
    let inputs = [("clk", 1), ("rst", 1), ("in_valid", 1), ("in_value", 16), ("in_last", 1), ("out_ready", 1)];
    let outputs = [("in_ready", 1), ("out_valid", 1), ("out_value", 17), ("out_last", 1)];
    let ports = inputs.map(|(name, width)| port(name, width, Direction::Input)).into_iter();
    let ports = ports.chain(outputs.map(|(name, width)| port(name, width, Direction::Output))).collect();
    let streams = [("in", Direction::Input), ("out", Direction::Output)];
    let streams = streams.map(|(name, direction)| StreamDeclaration::stream(name, direction, ["value", "last"]));
    VerilogSource {
        verilog: verilog.to_owned(),
        top: "fifo".to_owned(),
        ports,
        streams: streams.to_vec(),
        interfaces: vec![],
    }
}

fn library(verilog: &str) -> Arc<Library> {
    let builder = Builder::new().expect("verilator and g++ are installed");
    builder.build(&source(verilog), BuildOptions::default()).expect("the Verilog is clean")
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
