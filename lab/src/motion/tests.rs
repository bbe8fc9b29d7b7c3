use super::check::{case, check};
use fastrand::Rng;
use pointcore::stimuli::motion::Family;
use pointcore_contract::splat::{Config, Division};
use pointcore_contract::{Format, FragmentDepth, Sampling};
use pointcore_golden::splat::MotionEvaluation;

/// Cases of a family in a configuration.
const CASES: usize = 4000;

fn configs() -> [Config; 3] {
    let image = Config { width: 64, height: 48, ..Config::default() };
    let coarse = Config { geometry: Format::F24.flushed(), division: Division::Newton, ..image.clone() };
    let other = Config {
        kernel_gamma: 4.0,
        sampling: Sampling::Flipquad,
        depth: FragmentDepth::Plane,
        division: Division::Newton,
        ..image.clone()
    };
    [image, coarse, other]
}

fn random() -> Rng {
    let seed = std::env::var("POINTCORE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    println!("reproduce with POINTCORE_SEED={seed} cargo test -p pointcore-lab motion");
    Rng::with_seed(seed)
}

#[test]
fn shares_are_within_their_bound() {
    for config in configs() {
        let unit = MotionEvaluation::new(&config, 1);
        let mut random = random();
        for family in Family::ALL {
            let (mut cases, mut inside, mut well_posed) = (0, 0, 0);
            let (mut worst, mut worst_posed, mut of_bound) = (0.0_f64, 0.0_f64, 0.0_f64);
            for _ in 0..CASES {
                let Some(case) = case(&mut random, family, &config) else { continue };
                let outcome = check(&unit, &case, &config)
                    .unwrap_or_else(|violation| panic!("{family:?}: {violation}: {case:?}"));
                cases += 1;
                inside += u32::from(outcome.is_inside);
                well_posed += u32::from(outcome.is_well_posed && outcome.is_inside);
                worst = worst.max(outcome.error);
                of_bound = of_bound.max(outcome.of_bound);
                if outcome.is_well_posed {
                    worst_posed = worst_posed.max(outcome.error);
                }
            }
            println!(
                "{} {family:?}: {cases} cases, {inside} inside, {well_posed} well-posed; worst 2^{:.1}, well-posed 2^{:.1}, {of_bound:.3} of the bound",
                config.geometry,
                worst.log2(),
                worst_posed.log2(),
            );
            assert!(inside > 50, "{family:?}: only {inside} of {cases} are inside");
        }
    }
}
