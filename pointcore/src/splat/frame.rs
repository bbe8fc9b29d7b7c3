//! Fragments read back from the renderer, as a frame that can be shaded and compared with the reference.

use crate::number::{decode, decode_attribute};
use crate::plan::Plan;
use pointcore_contract::splat::records::{self, Attributes};
use pointcore_golden::reference::{Decisions, Fragment, Frame, Margins, Statistics};

/// Places fragments (as [`SplatHost`](super::host::SplatHost) collects them) in the scene's image; hardware for a larger one renders beyond it.
#[must_use]
pub fn assemble(plan: &Plan, fragments: &[records::Fragment]) -> Frame {
    let [width, height] = plan.image;
    let mut pixels = vec![None; width * height];
    for found in fragments {
        let [column, row] = [found.column, found.row].map(usize::from);
        if column >= width || row >= height {
            continue;
        }
        pixels[row * width + column] = Some(surface(plan, found.depth, &found.attributes));
    }
    // Tests are counted by the reference only.
    let (decisions, margins) = (vec![Decisions::default(); pixels.len()], vec![Margins::default(); pixels.len()]);
    Frame { width, height, pixels, decisions, margins, statistics: Statistics::default() }
}

/// A surface from depth and attributes as the hardware encodes them. Attributes that it does not carry take their constant, and so does a material
/// that is that of all splats.
pub(super) fn surface(plan: &Plan, depth: u32, bits: &Attributes) -> Fragment {
    let config = &plan.config;
    let mut attributes = plan.constants.map(|constant| f64::from(constant.unwrap_or(0.0)));
    for (&index, &bits) in plan.attributes.iter().zip(bits) {
        attributes[index] = decode_attribute(config.attribute, bits).into();
    }
    let cardinals = &bits[config.continuous as usize..config.attributes() as usize];
    let material = cardinals.first().map_or(plan.material, |&material| material as u16);
    // The hardware keeps the weight to itself; a fragment exists only where it is positive.
    Fragment { depth: decode(config.geometry, depth).into(), weight: 1.0, attributes, material }
}
