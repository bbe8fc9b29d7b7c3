//! `splat_arbiter` against its model, in every cycle.

use pointcore_contract::splat::records::{Pixel, PixelRun, StoredPixel};
use pointcore_contract::splat::config::RUN_PIXELS_MAX;
use pointcore_contract::splat::{Config, units};
use pointcore_contract::{read, words};
use pointcore_golden::splat::Arbiter;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::arbiter;
use pointcore_tb::lockstep::{Stall, StreamTestbench, seeds};

use crate::splat::{Device, RUNS, Travels, configs, scene, stalls};

/// Of a side.
const READS: u32 = 120;
const WRITES: u32 = 700;

/// Records of noise, as words.
fn noise<R: Travels>(config: &Config, count: usize, mut change: impl FnMut(usize, &mut R)) -> Vec<Vec<u64>> {
    let mut random = scene::random();
    let record = |index| {
        let mut record = scene::noise(config, &mut random);
        change(index, &mut record);
        words(config, record)
    };
    (0..count).map(record).collect()
}

/// Runs of pixels of tiles that tell the side by their lowest bit.
fn runs(side: u32) -> impl Iterator<Item = PixelRun> {
    let count = move |number: u32| ((number * (5 + side)) % RUN_PIXELS_MAX) as u8 + 1;
    (0..READS).map(move |number| PixelRun { surface: number % 3 == 0, tile: 2 * (number % 8) + side, pixel: 0, count: count(number) })
}

#[test]
fn it_agrees_with_the_model_and_nothing_is_lost() {
    for config in configs() {
        let device = Device::new(&config, &arbiter::module(&config), &units::arbiter::UNIT);
        let pixels: usize = runs(0).chain(runs(1)).map(|run| usize::from(run.count)).sum();
        let data = noise::<Pixel>(&config, pixels, |_, _| {});
        let mut waited = false;
        for seed in seeds(RUNS).unwrap() {
            let mut bench = StreamTestbench::new(device.library(), seed).source("data", data.clone(), stalls(seed)).unwrap();
            for (side, name) in (0..).zip(["low", "high"]) {
                let mark = |_, pixel: &mut StoredPixel| pixel.placed.tile = pixel.placed.tile & !1 | side;
                let of = |what: &str| format!("{name}_{what}");
                let pattern = stalls(seed + u64::from(side));
                bench = bench.source(&of("read"), runs(side).map(|run| words(&config, run)).collect(), Stall::Random(0.9)).unwrap();
                bench = bench.source(&of("write"), noise(&config, WRITES as usize, mark), pattern).unwrap();
                bench = bench.sink(&of("data"), pattern).unwrap();
            }
            for name in ["read", "write"] {
                bench = bench.sink(name, stalls(seed + 2)).unwrap();
            }
            let model = Ported::new(&config, Arbiter::default());
            let run = device.lockstep(model, seed).run(bench).unwrap_or_else(|error| panic!("{error}"));

            let collected = |name: &str| run.stimulus.collected(name);
            let runs = collected("read").iter().map(|words| read::<PixelRun>(&config, words));
            let (sides, counts): (Vec<u32>, Vec<u8>) = runs.map(|run| (run.tile & 1, run.count)).unzip();
            let owners = sides.iter().zip(&counts).flat_map(|(side, count)| vec![*side; usize::from(*count)]);
            let owners: Vec<u32> = owners.collect();
            assert_eq!(sides.len(), 2 * READS as usize);
            waited |= sides.windows(3).any(|sides| sides == [0, 0, 1]) && sides.windows(3).any(|sides| sides == [1, 0, 1]);
            for (side, name) in (0..).zip(["low_data", "high_data"]) {
                let of_side = data.iter().zip(&owners).filter(|(_, owner)| **owner == side).map(|(pixel, _)| pixel);
                assert!(collected(name).iter().eq(of_side), "{name}, seed {seed}");
            }
            assert_eq!(collected("write").len(), 2 * WRITES as usize);
        }
        assert!(waited, "requests of both sides come in one order only");
    }
}
