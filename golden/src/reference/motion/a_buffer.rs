//! The exact A-buffer (thesis 4.3.4): a sample's exposure is cut wherever a splat comes or goes, and where the order of surfaces changes between.

use super::exposure::Exposed;
use super::interval::Interval;
use super::kernel::{Hit, Piece};
use super::{Place, Setting};
use crate::reference::reconstruction::{Decision, Pixel};

/// Parts of the exposure shorter than this are not cut where surfaces change places: as many as temporal samples of the truth.
const SHORTEST: f64 = 2.0 / 256.0;

/// A splat over the sample, for one of its pieces.
#[derive(Clone, Copy)]
struct Entry<'h> {
    /// Its place in the order in which splats came.
    order: usize,
    hit: &'h Hit<'h>,
    piece: &'h Piece,
}

/// Cuts the exposure and adds up what is seen in each part.
pub(super) fn resolve(hits: &[Hit], place: &Place, setting: &Setting) -> Exposed {
    let entries = hits
        .iter()
        .enumerate()
        .flat_map(|(order, hit)| hit.pieces.iter().map(move |piece| Entry { order, hit, piece }));
    let mut coming: Vec<Entry> = entries.collect();
    coming.sort_by(|a, b| a.piece.interval.begin.total_cmp(&b.piece.interval.begin));
    let ends = coming.iter().flat_map(|entry| [entry.piece.interval.begin, entry.piece.interval.end]);
    let mut cuts: Vec<f64> = ends.collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();

    let mut exposed = Exposed::default();
    let mut coming = coming.into_iter().peekable();
    // Those that have come and not gone, in the order of splats.
    let mut there: Vec<Entry> = Vec::new();
    for interval in cuts.windows(2).filter_map(|ends| Interval::new(ends[0], ends[1])) {
        there.retain(|entry| entry.piece.interval.end > interval.begin);
        while let Some(entry) = coming.next_if(|entry| entry.piece.interval.begin <= interval.begin) {
            let index = there.partition_point(|other| other.order < entry.order);
            there.insert(index, entry);
        }
        see(&there, interval, place, setting, &mut exposed);
    }
    exposed
}

/// Adds what is seen in an interval in which the same splats cover the sample.
fn see(there: &[Entry], interval: Interval, place: &Place, setting: &Setting, exposed: &mut Exposed) {
    if there.is_empty() {
        return;
    }
    let members = |time: f64| surface(there, interval, time, place, setting).1;
    if interval.length() > SHORTEST && members(interval.begin) != members(interval.end) {
        let middle = interval.middle();
        for (begin, end) in [(interval.begin, middle), (middle, interval.end)] {
            see(there, Interval { begin, end }, place, setting, exposed);
        }
        return;
    }
    if let Some(fragment) = surface(there, interval, interval.middle(), place, setting).0.normalized() {
        exposed.add((setting.shade)(&fragment, place.position), setting.shutter.share(interval));
    }
}

/// The surface that is seen with depths as they are at a time, and which splats it is of.
fn surface(there: &[Entry], interval: Interval, time: f64, place: &Place, setting: &Setting) -> (Pixel, Vec<usize>) {
    let Setting { camera, rendering, shutter, .. } = *setting;
    let (mut pixel, mut members) = (Pixel::default(), Vec::new());
    for Entry { order, hit, piece } in there {
        let weight = piece.squared_distance.integral(shutter, rendering.kernel_gamma, interval);
        if weight <= 0.0 {
            continue;
        }
        match pixel.add(hit.kernel.splat, hit.kernel.band(time, place, camera, rendering), weight) {
            Decision::Fail => {}
            Decision::Pass => members = vec![*order],
            Decision::Blend => members.push(*order),
        }
    }
    (pixel, members)
}
