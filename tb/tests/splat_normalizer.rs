//! `splat_normalizer` against its model, in every cycle.

use fastrand::Rng;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{FinishedPixel, Fragment};
use pointcore_contract::splat::{AttributeFormat, Config, units};
use pointcore_golden::splat::Normalizer;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::normalizer;

use crate::splat::exchange::time;
use crate::splat::{Device, configs, fixed_configs, knobs, moving_configs, scene};
use crate::support::cases;

const PIXELS: u64 = 25_000;

/// A sum of attributes whose weights are `weight` together: in floating point between −8 and 8 times it, in fixed point up to its negative and
/// a little beyond one.
fn sum(config: &Config, weight: u64, random: &mut Rng) -> u64 {
    match config.attribute {
        AttributeFormat::Float(format) => scene::encode(format, weight as f32 / 65536.0 * 16.0 * (random.f32() - 0.5)),
        AttributeFormat::Fixed(fraction) => {
            let one = (weight << fraction.number().fraction) as i64;
            let sum = match random.u8(0..8) {
                0 => -one,
                1 => one - random.i64(0..=one >> 6),
                // Less than the limit by a single bit.
                2 => {
                    one - (one >> random.u32(1..fraction.number().fraction))
                        - random.i64(0..=one >> fraction.number().fraction)
                }
                _ => random.i64(-one..=one),
            };
            sum as u64 & (u64::MAX >> (64 - fraction.sum().width))
        }
    }
}

/// Weights of every magnitude, depths that go with them or are hard to round, sums of attributes as below and now and then of any bits.
fn pixels(config: &Config) -> Vec<FinishedPixel> {
    let mut random = scene::random();
    let pixel = |index| {
        let mut finished: FinishedPixel = scene::noise(config, &mut random);
        finished.end = index % 250 == 249;
        let value = &mut finished.placed.value;
        value.weight = (value.weight >> random.u32(0..28)).max(1);
        let weight = u64::from(value.weight);
        value.depth = weight * random.u64(0..1 << DEPTH_BITS);
        if random.u8(0..4) == 0 {
            // Halfway between two numbers of fewer bits, or next to that.
            let below = random.u32(1..40);
            let next = if random.bool() { 1 << random.u32(0..below) } else { 0 };
            value.depth = (value.depth >> below << below | 1 << (below - 1)) ^ next;
        }
        if random.u8(0..8) > 0 {
            value.attributes[..config.continuous as usize].fill_with(|| sum(config, weight, &mut random));
        }
        if config.has_motion() && random.bool() {
            // Parts are of any bits; where the spans end decides which of them count.
            (value.bin.nearest, value.bin.any) = (time(config, &mut random), time(config, &mut random));
        }
        finished
    };
    (0..PIXELS).map(pixel).collect()
}

#[test]
fn it_agrees_with_the_model() {
    for config in cases(configs().into_iter().chain(fixed_configs()).chain(knobs()).chain(moving_configs())) {
        let hardware = normalizer::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let device = Device::new(&config, &hardware.module, &units::normalizer::UNIT);
        let fragments: Vec<Fragment> = device.run(
            &Normalizer::new(&config, hardware.manifest.latency),
            &pixels(&config),
            &scene::uniforms(&config),
        );
        assert_eq!(fragments.len() as u64, PIXELS);
        assert_eq!(fragments.iter().filter(|fragment| fragment.end).count() as u64, PIXELS / 250);
    }
}
