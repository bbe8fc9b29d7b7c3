//! The exact A-buffer (thesis 4.3.4): a sample's exposure is cut wherever a splat comes or goes, and where the order of surfaces changes between.

use super::exposure::Exposed;
use super::interval::Interval;
use super::kernel::Hit;
use super::{Place, Setting};
use crate::reference::reconstruction::{Decision, Pixel};

/// Parts of the exposure shorter than this are not cut where surfaces change places: as many as temporal samples of the truth.
const SHORTEST: f64 = 2.0 / 256.0;

/// Cuts the exposure and adds up what is seen in each part.
pub(super) fn resolve(hits: &[Hit], place: &Place, setting: &Setting) -> Exposed {
    let ends = hits.iter().flat_map(|hit| &hit.pieces).flat_map(|piece| [piece.interval.begin, piece.interval.end]);
    let mut cuts: Vec<f64> = ends.collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let mut exposed = Exposed::default();
    // Splats that begin and have not ended, in the order in which they came.
    for interval in cuts.windows(2).filter_map(|ends| Interval::new(ends[0], ends[1])) {
        let there: Vec<&Hit> = hits.iter().filter(|hit| hit.covers(interval.middle())).collect();
        see(&there, interval, place, setting, &mut exposed);
    }
    exposed
}

/// Adds what is seen in an interval in which the same splats cover the sample.
fn see(hits: &[&Hit], interval: Interval, place: &Place, setting: &Setting, exposed: &mut Exposed) {
    if hits.is_empty() {
        return;
    }
    let halves = [(interval.begin, interval.middle()), (interval.middle(), interval.end)];
    if interval.length() > SHORTEST
        && surface(hits, interval, interval.begin, place, setting).1
            != surface(hits, interval, interval.end, place, setting).1
    {
        for half in halves.into_iter().filter_map(|(begin, end)| Interval::new(begin, end)) {
            see(hits, half, place, setting, exposed);
        }
        return;
    }
    if let Some(fragment) = surface(hits, interval, interval.middle(), place, setting).0.normalized() {
        exposed.add((setting.shade)(&fragment, place.position), setting.shutter.share(interval));
    }
}

/// The surface that is seen with depths as they are at a time, and which splats it is of.
fn surface(hits: &[&Hit], interval: Interval, time: f64, place: &Place, setting: &Setting) -> (Pixel, Vec<usize>) {
    let Setting { camera, rendering, shutter, .. } = *setting;
    let (mut pixel, mut members) = (Pixel::default(), Vec::new());
    for (index, hit) in hits.iter().enumerate() {
        let weight = hit.integral(interval, shutter, rendering.kernel_gamma);
        if weight <= 0.0 {
            continue;
        }
        match pixel.add(hit.kernel.splat, hit.kernel.band(time, place, camera, rendering), weight) {
            Decision::Fail => {}
            Decision::Pass => members = vec![index],
            Decision::Blend => members.push(index),
        }
    }
    (pixel, members)
}
