//! Fragments of bins of the exposure, before a still frame, as an exposed image.

use crate::plan::Plan;
use crate::scene::Scene;
use crate::shading;
use crate::splat::frame::surface;
use pointcore_contract::splat::motion::TIME_FRACTION_BITS;
use pointcore_contract::splat::records::{self, Seen};
use pointcore_golden::reference::Frame;
use pointcore_golden::reference::motion::{Exposure, Place};

/// What fragments expose, surface by surface, before a frame of what stands still.
#[must_use]
pub fn expose(scene: &Scene, plan: &Plan, fragments: &[records::Fragment], still: Option<&Frame>) -> Exposure {
    let rendering = &scene.rendering;
    let shade = shading::colors(scene, &scene.camera);
    let mut exposure = Exposure::dark(rendering);
    for found in fragments {
        let [column, row] = [found.column, found.row].map(usize::from);
        // Hardware for a larger image renders beyond it.
        if column >= exposure.width || row >= exposure.height {
            continue;
        }
        let (place, index) = (Place::new(column, row, rendering), row * exposure.width + column);
        let Seen { share, rest_share, depth, ref attributes, .. } = found.seen;
        for (share, depth, attributes) in [(share, found.depth, &found.attributes), (rest_share, depth, attributes)] {
            let surface = surface(plan, depth, attributes);
            if share > 0 {
                let share = f64::from(share) / f64::from(1 << TIME_FRACTION_BITS);
                exposure.samples[index].add(shade(&surface, place.position), share);
            }
        }
    }
    let Some(still) = still else { return exposure };
    for (index, (sample, still)) in exposure.samples.iter_mut().zip(&still.pixels).enumerate() {
        if let Some(still) = still {
            let place = Place::new(index % exposure.width, index / exposure.width, rendering);
            sample.add(shade(still, place.position), 1.0 - sample.coverage);
        }
    }
    exposure
}
