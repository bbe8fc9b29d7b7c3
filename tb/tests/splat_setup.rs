//! `splat_setup` against its model, in every cycle.

use pointcore_contract::splat::records::SetupSplat;
use pointcore_contract::splat::units;
use pointcore_golden::splat::Setup;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::setup;

use crate::splat::{Device, configs, edges, hard, integer_configs, knobs, scene};
use crate::support::cases;

const SPLATS: usize = 4000;
const CAMERAS: usize = 6;

#[test]
fn it_agrees_with_the_model_on_splats_of_all_kinds() {
    for config in cases(configs().into_iter().chain(knobs()).chain(integer_configs())) {
        let hardware = setup::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let device = Device::new(&config, &hardware.module, &units::setup::UNIT);
        let mut splats = scene::camera(&config, SPLATS);
        let mut random = scene::random();
        hard::spoil(&config, &mut splats, 16, &mut random);
        hard::cross_the_eye(&config, &mut splats, 4, &mut random);
        edges::border(&config, &mut splats, 3, &mut random);
        hard::strew(&config, &mut splats, 8, &mut random);
        edges::tie(&config, &mut splats, 8, &mut random);
        edges::pass_by(&config, &mut splats, 16, &mut random);
        edges::graze(&config, &mut splats, 8, &mut random);
        hard::flatten(&mut splats, 16, &mut random);
        hard::scale(&config, &mut splats, 4, &mut random);
        hard::tilt(&config, &mut splats, 4, &mut random);
        let model = Setup::new(&config, hardware.manifest.latency);
        for camera in 0..CAMERAS {
            let upright = scene::registers(&config);
            let uniforms = if camera == 0 { upright } else { scene::turned(&config, &mut random) };
            let passed: Vec<SetupSplat> = device.run(&model, &splats, &scene::named(&config, uniforms));
            let passed = passed.len();
            assert!((SPLATS / 10..splats.len()).contains(&passed), "{passed} of {} splats are in view", splats.len());
        }
    }
}
