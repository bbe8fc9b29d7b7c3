//! `splat_transform` against its model, in every cycle.

use pointcore_contract::splat::records::Splat;
use pointcore_contract::splat::units;
use pointcore_golden::splat::Transform;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::transform;

use crate::splat::{Device, configs, fixed_configs, hard, moving_configs, scene};
use crate::support::cases;

const SPLATS: usize = 4000;

#[test]
fn it_agrees_with_the_model_on_splats_of_all_kinds() {
    for config in cases(configs().into_iter().chain(fixed_configs()).chain(moving_configs())) {
        let hardware = transform::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let device = Device::new(&config, &hardware.module, &units::transform::UNIT);
        let mut splats = scene::world(&config, SPLATS);
        let mut random = scene::random();
        hard::approach(&config, &mut splats, 4, &mut random);
        hard::spoil(&config, &mut splats, 16, &mut random);
        let model = Transform::new(&config, hardware.manifest.latency);
        let passed: Vec<Splat> = device.run(&model, &splats, &scene::uniforms(&config));
        let passed = passed.len();
        assert!((SPLATS / 2..SPLATS).contains(&passed), "{passed} of {SPLATS} splats lie beyond the near plane");
        // Several cameras: of one, each number has one magnitude.
        for near_plane in [0.0, 0.0, 0.0, 0.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
            let camera = scene::named(&config, scene::any_camera(&config, near_plane, &mut random));
            let passed: Vec<Splat> = device.run(&model, &splats[..SPLATS / 4], &camera);
            let frames = passed.iter().filter(|splat| splat.end).count();
            assert!(near_plane != 0.0 || passed.len() > SPLATS / 40, "{} splats lie before the eye", passed.len());
            assert!(!near_plane.is_nan() || passed.len() == frames, "{} splats lie before nothing", passed.len());
        }
    }
}
