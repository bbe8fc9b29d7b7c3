//! Bins of time: a bounded A-buffer. A sample has so many, each a pixel of the static reconstruction buffer for its part of the exposure, with the
//! earliest and the latest time covered within it.
//!
//! One bin is what the thesis' passes look for (4.4.2), found in one pass; many approach the exact A-buffer.

use super::exposure::Exposed;
use super::interval::Interval;
use super::kernel::Hit;
use super::{Place, Setting};
use crate::reference::reconstruction::Pixel;

/// One bin of a sample.
#[derive(Default)]
struct Bin {
    pixel: Pixel,
    covered: Option<Interval>,
}

/// Adds splats to bins one by one, each with its share of the integral, and adds the bins up.
pub(super) fn resolve(hits: &[Hit], place: &Place, setting: &Setting, count: usize) -> Exposed {
    let Setting { camera, rendering, shutter, .. } = *setting;
    // Where nothing moves one bin says all, in the static frame's bits.
    let count = if hits.iter().all(|hit| hit.kernel.is_still()) { 1 } else { count };
    let mut exposed = Exposed::default();
    for part in Interval::equal_parts(count) {
        let mut bin = Bin::default();
        for hit in hits {
            let Some(covered) = hit.covered(part) else { continue };
            let weight = hit.integral(part, shutter, rendering.kernel_gamma);
            if weight > 0.0 {
                let band = hit.kernel.band(covered.middle(), place, camera, rendering);
                bin.pixel.add(hit.kernel.splat, band, weight);
                bin.covered = Some(bin.covered.map_or(covered, |before| before.hull(covered)));
            }
        }
        if let (Some(fragment), Some(covered)) = (bin.pixel.normalized(), bin.covered) {
            exposed.add((setting.shade)(&fragment, place.position), shutter.share(covered));
        }
    }
    exposed
}
