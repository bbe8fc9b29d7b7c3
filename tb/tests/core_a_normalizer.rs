//! `core_a_normalizer` against its model, in every cycle.

use pointcore_golden::core_a::Normalizer;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::core_a::normalizer;
use pointcore_spec::core_a::config::DEPTH_BITS;
use pointcore_spec::core_a::{Config, ports, records};

use crate::core_a::{Device, configs, scene};

const PIXELS: u64 = 2000;
/// Fields before the attributes: `end`, `tile`, `pixel`, `weight`, `depth`.
const WEIGHT: usize = 3;

/// Weights of every magnitude, depths that go with them, attributes between −8 and 8 times the weight and now and then any bits.
fn pixels(config: &Config) -> Vec<Vec<u64>> {
    let mut random = scene::random();
    let fields = records::finished_pixel(config);
    let attributes = fields.iter().position(|(name, _)| name.starts_with("attribute")).expect("the test carries some");
    let pixel = |index| {
        let mut record = scene::noise(&fields, &mut random);
        record[0] = u64::from(index % 250 == 249);
        record[WEIGHT] = (record[WEIGHT] >> random.u32(0..28)).max(1);
        record[WEIGHT + 1] = record[WEIGHT] * random.u64(0..1 << DEPTH_BITS);
        if random.u8(0..8) > 0 {
            let weight = record[WEIGHT] as f32 / 65536.0;
            for attribute in &mut record[attributes..attributes + config.continuous as usize] {
                *attribute = scene::encode(config.attribute, weight * 16.0 * (random.f32() - 0.5));
            }
        }
        record
    };
    (0..PIXELS).map(pixel).collect()
}

#[test]
fn it_agrees_with_the_model() {
    for config in configs() {
        let hardware = normalizer::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let device = Device::new(&hardware.module, ports::normalizer(&config));
        let fragments = device.run(&Normalizer::new(&config, hardware.manifest.latency), &pixels(&config), &[]);
        assert_eq!(fragments.len() as u64, PIXELS);
        assert_eq!(fragments.iter().filter(|fragment| fragment[0] == 1).count() as u64, PIXELS / 250);
    }
}
