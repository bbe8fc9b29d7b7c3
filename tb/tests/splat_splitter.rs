//! `splat_splitter` against its model, in every cycle.

use pointcore_contract::splat::{Config, ports, records};
use pointcore_golden::splat::Splitter;
use pointcore_hdl::splat::splitter;

use crate::splat::{Device, configs, scene};

const SPLATS: u64 = 500;

/// Fields of noise with a rectangle within the image: mostly a small one, sometimes one of any size.
fn splats(config: &Config) -> Vec<Vec<u64>> {
    let mut random = scene::random();
    let fields = records::setup(config);
    let splat = |index| {
        let mut record = scene::noise(&fields, &mut random);
        record[0] = u64::from(index % 100 == 99);
        let extent = if random.u8(0..8) == 0 { u32::MAX } else { 12 };
        let bounds = [config.width, config.height].map(|edge| {
            let first = random.u32(0..edge);
            [first, random.u32(first..edge.min(first.saturating_add(extent)))].map(u64::from)
        });
        let place = fields.len() - 4;
        record[place..].copy_from_slice(bounds.as_flattened());
        record
    };
    (0..SPLATS).map(splat).collect()
}

#[test]
fn it_agrees_with_the_model() {
    for config in configs() {
        let device = Device::new(&config, &splitter::module(&config), ports::splitter(&config));
        let copies = device.run(&Splitter::new(&config), &splats(&config), &[]);
        assert!(copies.len() as u64 > 2 * SPLATS, "{} copies", copies.len());
        let ends = copies.iter().filter(|copy| copy[0] == 1).count() as u64;
        assert_eq!(ends, SPLATS / 100);
    }
}
