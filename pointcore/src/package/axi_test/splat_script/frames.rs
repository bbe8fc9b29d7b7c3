//! Small frames whose splats lie in tiles all over the picture, and what the golden model makes of them.

use super::super::bench::depth_at;
use crate::number::{encode, encode_attribute};
use crate::splat::depth_memory::Depths;
use crate::splat::{END, EncodedFrame, SplatCore, SplatRunner};
use crate::stimuli::motion::motion;
use crate::uniforms::uniforms;
use fastrand::Rng;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::records::{Attributes, Fragment, Splat};
use pointcore_contract::{Camera, Rendering};
use pointcore_tb::lockstep::LockstepError;
use std::f64::consts::TAU;

/// Tiles with splats: more than the core keeps, so that some leave for memory and come back.
const TILES: usize = 7;
/// Splats of such a tile at least, and how many more than a small heap holds: their tiles come back while a frame is drawn.
const OF_TILE: usize = 4;
const BEYOND_HEAP: usize = 16;
const SMALL_HEAP: u32 = 64;
/// Half a splat's size, and how far it lies from the middle of its tile at most.
const RADII_PX: [f64; 2] = [0.8, 2.2];
const OFFSET_PX: f64 = 2.0;
/// Where the splats of a tile lie before the eye, and how far from each other at most: some belong to a surface, some do not.
const DEPTHS: [f64; 2] = [3.0, 9.0];
const THICKNESS: f64 = 0.05;
/// The units of length of both cameras.
const UNITS: [f64; 2] = [1.0, 1024.0];
/// What each tangent leads away from the eye, of what it leads across.
const TILT: [f64; 2] = [-0.5, 0.5];
/// Attributes are as large as that at most.
const ATTRIBUTE: f32 = 8.0;
/// Frames of a script, the last of them without splats.
const FRAMES: usize = 4;
/// Its number.
pub const EMPTY: usize = FRAMES - 1;

/// A frame and the fragments that come of it.
pub struct Frame {
    pub sent: EncodedFrame,
    pub fragments: Vec<Fragment>,
}

/// The frames of a script.
///
/// # Errors
/// One does not come to its end.
pub fn all(config: &Config, core: &SplatCore) -> Result<Vec<Frame>, LockstepError> {
    let frame = |number| {
        let sent = frame(config, number);
        let mut fragments = SplatRunner::new(config, &sent).golden(core)?.fragments;
        fragments.push(Fragment { end: true, ..Fragment::default() });
        Ok(Frame { sent, fragments })
    };
    (0..FRAMES).map(frame).collect()
}

/// The unit of length of a frame's camera.
fn unit(number: usize) -> f64 {
    UNITS[number.min(1)]
}

/// Two cameras: straight ahead, and turned and moved aside.
fn camera(config: &Config, number: usize) -> Camera {
    let [width, height] = [config.width, config.height].map(f64::from);
    let unit = unit(number);
    let number = number.min(1);
    let (near, far) = [(1.0, 10.0), (2.0, 20.0)][number];
    let depth_a = far / (far - near);
    let near = near * unit;
    let straight = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    let turned = [[0.0, 1.0, 0.0, 0.5 * unit], [-1.0, 0.0, 0.0, -0.25 * unit], [0.0, 0.0, 1.0, 1.5 * unit]];
    Camera {
        model_view: [straight, turned][number],
        scale_x: height,
        scale_y: [height, 1.25 * height][number],
        center_x: width / 2.0,
        center_y: height / 2.0,
        depth_a,
        depth_b: -near * depth_a,
        near,
    }
}

fn rendering(config: &Config, number: usize) -> Rendering {
    Rendering {
        width: config.width as usize,
        height: config.height as usize,
        sampling: config.sampling,
        depth: config.depth,
        kernel_gamma: Rendering::DEFAULT_KERNEL_GAMMA,
        filter_radius_px: Some([1.0, 1.0, 1.5, 1.5][number] * Rendering::DEFAULT_FILTER_RADIUS_PX),
        epsilon_scale: Rendering::DEFAULT_EPSILON_SCALE,
        epsilon_bias: [1e-3, 3e-3, 3e-3, 3e-3][number],
    }
}

fn frame(config: &Config, number: usize) -> EncodedFrame {
    let mut random = Rng::with_seed(1 + number as u64);
    let camera = camera(config, number);
    let [columns, rows] = [config.width, config.height].map(|edge| edge.div_ceil(TILE_SIZE));
    // The first and the last tile, and others.
    let others = 2..TILES.max(config.tile_slots as usize + 3);
    let mut tiles = vec![0, columns * rows - 1];
    tiles.extend(others.map(|_| random.u32(..columns * rows)));
    let tiles: Vec<(u32, f64)> = tiles.into_iter().map(|tile| (tile, between(DEPTHS, &mut random))).collect();
    let splat = |(tile, depth): &(u32, f64)| {
        let middle = [tile % columns, tile / columns].map(|tile| f64::from(tile * TILE_SIZE + TILE_SIZE / 2));
        let depth = unit(number) * (depth + THICKNESS * random.f64());
        splat(config, &camera, middle, depth, &mut random)
    };
    let heap = if config.heap_capacity() <= SMALL_HEAP { config.heap_capacity() as usize + BEYOND_HEAP } else { 0 };
    let count = if number == EMPTY { 0 } else { heap.max(OF_TILE * tiles.len()) };
    let splats: Vec<Splat> = tiles.iter().cycle().take(count).map(splat).collect();
    EncodedFrame {
        records: splats.into_iter().chain([END]).collect(),
        uniforms: uniforms(&camera, &rendering(config, number), config),
        depths: config.tests_samples().then(|| Depths::of_places(config, depth_at)),
    }
}

fn between([low, high]: [f64; 2], random: &mut Rng) -> f64 {
    low + (high - low) * random.f64()
}

/// A splat near a place in the picture that faces the eye, at a depth.
fn splat(config: &Config, camera: &Camera, [column, row]: [f64; 2], depth: f64, random: &mut Rng) -> Splat {
    let mut offset = || (2.0 * random.f64() - 1.0) * OFFSET_PX;
    let [x, y] = [column + offset(), row + offset()];
    let radius_px = between(RADII_PX, random);
    let eye = [(x - camera.center_x) / camera.scale_x * depth, (y - camera.center_y) / camera.scale_y * depth, depth];
    let radius = radius_px / camera.scale_x * depth;
    // From the eye's directions and places to those of the world: the matrix only turns.
    let turn = |vector: [f64; 3]| {
        [0, 1, 2].map(|axis| (0..3).map(|row| camera.model_view[row][axis] * vector[row]).sum::<f64>())
    };
    let vector = |numbers: [f64; 3]| numbers.map(|number| encode(config.geometry, number as f32));
    let center = vector(turn([0, 1, 2].map(|axis| eye[axis] - camera.model_view[axis][3])));
    // The cross product of the tangents points at the eye, more or less.
    let (sine, cosine) = between([0.0, TAU], random).sin_cos();
    let mut tilt = || radius * between(TILT, random);
    let tangents = [[radius * sine, radius * cosine, tilt()], [radius * cosine, -radius * sine, tilt()]];
    let tangents = tangents.map(|tangent| vector(turn(tangent)));
    let mut attributes = Attributes::default();
    let (continuous, cardinals) = attributes.split_at_mut(config.continuous as usize);
    continuous.fill_with(|| encode_attribute(config.attribute, ATTRIBUTE * (2.0 * random.f32() - 1.0)));
    cardinals[..config.cardinal as usize].fill(1);
    Splat { center, tangents, motion: motion(config, random), attributes, ..Splat::default() }
}
