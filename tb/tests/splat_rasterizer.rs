//! `splat_rasterizer` against its model, in every cycle.

use pointcore_contract::splat::records::{CompleteCopy, Sample};
use pointcore_contract::splat::units;
use pointcore_golden::splat::{MotionRasterizer, Rasterizer};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::rasterizer;

use crate::splat::{Device, configs, hard, integer_configs, integers, knobs, moving_configs, scene};
use crate::support::cases;

const SPLATS: usize = 1500;

#[test]
fn it_agrees_with_the_model() {
    for config in cases(configs().into_iter().chain(knobs()).chain(integer_configs()).chain(moving_configs())) {
        let hardware = rasterizer::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let device = Device::new(&config, &hardware.module, &units::rasterizer::UNIT);
        let mut random = scene::random();
        let copies = scene::touch(&config, &scene::copies(&config, SPLATS), 3, &mut random);
        let mut copies = scene::complete_copies(&config, copies, &mut random);
        scene::scatter(&config, &mut copies, 2, &mut random);
        hard::magnify(&config, &mut copies, 4, &mut random);
        integers::shrink(&config, &mut copies, 4, &mut random);
        integers::divide(&config, &mut copies, 8, &mut random);
        let latency = hardware.manifest.latency;
        let run = |copies: &[CompleteCopy], uniforms| -> Vec<Sample> {
            let uniforms = scene::named(&config, uniforms);
            if config.has_motion() {
                device.run(&MotionRasterizer::new(&config, latency), copies, &uniforms)
            } else {
                device.run(&Rasterizer::new(&config, latency), copies, &uniforms)
            }
        };
        let (upright, turned) = copies.split_at(copies.len() / 2);
        let mut uniforms = scene::turned(&config, &mut random);
        // With another exponent than the upright camera's.
        let depth_a = 2.0 + 60.0 * random.f32();
        uniforms.viewport.depth_a = pointcore::number::encode(config.geometry, depth_a);
        let turned = run(turned, uniforms);
        let samples = [run(upright, scene::registers(&config)), turned].concat();
        let places = || samples.iter().map(|sample| sample.place);
        let inside = places().filter(|place| place.inside).count();
        assert!(inside > 2 * SPLATS, "{inside} samples lie inside {SPLATS} splats");
        let last = places().filter(|place| place.last).count();
        assert_eq!(last, copies.len(), "every copy has a last sample");
    }
}
