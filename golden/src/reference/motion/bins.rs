//! Bins of time: a bounded A-buffer in one pass.
//!
//! What stands still is one static pixel. What moves before it falls into bins, each for its part of the exposure: the nearest surface as a pixel of
//! the static reconstruction buffer, with the earliest and the latest time at which it was there, and the sums of everything else, with the earliest and
//! the latest time at which anything was. The rest is seen when the nearest surface is not. It needs no order among itself: what is hidden behind
//! the nearest surface weighs as much as what is seen beside it, which errs only where three surfaces pass a sample within one bin.
//!
//! One bin looks for what the thesis' passes look for (4.4.2); many approach the exact A-buffer.

use super::background::Background;
use super::exposure::Exposed;
use super::interval::Interval;
use super::kernel::Hit;
use super::{Place, Setting};
use crate::reference::reconstruction::{Band, Decision, Pixel};

/// One bin of a sample.
#[derive(Default)]
struct Bin {
    nearest: Pixel,
    /// When the nearest surface covers the sample.
    covered_by_nearest: Option<Interval>,
    rest: Pixel,
    /// When anything does.
    covered: Option<Interval>,
}

impl Bin {
    /// Adds a hit's share of the bin.
    fn add(&mut self, hit: &Hit, band: Band, weight: f64, covered: Interval) {
        let extended = |before: Option<Interval>| Some(before.map_or(covered, |before| before.hull(covered)));
        self.covered = extended(self.covered);
        let before = self.nearest.clone();
        match self.nearest.add(hit.kernel.splat, band, weight) {
            Decision::Fail => {
                self.rest.add(hit.kernel.splat, Band::everywhere(band.depth()), weight);
            }
            Decision::Pass => {
                self.rest.merge(&before);
                self.covered_by_nearest = Some(covered);
            }
            Decision::Blend => self.covered_by_nearest = extended(self.covered_by_nearest),
        }
    }

    /// Adds what was seen to the exposure; returns the share of it.
    fn resolve(&self, place: &Place, setting: &Setting, exposed: &mut Exposed) -> f64 {
        let share = |covered: Option<Interval>| covered.map_or(0.0, |covered| setting.shutter.share(covered));
        let (nearest, all) = (share(self.covered_by_nearest), share(self.covered));
        for (pixel, share) in [(&self.nearest, nearest), (&self.rest, all - nearest)] {
            if let Some(fragment) = pixel.normalized() {
                exposed.add((setting.shade)(&fragment, place.position), share);
            }
        }
        all
    }
}

/// Adds splats to bins one by one, each with its share of the integral, and adds the bins up.
pub(super) fn resolve(hits: &[Hit], place: &Place, setting: &Setting, count: usize) -> Exposed {
    let Setting { camera, rendering, shutter, .. } = *setting;
    let (still, moving): (Vec<&Hit>, Vec<&Hit>) = hits.iter().partition(|hit| hit.kernel.is_still());
    let background = Background::new(&still, place, setting);
    let mut exposed = Exposed::default();
    let mut rest = 1.0;
    for part in Interval::equal_parts(count) {
        let mut bin = Bin::default();
        for hit in &moving {
            let Some(covered) = hit.covered(part) else { continue };
            let band = hit.kernel.band(covered.middle(), place, camera, rendering);
            let weight = hit.integral(part, shutter, rendering.kernel_gamma);
            if weight > 0.0 && !band.is_hidden_by(background.depth) {
                bin.add(hit, band, weight, covered);
            }
        }
        rest -= bin.resolve(place, setting, &mut exposed);
    }
    background.add_to(&mut exposed, rest);
    exposed
}
