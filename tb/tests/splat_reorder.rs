//! `splat_reorder` against its model, in every cycle.

use pointcore_contract::splat::records::TileCopy;
use pointcore_contract::splat::{Config, units};
use pointcore_contract::words;
use pointcore_golden::splat::Reorder;
use pointcore_hdl::splat::reorder;

use crate::splat::{Device, configs, scene};
use crate::support::cases;

const COPIES: u64 = 1200;

/// Fields of noise, in frames of two lengths, an empty frame among them.
fn copies(config: &Config) -> Vec<TileCopy> {
    let mut random = scene::random();
    let tiles = scene::tiles(config);
    let copy = |index| {
        let mut copy: TileCopy = scene::noise(config, &mut random);
        copy.end = index % 300 == 299 || [20, 21].contains(&index);
        let spread = if index % 64 < 32 { 4 } else { tiles.len() };
        copy.tile = tiles[copy.tile as usize % spread];
        copy
    };
    (0..COPIES).map(copy).collect()
}

/// Sorted within each frame.
fn by_frame(config: &Config, copies: &[TileCopy]) -> Vec<Vec<Vec<u64>>> {
    let frames = copies.split(|copy| copy.end).map(|frame| {
        let mut frame: Vec<_> = frame.iter().map(|copy| words(config, *copy)).collect();
        frame.sort();
        frame
    });
    frames.collect()
}

#[test]
fn it_agrees_with_the_model() {
    for config in cases(configs()) {
        let device = Device::new(&config, &reorder::module(&config), &units::reorder::UNIT);
        let copies = copies(&config);
        let runs = device.runs(&Reorder::new(&config), &copies, &[]);
        for run in &runs {
            assert_eq!(run.len(), copies.len());
            assert!(by_frame(&config, run) == by_frame(&config, &copies), "every frame has its own copies");
        }
        let in_order =
            |run: &&Vec<TileCopy>| run.iter().zip(&copies).all(|(left, right)| left.end || left.tile == right.tile);
        // Where the consumer is faster than the heap, never or seldom pausing, or the heap is slow, every copy leaves at once.
        let ordered = runs.iter().filter(in_order).count();
        assert!(
            ordered <= 1 + config.heap_interval as usize / 2,
            "{ordered} of {} runs were not reordered",
            runs.len()
        );
    }
}
