//! A frame's camera and rendering as the values of the renderer's uniform registers.

use crate::number::encode_uniform;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::ports::UNIFORMS;
use pointcore_contract::{Camera, Rendering};

/// The registers' values, in the order of [`UNIFORMS`].
#[must_use]
pub fn uniforms(camera: &Camera, rendering: &Rendering, config: &Config) -> Vec<u64> {
    let radius = rendering.filter_radius_px.unwrap_or(1.0);
    let viewport = [camera.scale_x, camera.scale_y, camera.center_x, camera.center_y, camera.depth_a, camera.depth_b];
    let tests = [camera.near, rendering.epsilon_scale, rendering.epsilon_bias, radius, 1.0 / (radius * radius)];
    let values = camera.model_view.iter().flatten().chain(&viewport).chain(&tests);
    UNIFORMS
        .iter()
        .zip(values)
        .map(|(name, &value)| encode_uniform(config.uniform_format(name), value as f32).into())
        .collect()
}
