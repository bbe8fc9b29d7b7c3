//! `splat_motion_evaluation` against its model, in every cycle.

use pointcore::stimuli::motion::{Family, camera, moved, rendering};
use pointcore_contract::splat::records::{MovingPlace, MovingSample};
use pointcore_contract::splat::{Config, Feature, units};
use pointcore_golden::reference::motion::MovingFootprint;
use pointcore_golden::splat::MotionEvaluation;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::motion_evaluation;

use crate::splat::{Device, moving_configs, scene};

const PLACES: usize = 1500;

/// Samples of moving splats of every family, and some whose fields are noise: numbers of every size, infinities, no numbers.
fn places(config: &Config) -> Vec<MovingPlace> {
    let mut random = scene::random();
    let (camera, rendering) = (camera(config), rendering(config));
    let mut places: Vec<MovingPlace> = Family::ALL
        .into_iter()
        .cycle()
        .filter_map(|family| {
            let moved = moved(&mut random, family, config);
            let footprint = MovingFootprint::new(&moved.splat, &camera, &rendering).ok()?.encoded(config.geometry);
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
    for config in moving_configs() {
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
        // Both tables are of one class, and share nothing.
        let most = used.operations.div_ceil(hardware.manifest.initiation_interval) + 1;
        assert!(used.instances <= most, "{class}: {} operations on {}", used.operations, used.instances);
    }
    assert!(operations > 100);
}
