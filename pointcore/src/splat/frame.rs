//! Fragments read back from the renderer, as a frame that can be shaded and compared with the reference.

use crate::number::{decode, decode_attribute};
use crate::plan::Plan;
use pointcore_contract::Splat;
use pointcore_contract::splat::records;
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use pointcore_golden::reference::{Decisions, Fragment, Frame, Margins, Statistics};

/// Places fragments (as [`SplatHost`](super::host::SplatHost) collects them) in the scene's image; hardware for a larger one renders beyond it.
/// Attributes the hardware does not carry take their constant; the material of a scene with only one is that of any splat.
#[must_use]
pub fn assemble(plan: &Plan, splats: &[Splat], fragments: &[records::Fragment]) -> Frame {
    let config = &plan.config;
    let [width, height] = plan.image;
    let constants: [f64; CONTINUOUS_ATTRIBUTES] = plan.constants.map(|constant| constant.unwrap_or(0.0).into());
    let only_material = splats.first().map_or(0, |splat| splat.material);

    let mut pixels = vec![None; width * height];
    for found in fragments {
        let [column, row] = [found.column, found.row].map(usize::from);
        if column >= width || row >= height {
            continue;
        }
        let mut attributes = constants;
        for (&index, &bits) in plan.attributes.iter().zip(&found.attributes) {
            attributes[index] = decode_attribute(config.attribute, bits).into();
        }
        let cardinals = &found.attributes[config.continuous as usize..config.attributes() as usize];
        let material = cardinals.first().map_or(only_material, |&material| material as u16);
        // The hardware keeps the weight to itself; a fragment exists only where it is positive.
        let depth = decode(config.geometry, found.depth).into();
        pixels[row * width + column] = Some(Fragment { depth, weight: 1.0, attributes, material });
    }
    // Tests are counted by the reference only.
    let (decisions, margins) = (vec![Decisions::default(); pixels.len()], vec![Margins::default(); pixels.len()]);
    Frame { width, height, pixels, decisions, margins, statistics: Statistics::default() }
}
