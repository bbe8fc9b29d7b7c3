//! `splat_heap` against its model, in every cycle.

use pointcore_contract::splat::records::HeapEntry;
use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::Heap;
use pointcore_hdl::splat::heap;

use crate::splat::{Device, RUNS, scene};

const ENTRIES: u64 = 3000;

/// Entries in bursts of few tiles, so that many have the same tile and differ in arrival only.
fn entries(config: &Config) -> Vec<HeapEntry> {
    let mut random = scene::random();
    let (tiles, pointers) = (1 << config.tile_bits(), 1 << config.heap_levels);
    let entry = |index: u64| {
        let spread = if index % 64 < 32 { 3 } else { tiles };
        HeapEntry { tile: random.u32(0..spread), pointer: random.u16(0..pointers) }
    };
    (0..ENTRIES).map(entry).collect()
}

fn sorted(mut entries: Vec<HeapEntry>) -> Vec<HeapEntry> {
    entries.sort_by_key(|entry| (entry.tile, entry.pointer));
    entries
}

/// Levels, cycles of an operation, bits of the arrival number and image width: epochs as short as two arrivals, longer ones than
/// the heap is large, one column of tiles and many.
#[test]
fn it_agrees_with_the_model_at_every_size() {
    for (heap_levels, heap_interval, sequence_bits, width) in [
        (2, 2, 2, 8),
        (2, 4, 2, 61),
        (3, 2, 3, 61),
        (4, 2, 2, 61),
        (4, 4, 7, 61),
        (5, 2, 4, 130),
        (5, 4, 4, 130),
        (3, 2, 6, 61),
        (5, 2, 7, 61),
        (6, 4, 8, 61),
        (7, 2, 9, 61),
        (10, 2, 12, 61),
        (10, 4, 12, 61),
        (12, 4, 13, 61),
    ] {
        let config = Config { heap_levels, heap_interval, width, height: 37, ..Config::default() };
        let device = Device::new(&config, &heap::numbered(&config, sequence_bits), &units::heap::UNIT);
        let entries = entries(&config);
        let runs = device.runs(&Heap::numbered(&config, sequence_bits), &entries, &[]);
        let reordered = runs.iter().filter(|run| **run != entries).count() as u64;
        // Without stalls every entry leaves at once, and a slow heap lets them with few stalls as well.
        assert!(reordered >= RUNS - u64::from(heap_interval) / 2, "{reordered} runs of {RUNS} were reordered");
        for run in runs {
            assert!(sorted(run) == sorted(entries.clone()), "what leaves is what entered");
        }
    }
}
