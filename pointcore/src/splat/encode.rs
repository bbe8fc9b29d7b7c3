//! A scene as the words that the renderer takes: splat records and uniform registers.

use crate::number::{encode, encode_attribute, encode_uniform};
use crate::plan::Plan;
use crate::scene::Scene;
use pointcore_contract::splat::ports::UNIFORMS;
use pointcore_contract::splat::{AttributeFormat, Config, records};
use pointcore_contract::{Camera, Format, Rendering, Splat};

/// Splat records one after the other, and the uniform registers by address.
pub struct Frame {
    /// Words of the records, `record_words` each; the last one is the end record.
    pub records: Vec<u64>,
    /// Fields of a record.
    pub record_words: usize,
    /// Values of the uniform registers.
    pub uniforms: Vec<u64>,
}

/// A number as a word.
pub fn word(format: Format, value: f32) -> u64 {
    encode(format, value).into()
}

/// An attribute as a word.
pub(super) fn attribute_word(format: AttributeFormat, value: f32) -> u64 {
    encode_attribute(format, value).into()
}

impl Frame {
    /// Encodes what the planned hardware needs of a scene.
    #[must_use]
    pub fn new(scene: &Scene, plan: &Plan) -> Self {
        let config = &plan.config;
        let record_words = records::splat(config).len();
        let mut words = Vec::with_capacity((scene.splats.len() + 1) * record_words);
        for splat in &scene.splats {
            words.extend(splat_record(splat, plan));
        }
        let end = words.len();
        words.resize(end + record_words, 0);
        words[end] = 1;
        Self { records: words, record_words, uniforms: uniforms(&scene.camera, &scene.rendering, config) }
    }

    /// Records in the frame, the end record among them.
    #[must_use]
    pub fn count(&self) -> usize {
        self.records.len() / self.record_words
    }
}

fn splat_record(splat: &Splat, plan: &Plan) -> Vec<u64> {
    let config = &plan.config;
    let geometry = splat.center.iter().chain(splat.tangents.iter().flatten());
    let attributes = plan.attributes.iter().map(|&index| attribute_word(config.attribute, splat.attributes[index]));
    // Hardware may carry more than the scene has.
    let unused = plan.attributes.len()..config.continuous as usize;
    let attributes = attributes.chain(unused.map(|_| 0));
    let cardinals = (0..config.cardinal).map(|_| splat.material.into());
    let end = std::iter::once(0);
    end.chain(geometry.map(|&value| word(config.geometry, value))).chain(attributes).chain(cardinals).collect()
}

/// In the order of [`UNIFORMS`].
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
