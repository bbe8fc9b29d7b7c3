//! `splat_reorder` against its model, in every cycle.

use pointcore_contract::splat::{Config, ports, records};
use pointcore_golden::splat::Reorder;
use pointcore_hdl::splat::reorder;

use crate::splat::{Device, configs, scene};

const COPIES: u64 = 1200;

/// Fields of noise, in frames of two lengths, an empty frame among them.
fn copies(config: &Config) -> Vec<Vec<u64>> {
    let mut random = scene::random();
    let fields = records::copy(config);
    let copy = |index| {
        let mut record = scene::noise(&fields, &mut random);
        record[0] = u64::from(index % 300 == 299 || [20, 21].contains(&index));
        let last = record.len() - 1;
        if index % 64 < 32 {
            record[last] %= 4;
        }
        record
    };
    (0..COPIES).map(copy).collect()
}

/// Sorted within each frame.
fn by_frame(copies: &[Vec<u64>]) -> Vec<Vec<Vec<u64>>> {
    let mut frames: Vec<Vec<Vec<u64>>> = copies.split(|copy| copy[0] == 1).map(<[_]>::to_vec).collect();
    frames.iter_mut().for_each(|frame| frame.sort());
    frames
}

#[test]
fn it_agrees_with_the_model() {
    for config in configs() {
        let device = Device::new(&config, &reorder::module(&config), ports::reorder(&config));
        let copies = copies(&config);
        let runs = device.runs(&Reorder::new(&config), &copies, &[]);
        for run in &runs {
            assert_eq!(run.len(), copies.len());
            assert!(by_frame(run) == by_frame(&copies), "every frame has its own copies");
        }
        let in_order = |run: &&Vec<Vec<u64>>| {
            run.iter().zip(&copies).all(|(left, right)| left[0] == 1 || left.last() == right.last())
        };
        // Where the consumer is faster than the heap, never or seldom pausing, or the heap is slow, every copy leaves at once.
        let ordered = runs.iter().filter(in_order).count();
        assert!(
            ordered <= 1 + config.heap_interval as usize / 2,
            "{ordered} of {} runs were not reordered",
            runs.len()
        );
    }
}
