//! What a scene's splats carry beside their geometry, and whether the hardware's format holds it.

use crate::scene::Scene;
use pointcore_spec::core_a::{AttributeFormat, Fraction};
use pointcore_spec::splat::{CONTINUOUS_ATTRIBUTES, NORMAL};

/// Why the scene's materials do not go into an attribute, and the format's name: a material takes as many bits as an attribute has, which in every
/// floating-point format are all of its own.
pub(super) fn material_conflict(scene: &Scene, attribute: AttributeFormat) -> Option<(&'static str, String)> {
    let AttributeFormat::Fixed(fraction) = attribute else { return None };
    let largest = scene.splats.iter().map(|splat| splat.material).max().unwrap_or(0);
    let needed = u16::BITS - largest.leading_zeros();
    let (name, _) = Fraction::NAMED.iter().find(|(_, named)| *named == fraction)?;
    (needed > fraction.width()).then(|| (*name, format!("material {largest} of the scene needs {needed} bits")))
}

/// Indices of the attributes that differ between splats (at least one is carried), and the values of the others.
pub(super) fn attributes(scene: &Scene) -> (Vec<usize>, [Option<f32>; CONTINUOUS_ATTRIBUTES]) {
    let constant = |index: usize| {
        let first = scene.splats.first().map(|splat| splat.attributes[index])?;
        scene.splats.iter().all(|splat| splat.attributes[index] == first).then_some(first)
    };
    let mut constants: [_; CONTINUOUS_ATTRIBUTES] = std::array::from_fn(constant);
    if constants.iter().all(Option::is_some) {
        constants[NORMAL.start] = None;
    }
    let varying = (0..CONTINUOUS_ATTRIBUTES).filter(|&index| constants[index].is_none()).collect();
    (varying, constants)
}
