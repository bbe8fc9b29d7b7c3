//! `stream_skid` against its model, in every cycle.

use pointcore_golden::stream::Skid;
use pointcore_tb::lockstep::{Lockstep, Stall, StreamTestbench, seeds};

use crate::support;

/// Fields of an item, which share a port.
const LAYOUT: [(&str, u32); 2] = [("value", 16), ("last", 1)];
const ITEMS: u64 = 600;

/// Ports `rst, in_valid, in_data, out_ready` to `in_ready, out_valid, out_data`.
fn golden() -> impl FnMut(&[u64], &mut [u64]) {
    let mut skid = Skid::default();
    move |inputs, outputs| {
        let &[rst, in_valid, in_data, out_ready] = inputs else { panic!("four inputs, not {inputs:?}") };
        let data = skid.out().copied().unwrap_or_default();
        outputs.copy_from_slice(&[u64::from(skid.in_ready()), u64::from(skid.out().is_some()), data]);
        skid.step((in_valid != 0).then_some(in_data), out_ready != 0);
        if rst != 0 {
            skid = Skid::default();
        }
    }
}

#[test]
fn it_agrees_with_the_model_under_every_stall_pattern() {
    let items: Vec<Vec<u64>> = (0..ITEMS).map(|n| vec![n * 7919 % 0x2_0000]).collect();
    let library = support::verilate(&pointcore_hdl::stream::skid(&LAYOUT));
    for seed in seeds(5).unwrap() {
        for stall in [Stall::Never, Stall::Random(0.2), Stall::Random(0.7), Stall::Bursts(20)] {
            let testbench = StreamTestbench::new(&library, seed).source("in", items.clone(), stall).unwrap();
            let testbench = testbench.sink("out", stall).unwrap();
            let run = Lockstep::new(&library, golden(), seed).run(testbench).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(run.stimulus.collected("out"), items, "seed {seed}, {stall:?}");
        }
    }
}

#[test]
fn it_moves_an_item_in_every_cycle() {
    let items: Vec<Vec<u64>> = (0..ITEMS).map(|n| vec![n]).collect();
    let library = support::verilate(&pointcore_hdl::stream::skid(&LAYOUT));
    let testbench = StreamTestbench::new(&library, 1).source("in", items, Stall::Never).unwrap();
    let testbench = testbench.sink("out", Stall::Never).unwrap().quiet_cycles(1);
    let run = Lockstep::new(&library, golden(), 1).run(testbench).unwrap_or_else(|error| panic!("{error}"));
    // One cycle of latency, one to notice the end of it, and the silence that ends the run.
    assert!(run.report.cycles <= ITEMS + 4, "{} cycles for {ITEMS} items", run.report.cycles);
}
