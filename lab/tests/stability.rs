//! The stability checks themselves: the truth, the bounds, that they find faults, and the weaknesses that docs/stability.md admits.

use fastrand::Rng;
use glam::DVec3;
use pointcore::number::encode;
use pointcore_contract::splat::records::Splat;
use pointcore_contract::splat::{Division, Feature};
use pointcore_contract::{Format, Subnormals};
use pointcore_lab::stability::analysis::Analysis;
use pointcore_lab::stability::case::{Case, IMAGE_EDGE_PX, Lens};
use pointcore_lab::stability::check::{Property, check};
use pointcore_lab::stability::compare::compare;
use pointcore_lab::stability::families::{LEVELS, case};
use pointcore_lab::stability::family::Family;
use pointcore_lab::stability::hardware::{Fate, Units};
use pointcore_lab::stability::methods::{Method, Prepared};
use pointcore_lab::stability::truth::Truth;
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

const FORMATS: [Format; 2] = [Format::F32.flushed(), Format::F24.flushed()];

/// Cases of every family and severity, in turns.
fn cases(format: Format, rounds: u64) -> impl Iterator<Item = Case> {
    let levels = (0..rounds).flat_map(|round| (0..LEVELS).map(move |level| (round, level)));
    levels.flat_map(move |(round, level)| Family::ALL.map(|family| case(family, level, format, round)))
}

/// A splat in camera space before the ordinary camera, without a screen filter.
fn splat(format: Format, center: [f32; 3], tangents: [[f32; 3]; 2], attribute: f32) -> Case {
    let vector = |v: [f32; 3]| v.map(|number| encode(format, number));
    let attributes = [encode(Format::F16, attribute); 14];
    let splat = Splat { center: vector(center), tangents: tangents.map(vector), attributes, ..Splat::default() };
    let lens = Lens::new(format, 1.0, 1000.0);
    Case { family: Family::Ordinary, level: 0, format, splat, lens, filter: Feature::Off }
}

#[test]
fn the_quick_truth_is_the_exact_one() {
    const TOLERANCE: f64 = 1e-9;
    let mut random = Rng::with_seed(1);
    let (mut quick_hits, mut inside) = (0, 0);
    for case in cases(FORMATS[0], 4) {
        let Some(truth) = Truth::new(&case) else { continue };
        for _ in 0..4 {
            let pixel = [0, 1].map(|_| random.u32(0..IMAGE_EDGE_PX));
            let Some(quick) = truth.quick_hit(pixel, TOLERANCE) else { continue };
            let exact = truth.exact().hit(pixel);
            assert_eq!(quick.is_inside, exact.is_inside, "{case:?} at {pixel:?}");
            let error = (quick.squared_distance - exact.squared_distance).abs();
            assert!(quick.squared_distance == exact.squared_distance || error <= TOLERANCE, "{case:?}: {error:e}");
            quick_hits += 1;
            inside += u32::from(exact.is_inside);
        }
        if case.numbers()[2] > 0.0 {
            assert_eq!(truth.is_whole(), truth.exact().is_whole(), "{case:?}");
        }
        assert_eq!(truth.faces_away(), truth.exact().faces_away(), "{case:?}");
    }
    assert!(quick_hits > 1000 && inside > 50, "{quick_hits} hits, {inside} inside");
}

#[test]
fn what_is_proved_holds_in_every_family() {
    let kinds =
        [Division::Rounded, Division::Newton].into_iter().flat_map(|division| FORMATS.map(|format| (division, format)));
    for (division, format) in kinds {
        let units = Units::with_division(format, division);
        let (mut samples, mut undetermined) = (0, 0);
        for (index, case) in (0..).zip(cases(format, 4)) {
            let findings = check(&units, &case, index);
            let broken = findings.violations.iter().find(|violation| violation.property.is_proved());
            assert!(broken.is_none(), "{broken:?} of {case:?}, {division:?}");
            samples += findings.samples;
            undetermined += findings.undetermined;
        }
        assert!(undetermined < samples / 2, "of {samples} samples {undetermined} have no bound");
    }
}

#[test]
fn an_error_in_the_footprint_exceeds_the_bound() {
    let format = FORMATS[0];
    let units = Units::new(format);
    let mut noticed = 0;
    let drawn = (0..64).map(|seed| Case { filter: Feature::Off, ..case(Family::Ordinary, 0, format, seed) });
    let drawn: Vec<_> = drawn
        .filter_map(|case| match units.fate(&case) {
            Fate::Drawn(drawn) => Some((case, drawn)),
            _ => None,
        })
        .collect();
    for (case, drawn) in &drawn {
        let mut footprint = drawn.footprint;
        // A thousandth of one coefficient: some hundred times its bound.
        footprint.ax ^= 1 << 13;
        let pixel = [drawn.bounds.left, drawn.bounds.top].map(u32::from);
        let bounded = Analysis::new(case, units.division).squared_distance(pixel);
        let computed = f64::from(units.squared_distance(case, &footprint, pixel).value());
        let exact = Truth::new(case).expect("its numbers are finite").hit(pixel, 1e-12).squared_distance;
        noticed += usize::from((computed - exact).abs() > bounded.error);
    }
    assert!(drawn.len() > 16 && 2 * noticed > drawn.len(), "{noticed} of {} noticed", drawn.len());
}

#[test]
fn the_other_methods_are_right_where_precision_is_no_question() {
    // More bits than any hardware has.
    let format = Format { exponent: 11, mantissa: 28, subnormals: Subnormals::Keep };
    let units = Units::new(FORMATS[0]);
    let mut compared = 0;
    for seed in 0..64 {
        let case = Case { filter: Feature::Off, ..case(Family::Ordinary, 0, FORMATS[0], seed) };
        // Even these bits are few for the conic of a splat that is hardly seen.
        let [u, a1, a2] = [0, 3, 6].map(|first| DVec3::from_slice(&case.numbers()[first..]));
        let sight = u.normalize().dot(a1.cross(a2).normalize());
        if sight > -0.3 || compare(&units, &case, seed).is_none() {
            continue;
        }
        compared += 1;
        let truth = Truth::new(&case).expect("its numbers are finite");
        for method in [Method::Conic, Method::Square] {
            let prepared = Prepared::in_format(method, &case, format);
            let [columns, rows] = prepared.bounds.clone();
            for pixel in columns.flat_map(|column| rows.clone().map(move |row| [column, row])) {
                let exact = truth.hit(pixel, 1e-6).squared_distance;
                let found = prepared.squared_distance(pixel);
                let is_plain = (exact - 1.0).abs() > 0.01;
                assert!(!is_plain || (exact < 1.0) == (found < 1.0), "{method:?}: {found}, not {exact}, of {case:?}");
            }
        }
    }
    assert!(compared > 16, "{compared} cases");
}

/// Numbers of all kinds, simple ones first, so that they shrink to them.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        prop::sample::select(vec![0.0, 1.0, -1.0, 2.0, 0.5, -0.5]),
        -4.0_f32..4.0,
        -1000.0_f32..1000.0,
        any::<f32>(),
        any::<u32>().prop_map(f32::from_bits),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct("tests/stability.regressions"))),
        ..ProptestConfig::with_cases(2000)
    })]

    #[test]
    fn what_is_proved_holds_of_any_splat(
        center in prop::array::uniform3(number()), first in prop::array::uniform3(number()), second in prop::array::uniform3(number()),
        is_narrow in any::<bool>(), is_newton in any::<bool>(), is_filtered in any::<bool>(), seed in any::<u64>(),
    ) {
        let format = FORMATS[usize::from(is_narrow)];
        let division = if is_newton { Division::Newton } else { Division::Rounded };
        let case = Case {
            filter: if is_filtered { Feature::On } else { Feature::Off },
            ..splat(format, center, [first, second], 1.0)
        };
        let findings = check(&Units::with_division(format, division), &case, seed);
        let broken = findings.violations.iter().find(|violation| violation.property.is_proved());
        prop_assert!(broken.is_none(), "{:?} of {:?}, {:?}", broken, case.numbers(), division);
        prop_assert!(findings.of(Property::Malformed).is_none(), "{:?} of {:?}", findings.violations, case.numbers());
    }
}

#[test]
fn what_is_proved_holds_where_a_coefficient_vanishes() {
    // A tangent in the centre's place is so long that `m` falls below the least number when all get one scale.
    let center = [0.0, -3.507_438_2, 0.0];
    let tangents = [[3.215_258_6e37, 0.0, 114_478_440.0], [0.0, 0.0, -7_144_673.0]];
    for (format, division) in FORMATS.into_iter().zip([Division::Newton, Division::Rounded]) {
        let case = Case { filter: Feature::Off, ..splat(format, center, tangents, 1.0) };
        let units = Units::with_division(format, division);
        let broken = (0..64).flat_map(|seed| check(&units, &case, seed).violations).find(|v| v.property.is_proved());
        assert!(broken.is_none(), "{broken:?}");
    }
}

/// Whether some choice of samples shows that a property does not hold.
fn is_violated(case: &Case, property: Property) -> bool {
    let units = Units::new(case.format);
    (0..64).any(|seed| check(&units, case, seed).of(property).is_some())
}

/// What docs/stability.md admits. When hardware changes one of these, the page changes too.
#[test]
fn the_known_weaknesses_are_these() {
    let [wide, _] = FORMATS;
    let weaknesses = [
        // A tangent's vanishing point is the origin, and what is measured by it is below every number.
        (Property::Lost, splat(wide, [3.75, -2.5, 0.0], [[-0.125, -0.25, 0.0], [0.0, 0.125, -3e38]], 1.0)),
    ];
    for (property, case) in weaknesses {
        assert!(is_violated(&case, property), "{property:?} holds of {:?} now", case.numbers());
    }
}

/// What once was admitted.
#[test]
fn these_are_weaknesses_no_more() {
    let [wide, narrow] = FORMATS;
    let mended = [
        // The centre decided for all of a splat.
        (Property::Near, splat(wide, [0.0, 0.0, 1.0], [[0.0, -1.0, 0.0], [-1.0, 0.0, 1.0]], 1.0)),
        (Property::Near, splat(narrow, [0.0, 0.0, 1.0], [[0.0, -1.0, 0.0], [-1.0, 0.0, 1.0]], 1.0)),
        (Property::Far, splat(wide, [0.0, 1.0, 4096.0], [[0.0, 0.0, -4096.0], [1.0, 0.0, 0.0]], 1.0)),
        // `D²` overflowed, and `Δ`.
        (Property::Lost, splat(wide, [1.0, 0.0, 2.0], [[0.0, 0.0, -1.0], [0.0, -4.5e15, 0.0]], 1.0)),
        (Property::Facing, splat(wide, [1.0, -1.0, 2.0], [[0.0, 0.0, -1.0], [-1.0, 0.0, 8.3e34]], 1.0)),
        // A centre thousands of pixels aside was the origin.
        (Property::Lost, splat(narrow, [1_572_864.0, 0.0, 8.0], [[0.0, 65536.0, 0.0], [0.0, 0.0, -4_194_304.0]], 1.0)),
        // A product of three vectors overflowed, and with it the test whether the splat faces away.
        (Property::Facing, splat(wide, [0.0, 0.0, 1.5], [[0.0, 8e18, 0.0], [6e17, 0.0, 1.5e20]], 1.0)),
        // Exactly edge-on and across the eye plane.
        (Property::Stray, splat(wide, [0.0, 0.0, 16.0], [[0.0, 0.0, 24.0], [1.0, 0.0, 0.0]], 1.0)),
        (Property::Stray, splat(narrow, [0.0, 0.0, 16.0], [[0.0, 0.0, 24.0], [1.0, 0.0, 0.0]], 1.0)),
        // Nearly touching the eye plane, with bounds of few digits.
        (Property::Rim, splat(narrow, [0.0, 1.25, 2.2436], [[0.0, 1.0, 2.2041], [-1.0, 0.25, 0.4141]], 1.0)),
    ];
    for (property, case) in mended {
        assert!(!is_violated(&case, property), "{property:?} does not hold of {:?}", case.numbers());
    }
    let toward = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    // An attribute that is no number; two of more than half the largest one.
    for attribute in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 40_000.0, -40_000.0] {
        let case = splat(wide, [0.0, 0.0, 2.0], toward, attribute);
        assert!(!is_violated(&case, Property::Finite), "{attribute}");
    }
}
