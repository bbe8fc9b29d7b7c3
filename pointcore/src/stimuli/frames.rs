//! Random frames for a renderer of any configuration: scenes of discs, heaps of small splats on a few tiles, hard cases
//! that whoever asks brings along, and empty frames.

use super::motion::motion;
use super::one_of;
use crate::number::{decode, encode, encode_attribute, encode_uniform};
use crate::splat::END;
use fastrand::Rng;
use glam::{EulerRot, Quat, Vec3};
use pointcore_contract::splat::motion::{SHUTTER, TIME_BINS_MAX};
use pointcore_contract::splat::records::{Attributes, EpsilonScale, ModelView, Shutter, Splat, Uniforms, Viewport};
use pointcore_contract::splat::{AttributeFormat, Config};
use pointcore_contract::{places, read, words};
use std::f32::consts::TAU;

/// Numbers that are none, or hardly.
const ODD: [f32; 10] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -0.0, f32::MAX, f32::MIN, 1e-40, -1e-20, 1e20];
/// Samples that a frame's splats cover together, roughly: what a frame takes in cycles.
const COVERED_SAMPLES: u32 = 100_000;
/// The camera stands so far before the middle of the scene.
const DISTANCE: f32 = 4.0;

/// How far splats about one place are from it: within a tile, and on several.
const NARROW: f32 = 0.02;
const WIDE: f32 = 0.2;
/// The binary logarithm of the radius of a small one.
const SMALL: f32 = -5.0;

/// Near and far plane.
const NEAR: [f32; 2] = [0.6, 1.4];
const FAR: [f32; 2] = [8.0, 12.0];
/// How far before the eye a splat is that it sees, or one that the near plane or the eye's cuts.
const SEEN: [f32; 2] = [0.5, 9.0];
const CUT: [f32; 2] = [-1.0, 1.5];
/// Places in the image are so far beyond its first pixel at most, and so many pixels before it.
const WINDOW_PX: f32 = 128.0;
const BESIDE_PX: f32 = 16.0;
/// The binary logarithm of a radius in pixels.
const LOG2_RADIUS_PX: [f32; 2] = [-1.5, 4.0];

/// Splats that are made to be hard, and the camera before which they are.
#[derive(Clone, Copy, Debug)]
pub struct HardCases {
    /// A case at random.
    pub splat: fn(&Config, &mut Rng) -> Splat,
    /// The uniforms of the camera.
    pub uniforms: fn(&Config) -> Uniforms,
}

/// How a camera maps what it sees to the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// Pixels of a unit at distance 1.
    pub scale: [f32; 2],
    /// The pixel on the camera's axis.
    pub origin: [f32; 2],
}

impl Lens {
    /// What it sees fills the image.
    #[must_use]
    pub fn whole(config: &Config) -> Self {
        let size = [config.width, config.height].map(|edge| edge as f32);
        Self { scale: size.map(|edge| 0.9 * edge), origin: size.map(|edge| edge / 2.0) }
    }
}

/// A frame as the host sends it.
#[derive(Clone, Debug)]
pub struct Frame {
    /// What is written to the uniform registers, if the frame does not keep those of the frame before.
    pub uniforms: Vec<u64>,
    /// Whether the frame before had others.
    pub is_new_view: bool,
    /// Splats, and the record that closes the frame.
    pub records: Vec<Splat>,
}

/// What a frame shows.
#[derive(Clone, Copy, Debug)]
enum Content {
    /// Discs of all sizes anywhere around the view.
    Scene,
    /// Small discs about one place, few elsewhere: samples of the same pixels follow one another, and copies for other
    /// tiles wait in the heap for long.
    Heap(Place),
    /// Hard cases before their own camera.
    Hard(HardCases),
    /// Nothing.
    Empty,
}

/// Where most discs of a frame are, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Their middle; the camera looks at the origin.
    pub center: Vec3,
    /// How far they are from there at most, in each direction.
    pub spread: f32,
    /// The binary logarithm of their radius, on average; most differ from it by up to one.
    pub log2_radius: f32,
}

impl Place {
    fn random(random: &mut Rng) -> Self {
        let mut signed = || 2.0 * random.f32() - 1.0;
        let center = Vec3::new(signed(), signed(), 0.0);
        Self { center, spread: one_of(random, &[NARROW, WIDE]), log2_radius: SMALL }
    }
}

/// Frames that follow one another, some under the uniforms of the one before, of so many splats at most.
#[must_use]
pub fn frames(
    config: &Config,
    count: usize,
    most_splats: u32,
    lens: Lens,
    hard: Option<HardCases>,
    random: &mut Rng,
) -> Vec<Frame> {
    let mut frames = Vec::<Frame>::new();
    for _ in 0..count {
        let heap = Content::Heap(Place::random(random));
        let content = one_of(
            random,
            &[
                Content::Scene,
                Content::Scene,
                Content::Scene,
                heap,
                heap,
                hard.map_or(heap, Content::Hard),
                Content::Empty,
            ],
        );
        let kept = frames.last().filter(|_| random.bool()).map(|frame| frame.uniforms.clone());
        let is_new_view = kept.is_none();
        let uniforms = kept.unwrap_or_else(|| view(config, content, lens, random));
        frames.push(Frame { uniforms, is_new_view, records: records(config, content, most_splats, random) });
    }
    frames
}

/// A frame of so many splats about a place, none of them odd: one that is may cover the image, and hide what others do.
#[must_use]
pub fn about(place: Place, config: &Config, splats: u32, lens: Lens, random: &mut Rng) -> Frame {
    let content = Content::Heap(place);
    let mut records: Vec<_> = (0..splats).map(|_| disc(config, content, random)).collect();
    records.push(END);
    Frame { uniforms: words(config, camera(config, lens, Pose::random(random), random)), is_new_view: true, records }
}

/// A frame of so many discs that are small in the image, anywhere in it and around: some behind the eye, cut by a plane or
/// beyond the far one, some edge-on.
#[must_use]
pub fn around(config: &Config, splats: u32, lens: Lens, random: &mut Rng) -> Frame {
    let pose = Pose::random(random);
    let mut records: Vec<_> = (0..splats).map(|_| seen(config, lens, pose, random)).collect();
    records.push(END);
    Frame { uniforms: words(config, camera(config, lens, pose, random)), is_new_view: true, records }
}

impl Frame {
    /// The same in another unit of length, of which there are so many in one of before.
    #[must_use]
    pub fn in_units(self, config: &Config, units: f32) -> Self {
        let longer = |bits: &mut u32| *bits = encode(config.geometry, units * decode(config.geometry, *bits));
        let mut uniforms: Uniforms = read(config, &self.uniforms);
        uniforms.model_view.rows.iter_mut().for_each(|row| longer(&mut row[3]));
        longer(&mut uniforms.near_plane);
        longer(&mut uniforms.viewport.depth_b);
        let mut records = self.records;
        for Splat { center, tangents, .. } in &mut records {
            center.iter_mut().chain(tangents.iter_mut().flatten()).for_each(longer);
        }
        Self { uniforms: words(config, uniforms), records, ..self }
    }
}

/// The words of uniform registers, one of them odd now and then.
fn view(config: &Config, content: Content, lens: Lens, random: &mut Rng) -> Vec<u64> {
    let uniforms = camera(config, lens, Pose::random(random), random);
    let uniforms = match content {
        Content::Hard(cases) => {
            let Uniforms { filter_radius, filter_scale, .. } = uniforms;
            Uniforms { filter_radius, filter_scale, ..(cases.uniforms)(config) }
        }
        _ => uniforms,
    };
    let mut words = words(config, uniforms);
    if random.u8(..12) == 0 {
        // From the scale of the filter on they are of other formats.
        let numbers = places::<Uniforms>(config).filter_scale.expect("it is always there");
        let place = random.usize(..numbers);
        words[place] = encode(config.geometry, one_of(random, &ODD)).into();
    }
    words
}

/// Where a camera stands: the way from the world's directions and places to its own.
#[derive(Clone, Copy, Debug)]
struct Pose {
    turn: Quat,
    offset: Vec3,
}

impl Pose {
    /// It looks at the origin from somewhere.
    fn random(random: &mut Rng) -> Self {
        let [yaw, pitch, roll] = [(); 3].map(|()| TAU * random.f32());
        let mut offset = || random.f32() - 0.5;
        let offset = Vec3::new(offset(), offset(), DISTANCE + offset());
        Self { turn: Quat::from_euler(EulerRot::YXZ, yaw, pitch, roll), offset }
    }
}

/// A camera's uniforms.
fn camera(config: &Config, lens: Lens, Pose { turn, offset }: Pose, random: &mut Rng) -> Uniforms {
    let number = |number| encode(config.geometry, number);
    let row = |axis: Vec3, offset| (turn.conjugate() * axis).extend(offset).to_array();
    let rows = [row(Vec3::X, offset.x), row(Vec3::Y, offset.y), row(Vec3::Z, offset.z)];
    let [near, far] = [NEAR, FAR].map(|range| between(range, random));
    let depth_a = far / (far - near);
    let scale = one_of(random, &[1.0, 1.0, 0.7, 4.0]);
    Uniforms {
        model_view: ModelView { rows: rows.map(|row| row.map(number)) },
        viewport: Viewport {
            scale: lens.scale.map(number),
            origin: lens.origin.map(number),
            depth_a: number(depth_a),
            depth_b: number(-near * depth_a),
        },
        near_plane: number(near),
        epsilon: EpsilonScale { scale: number(random.f32()), bias: number(0.05 * random.f32()) },
        filter_radius: number(f32::sqrt(1.0 / scale)),
        filter_scale: encode_uniform(config.filter_scale_format(), scale),
        shutter: if config.has_motion() { shutter(random) } else { Shutter::default() },
    }
}

/// A number from the first to the last.
pub(crate) fn between([low, high]: [f32; 2], random: &mut Rng) -> f32 {
    low + (high - low) * random.f32()
}

/// Bins that count as much as a box's, or anything.
fn shutter(random: &mut Rng) -> Shutter {
    let one = 1 << SHUTTER.fraction;
    Shutter { weight: [(); TIME_BINS_MAX].map(|()| if random.bool() { one } else { random.u32(..2 * one) }) }
}

fn records(config: &Config, content: Content, most_splats: u32, random: &mut Rng) -> Vec<Splat> {
    // A large splat covers the whole image.
    let affordable = 8 * COVERED_SAMPLES / (config.width * config.height);
    let most = if matches!(content, Content::Heap(_)) { 4 * most_splats } else { most_splats.min(affordable.max(8)) };
    let count = if matches!(content, Content::Empty) { 0 } else { random.u32(1..=most) };
    let mut records: Vec<_> = (0..count).map(|_| splat(config, content, random)).collect();
    records.push(END);
    records
}

fn splat(config: &Config, content: Content, random: &mut Rng) -> Splat {
    let mut splat = match content {
        Content::Hard(cases) => Splat { attributes: attributes(config, random), ..(cases.splat)(config, random) },
        _ => disc(config, content, random),
    };
    if random.u8(..32) == 0 {
        let [first, second] = &mut splat.tangents;
        let vector = [&mut splat.center, first, second][random.usize(..3)].as_mut();
        vector[random.usize(..3)] = encode(config.geometry, one_of(random, &ODD));
    }
    if random.u8(..32) == 0 {
        // Tangents that are parallel but for a few bits: the splat is seen edge-on from anywhere.
        let noise = (1 << random.u32(..12)) - 1;
        splat.tangents[1] = splat.tangents[0].map(|component| component ^ (random.u32(..) & noise));
    }
    splat
}

/// A disc or an ellipse, anywhere in and around the view, or about the origin.
fn disc(config: &Config, content: Content, random: &mut Rng) -> Splat {
    let is_elsewhere = random.u8(..32) == 0;
    let mut signed = || 2.0 * random.f32() - 1.0;
    let center = match content {
        Content::Heap(Place { center, spread, .. }) if !is_elsewhere => {
            center + Vec3::new(signed(), signed(), signed()) * spread
        }
        _ => Vec3::new(4.0 * signed(), 4.0 * signed(), 4.5 * signed()),
    };
    let [a, b] = [(); 2].map(|()| Vec3::new(signed(), signed(), signed()));
    let [first, second] = tangents(a, b);
    let exponent = match content {
        Content::Heap(Place { log2_radius, .. }) => signed() + log2_radius,
        _ => 3.5 * signed() - 2.5,
    };
    let radius = exponent.exp2();
    let shorter = if random.u8(..8) == 0 { random.f32() } else { 1.0 };
    let vector = |vector: Vec3| vector.to_array().map(|number| encode(config.geometry, number));
    let tangents = [first * radius, second * (radius * shorter)].map(vector);
    let motion = motion(config, random);
    Splat { end: false, center: vector(center), tangents, motion, attributes: attributes(config, random) }
}

/// Tangents of length 1 of a disc with a normal, turned in its plane by another vector.
fn tangents(normal: Vec3, other: Vec3) -> [Vec3; 2] {
    let normal = normal.try_normalize().unwrap_or(Vec3::Z);
    let first = normal.cross(other).try_normalize().unwrap_or(normal.any_orthonormal_vector());
    [first, normal.cross(first)]
}

/// A disc as the camera sees it: so small in the image, whatever its distance.
fn seen(config: &Config, lens: Lens, pose: Pose, random: &mut Rng) -> Splat {
    let depth = match random.u8(..8) {
        0 => between(CUT, random),
        1 => between(FAR, random),
        _ => between(SEEN, random),
    };
    let mut pixel = |edge: u32| between([-BESIDE_PX, (edge as f32).min(WINDOW_PX) + BESIDE_PX], random);
    let pixel = [pixel(config.width), pixel(config.height)];
    let [x, y] = [0, 1].map(|axis| (pixel[axis] - lens.origin[axis]) / lens.scale[axis] * depth);
    let center = Vec3::new(x, y, depth);
    let radius = between(LOG2_RADIUS_PX, random).exp2() / lens.scale[0] * depth.abs();
    let mut signed = || 2.0 * random.f32() - 1.0;
    let [a, b] = [(); 2].map(|()| Vec3::new(signed(), signed(), signed()));
    let is_edge_on = random.u8(..8) == 0;
    let tangents = tangents(if is_edge_on { center.cross(a) } else { a }, b);
    let back = pose.turn.conjugate();
    let vector = |vector: Vec3| (back * vector).to_array().map(|number| encode(config.geometry, number));
    Splat {
        end: false,
        center: vector(center - pose.offset),
        tangents: tangents.map(|tangent| vector(tangent * radius)),
        motion: motion(config, random),
        attributes: attributes(config, random),
    }
}

/// Attributes of both kinds, now and then any bits or an odd number.
fn attributes(config: &Config, random: &mut Rng) -> Attributes {
    let any = |random: &mut Rng| random.u32(..) >> (u32::BITS - config.attribute.width());
    let mut attributes = Attributes::default();
    let (continuous, cardinal) = attributes.split_at_mut(config.continuous as usize);
    for attribute in continuous {
        *attribute = match random.u8(..32) {
            0 => any(random),
            1 if matches!(config.attribute, AttributeFormat::Float(_)) => {
                encode_attribute(config.attribute, one_of(random, &ODD))
            }
            _ => encode_attribute(config.attribute, 4.0 * random.f32() - 2.0),
        };
    }
    cardinal[..config.cardinal as usize].fill_with(|| any(random));
    attributes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stimuli::configuration::renderer;

    #[test]
    fn every_frame_ends_and_fits_its_configuration() {
        let (mut empty, mut kept, mut splats) = (0, 0, 0);
        for seed in 0..200 {
            let random = &mut Rng::with_seed(seed);
            let config = renderer(random);
            for frame in frames(&config, 3, 120, Lens::whole(&config), None, random) {
                let ends: Vec<_> = frame.records.iter().map(|record| record.end).collect();
                assert_eq!(ends.iter().position(|end| *end), Some(ends.len() - 1));
                let width = config.attribute.width();
                let fits = |bits: &u32| u64::from(*bits) < 1 << width;
                assert!(frame.records.iter().all(|record| record.attributes.iter().all(fits)), "{config:?}");
                empty += usize::from(frame.records.len() == 1);
                kept += usize::from(!frame.is_new_view);
                splats += frame.records.len() - 1;
            }
        }
        assert!(empty > 20 && kept > 50 && splats > 5000, "{empty} empty, {kept} kept, {splats} splats");
    }
}
