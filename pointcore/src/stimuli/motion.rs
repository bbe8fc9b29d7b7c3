//! Random splats that move while the shutter is open, of every kind that is hard for one reason, each with a sample near its way.

use super::one_of;
use crate::number::encode;
use fastrand::Rng;
use glam::DVec3;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{self, Uniforms};
use pointcore_contract::{Camera, Rendering, Splat, fields, words};
use pointcore_golden::reference::motion::{Interval, MovingSplat, Place};
use pointcore_golden::splat::MotionUniforms;

/// Parts of the exposure at whose borders some splats come and go.
const BORDERS: u32 = 4;

/// What is hard about a splat.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Family {
    /// Nothing.
    Free,
    /// It does not move, but is not taken for a still one either.
    Still,
    /// It hardly moves.
    Slow,
    /// It moves within its own plane.
    InPlane,
    /// It comes towards the eye.
    TowardsEye,
    /// Its center passes the near plane within the exposure.
    AcrossNear,
    /// Its center passes the eye plane within the exposure.
    AcrossEye,
    /// It is seen edge-on at some instant of the exposure.
    EdgeOn,
    /// It is there from the border of a bin to another.
    AtBorders,
    /// It enters or leaves the image.
    AcrossImage,
    /// It passes many of its own radii.
    Fast,
}

impl Family {
    /// Every family.
    pub const ALL: [Self; 11] = [
        Self::Free,
        Self::Still,
        Self::Slow,
        Self::InPlane,
        Self::TowardsEye,
        Self::AcrossNear,
        Self::AcrossEye,
        Self::EdgeOn,
        Self::AtBorders,
        Self::AcrossImage,
        Self::Fast,
    ];
}

/// A moving splat and a sample.
#[derive(Clone, Debug)]
pub struct Moved {
    /// What is hard about it.
    pub family: Family,
    /// The splat, in camera space.
    pub splat: MovingSplat,
    /// A sample that it may cover.
    pub place: Place,
}

/// A camera in the origin that looks along z, with planes at distances of 1 and 40, for the image of a configuration.
#[must_use]
pub fn camera(config: &Config) -> Camera {
    const FAR: f64 = 40.0;
    let (width, height) = (pixels(config), f64::from(config.height));
    Camera {
        model_view: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
        scale_x: width,
        scale_y: 1.1 * width,
        center_x: 0.5 * width,
        center_y: 0.5 * height,
        depth_a: FAR / (FAR - 1.0),
        depth_b: -FAR / (FAR - 1.0),
        near: 1.0,
    }
}

/// How the image of a configuration is rendered, without a screen filter.
#[must_use]
pub fn rendering(config: &Config) -> Rendering {
    Rendering {
        width: config.width as usize,
        height: config.height as usize,
        sampling: config.sampling,
        depth: config.depth,
        kernel_gamma: config.kernel_gamma,
        filter_radius_px: None,
        epsilon_scale: Rendering::DEFAULT_EPSILON_SCALE,
        epsilon_bias: 0.01,
    }
}

fn pixels(config: &Config) -> f64 {
    f64::from(config.width / config.sampling.columns())
}

fn uniform(random: &mut Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * random.f64()
}

fn vector(random: &mut Rng, size: f64) -> DVec3 {
    DVec3::from_array([(); 3].map(|()| uniform(random, -size, size)))
}

/// What faces the eye well enough, from a hundredth to a quarter of its distance large.
fn disc(random: &mut Rng) -> (DVec3, [DVec3; 2]) {
    let z = uniform(random, 2.0, 20.0);
    let size = z * 2.0_f64.powf(uniform(random, -6.5, -2.0));
    let center = DVec3::new(uniform(random, -0.5, 0.5) * z, uniform(random, -0.4, 0.4) * z, z);
    loop {
        let tangents = [vector(random, size), vector(random, size)];
        let normal = tangents[0].cross(tangents[1]);
        if normal.length() > 0.2 * size * size && normal.dot(center) < -0.3 * normal.length() * center.length() {
            return (center, tangents);
        }
    }
}

/// A splat of a family.
#[must_use]
pub fn splat(random: &mut Rng, family: Family) -> MovingSplat {
    let (mut center, mut tangents) = disc(random);
    let (z, speed) = (center.z, 0.5 * random.f64().powi(2));
    let mut motion = vector(random, speed * z);
    let mut part = Interval::EXPOSURE;
    match family {
        Family::Free => {}
        Family::Still => motion = DVec3::ZERO,
        Family::Slow => motion *= 10.0_f64.powf(uniform(random, -12.0, -1.0)),
        Family::InPlane => {
            let along = vector(random, 3.0);
            motion = along.x * tangents[0] + along.y * tangents[1];
        }
        Family::TowardsEye => motion = -center * uniform(random, 0.1, 0.8),
        Family::AcrossNear => motion.z = -(z - 1.0) / uniform(random, 0.1, 0.9),
        Family::AcrossEye => motion.z = -z / uniform(random, 0.1, 0.9),
        Family::EdgeOn => {
            // The normal and the line of sight come to be square at some time.
            let time = uniform(random, -1.0, 1.0);
            let normal = tangents[0].cross(tangents[1]);
            motion -= normal * ((center + time * motion).dot(normal) / (time * normal.length_squared()));
            if random.u8(0..4) == 0 {
                let lean = center.normalize() * tangents[1].length();
                tangents[1] = lean + 10.0_f64.powf(uniform(random, -6.0, -1.0)) * tangents[1];
            }
        }
        Family::AtBorders => {
            let [first, second] = [(); 2].map(|()| random.u32(0..=BORDERS));
            let border = |index: u32| f64::from(2 * index) / f64::from(BORDERS) - 1.0;
            part = Interval::new(border(first.min(second)), border(first.max(second))).unwrap_or(part);
        }
        Family::AcrossImage => {
            let way = one_of(random, &[DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y]) * uniform(random, 0.3, 1.5) * z;
            motion += way;
            center -= way * one_of(random, &[-0.7, 0.7]);
        }
        Family::Fast => motion *= 2.0_f64.powf(uniform(random, 2.0, 8.0)),
    }
    let single = |vector: DVec3| vector.as_vec3().to_array();
    let splat = Splat { center: single(center), tangents: tangents.map(single), attributes: [0.0; 6], material: 0 };
    MovingSplat { splat, motion: motion.as_vec3().as_dvec3(), part }
}

/// What of a splat is there in one of so many bins of the exposure, any one in which it is.
fn in_bin(random: &mut Rng, moving: MovingSplat, bins: u32) -> MovingSplat {
    let parts: Vec<_> = Interval::equal_parts(bins as usize).filter_map(|bin| moving.part.intersection(bin)).collect();
    let part = one_of(random, &parts);
    let center = DVec3::from_array(moving.splat.center.map(f64::from));
    let center = center + (part.middle() - moving.part.middle()) * moving.motion;
    let splat = Splat { center: center.as_vec3().to_array(), ..moving.splat };
    MovingSplat { splat, part, ..moving }
}

/// A splat of a family in a bin of the exposure, with a sample near its way.
#[must_use]
pub fn moved(random: &mut Rng, family: Family, config: &Config) -> Moved {
    let (camera, rendering) = (camera(config), rendering(config));
    let splat = splat(random, family);
    let splat = in_bin(random, splat, config.time_bins);
    let double = |vector: [f32; 3]| DVec3::from_array(vector.map(f64::from));
    let time = uniform(random, splat.part.begin, splat.part.end) - splat.part.middle();
    let [first, second] = splat.splat.tangents.map(double);
    let on_splat = vector(random, 0.9);
    let point = double(splat.splat.center) + time * splat.motion + on_splat.x * first + on_splat.y * second;
    let near = |along: f64, size: usize| (along.max(0.0) as usize).min(size - 1);
    let columns = f64::from(config.sampling.columns());
    let column = near(columns * (camera.scale_x * point.x / point.z + camera.center_x), rendering.width);
    let row = near(camera.scale_y * point.y / point.z + camera.center_y, rendering.height);
    Moved { family, splat, place: Place::new(column, row, &rendering) }
}

/// A splat as setup takes it, with random attributes.
#[must_use]
pub fn encoded(moving: &MovingSplat, config: &Config, random: &mut Rng) -> records::Splat {
    let number = |value: f64| encode(config.geometry, value as f32);
    let vector = |numbers: [f32; 3]| numbers.map(|value| encode(config.geometry, value));
    let MovingSplat { splat, motion, part } = moving;
    let center = DVec3::from_array(splat.center.map(f64::from)) - part.middle() * *motion;
    let mut attributes = records::Attributes::default();
    attributes[..config.attributes() as usize].fill_with(|| random.u32(..) >> (32 - config.attribute.width()));
    records::Splat {
        end: false,
        center: center.to_array().map(number),
        tangents: splat.tangents.map(vector),
        motion: records::Motion { way: motion.to_array().map(number), part: [part.begin, part.end].map(number) },
        attributes,
    }
}

/// A motion of any speed, or none, in a bin of the exposure or a part of it; nothing where nothing moves.
#[must_use]
pub fn motion(config: &Config, random: &mut Rng) -> records::Motion {
    if !config.has_motion() {
        return records::Motion::default();
    }
    let number = |number: f32| encode(config.geometry, number);
    let speed = match random.u8(..8) {
        0 | 1 => 0.0,
        2 => 1e-6 * random.f32(),
        3 => 8.0,
        _ => (-5.0 * random.f32()).exp2(),
    };
    let border = |index: u32| 2.0 * index as f32 / config.time_bins as f32 - 1.0;
    let bin = random.u32(..config.time_bins);
    let part = match random.u8(..8) {
        // Across borders: what is there is what lies in the bin of the middle.
        0 => sorted([(); 2].map(|()| 2.0 * random.f32() - 1.0)),
        1 => sorted([(); 2].map(|()| border(random.u32(0..=config.time_bins)))),
        2 | 3 => sorted([(); 2].map(|()| border(bin) + random.f32() * (border(bin + 1) - border(bin)))),
        _ => [border(bin), border(bin + 1)],
    };
    let way = [(); 3].map(|()| number(speed * (2.0 * random.f32() - 1.0)));
    records::Motion { way, part: part.map(number) }
}

fn sorted(mut ends: [f32; 2]) -> [f32; 2] {
    ends.sort_by(f32::total_cmp);
    ends
}

/// What setup's splats share.
#[must_use]
pub fn motion_uniforms(config: &Config) -> MotionUniforms {
    let (camera, rendering) = (camera(config), rendering(config));
    let number = |value: f64| encode(config.geometry, value as f32);
    MotionUniforms {
        viewport: records::Viewport {
            scale: [camera.scale_x, camera.scale_y].map(number),
            origin: [camera.center_x, camera.center_y].map(number),
            depth_a: number(camera.depth_a),
            depth_b: number(camera.depth_b),
        },
        epsilon: records::EpsilonScale { scale: number(rendering.epsilon_scale), bias: number(rendering.epsilon_bias) },
        near_plane: number(camera.near),
    }
}

/// Their names and values, as ports have them.
#[must_use]
pub fn uniforms(config: &Config) -> Vec<(String, u64)> {
    let MotionUniforms { viewport, epsilon, near_plane } = motion_uniforms(config);
    let all = Uniforms { viewport, epsilon, near_plane, ..Uniforms::default() };
    let names = fields::<Uniforms>(config).into_iter().map(|field| field.name);
    names.zip(words(config, all)).collect()
}
