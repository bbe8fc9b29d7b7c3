use super::bound::WELL_POSED_ERROR;
use super::check::{Case, Outcome, Units, Violation, case};
use super::configurations;
use crate::Figures;
use crate::bench::motion_units;
use fastrand::Rng;
use pointcore::stimuli::motion::{Family, camera, rendering};
use pointcore_contract::splat::motion::SHARE_BITS;
use pointcore_golden::reference::motion::{Shutter, quadrature};

/// Cases of a family in a configuration.
const CASES: usize = 4000;

fn random() -> Rng {
    let seed = std::env::var("POINTCORE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    println!("reproduce with POINTCORE_SEED={seed} cargo test -p pointcore-lab motion");
    Rng::with_seed(seed)
}

/// Runs cases of every family in every configuration; so many of each must be inside.
fn hold(check: impl Fn(&Units, &Case) -> Result<Outcome, Violation>) {
    for config in configurations() {
        let units = Units::new(&config);
        let mut random = random();
        for family in Family::ALL {
            let (mut cases, mut inside, mut well_posed) = (0, 0, 0);
            let (mut worst, mut worst_posed, mut of_bound) = (0.0_f64, 0.0_f64, 0.0_f64);
            for _ in 0..CASES {
                let Some(case) = case(&mut random, family, &config) else { continue };
                let outcome =
                    check(&units, &case).unwrap_or_else(|violation| panic!("{family:?}: {violation}: {case:?}"));
                cases += 1;
                inside += u32::from(outcome.is_inside);
                well_posed += u32::from(outcome.is_well_posed && outcome.is_inside);
                worst = worst.max(outcome.error);
                of_bound = of_bound.max(outcome.of_bound);
                if outcome.is_well_posed {
                    worst_posed = worst_posed.max(outcome.error);
                }
            }
            let [worst, worst_posed] = [worst, worst_posed].map(f64::log2);
            let format = config.geometry;
            println!("{format} {family:?}: {cases} cases, {inside} inside, {well_posed} of them well-posed");
            println!("  worst 2^{worst:.1}, well-posed 2^{worst_posed:.1}, {of_bound:.3} of the bound");
            assert!(inside > 50, "{family:?}: only {inside} of {cases} are inside");
        }
    }
}

#[test]
fn evaluation_is_within_its_bound_of_the_footprint_that_it_is_given() {
    hold(Units::evaluate);
}

#[test]
fn setup_and_evaluation_are_within_their_bound_of_the_splat() {
    hold(Units::draw);
}

#[test]
fn quadrature_says_the_same() {
    let [config, ..] = configurations();
    let (units, camera, rendering) = (Units::new(&config), camera(&config), rendering(&config));
    let mut random = random();
    let (mut others, mut well_posed, mut worst) = (0, 0, 0.0_f64);
    // Those whose center is as given in single precision.
    for family in Family::ALL.into_iter().filter(|family| *family != Family::AtBorders) {
        for index in 0..CASES {
            let Some(case) = case(&mut random, family, &config) else { continue };
            let outcome = units.draw(&case).unwrap_or_else(|violation| panic!("{family:?}: {violation}: {case:?}"));
            if !outcome.is_inside || !(outcome.is_well_posed || index < CASES / 40) {
                continue;
            }
            let found = f64::from(units.drawn(&case).share) / f64::from(1 << SHARE_BITS);
            let moved = &case.moved;
            let numbers = quadrature::integral(&moved.splat, &moved.place, Shutter::Box, &camera, &rendering);
            // At either end the sum errs by half a step times the kernel there: that of the edge, or of a place between planes.
            let is_cut = [Family::TowardsEye, Family::AcrossNear, Family::AcrossEye, Family::EdgeOn].contains(&family);
            let jump = if is_cut { 1.0 } else { (-config.kernel_gamma).exp() };
            let off = (found - numbers).abs() - jump * quadrature::STEP;
            let bound = if outcome.is_well_posed { outcome.bound.min(WELL_POSED_ERROR) } else { outcome.bound };
            assert!(off <= bound, "{family:?}: {found} beside {numbers}: {case:?}");
            if outcome.is_well_posed {
                well_posed += 1;
                worst = worst.max(off);
            } else {
                others += 1;
            }
        }
    }
    println!("{well_posed} well-posed and {others} others; well-posed off by {worst:e} beyond what the sum resolves");
    assert!(well_posed > 200 && others > 200, "{well_posed} and {others}");
}

#[test]
fn the_benchmark_counts_cases_and_finds_nothing() {
    let mut figures = Figures::new();
    motion_units::counted(1_000, 100, &mut figures).unwrap_or_else(|error| panic!("{error}"));
    let count = |key: &str| figures[&format!("motion.{key}")].as_u64().expect("it is a count");
    assert_eq!((count("golden_cases"), count("rtl_cases")), (1_000, 100));
    assert_eq!((count("violations"), count("mismatches")), (0, 0));
    assert!(count("golden_covered") > 500);
}
