//! Random splats of all kinds, as words, on every unit's input.

use fastrand::Rng;
use pointcore_contract::Format;
use pointcore_contract::splat::ports;
use pointcore_contract::splat::records::{EpsilonScale, ModelView, Uniforms, Viewport};
use pointcore_contract::splat::{AttributeFormat, Config, Field, records};
use pointcore_contract::{fields, words};
use pointcore_golden::splat::{Rasterizer, Setup, Splitter, Transform};
use pointcore_tb::lockstep::seed;

use super::through;

/// Splats between two end records.
const FRAME: usize = 120;
/// Geometry fields of a splat behind `end`.
const GEOMETRY: std::ops::Range<usize> = 1..10;
/// Numbers that are none, or hardly.
const ODD: [f32; 8] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -0.0, f32::MAX, 1e-40, -1e-20];

/// Randomness of the stimulus: the same whatever the stalls, unless the environment has another seed.
pub fn random() -> Rng {
    Rng::with_seed(seed().expect("POINTCORE_SEED is a number"))
}

/// A number in one of the core's formats.
pub fn encode(format: Format, number: f32) -> u64 {
    pointcore::number::encode(format, number).into()
}

/// A continuous attribute in the core's format.
pub fn encode_attribute(config: &Config, number: f32) -> u64 {
    pointcore::number::encode_attribute(config.attribute, number).into()
}

/// The uniform registers: a camera that looks at the origin, a little from above.
pub fn registers(config: &Config) -> Uniforms {
    let (sin, cos) = 0.3_f32.sin_cos();
    let number = |number| pointcore::number::encode(config.geometry, number);
    let (width, height) = (config.width as f32, config.height as f32);
    let rows = [[1.0, 0.0, 0.0, 0.1], [0.0, cos, -sin, -0.2], [0.0, sin, cos, 4.0]];
    let filter_scale = 1.0 / (0.9 * 0.9);
    Uniforms {
        model_view: ModelView { rows: rows.map(|row| row.map(number)) },
        viewport: Viewport {
            scale: [0.9 * width; 2].map(number),
            origin: [width / 2.0, height / 2.0].map(number),
            depth_a: number(10.0 / 9.0),
            depth_b: number(-10.0 / 9.0),
        },
        near_plane: number(1.0),
        epsilon: EpsilonScale { scale: number(0.7), bias: number(0.02) },
        filter_radius: number(0.9),
        filter_scale: pointcore::number::encode_uniform(config.filter_scale_format(), filter_scale),
    }
}

/// Their names and values.
pub fn uniforms(config: &Config) -> Vec<(String, u64)> {
    let names = fields::<Uniforms>(config).into_iter().map(|field| field.name);
    names.zip(words(config, registers(config))).collect()
}

/// Fills fields with random bits.
pub fn noise(fields: &[Field], random: &mut Rng) -> Vec<u64> {
    fields.iter().map(|(_, width)| random.u64(..) >> (64 - width)).collect()
}

fn end(words: usize) -> Vec<u64> {
    let mut record = vec![0; words];
    record[0] = 1;
    record
}

/// A disc, rarely a sliver, somewhere around the view: some beside it, behind the eye, across the eye plane, beyond the far plane.
fn splat(config: &Config, random: &mut Rng) -> Vec<u64> {
    let mut centered = || 2.0 * random.f32() - 1.0;
    let z = 4.5 * centered() + 1.5;
    let spread = 0.6 * (z + 4.5);
    let center = [spread * centered(), spread * centered(), z];
    let [a, b] = [(); 2].map(|()| glam::Vec3::new(centered(), centered(), centered()));
    let normal = a.try_normalize().unwrap_or(glam::Vec3::Z);
    let first = normal.cross(b).try_normalize().unwrap_or(normal.any_orthonormal_vector());
    let radius = 2_f32.powf(3.5 * centered() - 2.5);
    let shorter = if random.u8(0..8) == 0 { random.f32() } else { 1.0 };
    let tangents = [first * radius, normal.cross(first) * (radius * shorter)];
    let geometry = center.into_iter().chain(tangents.into_iter().flat_map(|tangent| tangent.to_array()));
    let continuous: Vec<f32> = (0..config.continuous).map(|_| 4.0 * random.f32() - 2.0).collect();
    let mut record = vec![0];
    record.extend(geometry.map(|number| encode(config.geometry, number)));
    record.extend(continuous.into_iter().map(|number| encode_attribute(config, number)));
    record.extend((0..config.cardinal).map(|_| random.u64(..) >> (64 - config.attribute.width())));
    record
}

/// Replaces a number of one splat in `one_in` by an odd one, and a continuous attribute of as many.
pub fn spoil(config: &Config, splats: &mut [Vec<u64>], one_in: u32, random: &mut Rng) {
    let attributes = GEOMETRY.end..GEOMETRY.end + config.continuous as usize;
    for splat in splats {
        let formats = [(GEOMETRY, AttributeFormat::Float(config.geometry)), (attributes.clone(), config.attribute)];
        for (places, format) in formats {
            if random.u32(0..one_in) == 0 {
                let odd = ODD[random.usize(0..ODD.len())];
                splat[random.usize(places)] = pointcore::number::encode_attribute(format, odd).into();
            }
        }
    }
}

/// Gives one splat in `one_in` a second tangent that is the first one, to a few bits: it is seen edge-on from anywhere.
pub fn flatten(splats: &mut [Vec<u64>], one_in: u32, random: &mut Rng) {
    for splat in splats {
        if random.u32(0..one_in) == 0 {
            let noise = (1 << random.u32(0..12)) - 1;
            for component in GEOMETRY.end - 6..GEOMETRY.end - 3 {
                splat[component + 3] = splat[component] ^ (random.u64(..) & noise);
            }
        }
    }
}

/// Splats in world space, cut into frames; the last record is an end.
pub fn world(config: &Config, count: usize) -> Vec<Vec<u64>> {
    let mut random = random();
    let words = records::splat(config).len();
    let record = |index: usize| {
        if index % FRAME == FRAME - 1 || index == count - 1 { end(words) } else { splat(config, &mut random) }
    };
    (0..count).map(record).collect()
}

/// Splats in camera space.
pub fn camera(config: &Config, count: usize) -> Vec<Vec<u64>> {
    through(config, Transform::new(config, 1), &ports::transform(config), &world(config, count), &uniforms(config))
}

/// Splats with their footprints.
pub fn footprints(config: &Config, count: usize) -> Vec<Vec<u64>> {
    through(config, Setup::new(config, 1), &ports::setup(config), &camera(config, count), &uniforms(config))
}

/// Copies of splats, one a tile.
pub fn copies(config: &Config, count: usize) -> Vec<Vec<u64>> {
    through(config, Splitter::new(config), &ports::splitter(config), &footprints(config, count), &[])
}

/// Copies with slots, and one end record behind them all: the rasterizer sees no copy until its frame has ended.
pub fn placed_copies(config: &Config, count: usize) -> Vec<Vec<u64>> {
    let mut random = random();
    let mut copies = copies(config, count);
    copies.retain(|copy| copy[0] == 0);
    copies.iter_mut().for_each(|copy| copy.push(random.u64(0..config.tile_slots.into())));
    copies.push(end(records::placed_copy(config).len()));
    copies
}

/// Samples of splats.
pub fn samples(config: &Config, count: usize) -> Vec<Vec<u64>> {
    let ports = ports::rasterizer(config);
    through(config, Rasterizer::new(config, 1), &ports, &placed_copies(config, count), &uniforms(config))
}
