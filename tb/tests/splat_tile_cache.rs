//! `splat_tile_cache` against its model, in every cycle, in a closed loop with an accumulator.

use pointcore_contract::splat::config::IN_FLIGHT_BITS;
use pointcore_contract::splat::{Config, Feature, units};
use pointcore_golden::splat::TileCache;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::tile_cache;
use pointcore_tb::lockstep::seeds;

use crate::splat::exchange::{Drive, Exchange, Side};
use crate::splat::{Device, RUNS, configs, moving_configs, stalls};
use crate::support::cases;

#[test]
fn it_agrees_with_the_model() {
    let [_, moving, ..] = moving_configs();
    let moving = Config { merge: Feature::On, ..moving };
    for config in cases(configs().into_iter().chain([moving])) {
        let device = Device::new(&config, &tile_cache::module(&config), &units::tile_cache::UNIT);
        let mut most_in_flight = 0;
        for seed in seeds(RUNS).unwrap() {
            let drive = Drive::new(Exchange::new(&config, stalls(seed), seed), Side::TileCache, &device);
            let run = device.lockstep(Ported::new(&config, TileCache::new(&config)), seed).run(drive);
            let run = run.unwrap_or_else(|error| panic!("{error}"));
            let counts = run.stimulus.exchange.counts;
            assert!(counts.reads > 300 && counts.writes > 300 && counts.pixels > 300, "seed {seed}: {counts:?}");
            assert_eq!(u64::from(counts.writes), run.report.transfers("write"));
            most_in_flight = most_in_flight.max(counts.in_flight);
        }
        assert!(most_in_flight >= 1 << (IN_FLIGHT_BITS - 1), "{most_in_flight} copies were under way at most");
    }
}
