//! `splat_motion_evaluation` against its model, in every cycle.

use pointcore::stimuli::motion::{Family, camera, moved, rendering};
use pointcore_contract::splat::records::{MovingPlace, MovingSample};
use pointcore_contract::splat::{Config, Feature, units};
use pointcore_golden::reference::motion::{Interval, MovingFootprint, Place};
use pointcore_golden::splat::MotionEvaluation;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::motion_evaluation;

use crate::splat::{Device, moving_configs, scene};
use crate::support::cases;

const PLACES: usize = 2500;

/// Speeds below which a splat counts as still, and as a narrow one of a bin, in kernel radii a unit of `τ`.
fn speeds(config: &Config) -> [f64; 2] {
    [2_f64.powi(-30), f64::from(config.time_bins) / 32.0]
}

/// A footprint of which a number is compared at a sample with one that hardly differs: by one of its digits, or none; or one on whose line
/// the sample nearly lies.
fn touching(
    config: &Config,
    footprint: &MovingFootprint,
    place: &Place,
    random: &mut fastrand::Rng,
) -> MovingFootprint {
    let digit = 2_f64.powi(-random.i32(0..config.geometry.mantissa as i32 + 2));
    let hair = 1.0 + digit * f64::from(random.i8(-1..=1));
    let (mut touching, met) = (footprint.clone(), footprint.meet(place));
    let [at, speed] = [met.place, met.speed].map(glam::DVec2::from);
    let whole = Interval { begin: -4.0, end: 4.0 };
    let covered = met.squared_distance(footprint.time).within_kernel(whole).unwrap_or(footprint.life);
    let time = hair * if random.bool() { covered.begin } else { covered.end };
    let [.., offset] = footprint.planes;
    match random.u8(0..7) {
        0 => {
            let by = hair * speeds(config)[random.usize(0..2)] / speed.length();
            touching.speed = touching.speed.map(|form| form.map(|number| by * number));
        }
        kind @ (1 | 2) => {
            let distance = if kind == 1 { hair } else { digit };
            let by = distance / at.perp_dot(speed.normalize_or(glam::DVec2::X)).abs();
            touching.place = touching.place.map(|form| form.map(|number| by * number));
        }
        3 => touching.life.begin = time,
        4 => touching.life.end = time,
        5 => touching.planes[0] = (time + offset) / met.determinant,
        _ => touching.planes[1] = (time + offset) / met.determinant,
    }
    touching
}

/// Samples of moving splats of every family. Some touch what they are compared with. Of some, fields are noise: numbers of every size,
/// infinities, no numbers.
fn places(config: &Config) -> Vec<MovingPlace> {
    let mut random = scene::random();
    let (camera, rendering) = (camera(config), rendering(config));
    let mut places: Vec<MovingPlace> = Family::ALL
        .into_iter()
        .cycle()
        .filter_map(|family| {
            let moved = moved(&mut random, family, config);
            let whole = MovingFootprint::new(&moved.splat, &camera, &rendering).ok()?;
            let touches = random.u8(0..3) == 0;
            let footprint = if touches { touching(config, &whole, &moved.place, &mut random) } else { whole };
            let footprint = footprint.encoded(config.geometry);
            let (last, slot) = (random.u8(0..8) == 0, random.u8(0..config.tile_slots as u8));
            let (column, row) = (moved.place.column as u16, moved.place.row as u16);
            let bin = (moved.splat.part.middle() + 1.0) * 0.5 * f64::from(config.time_bins);
            let odd_bin = bin as u32 % 2 == 1;
            Some(MovingPlace { last, slot, column, row, odd_bin, footprint })
        })
        .take(PLACES)
        .collect();
    for _ in 0..PLACES / 10 {
        let noise = scene::noise::<MovingPlace>(config, &mut random);
        let place = random.usize(0..places.len());
        // All of it, or but one of its numbers.
        if random.bool() {
            places[place] = noise;
        } else {
            let numbers = &mut places[place].footprint;
            let choices =
                [&mut numbers.time, &mut numbers.determinant[0], &mut numbers.place[1][0], &mut numbers.speed[0][2]];
            let choice = random.usize(0..choices.len());
            *choices.into_iter().nth(choice).expect("it is one of them") = noise.footprint.time;
        }
    }
    places
}

#[test]
fn it_agrees_with_the_model_on_splats_of_all_families() {
    for config in cases(moving_configs()) {
        let hardware =
            motion_evaluation::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let device = Device::new(&config, &hardware.module, &units::motion_evaluation::UNIT);
        let places = places(&config);
        let depth_a = pointcore::number::encode(config.geometry, camera(&config).depth_a as f32);
        let constants = [("depth_a".to_owned(), u64::from(depth_a))];
        let model = MotionEvaluation::new(&config, hardware.manifest.latency);
        let samples: Vec<MovingSample> = device.run(&model, &places, &constants);
        let inside = samples.iter().filter(|sample| sample.inside).count();
        assert!(inside > PLACES / 4, "only {inside} of {} are inside", places.len());
        assert!(samples.len() < places.len(), "none is left out");
    }
}

#[test]
fn operators_are_shared_over_the_cycles_of_a_sample() {
    let config = Config { time_bins: 4, sample_interval: 4, screen_filter: Feature::Off, ..Config::default() };
    let hardware = motion_evaluation::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    println!("latency {}", hardware.manifest.latency);
    let mut operations = 0;
    for (class, used) in &hardware.manifest.operators {
        println!("{class}: {} operations on {}", used.operations, used.instances);
        operations += used.operations;
        // Comparisons share nothing; nor do both tables, which are of one class.
        let most = match class.starts_with('l') {
            true => used.operations,
            false => used.operations.div_ceil(hardware.manifest.initiation_interval) + 1,
        };
        assert!(used.instances <= most, "{class}: {} operations on {}", used.operations, used.instances);
    }
    assert!(operations > 100);
}
