//! `splat_weighting` against its model, in every cycle.

use pointcore_contract::splat::records::{Sample, WeightedSample};
use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::Weighting;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::weighting;

use crate::splat::{Device, configs, fixed_configs, moving_configs, scene};
use crate::support::cases;

const SAMPLES: usize = 8000;

/// Samples of splats, and some whose fields are noise: numbers of every size, infinities, no numbers.
fn samples(config: &Config) -> Vec<Sample> {
    let mut random = scene::random();
    let mut samples = scene::samples(config, SAMPLES / 7);
    samples.truncate(SAMPLES);
    samples.extend((0..SAMPLES / 4).map(|_| scene::noise::<Sample>(config, &mut random)));
    samples
}

#[test]
fn it_agrees_with_the_model() {
    for config in cases(configs().into_iter().chain(fixed_configs()).chain(moving_configs())) {
        let hardware = weighting::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let device = Device::new(&config, &hardware.module, &units::weighting::UNIT);
        let samples = samples(&config);
        assert!(samples.len() > SAMPLES, "{} samples", samples.len());
        let weighted: Vec<WeightedSample> =
            device.run(&Weighting::new(&config, hardware.manifest.latency), &samples, &[]);
        assert_eq!(weighted.len(), samples.len());
    }
}
