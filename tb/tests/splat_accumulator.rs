//! `splat_accumulator` against its model, in every cycle, in a closed loop with a tile cache.

use pointcore::splat::mask::HeldBefore;
use pointcore_contract::splat::{AttributeFormat, units};
use pointcore_golden::splat::Accumulator;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::accumulator;
use pointcore_tb::lockstep::{Lockstep, seeds};

use crate::splat::exchange::{Drive, Exchange, Side};
use crate::splat::{Device, RUNS, configs, fixed_configs, moving_configs, stalls};
use crate::support::cases;

#[test]
fn it_agrees_with_the_model() {
    for config in cases(configs().into_iter().chain(fixed_configs()).chain(moving_configs())) {
        let device = Device::new(&config, &accumulator::module(&config), &units::accumulator::UNIT);
        for seed in seeds(RUNS).unwrap() {
            let drive = Drive::new(Exchange::new(&config, stalls(seed), seed), Side::Accumulator, &device);
            let held = HeldBefore::new(&config, &device.outputs());
            let golden = device.golden(Ported::new(&config, held.watch(Accumulator::new(&config))));
            let run = Lockstep::new(device.library(), golden, seed).mask(held.mask()).run(drive);
            let run = run.unwrap_or_else(|error| panic!("{error}"));
            let counts = run.stimulus.exchange.counts;
            assert!(counts.accumulated > 1500 && counts.hazards > 100 && counts.slot_waits > 100, "{counts:?}");
            // Sums in fixed point cannot overflow.
            let overflows = config.attribute == AttributeFormat::F16;
            assert!(counts.saturated > 5 || !overflows, "seed {seed}: {counts:?}");
            assert!(counts.heavy > 20 && run.report.transfers("retire") > 1000, "seed {seed}: {counts:?}");
        }
    }
}
