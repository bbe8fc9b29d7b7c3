//! The thesis' passes on a graphics processor (4.4), for each of several equal parts of the exposure (4.4.5).
//!
//! Passes 1 and 2 draw discs where they are when the part begins and ends, for depth alone. A kernel that at its nearest is hidden in both is left out.
//! Passes 3 and 4 find the earliest and the latest time covered, pass 5 blends all kernels that are left with all of their integral, pass 6 normalizes
//! and blends with what is behind by the time covered. Splats that stand still are drawn before, as that background.

use super::background::Background;
use super::exposure::Exposed;
use super::interval::Interval;
use super::kernel::Hit;
use super::{Place, Setting};
use crate::reference::reconstruction::{Band, Pixel};

/// Carries out the passes for one sample.
pub(super) fn resolve(hits: &[Hit], place: &Place, setting: &Setting, parts: usize) -> Exposed {
    let Setting { camera, rendering, shutter, .. } = *setting;
    let (still, moving): (Vec<&Hit>, Vec<&Hit>) = hits.iter().partition(|hit| hit.kernel.is_still());
    let background = Background::new(&still, place, setting);
    let band = |hit: &Hit, time: f64| hit.kernel.band(time, place, camera, rendering);
    let mut exposed = Exposed::default();
    let mut rest = 1.0;
    for part in Interval::equal_parts(parts) {
        let drawn_at = |time: f64| {
            let depths = moving.iter().filter(|hit| hit.covers(time)).map(|hit| band(hit, time).depth());
            depths.fold(f64::INFINITY, f64::min)
        };
        let farthest_seen = drawn_at(part.begin).max(drawn_at(part.end)).min(background.depth);
        let (mut blended, mut seen) = (Pixel::default(), None::<Interval>);
        for hit in &moving {
            let Some(covered) = hit.covered(part) else { continue };
            let [first, last] = [covered.begin, covered.end].map(|time| band(hit, time));
            let nearest = if first.depth() < last.depth() { first } else { last };
            let weight = hit.integral(part, shutter, rendering.kernel_gamma);
            if nearest.is_hidden_by(farthest_seen) || weight <= 0.0 {
                continue;
            }
            blended.add(hit.kernel.splat, Band::everywhere(nearest.depth()), weight);
            seen = Some(seen.map_or(covered, |before| before.hull(covered)));
        }
        if let (Some(fragment), Some(seen)) = (blended.normalized(), seen) {
            let share = shutter.share(seen);
            exposed.add((setting.shade)(&fragment, place.position), share);
            rest -= share;
        }
    }
    background.add_to(&mut exposed, rest);
    exposed
}
