//! `splat_rasterizer` against its model, in every cycle.

use pointcore_contract::splat::ports;
use pointcore_golden::splat::Rasterizer;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::rasterizer;

use crate::splat::{Device, configs, integer_configs, knobs, scene};

const SPLATS: usize = 700;

#[test]
fn it_agrees_with_the_model() {
    for config in configs().into_iter().chain(knobs()).chain(integer_configs()) {
        let hardware = rasterizer::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let device = Device::new(&config, &hardware.module, ports::rasterizer(&config));
        let copies = scene::placed_copies(&config, SPLATS);
        let model = Rasterizer::new(&config, hardware.manifest.latency);
        let samples = device.run(&model, &copies, &scene::uniforms(&config));
        // Fields `end`, `last`, `inside`.
        let inside = samples.iter().filter(|sample| sample[0] == 0 && sample[2] == 1).count();
        assert!(inside > 2 * SPLATS, "{inside} samples lie inside {SPLATS} splats");
        let last = samples.iter().filter(|sample| sample[0] == 0 && sample[1] == 1).count();
        assert_eq!(last, copies.len() - 1, "every copy has a last sample");
        assert_eq!(samples.iter().filter(|sample| sample[0] == 1).count(), 1);
    }
}
