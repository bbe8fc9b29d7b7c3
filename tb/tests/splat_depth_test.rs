//! `splat_depth_test` against its model, in every cycle.

use pointcore_contract::splat::config::{DEPTH_BITS, WEIGHT_SUM_BITS};
use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::DepthTest;
use pointcore_golden::splat::depth_test::{In, test};
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::depth_test;
use pointcore_tb::lockstep::{Flow, seeds};

use crate::splat::{Device, RUNS};

const CYCLES: u64 = 20_000;
/// Further cycles of reset, in which what is under way without a flag of its own leaves.
const DRAINED: u64 = 2;

/// A pixel and a band: its depth is any, or next to where the outcome changes; sometimes the pixel is empty.
fn operands(random: &mut fastrand::Rng) -> In {
    let band = [random.u32(0..1 << DEPTH_BITS), random.u32(0..1 << DEPTH_BITS)];
    let weight = random.u32(0..1 << WEIGHT_SUM_BITS) >> random.u32(0..28);
    let limit = u64::from(weight) * u64::from(band[random.usize(0..2)]);
    let depth = match random.u8(0..8) {
        0 => 0,
        1..4 => u64::from(weight) * random.u64(0..1 << DEPTH_BITS),
        _ => (limit + random.u64(0..3)).saturating_sub(1),
    };
    let [depth_low, depth_high] = [band[0].min(band[1]), band[0].max(band[1])];
    In { weight, depth, depth_low, depth_high }
}

#[test]
fn it_agrees_with_the_model_next_to_its_limits() {
    let config = Config::default();
    let device = Device::new(&config, &depth_test::module(&config), &units::depth_test::UNIT);
    let places = device.input_places();
    for seed in seeds(RUNS).unwrap() {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut outcomes = [0; 3];
        for _ in 0..CYCLES {
            let outcome = test(&operands(&mut random));
            outcomes[usize::from(outcome.fail) + 2 * usize::from(outcome.pass)] += 1;
        }
        assert!(outcomes.iter().all(|count| *count > CYCLES / 20), "seed {seed}: {outcomes:?}");

        let (mut random, places) = (fastrand::Rng::with_seed(seed), places.clone());
        let stimulus = move |cycle: u64, _: &[u64], inputs: &mut [u64]| {
            let In { weight, depth, depth_low, depth_high } = operands(&mut random);
            let words = match cycle {
                ..DRAINED => [1, 0, 0, 0, 0],
                _ => [0, weight.into(), depth, depth_low.into(), depth_high.into()],
            };
            places.iter().zip(words).for_each(|(&place, word)| inputs[place] = word);
            if cycle < CYCLES { Flow::Continue } else { Flow::Done }
        };
        let run = device.lockstep(Ported::new(&config, DepthTest::default()), seed).run(stimulus);
        assert_eq!(run.unwrap_or_else(|error| panic!("{error}")).report.cycles, CYCLES);
    }
}
