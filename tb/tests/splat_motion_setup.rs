//! `splat_motion_setup` against its model, in every cycle.

use pointcore::stimuli::motion;
use pointcore_contract::splat::records::{SetupSplat, Splat};
use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::MotionSetup;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::motion_setup;

use crate::splat::{Device, hard, moving_configs, scene};
use crate::support::cases;

const SPLATS: usize = 5000;

/// Moving splats of every family, frames' ends, some whose fields are noise: numbers of every size, infinities, no numbers. And some of
/// another magnitude.
fn splats(config: &Config) -> Vec<Splat> {
    let mut random = scene::random();
    let families = motion::Family::ALL.into_iter().cycle();
    let mut splats: Vec<Splat> = families
        .map(|family| {
            let whole = motion::splat(&mut random, family);
            // Across bins, or in one.
            let splat = if random.bool() { whole } else { motion::moved(&mut random, family, config).splat };
            motion::encoded(&splat, config, &mut random)
        })
        .take(SPLATS)
        .collect();
    for _ in 0..SPLATS / 8 {
        let noise = scene::noise::<Splat>(config, &mut random);
        let splat = &mut splats[random.usize(0..SPLATS)];
        match random.u8(0..5) {
            0 => *splat = noise,
            1 => splat.end = true,
            2 => splat.motion.way[random.usize(0..3)] = 0,
            3 => splat.center[random.usize(0..3)] = noise.motion.way[0],
            _ => splat.motion.way[random.usize(0..3)] = noise.motion.way[0],
        }
    }
    hard::scale(config, &mut splats, 8, &mut random);
    splats
}

#[test]
fn it_agrees_with_the_model_on_splats_of_all_families() {
    for config in cases(moving_configs()) {
        let hardware = motion_setup::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        for (class, used) in &hardware.manifest.operators {
            println!("{class}: {} operations on {}", used.operations, used.instances);
        }
        println!("latency {}", hardware.manifest.latency);
        let device = Device::new(&config, &hardware.module, &units::motion_setup::UNIT);
        let splats = splats(&config);
        let model = MotionSetup::new(&config, hardware.manifest.latency);
        let uniforms: Vec<_> = motion::uniforms(&config);
        let passed: Vec<SetupSplat> = device.run(&model, &splats, &uniforms);
        assert!((SPLATS / 2..SPLATS).contains(&passed.len()), "{} of {SPLATS} splats are in view", passed.len());
    }
}
