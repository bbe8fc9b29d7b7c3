//! `splat_distributor` against its model, in every cycle.

use pointcore_contract::splat::records::SplatCopy;
use pointcore_contract::splat::{Config, units};
use pointcore_contract::{read, words};
use pointcore_golden::splat::{Distributor, Share};
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::distributor;
use pointcore_tb::lockstep::{Stall, StreamTestbench, seeds};

use crate::splat::{Device, RUNS, configs, scene, stalls};
use crate::support::cases;

const COPIES: usize = 1500;
/// Pauses of the side that is not as fast as the other, by turns: long enough to fill its queue, or so many that it is nearly always full.
const SLOW: [Stall; 3] = [Stall::Random(0.3), Stall::Bursts(100), Stall::Random(0.9)];

/// End records without what else they carry.
fn bare_end(copy: SplatCopy) -> SplatCopy {
    if copy.end { SplatCopy { end: true, ..SplatCopy::default() } } else { copy }
}

/// What is to leave on a side at a level; the first of a splat's copies there is marked.
fn expected(config: &Config, copies: &[SplatCopy], level: u32, side: u32) -> Vec<SplatCopy> {
    let (share, bit) = (Share::new(config), config.rasterizer_bits() - 1 - level);
    let goes = |copy: &SplatCopy| copy.end || share.rasterizer(copy.tile) >> bit & 1 == side;
    let mut begun = false;
    let leaves = |copy: &SplatCopy| {
        begun &= copy.end || !copy.first;
        let first = !begun;
        begun |= !copy.end && goes(copy);
        goes(copy).then(|| bare_end(SplatCopy { first, ..*copy }))
    };
    copies.iter().filter_map(leaves).collect()
}

#[test]
fn it_agrees_with_the_model_and_copies_go_to_their_side() {
    let [bare, _, mixed] = configs();
    for (config, level) in cases([(Config { rasterizers: 2, ..bare }, 0), (Config { rasterizers: 8, ..mixed }, 1)]) {
        let device = Device::new(&config, &distributor::module(&config, level), &units::distributor::UNIT);
        for seed in seeds(4 * RUNS).unwrap() {
            // What a reset leaves shows in the first of them.
            let mut random = fastrand::Rng::with_seed(seed);
            let copy = |index| SplatCopy { end: index % 100 == 99, ..scene::noise(&config, &mut random) };
            let copies: Vec<SplatCopy> = (0..COPIES).map(copy).collect();
            let [slow, other] = [SLOW[seed as usize % SLOW.len()], stalls(seed + 1)];
            let [low, high] = if seed % 2 == 0 { [slow, other] } else { [other, slow] };
            let bench = StreamTestbench::new(device.library(), seed);
            let sent = copies.iter().map(|copy| words(&config, *copy)).collect();
            let bench = bench.source("in", sent, stalls(seed)).unwrap();
            let bench = bench.sink("low", low).unwrap().sink("high", high).unwrap();
            let model = Ported::new(&config, Distributor::new(&config, level));
            let run = device.lockstep(model, seed).run(bench).unwrap_or_else(|error| panic!("{error}"));
            for (side, name) in (0..).zip(["low", "high"]) {
                let left = run.stimulus.collected(name).iter().map(|copy| bare_end(read(&config, copy)));
                assert!(left.eq(expected(&config, &copies, level, side)), "{name}, seed {seed}");
            }
        }
    }
}
