//! `splat_splitter` against its model, in every cycle.

use pointcore_contract::splat::records::{ImageRectangle, SetupSplat, SplatCopy};
use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::Splitter;
use pointcore_hdl::splat::splitter;

use crate::splat::{Device, configs, scene};

const SPLATS: u64 = 500;

/// Fields of noise with a rectangle within the image: mostly a small one, sometimes one of any size.
fn splats(config: &Config) -> Vec<SetupSplat> {
    let mut random = scene::random();
    let splat = |index| {
        let noise: SetupSplat = scene::noise(config, &mut random);
        let extent = if random.u8(0..8) == 0 { u32::MAX } else { 12 };
        let [[left, right], [top, bottom]] = [config.width, config.height].map(|edge| {
            let first = random.u32(0..edge);
            [first, random.u32(first..edge.min(first.saturating_add(extent)))].map(|pixel| pixel as u16)
        });
        SetupSplat { end: index % 100 == 99, bounds: ImageRectangle { left, right, top, bottom }, ..noise }
    };
    (0..SPLATS).map(splat).collect()
}

#[test]
fn it_agrees_with_the_model() {
    for config in configs() {
        let device = Device::new(&config, &splitter::module(&config), &units::splitter::UNIT);
        let copies: Vec<SplatCopy> = device.run(&Splitter::new(&config), &splats(&config), &[]);
        assert!(copies.len() as u64 > 2 * SPLATS, "{} copies", copies.len());
        let ends = copies.iter().filter(|copy| copy.end).count() as u64;
        assert_eq!(ends, SPLATS / 100);
    }
}
