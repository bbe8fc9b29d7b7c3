mod footprint;
mod integral;
mod visibility;

use super::*;
use pointcore_contract::{FragmentDepth, Sampling};

const CAMERA: Camera = Camera {
    model_view: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
    scale_x: 50.0,
    scale_y: 60.0,
    center_x: 16.0,
    center_y: 15.0,
    depth_a: 100.0 / 99.0,
    depth_b: -100.0 / 99.0,
    near: 1.0,
};

const RENDERING: Rendering = Rendering {
    width: 32,
    height: 30,
    sampling: Sampling::Center,
    depth: FragmentDepth::Center,
    kernel_gamma: Rendering::DEFAULT_KERNEL_GAMMA,
    filter_radius_px: Some(Rendering::DEFAULT_FILTER_RADIUS_PX),
    epsilon_scale: Rendering::DEFAULT_EPSILON_SCALE,
    epsilon_bias: 0.01,
};

const UNFILTERED: Rendering = Rendering { filter_radius_px: None, ..RENDERING };

/// A source of numbers, whose seed `POINTCORE_SEED` replaces.
struct Random(fastrand::Rng);

impl Random {
    fn new() -> Self {
        let seed = std::env::var("POINTCORE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1_u64);
        println!("reproduce with POINTCORE_SEED={seed} cargo test -p pointcore-golden reference::motion");
        Self(fastrand::Rng::with_seed(seed))
    }

    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.f64()
    }

    fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::new(self.uniform(-size, size), self.uniform(-size, size), self.uniform(-size, size))
    }

    /// A splat between near and far plane that faces the eye well enough, somewhere before the image.
    fn splat(&mut self) -> Splat {
        let z = self.uniform(3.0, 20.0);
        let size = z * self.uniform(0.02, 0.2);
        let center = DVec3::new(self.uniform(-0.3, 0.3) * z, self.uniform(-0.25, 0.25) * z, z);
        loop {
            let tangents = [self.vector(size), self.vector(size)];
            let normal = tangents[0].cross(tangents[1]);
            if normal.length() > 0.2 * size * size && normal.dot(center) < -0.3 * normal.length() * center.length() {
                return splat(center, tangents, [self.uniform(0.0, 1.0) as f32; 3]);
            }
        }
    }

    fn moving(&mut self, speed: f64) -> MovingSplat {
        let splat = self.splat();
        let motion = self.vector(speed * f64::from(splat.center[2]));
        MovingSplat { splat, motion, part: Interval::EXPOSURE }
    }

    /// A place near the way of the splat's center.
    fn place_near(&mut self, moving: &MovingSplat) -> Place {
        let center = DVec3::from_array(moving.splat.center.map(f64::from)) + self.uniform(-1.0, 1.0) * moving.motion;
        let near = |along: f64, size: usize| (along.max(0.0) as usize).min(size - 1);
        let x = CAMERA.scale_x * center.x / center.z + CAMERA.center_x + self.uniform(-2.0, 2.0);
        let y = CAMERA.scale_y * center.y / center.z + CAMERA.center_y + self.uniform(-2.0, 2.0);
        Place::new(near(x, RENDERING.width), near(y, RENDERING.height), &RENDERING)
    }

    fn shutter(&mut self) -> Shutter {
        if self.0.bool() { Shutter::Box } else { Shutter::Gaussian }
    }
}

fn splat(center: DVec3, tangents: [DVec3; 2], color: [f32; 3]) -> Splat {
    let single = |vector: DVec3| vector.as_vec3().to_array();
    let [red, green, blue] = color;
    Splat {
        center: single(center),
        tangents: tangents.map(single),
        attributes: [0.0, 0.0, -1.0, red, green, blue],
        material: 0,
    }
}

/// A disc that faces the eye squarely.
fn facing(center: DVec3, radius: f64, color: [f32; 3]) -> Splat {
    splat(center, [DVec3::Y * radius, DVec3::X * radius], color)
}
