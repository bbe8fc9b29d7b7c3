//! A scene as the renderer takes it: splat records and uniform registers.

use super::depth_memory::Depths;
use super::moving::{moving_records, shutter_weights};
use crate::number::{encode, encode_attribute};
use crate::plan::Plan;
use crate::scene::Scene;
use crate::triangles::Layer;
use crate::uniforms::uniforms;
use pointcore_contract::Splat;
use pointcore_contract::splat::records::{self, Attributes, Uniforms};

/// The record that closes a frame.
pub const END: records::Splat = records::Splat {
    end: true,
    center: [0; 3],
    tangents: [[0; 3]; 2],
    motion: records::Motion { way: [0; 3], part: [0; 2] },
    attributes: [0; records::ATTRIBUTES],
};

/// What the host sends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EncodedFrame {
    /// The splats in world space; the last record closes the frame, others a surface of it.
    pub records: Vec<records::Splat>,
    /// The uniform registers.
    pub uniforms: Uniforms,
    /// What lies in memory that fragments are tested against, or samples of what moves; nothing, unless it is said.
    pub depths: Option<Depths>,
}

impl EncodedFrame {
    /// Encodes what the planned hardware needs of a scene; hardware with bins of the exposure is sent what moves.
    #[must_use]
    pub fn new(scene: &Scene, plan: &Plan) -> Self {
        let mut uniforms = uniforms(&scene.camera, &scene.rendering, &plan.config);
        let mut records: Vec<_> = if plan.config.has_motion() {
            uniforms.shutter = shutter_weights(scene, &plan.config);
            moving_records(scene, plan)
        } else {
            scene.splats.iter().map(|splat| splat_record(splat, plan)).collect()
        };
        // The last first, so that the others' places stay.
        for surface in scene.surfaces.iter().rev().skip(1) {
            records.insert(surface.end, END);
        }
        records.push(END);
        let depths = plan.config.merge.is_on().then(|| Layer::of(scene)).flatten();
        Self { records, uniforms, depths: depths.map(|layer| layer.depths(&plan.config)) }
    }
}

fn splat_record(splat: &Splat, plan: &Plan) -> records::Splat {
    let config = &plan.config;
    let vector = |numbers: [f32; 3]| numbers.map(|number| encode(config.geometry, number));
    // Hardware may carry more than the scene has.
    let mut attributes = Attributes::default();
    for (attribute, &index) in attributes.iter_mut().zip(&plan.attributes) {
        *attribute = encode_attribute(config.attribute, splat.attributes[index]);
    }
    attributes[config.continuous as usize..config.attributes() as usize].fill(splat.material.into());
    let tangents = splat.tangents.map(vector);
    records::Splat { center: vector(splat.center), tangents, attributes, ..records::Splat::default() }
}
