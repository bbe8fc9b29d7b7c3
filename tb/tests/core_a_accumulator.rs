//! `core_a_accumulator` against its model, in every cycle, in a closed loop with a tile cache.

use pointcore::core_a::mask::DrainedPixel;
use pointcore::lockstep::{Lockstep, seeds};
use pointcore_golden::core_a::Accumulator;
use pointcore_golden::unit::Ported;
use pointcore_hdl::core_a::accumulator;
use pointcore_spec::core_a::{AttributeFormat, ports};

use crate::core_a::exchange::{Drive, Exchange, Side};
use crate::core_a::{Device, RUNS, configs, fixed_configs, stalls};
use crate::support;

#[test]
fn it_agrees_with_the_model() {
    for config in configs().into_iter().chain(fixed_configs()) {
        let device = Device::new(&accumulator::module(&config), ports::accumulator(&config));
        for seed in seeds(RUNS).unwrap() {
            let drive = Drive::new(Exchange::new(&config, stalls(seed), seed), Side::Accumulator, &device);
            let drained = DrainedPixel::new(&support::ports(device.library()));
            let golden = drained.watch(device.golden(Ported::new(Accumulator::new(&config))));
            let run = Lockstep::new(device.library(), golden, seed).mask(drained.mask()).run(drive);
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
