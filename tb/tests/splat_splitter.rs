//! `splat_splitter` against its model, in every cycle.

use pointcore_contract::splat::records::{ImageDiagonals, ImageRectangle, SetupSplat, SplatCopy};
use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::Splitter;
use pointcore_hdl::splat::splitter;

use crate::splat::{Device, configs, moving_configs, scene};
use crate::support::cases;

const SPLATS: u64 = 24_000;

/// Fields of noise with a rectangle within the image: mostly a small one, sometimes one of any size; and an octagon in it, or noise for one.
fn splats(config: &Config) -> Vec<SetupSplat> {
    let mut random = scene::random();
    let splat = |index| {
        let noise: SetupSplat = scene::noise(config, &mut random);
        let extent = if random.u8(0..8) == 0 { u32::MAX } else { 12 };
        let [[left, right], [top, bottom]] = [config.width, config.height].map(|edge| {
            let first = random.u32(0..edge);
            [first, random.u32(first..edge.min(first.saturating_add(extent)))].map(|pixel| pixel as u16)
        });
        let per_pixel = config.sampling.columns() as u16;
        let row_mask = (1 << config.row_bits()) - 1;
        // Of two pixels within the rectangle, so that something of it is left.
        let mut pixel = || [random.u16(left..=right) / per_pixel, random.u16(top..=bottom)];
        let [[a, b], [c, d]] = [pixel(), pixel()];
        let [sums, differences] = [[a + b, c + d], [a + (row_mask - b), c + (row_mask - d)]];
        // Or hardly so, and of some rectangles nothing.
        let inset = if random.u8(0..4) == 0 { 6 } else { 0 };
        let mut limits = |[a, b]: [u16; 2]| {
            let [below, above] = [random.u16(..12), random.u16(..12)];
            let [first, last] = [(a.min(b) + inset).saturating_sub(below), (a.max(b) + above).saturating_sub(inset)];
            [first, last].map(|limit| limit.min((1 << config.diagonal_bits()) - 1))
        };
        let ([first_sum, last_sum], [first_difference, last_difference]) = (limits(sums), limits(differences));
        let octagon = ImageDiagonals { first_sum, last_sum, first_difference, last_difference };
        let diagonals = if random.u8(0..8) == 0 { noise.diagonals } else { octagon };
        SetupSplat { end: index % 100 == 99, bounds: ImageRectangle { left, right, top, bottom }, diagonals, ..noise }
    };
    (0..SPLATS).map(splat).collect()
}

#[test]
fn it_agrees_with_the_model() {
    let [bare, full, mixed] = configs();
    for config in
        cases([Config { rasterizers: 2, ..bare.clone() }, bare, full, mixed].into_iter().chain(moving_configs()))
    {
        let device = Device::new(&config, &splitter::module(&config), &units::splitter::UNIT);
        let copies: Vec<SplatCopy> = device.run(&Splitter::new(&config), &splats(&config), &[]);
        assert!(copies.len() as u64 > SPLATS * 3 / 2, "{} copies", copies.len());
        let ends = copies.iter().filter(|copy| copy.end).count() as u64;
        assert_eq!(ends, SPLATS / 100);
    }
}
