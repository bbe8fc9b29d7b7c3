//! A frame's camera and rendering as the renderer's uniform registers.

use crate::number::{encode, encode_uniform};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::motion::{SHUTTER, TIME_BINS_MAX};
use pointcore_contract::splat::records::{EpsilonScale, ModelView, Shutter, Uniforms, Viewport};
use pointcore_contract::{Camera, Rendering};

/// The registers' values.
#[must_use]
pub fn uniforms(camera: &Camera, rendering: &Rendering, config: &Config) -> Uniforms {
    let number = |value: f64| encode(config.geometry, value as f32);
    let radius = rendering.filter_radius_px.unwrap_or(1.0);
    Uniforms {
        model_view: ModelView { rows: camera.model_view.map(|row| row.map(number)) },
        viewport: Viewport {
            scale: [camera.scale_x, camera.scale_y].map(number),
            origin: [camera.center_x, camera.center_y].map(number),
            depth_a: number(camera.depth_a),
            depth_b: number(camera.depth_b),
        },
        near_plane: number(camera.near),
        epsilon: EpsilonScale { scale: number(rendering.epsilon_scale), bias: number(rendering.epsilon_bias) },
        filter_radius: number(radius),
        filter_scale: encode_uniform(config.filter_scale_format(), (1.0 / (radius * radius)) as f32),
        shutter: open_shutter(),
    }
}

/// A shutter that is a box: every bin of the exposure counts alike.
#[must_use]
pub const fn open_shutter() -> Shutter {
    Shutter { weight: [1 << SHUTTER.fraction; TIME_BINS_MAX] }
}
