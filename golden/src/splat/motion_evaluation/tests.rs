use super::*;
use crate::splat::Rasterizer;
use crate::testing::for_each_seed;
use fastrand::Rng;
use pointcore_contract::splat::Feature;
use pointcore_contract::splat::motion::SHARE_BITS;
use pointcore_contract::splat::records::Footprint;

fn number(value: f64) -> u32 {
    (value as f32).to_bits()
}

/// A disc of three to seven pixels about the image's middle, which stands still, and the same as the static core has it.
fn still(random: &mut Rng) -> (MovingFootprint, Footprint) {
    let mut spread = || 2.0 * random.f64() - 1.0;
    let (radius, turn) = (5.0 + 2.0 * spread(), 3.2 * spread());
    let center = [32.0 + spread(), 24.0 + spread()].map(number);
    let [[ax, ay], [bx, by]] =
        [[turn.cos(), turn.sin()], [-turn.sin(), turn.cos()]].map(|part| part.map(|part| number(part / radius)));
    let m = [0.02 * spread(), 0.02 * spread()].map(number);
    let negated = |bits: u32| bits ^ 0x8000_0000;
    let one = number(1.0);
    let fixed = Footprint { center, ax, bx, ay, by, delta: one, mx: m[0], my: m[1], ..Footprint::default() };
    let moving = MovingFootprint {
        center,
        determinant: m,
        place: [[by, negated(bx)], [negated(ay), ax]],
        distance: [one, 0],
        depth_scale: number(-0.1),
        // The third of four bins.
        life: [number(0.0), number(0.5)],
        planes: [f32::NEG_INFINITY, f32::INFINITY, 0.0].map(f32::to_bits),
        ..MovingFootprint::default()
    };
    (moving, fixed)
}

fn config() -> Config {
    Config {
        width: 64,
        height: 48,
        time_bins: 4,
        screen_filter: Feature::Off,
        eye_plane: Feature::Off,
        kernel_index_bits: 10,
        ..Config::default()
    }
}

#[test]
fn a_splat_that_does_not_move_has_the_static_weight_for_all_of_its_bin() {
    let config = config();
    let (unit, rasterizer) = (MotionEvaluation::new(&config, 1), Rasterizer::new(&config, 1));
    for_each_seed("motion_evaluation", |random| {
        for _ in 0..200 {
            let (footprint, fixed) = still(random);
            let mut covered = 0;
            for (column, row) in (14..30).flat_map(|row| (22..42).map(move |column| (column, row))) {
                let place = MovingPlace { column, row, footprint, ..MovingPlace::default() };
                let sample = unit.evaluate(&place, number(1.1));
                let squared = rasterizer.squared_distance(&fixed, [column, row].map(u32::from), 0);
                let is_inside = Rasterizer::is_inside(squared);
                if (squared.value() - 1.0).abs() > 1e-5 {
                    assert_eq!(sample.inside, is_inside, "{squared:?}");
                }
                if !(sample.inside && is_inside) {
                    continue;
                }
                assert_eq!(sample.time, [1 << 14; 2]);
                assert_eq!(sample.depth[0], sample.depth[1]);
                let whole = 4.0 * f64::from(sample.share) / f64::from(1 << SHARE_BITS);
                let weight = f64::from(rasterizer.weight(squared)) / 65535.0;
                assert!((whole - weight).abs() < 1.0 / 32768.0, "{whole} beside {weight}");
                covered += 1;
            }
            assert!(covered > 20, "{covered}");
        }
    });
}

#[test]
fn numbers_that_are_none_cover_nothing() {
    let unit = MotionEvaluation::new(&config(), 1);
    for_each_seed("motion_evaluation", |random| {
        let (footprint, _) = still(random);
        let inside = |footprint: MovingFootprint| {
            let place = MovingPlace { column: 32, row: 24, footprint, ..MovingPlace::default() };
            unit.evaluate(&place, number(1.1)).inside
        };
        assert!(inside(footprint));
        let none = f32::NAN.to_bits();
        assert!(!inside(MovingFootprint { center: [none, footprint.center[1]], ..footprint }));
        assert!(!inside(MovingFootprint { determinant: [none; 2], ..footprint }));
        assert!(!inside(MovingFootprint { place: [[none; 2], footprint.place[1]], ..footprint }));
        assert!(!inside(MovingFootprint { speed: [footprint.speed[0], [none; 3]], ..footprint }));
    });
}
