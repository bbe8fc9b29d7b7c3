//! `bus_abort` against its model, in every cycle.

use pointcore_golden::bus::Abort;
use pointcore_hdl::bus::abort;
use pointcore_tb::lockstep::seeds;

use crate::bus::{Bench, SEEDS};

const CYCLES: u32 = 20_000;

#[test]
fn runs_end_as_in_the_model() {
    for seed in seeds(SEEDS).unwrap() {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut bench = Bench::new(abort::module(), seed);
        let mut model = Abort::default();
        let mut ends = 0;
        for _ in 0..CYCLES {
            // Quiet often lasts as long as it takes, and often not quite.
            let [asked, running, quiet] = [0.2, 0.7, 0.9].map(|chance| random.f64() < chance);
            for (name, value) in [("asked", asked), ("running", running), ("quiet", quiet)] {
                bench.set(name, value.into());
            }
            bench.step();
            let outputs = ["aborts", "ended"].map(|name| bench.get(name) == 1);
            assert_eq!(outputs, [model.aborts(), model.ended()], "cycle {}", bench.cycle);
            ends += u32::from(model.ended());
            model.clock(asked, running, quiet);
        }
        assert!(ends > CYCLES / 100, "{ends} runs ended");
    }
}
