use super::*;
use crate::splat::Setup;
use crate::splat::uniforms::SetupUniforms;
use crate::testing::for_each_seed;
use fastrand::Rng;
use pointcore_contract::splat::Feature;
use pointcore_contract::splat::records::ImageDiagonals;

fn number(value: f64) -> u32 {
    (value as f32).to_bits()
}

fn config() -> Config {
    Config { width: 64, height: 48, time_bins: 1, screen_filter: Feature::Off, ..Config::default() }
}

fn uniforms() -> MotionUniforms {
    MotionUniforms {
        viewport: Viewport {
            scale: [60.0, 60.0].map(number),
            origin: [32.0, 24.0].map(number),
            depth_a: number(10.0 / 9.0),
            depth_b: number(-10.0 / 9.0),
        },
        epsilon: EpsilonScale { scale: number(1.0), bias: number(0.01) },
        near_plane: number(1.0),
    }
}

/// Somewhere before the image, turned to any side.
fn splat(random: &mut Rng) -> Splat {
    let mut spread = |size: f64| size * (2.0 * random.f64() - 1.0);
    let z = 5.5 + spread(3.5);
    let tangents = [(); 2].map(|()| [(); 3].map(|()| number(spread(0.2 * z))));
    Splat { center: [spread(0.5 * z), spread(0.5 * z), z].map(number), tangents, ..Splat::default() }
}

fn moving(splat: Splat, way: [f64; 3]) -> Splat {
    Splat { motion: Motion { way: way.map(number), part: [-1.0, 1.0].map(number) }, ..splat }
}

/// A disc on the optical axis that faces the eye.
fn at(z: f64) -> Splat {
    let tangents = [[0.0, 0.5, 0.0], [0.5, 0.0, 0.0]].map(|tangent| tangent.map(number));
    Splat { center: [0.0, 0.0, z].map(number), tangents, ..Splat::default() }
}

#[test]
fn a_splat_that_does_not_move_is_where_the_static_one_is() {
    let (config, uniforms) = (config(), uniforms());
    let unit = MotionSetup::new(&config, 1);
    let still = Setup::new(&Config { time_bins: 0, ..config }, 1);
    let MotionUniforms { viewport, epsilon, near_plane } = uniforms;
    let of_still = SetupUniforms { viewport, epsilon, near_plane, filter_radius: 0 };
    for_each_seed("motion_setup", |random| {
        let (mut drawn, mut different) = (0, 0);
        for _ in 0..2000 {
            let splat = splat(random);
            let (moving, expected) = (unit.setup(&moving(splat, [0.0; 3]), &uniforms), still.setup(&splat, &of_still));
            let (Some(moving), Some(expected)) = (moving, expected) else {
                // What is seen edge-on is dropped by one of them, and diagonals leave out what touches the image's corner.
                different += u32::from(moving.is_some() != expected.is_some());
                continue;
            };
            assert_eq!(moving.bounds, expected.bounds);
            assert_eq!(moving.moving.footprint.center, expected.footprint.center);
            let (hull, limits) = (moving.diagonals, expected.diagonals);
            // Both make up for roundings, each in its own way.
            let [moving_limits, still_limits] = [hull, limits].map(|of| {
                let ImageDiagonals { first_sum, last_sum, first_difference, last_difference } = of;
                [first_sum, last_sum, first_difference, last_difference]
            });
            assert!(
                moving_limits.iter().zip(still_limits).all(|(a, b)| a.abs_diff(b) <= 1),
                "{hull:?} beside {limits:?}"
            );
            let band = expected.footprint.band;
            // What does not end at near or far plane.
            if band.low > 0 && band.high < (1 << DEPTH_BITS) - 1 {
                let half = (band.high - band.low) / 2;
                assert!(moving.moving.epsilon.abs_diff(half) <= 16, "{} beside {half}", moving.moving.epsilon);
            }
            assert!(moving.moving.footprint.speed.as_flattened().iter().all(|&speed| speed << 1 == 0));
            drawn += 1;
        }
        assert!(drawn > 500 && different < 20, "{drawn} are drawn, {different} by one only");
    });
}

#[test]
fn bounds_hold_those_of_every_instant() {
    let (config, uniforms) = (config(), uniforms());
    let unit = MotionSetup::new(&config, 1);
    for_each_seed("motion_setup", |random| {
        let mut drawn = 0;
        for _ in 0..500 {
            let splat = splat(random);
            let motion = [(); 3].map(|()| 2.0 * random.f64() - 1.0);
            let Some(whole) = unit.setup(&moving(splat, motion), &uniforms) else { continue };
            drawn += 1;
            for step in -4..4 {
                let part = [step, step + 1].map(|step| number(0.25 * f64::from(step)));
                let all = moving(splat, motion);
                let part = Splat { motion: Motion { part, ..all.motion }, ..all };
                let Some(instant) = unit.setup(&part, &uniforms) else { continue };
                let (outer, inner) = (whole.bounds, instant.bounds);
                // Rounding at a border within life may take a pixel more than rounding at its ends.
                assert!(outer.left <= inner.left + 1 && inner.right <= outer.right + 1, "{inner:?} in {outer:?}");
                let (limits, within) = (whole.diagonals, instant.diagonals);
                assert!(limits.first_sum <= within.first_sum + 1 && within.last_sum <= limits.last_sum + 1);
                assert!(limits.first_difference <= within.first_difference + 1);
                assert!(within.last_difference <= limits.last_difference + 1);
                assert!(outer.top <= inner.top + 1 && inner.bottom <= outer.bottom + 1, "{inner:?} in {outer:?}");
            }
        }
        assert!(drawn > 100, "{drawn}");
    });
}

#[test]
fn a_splat_is_there_in_the_bin_of_its_middle() {
    let uniforms = uniforms();
    let unit = MotionSetup::new(&Config { time_bins: 4, ..config() }, 1);
    let cases = [([-1.0, -0.5], 0, [-1.0, -0.5]), ([0.5, 1.0], 3, [0.5, 1.0]), ([-0.4, -0.2], 1, [-0.4, -0.2])];
    // Across a border, and across several.
    for (part, bin, life) in cases.into_iter().chain([([-0.6, 0.0], 1, [-0.5, 0.0]), ([-1.0, 1.0], 2, [0.0, 0.5])]) {
        let splat = Splat { motion: Motion { part: part.map(number), ..Motion::default() }, ..at(5.0) };
        let drawn = unit.setup(&splat, &uniforms).expect("it faces the eye");
        assert_eq!((drawn.bin, drawn.moving.footprint.life), (bin, life.map(number)), "{part:?}");
    }
}

#[test]
fn what_is_never_seen_is_dropped() {
    let uniforms = uniforms();
    let unit = MotionSetup::new(&config(), 1);
    let facing = at(5.0);
    let drawn = |splat: Splat, motion: [f64; 3]| unit.setup(&moving(splat, motion), &uniforms).is_some();
    assert!(drawn(facing, [0.0; 3]) && drawn(facing, [0.0, 0.0, -8.0]));
    assert!(!drawn(at(0.5), [0.0; 3]), "before the near plane");
    assert!(drawn(at(0.5), [0.0, 0.0, 2.0]), "it comes from there");
    assert!(!drawn(at(12.0), [0.0; 3]), "behind the far plane");
    assert!(drawn(at(12.0), [0.0, 0.0, 4.0]), "it goes there");
    let [first, second] = facing.tangents;
    assert!(!drawn(Splat { tangents: [second, first], ..facing }, [0.0; 3]), "it faces away");
    assert!(!drawn(Splat { tangents: [first, first], ..facing }, [0.0; 3]), "edge-on");
    let beside = Splat { center: [9.0, 0.0, 5.0].map(number), ..facing };
    assert!(!drawn(beside, [0.0; 3]) && drawn(beside, [-9.0, 0.0, 0.0]), "it enters the image");
    let end = Splat { end: true, ..moving(facing, [0.0; 3]) };
    assert!(unit.setup(&end, &uniforms).is_some_and(|splat| splat.end));
}
