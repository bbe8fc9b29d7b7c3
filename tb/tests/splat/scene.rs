//! Random splats of all kinds, on every unit's input.

use std::iter::repeat_with;

use fastrand::Rng;
use pointcore::number::{decode, encode_attribute};
use pointcore::splat::{END, EncodedFrame};
use pointcore::stimuli::motion::motion;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{DEPTH_BITS, TILE_SIZE};
use pointcore_contract::splat::records::{
    Attributes, Band, CompleteCopy, DepthPlane, EpsilonScale, Footprint, ModelView, Moving, MovingFootprint, Sample,
    SetupSplat, Shutter, Sight, Splat, SplatCopy, TileDiagonals, TileRectangle, Uniforms, Viewport,
};
use pointcore_contract::splat::units::{motion_setup, rasterizer, setup, splitter, transform};
use pointcore_contract::{Field, Format, Visitor, Word, Words, fields, words};
use pointcore_golden::splat::rasterizer::columns;
use pointcore_golden::splat::{MotionRasterizer, MotionSetup, Rasterizer, Setup, Splitter, Transform};
use pointcore_tb::lockstep::seed;

use super::{Travels, through};

/// Splats between two end records.
const FRAME: usize = 120;
/// The depth that some splats share.
const SURFACE: u32 = 0x9e_3779;
/// How far depths that nearly meet are apart, in their last place.
const NEAR_BY: u32 = 5;

/// Randomness of the stimulus: the same whatever the stalls, unless the environment has another seed.
pub fn random() -> Rng {
    Rng::with_seed(seed().expect("POINTCORE_SEED is a number"))
}

/// A number in one of the core's formats.
pub fn encode(format: Format, number: f32) -> u64 {
    pointcore::number::encode(format, number).into()
}

/// The uniform registers: a camera that looks at the origin, a little from above and aslant, so that no coordinate is another's alone.
pub fn registers(config: &Config) -> Uniforms {
    let turn = glam::Mat3::from_euler(glam::EulerRot::YXZ, 0.2, 0.3, 0.1);
    let at = [0.1, -0.2, 4.0];
    let number = |number| pointcore::number::encode(config.geometry, number);
    let (width, height) = (config.width as f32, config.height as f32);
    let rows = [0, 1, 2].map(|row| turn.row(row).extend(at[row]).to_array());
    let filter_scale = 1.0 / (0.9 * 0.9);
    Uniforms {
        model_view: ModelView { rows: rows.map(|row| row.map(number)) },
        viewport: Viewport {
            scale: [0.9 * width; 2].map(number),
            origin: [width / 2.0, height / 2.0].map(number),
            depth_a: number(10.0 / 9.0),
            depth_b: number(-10.0 / 9.0),
        },
        near_plane: number(1.07),
        epsilon: EpsilonScale { scale: number(0.7), bias: number(0.02) },
        filter_radius: number(0.9),
        filter_scale: pointcore::number::encode_uniform(config.filter_scale_format(), filter_scale),
        shutter: Shutter { weight: [0x8000, 0x6123, 0x9abc, 0x7fff, 0, 0xffff, 0x4321, 1] },
    }
}

/// Their names and values.
pub fn uniforms(config: &Config) -> Vec<(String, u64)> {
    named(config, registers(config))
}

/// Names and values of uniform registers.
pub fn named(config: &Config, uniforms: Uniforms) -> Vec<(String, u64)> {
    let names = fields::<Uniforms>(config).into_iter().map(|field| field.name);
    names.zip(words(config, uniforms)).collect()
}

/// The uniform registers with the image turned upside down, another far plane and another filter.
pub fn turned(config: &Config, random: &mut Rng) -> Uniforms {
    let registers = registers(config);
    let number = |number| pointcore::number::encode(config.geometry, number);
    let far = 5.0 + 10.0 * random.f32();
    let viewport = Viewport {
        scale: registers.viewport.scale.map(|scale| number(-decode(config.geometry, scale))),
        depth_a: number(far / (far - 1.0)),
        depth_b: number(-far / (far - 1.0)),
        ..registers.viewport
    };
    let filter_scale = pointcore::number::encode_uniform(config.filter_scale_format(), 0.5 + random.f32());
    Uniforms { viewport, filter_scale, ..registers }
}

/// Those of any camera, with its near plane there.
pub fn any_camera(config: &Config, near_plane: f32, random: &mut Rng) -> Uniforms {
    let mut number = || pointcore::number::encode(config.geometry, 2.0 * random.f32() - 1.0);
    let model_view = ModelView { rows: [(); 3].map(|()| [(); 4].map(|()| number())) };
    Uniforms { model_view, near_plane: pointcore::number::encode(config.geometry, near_plane), ..registers(config) }
}

/// Fills the values of a record with random bits, as many as the field has.
struct Noise<'a>(&'a mut Rng, std::vec::IntoIter<Field>);

impl Visitor<Words> for Noise<'_> {
    fn bits<W: Word>(&mut self, value: &mut W) {
        let field = self.1.next().expect("the record has as many fields as described");
        *value = W::from_word(self.0.u64(..) >> (64 - field.width));
    }
}

/// A record of random bits.
pub fn noise<R: Travels>(config: &Config, random: &mut Rng) -> R {
    let mut record = R::default();
    record.visit(config, &mut Noise(random, fields::<R>(config).into_iter()));
    record
}

/// A disc, rarely a sliver, somewhere around the view: some beside it, behind the eye, across the eye plane, beyond the far plane.
fn splat(config: &Config, random: &mut Rng) -> Splat {
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
    let vector = |numbers: [f32; 3]| numbers.map(|number| pointcore::number::encode(config.geometry, number));
    let mut attributes = Attributes::default();
    let (continuous, cardinals) = attributes.split_at_mut(config.continuous as usize);
    continuous.fill_with(|| encode_attribute(config.attribute, 4.0 * random.f32() - 2.0));
    cardinals[..config.cardinal as usize].fill_with(|| random.u32(..) >> (32 - config.attribute.width()));
    let tangents = tangents.map(|tangent| vector(tangent.to_array()));
    Splat { center: vector(center), tangents, attributes, motion: motion(config, random), ..Splat::default() }
}

/// Splats in world space, cut into frames; the last record is an end.
pub fn world(config: &Config, count: usize) -> Vec<Splat> {
    let mut random = random();
    let record = |index: usize| {
        if index % FRAME == FRAME - 1 || index == count - 1 { END } else { splat(config, &mut random) }
    };
    (0..count).map(record).collect()
}

/// Frames of splats in world space.
pub fn frames(config: &Config, count: usize) -> EncodedFrame {
    EncodedFrame { records: world(config, count), uniforms: registers(config), depths: None }
}

/// Splats in camera space.
pub fn camera(config: &Config, count: usize) -> Vec<Splat> {
    let Uniforms { model_view, near_plane, .. } = registers(config);
    let see = |input| transform::In { input, out_ready: true, model_view, near_plane };
    through(Transform::new(config, 1), &world(config, count), see, |shown| (shown.in_ready, shown.out))
}

/// Splats with their footprints.
pub fn footprints(config: &Config, count: usize) -> Vec<SetupSplat> {
    let Uniforms { viewport, epsilon, near_plane, filter_radius, .. } = registers(config);
    let see = |input| setup::In { input, out_ready: true, viewport, epsilon, near_plane, filter_radius };
    if config.has_motion() {
        let see = |input| motion_setup::In { input, out_ready: true, viewport, epsilon, near_plane };
        let shown = |shown: motion_setup::Out| (shown.in_ready, shown.out);
        return through(MotionSetup::new(config, 1), &camera(config, count), see, shown);
    }
    through(Setup::new(config, 1), &camera(config, count), see, |shown| (shown.in_ready, shown.out))
}

/// The tiles of the image.
pub fn tiles(config: &Config) -> Vec<u32> {
    let (columns, rows) = (config.tile_columns(), config.height.div_ceil(TILE_SIZE));
    (0..rows).flat_map(|row| (0..columns).map(move |column| row << config.tile_column_bits() | column)).collect()
}

/// Copies of splats, one a tile.
pub fn copies(config: &Config, count: usize) -> Vec<SplatCopy> {
    let see = |input| splitter::In { input, out_ready: true };
    through(Splitter::new(config), &footprints(config, count), see, |shown| (shown.in_ready, shown.out))
}

/// Has one splat in `one_in` touch its limits, and other splats; half of these lie where the one before them does.
pub fn touch(config: &Config, copies: &[SplatCopy], one_in: u32, random: &mut Rng) -> Vec<SplatCopy> {
    let mut before: Vec<SplatCopy> = Vec::new();
    let mut touched = Vec::with_capacity(copies.len());
    for splat in copies.chunk_by(|_, next| !next.first) {
        let mut splat = splat.to_vec();
        if !splat[0].end && random.u32(0..one_in) == 0 {
            if random.bool() && !before.is_empty() {
                let attributes = splat[0].attributes;
                splat = before.iter().map(|copy| SplatCopy { attributes, ..*copy }).collect();
            }
            let footprint = touching(config, splat[0].footprint, random);
            let moving = moving_and_touching(config, splat[0].moving, random);
            splat.iter_mut().for_each(|copy| (copy.footprint, copy.moving) = (footprint, moving));
        }
        if !splat[0].end {
            before.clone_from(&splat);
        }
        touched.extend(splat);
    }
    touched
}

/// The same splat with limits of its depth, and of what is seen of it, that differ from these in one bit each, or a little more. Its depth
/// is that of the same surface for all such splats, or the surface is where its band ends; where samples have `D`, all have that of the centre.
fn touching(config: &Config, footprint: Footprint, random: &mut Rng) -> Footprint {
    let format = config.raster_format();
    let mut limits = |exact: u32, bits: u32| {
        let [a, b] = [(); 2].map(|()| exact ^ 1 << random.u32(0..bits));
        [a.min(b), a.max(b)]
    };
    let delta = footprint.delta;
    let negative = delta >> (format.delta_width() - 1) != 0;
    let magnitude = if negative && format.fixed().is_some() { !delta } else { delta };
    let bits = format.limit_width();
    let [far, near] = limits(magnitude & (u32::MAX >> (32 - bits)), bits);
    let [low, high] = limits(SURFACE, DEPTH_BITS).map(|limit| (limit + NEAR_BY / 2).min((1 << DEPTH_BITS) - 1));
    let band = Band { depth: SURFACE + random.u32(0..NEAR_BY), low: low - random.u32(0..NEAR_BY).min(low), high };
    let [mx, my] = if config.eye_plane.is_on() { [0; 2] } else { [footprint.mx, footprint.my] };
    // Without limits `s1` and `D` may be either.
    let sight = if random.u8(0..8) == 0 {
        Sight { turned: true, ..seen(config, footprint.sight) }
    } else {
        Sight { negative, near, far, turned: false, ..footprint.sight }
    };
    let plane = format.floating().map_or(footprint.plane, |format| plane(format, random));
    Footprint { mx, my, sight, band, plane, ..footprint }
}

/// What is seen without limits of `D`.
pub fn seen(config: &Config, sight: Sight) -> Sight {
    Sight { near: u32::MAX >> (u32::BITS - config.raster_format().limit_width()), far: 0, ..sight }
}

/// A surface, or another whose band ends there.
fn plane(format: Format, random: &mut Rng) -> DepthPlane {
    let number = |value| pointcore::number::encode(format, value);
    let surface = number(0.53) + random.u32(0..NEAR_BY);
    let apart = if random.bool() { 0.25 + 0.2 * random.f32() } else { 0.0 };
    let center = number(decode(format, surface) + apart);
    let epsilon = number(apart) + random.u32(0..NEAR_BY);
    let whole = [0.0, 1.0].map(number);
    let mut range =
        if random.bool() { whole } else { [(); 2].map(|()| center ^ 1 << random.u32(0..format.width() - 1)) };
    range.sort_unstable();
    DepthPlane { center, slope: [0; 2], range, epsilon }
}

/// The same splat with a depth close to its own, or with a band that ends there.
fn moving_and_touching(config: &Config, moving: Moving, random: &mut Rng) -> Moving {
    let format = config.geometry;
    let [scale, distance] =
        [moving.footprint.depth_scale, moving.footprint.distance[0]].map(|bits| decode(format, bits));
    let farther = if random.bool() { scale * (1.0 - 0.25 * random.f32()) } else { scale };
    let apart = ((farther - scale) / distance * (1 << DEPTH_BITS) as f32).clamp(0.0, (SURFACE / 2) as f32);
    let depth_scale = pointcore::number::encode(format, farther);
    // Between both planes for a part of the exposure, which is the difference of numbers that are far larger.
    let offset = 2_f32.powi(random.i32(-4..10));
    let [begin, end] = [(); 2].map(|()| 1.5 - 3.0 * random.f32());
    let met = [offset + begin.min(end), offset + begin.max(end), offset];
    let planes = if random.bool() {
        met.map(|number| pointcore::number::encode(format, number))
    } else {
        moving.footprint.planes
    };
    let footprint = MovingFootprint { depth_scale, planes, ..moving.footprint };
    Moving { footprint, epsilon: apart as u32 + random.u32(0..NEAR_BY) }
}

/// Copies with slots and payloads.
pub fn complete_copies(config: &Config, copies: Vec<SplatCopy>, random: &mut Rng) -> Vec<CompleteCopy> {
    let place = |copy| {
        let SplatCopy { footprint, moving, attributes, bounds, diagonals, tile, .. } = copy;
        let slot = random.u8(0..config.tile_slots as u8);
        CompleteCopy { footprint, moving, attributes, bounds, diagonals, tile, slot }
    };
    copies.into_iter().filter(|copy| !copy.end).map(place).collect()
}

/// Gives one copy in `one_in` any edges that leave a sample in each of its rows, and one in as many any tile.
pub fn scatter(config: &Config, copies: &mut [CompleteCopy], one_in: u32, random: &mut Rng) {
    let per_pixel = config.sampling.columns();
    for copy in copies {
        if random.u32(0..one_in) == 0 {
            let edges = || {
                let CompleteCopy { mut bounds, diagonals, .. } = noise(config, random);
                // Whole pixels.
                bounds.left &= !(per_pixel as u16 - 1);
                bounds.right |= per_pixel as u16 - 1;
                (bounds, diagonals)
            };
            let has_samples = |(bounds, diagonals): &(TileRectangle, TileDiagonals)| {
                let mut rows = bounds.top..=bounds.bottom;
                !rows.is_empty() && rows.all(|row| !columns(per_pixel, bounds, diagonals, row).is_empty())
            };
            let edges = repeat_with(edges).find(has_samples).expect("noise does not end");
            (copy.bounds, copy.diagonals) = edges;
        }
        if random.u32(0..one_in) == 0 {
            copy.tile = noise::<CompleteCopy>(config, random).tile;
        }
    }
}

/// Samples of splats.
pub fn samples(config: &Config, count: usize) -> Vec<Sample> {
    let Uniforms { filter_scale, viewport: Viewport { depth_a, .. }, .. } = registers(config);
    let copies = complete_copies(config, copies(config, count), &mut random());
    let see = |input| rasterizer::In { input, out_ready: true, filter_scale, depth_a };
    if config.has_motion() {
        let shown = |shown: rasterizer::Out| (shown.in_ready, shown.out);
        return through(MotionRasterizer::new(config, 1), &copies, see, shown);
    }
    through(Rasterizer::new(config, 1), &copies, see, |shown| (shown.in_ready, shown.out))
}
