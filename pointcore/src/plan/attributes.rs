//! What a scene's splats carry beside their geometry, and whether the hardware's formats hold it and the scene's filter.

use crate::scene::Scene;
use pointcore_contract::Splat;
use pointcore_contract::splat::{AttributeFormat, Coefficient, Fraction, RasterFormat};
use pointcore_contract::surface::{CONTINUOUS_ATTRIBUTES, NORMAL};

/// Why the scene's materials do not go into an attribute, and the format's name: a material takes as many bits as an attribute has, which in every
/// floating-point format are all of its own.
pub(super) fn material_conflict(scene: &Scene, attribute: AttributeFormat) -> Option<(&'static str, String)> {
    let AttributeFormat::Fixed(fraction) = attribute else { return None };
    let largest = scene.splats.iter().map(|splat| splat.material).max().unwrap_or(0);
    let needed = u16::BITS - largest.leading_zeros();
    let (name, _) = Fraction::NAMED.iter().find(|(_, named)| *named == fraction)?;
    (needed > fraction.width()).then(|| (*name, format!("material {largest} of the scene needs {needed} bits")))
}

/// Radii of screen filters that a rasterizer in fixed point has numbers for, px.
const FILTER_RADII_PX: std::ops::RangeInclusive<f64> = 0.2501..=4.0;

/// Why the scene's filter does not go into a rasterizer in fixed point, and the format's name.
pub(super) fn filter_conflict(scene: &Scene, rasterizer: RasterFormat) -> Option<(&'static str, String)> {
    let radius = scene.rendering.filter_radius_px.filter(|radius| !FILTER_RADII_PX.contains(radius))?;
    let (name, _) = Coefficient::NAMED.iter().find(|(_, named)| Some(*named) == rasterizer.fixed())?;
    let reason = format!(
        "the scene's filter of {radius} px is not wider than ¼ px and at most 4 px, for which fixed point has numbers"
    );
    Some((*name, reason))
}

/// The values of attributes that are the same for all splats in all frames; one is carried at least.
pub(super) fn constants(scene: &Scene) -> [Option<f32>; CONTINUOUS_ATTRIBUTES] {
    // Splats that turn with the eye have another normal in another frame.
    let turns = scene.views.len() > 1 && !scene.sides.is_empty() && scene.is_lit();
    let mut constants = differing(scene.splats.iter());
    if turns {
        constants[NORMAL].fill(None);
    }
    constants
}

/// The same of splats alone.
pub(super) fn differing<'a>(splats: impl Iterator<Item = &'a Splat> + Clone) -> [Option<f32>; CONTINUOUS_ATTRIBUTES] {
    let constant = |index: usize| {
        let mut values = splats.clone().map(|splat| splat.attributes[index]);
        let first = values.next()?;
        values.all(|value| value == first).then_some(first)
    };
    let mut constants: [_; CONTINUOUS_ATTRIBUTES] = std::array::from_fn(constant);
    if constants.iter().all(Option::is_some) {
        constants[NORMAL.start] = None;
    }
    constants
}

/// Indices of the attributes that are carried.
pub(super) fn varying(constants: &[Option<f32>]) -> Vec<usize> {
    (0..constants.len()).filter(|&index| constants[index].is_none()).collect()
}
