//! `splat_arbiter` against its model, in every cycle.

use fastrand::Rng;
use pointcore_contract::splat::config::RUN_PIXELS_MAX;
use pointcore_contract::splat::records::{Pixel, PixelRun, StoredPixel};
use pointcore_contract::splat::{Config, units};
use pointcore_contract::{read, words};
use pointcore_golden::splat::Arbiter;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::arbiter;
use pointcore_tb::lockstep::{Stall, StreamTestbench, seeds};

use crate::splat::{Device, RUNS, Travels, configs, scene, stalls};
use crate::support::cases;

/// Of a side.
const READS: usize = 120;
const WRITES: usize = 700;

/// Records of noise, as words.
fn noise<R: Travels>(config: &Config, count: usize, random: &mut Rng) -> Vec<Vec<u64>> {
    (0..count).map(|_| words(config, scene::noise::<R>(config, random))).collect()
}

/// What of a run tells its side: the lowest bit of its tile, or of its pixel.
#[derive(Clone, Copy)]
enum Mark {
    Tile,
    Pixel,
}

impl Mark {
    fn put(self, run: &mut PixelRun, side: u32) {
        match self {
            Self::Tile => run.tile = run.tile & !1 | side,
            Self::Pixel => run.pixel = run.pixel & !1 | side as u8,
        }
    }

    fn side(self, run: &PixelRun) -> u32 {
        match self {
            Self::Tile => run.tile & 1,
            Self::Pixel => u32::from(run.pixel & 1),
        }
    }
}

/// Runs of noise that bear a side's mark.
fn runs(config: &Config, mark: Mark, side: u32, random: &mut Rng) -> Vec<PixelRun> {
    let run = |_| {
        let mut run = PixelRun { count: random.u8(1..=RUN_PIXELS_MAX as u8), ..scene::noise(config, random) };
        mark.put(&mut run, side);
        run
    };
    (0..READS).map(run).collect()
}

#[test]
fn it_agrees_with_the_model_and_nothing_is_lost() {
    for config in cases(configs()) {
        let device = Device::new(&config, &arbiter::module(&config), &units::arbiter::UNIT);
        let mut waited = false;
        for seed in seeds(RUNS).unwrap() {
            let mut random = scene::random();
            let mark = if seed % 2 == 0 { Mark::Tile } else { Mark::Pixel };
            let sides = [0, 1].map(|side| runs(&config, mark, side, &mut random));
            let pixels = sides.iter().flatten().map(|run| usize::from(run.count)).sum();
            let data = noise::<Pixel>(&config, pixels, &mut random);
            let mut bench =
                StreamTestbench::new(device.library(), seed).source("data", data.clone(), stalls(seed)).unwrap();
            for (side, (name, runs)) in (0..).zip(["low", "high"].into_iter().zip(sides)) {
                let of = |what: &str| format!("{name}_{what}");
                let pattern = stalls(seed + side);
                let runs = runs.into_iter().map(|run| words(&config, run)).collect();
                bench = bench.source(&of("read"), runs, Stall::Random(0.9)).unwrap();
                let writes = noise::<StoredPixel>(&config, WRITES, &mut random);
                bench = bench.source(&of("write"), writes, pattern).unwrap();
                bench = bench.sink(&of("data"), pattern).unwrap();
            }
            for name in ["read", "write"] {
                bench = bench.sink(name, stalls(seed + 2)).unwrap();
            }
            let model = Ported::new(&config, Arbiter::default());
            let run = device.lockstep(model, seed).run(bench).unwrap_or_else(|error| panic!("{error}"));

            let collected = |name: &str| run.stimulus.collected(name);
            let runs = collected("read").iter().map(|words| read::<PixelRun>(&config, words));
            let (sides, counts): (Vec<u32>, Vec<u8>) = runs.map(|run| (mark.side(&run), run.count)).unzip();
            let owners = sides.iter().zip(&counts).flat_map(|(side, count)| vec![*side; usize::from(*count)]);
            let owners: Vec<u32> = owners.collect();
            assert_eq!(sides.len(), 2 * READS);
            waited |=
                sides.windows(3).any(|sides| sides == [0, 0, 1]) && sides.windows(3).any(|sides| sides == [1, 0, 1]);
            for (side, name) in (0..).zip(["low_data", "high_data"]) {
                let of_side = data.iter().zip(&owners).filter(|(_, owner)| **owner == side).map(|(pixel, _)| pixel);
                assert!(collected(name).iter().eq(of_side), "{name}, seed {seed}");
            }
            assert_eq!(collected("write").len(), 2 * WRITES);
        }
        assert!(waited, "requests of both sides come in one order only");
    }
}
