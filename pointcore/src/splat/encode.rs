//! A scene as the words that the renderer takes: splat records and uniform registers.

use crate::number::{encode, encode_attribute};
use crate::plan::Plan;
use crate::scene::Scene;
use crate::uniforms::uniforms;
use pointcore_contract::Splat;
use pointcore_contract::splat::records;

/// Splat records one after the other, and the uniform registers by address.
pub struct EncodedFrame {
    /// Words of the records, `record_words` each; the last one is the end record.
    pub records: Vec<u64>,
    /// Fields of a record.
    pub record_words: usize,
    /// Values of the uniform registers.
    pub uniforms: Vec<u64>,
}

impl EncodedFrame {
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
    let attributes =
        plan.attributes.iter().map(|&index| encode_attribute(config.attribute, splat.attributes[index]).into());
    // Hardware may carry more than the scene has.
    let unused = plan.attributes.len()..config.continuous as usize;
    let attributes = attributes.chain(unused.map(|_| 0));
    let cardinals = (0..config.cardinal).map(|_| splat.material.into());
    let end = std::iter::once(0);
    end.chain(geometry.map(|&value| encode(config.geometry, value).into())).chain(attributes).chain(cardinals).collect()
}
