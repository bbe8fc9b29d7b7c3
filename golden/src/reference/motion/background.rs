//! What stands still all through the exposure: one static pixel, whatever else moves before it.

use super::exposure::Exposed;
use super::interval::Interval;
use super::kernel::Hit;
use super::{Place, Setting};
use crate::reference::reconstruction::Pixel;

/// The splats over a sample that stand still, as the static renderer has them.
pub(super) struct Background {
    color: Option<[f64; 3]>,
    /// Of the surface that is seen; infinite where there is none.
    pub depth: f64,
}

impl Background {
    pub(super) fn new(still: &[&Hit], place: &Place, setting: &Setting) -> Self {
        let Setting { camera, rendering, shutter, .. } = *setting;
        let mut pixel = Pixel::default();
        for hit in still {
            let weight = hit.integral(Interval::EXPOSURE, shutter, rendering.kernel_gamma);
            pixel.add(hit.kernel.splat, hit.kernel.band(0.0, place, camera, rendering), weight);
        }
        let fragment = pixel.normalized();
        Self {
            color: fragment.as_ref().map(|fragment| (setting.shade)(fragment, place.position)),
            depth: fragment.map_or(f64::INFINITY, |fragment| fragment.depth),
        }
    }

    /// Adds it for a share of the exposure.
    pub(super) fn add_to(&self, exposed: &mut Exposed, share: f64) {
        if let Some(color) = self.color {
            exposed.add(color, share);
        }
    }
}
