//! `stream_fifo` against its model, in every cycle.

use pointcore_golden::stream::Fifo;
use pointcore_tb::lockstep::{Lockstep, Stall, StreamTestbench, seeds};

use crate::support;

/// Fields of an item, which share a port.
const LAYOUT: [(&str, u32); 2] = [("value", 16), ("last", 1)];
const ITEMS: u64 = 600;

/// Ports `rst, in_valid, in_data, out_ready` to `in_ready, out_valid, out_data`.
fn golden(depth: u32) -> impl FnMut(&[u64], &mut [u64]) {
    let mut fifo = Fifo::new(depth as usize);
    move |inputs, outputs| {
        let &[rst, in_valid, in_data, out_ready] = inputs else { panic!("four inputs, not {inputs:?}") };
        let data = fifo.out().copied().unwrap_or_default();
        outputs.copy_from_slice(&[u64::from(fifo.in_ready()), u64::from(fifo.out().is_some()), data]);
        fifo.step((in_valid != 0).then_some(in_data), out_ready != 0);
        if rst != 0 {
            fifo = Fifo::new(depth as usize);
        }
    }
}

#[test]
fn queues_of_every_kind_of_depth_agree_with_the_model() {
    let items: Vec<Vec<u64>> = (0..ITEMS).map(|n| vec![n * 7919 % 0x2_0000]).collect();
    for depth in [2, 3, 5, 16, 50] {
        let library = support::verilate(&pointcore_hdl::stream::fifo(depth, &LAYOUT));
        for seed in seeds(5).unwrap() {
            for (source, sink) in [
                (Stall::Never, Stall::Never),
                (Stall::Random(0.5), Stall::Random(0.5)),
                (Stall::Bursts(100), Stall::Random(0.2)),
                (Stall::Random(0.2), Stall::Bursts(100)),
            ] {
                let testbench = StreamTestbench::new(&library, seed).source("in", items.clone(), source).unwrap();
                let testbench = testbench.sink("out", sink).unwrap();
                let run = Lockstep::new(&library, golden(depth), seed).run(testbench);
                let run = run.unwrap_or_else(|error| panic!("depth {depth}: {error}"));
                assert_eq!(run.stimulus.collected("out"), items, "depth {depth}, seed {seed}");
            }
        }
    }
}

/// The cycles in which `out_valid` is first high, and `in_ready` first low, when nothing is taken out.
fn first_cycles(depth: u32) -> (usize, usize) {
    let library = support::verilate(&pointcore_hdl::stream::fifo(depth, &LAYOUT));
    let mut model = library.instantiate(1);
    model.reset(2).unwrap();
    let mut outputs = [0; 3];
    let states: Vec<[u64; 3]> = (0..depth + 3)
        .map(|_| {
            model.step(&[0, 1, 7, 0], &mut outputs).unwrap();
            outputs
        })
        .collect();
    let first = |word: usize, value: u64| states.iter().position(|state| state[word] == value).unwrap();
    (first(1, 1), first(0, 0))
}

#[test]
fn an_item_takes_two_cycles_and_capacity_is_the_depth() {
    for depth in [2, 5, 16] {
        assert_eq!(first_cycles(depth), (2, depth as usize));
    }
}
