//! Synthetic splats and the camera that sees them.

use fastrand::Rng;
use glam::Vec3;
use pointcore_contract::{Camera, FragmentDepth, Rendering, Sampling, Splat};

pub const CAMERA: Camera = Camera {
    model_view: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 4.0]],
    scale_x: 150.0,
    scale_y: 150.0,
    center_x: 52.0,
    center_y: 41.0,
    depth_a: 10.0 / 9.0,
    depth_b: -10.0 / 9.0,
    near: 1.0,
};

/// Neither edge is a multiple of a tile's.
pub const RENDERING: Rendering = Rendering {
    width: 103,
    height: 83,
    sampling: Sampling::Center,
    depth: FragmentDepth::Center,
    kernel_gamma: Rendering::DEFAULT_KERNEL_GAMMA,
    filter_radius_px: Some(Rendering::DEFAULT_FILTER_RADIUS_PX),
    epsilon_scale: Rendering::DEFAULT_EPSILON_SCALE,
    epsilon_bias: 0.02,
};

fn direction(random: &mut Rng) -> Vec3 {
    let component = |random: &mut Rng| 2.0 * random.f32() - 1.0;
    loop {
        let vector = Vec3::new(component(random), component(random), component(random));
        if (0.1..1.0).contains(&vector.length()) {
            return vector.normalize();
        }
    }
}

/// A disc whose front faces along `normal`.
pub fn disc(center: Vec3, normal: Vec3, radius: f32) -> Splat {
    let first = normal.any_orthonormal_vector();
    let tangents = [(first * radius).to_array(), (normal.cross(first) * radius).to_array()];
    let attributes = [normal.x, normal.y, normal.z, 0.5 + 0.5 * center.x, 0.5 + 0.5 * center.y, 0.5];
    Splat { center: center.to_array(), tangents, attributes, material: 0 }
}

/// A unit sphere at the origin, in random order: neighbours on the screen are far apart in time.
pub fn sphere(count: u16, random: &mut Rng) -> Vec<Splat> {
    let radius = 2.5 / f32::from(count).sqrt();
    let mut splat = |material| {
        let normal = direction(random);
        Splat { material, ..disc(normal, normal, radius * (0.5 + random.f32())) }
    };
    (0..count).map(&mut splat).collect()
}

/// Discs and slivers of all sizes and places: beside the view, behind the eye, across the eye plane, behind the far plane.
pub fn chaos(count: u16, random: &mut Rng) -> Vec<Splat> {
    let mut splat = |material| {
        let z = 10.0 * random.f32() - 3.5;
        let spread = 1.2 * (z + 4.0);
        let center = Vec3::new((random.f32() - 0.5) * spread, (random.f32() - 0.5) * spread, z);
        let radius = 2_f32.powf(11.0 * random.f32() - 8.0);
        let mut splat = disc(center, direction(random), radius);
        splat.tangents[0] = splat.tangents[0].map(|component| component * random.f32());
        Splat { material, ..splat }
    };
    (0..count).map(&mut splat).collect()
}
