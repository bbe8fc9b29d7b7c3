//! Bins of time: a bounded A-buffer in one pass.
//!
//! What stands still is one static pixel. What moves before it falls into bins, each for its part of the exposure: the nearest surface as a pixel of
//! the static reconstruction buffer, with when it was there, and the sums of everything else, with when anything was. The rest is seen when the nearest
//! surface is not. It needs no order among itself: what is hidden for a part of its time weighs as much as what is seen, which errs only where three
//! surfaces pass a sample within one bin. What is hidden for all of its time is left out.
//!
//! A splat blends with what lies within ε of any depth that it has there. When something was there is known by its earliest and its latest time, and
//! by which of sixteen parts of the bin it was there in.
//!
//! One bin looks for what the thesis' passes look for (4.4.2); many approach the exact A-buffer.

use super::background::Background;
use super::exposure::Exposed;
use super::interval::Interval;
use super::kernel::Hit;
use super::{Place, Setting, Shutter};
use crate::reference::reconstruction::{Band, Decision, Pixel};
use pointcore_contract::splat::motion::BIN_PARTS;

/// When a sample is covered within a bin.
#[derive(Clone, Copy, Default)]
struct Cover {
    /// From the first to the last time.
    hull: Option<Interval>,
    /// A bit for each part of the bin in which it is.
    parts: u32,
}

impl Cover {
    /// All of the intervals, within a bin.
    fn of(bin: Interval, intervals: impl Iterator<Item = Interval>) -> Self {
        let alone = |covered: Interval| {
            let touched = parts(bin).map(|part| part.intersection(covered).is_some());
            let parts =
                touched.enumerate().fold(0, |parts, (index, is_touched)| parts | u32::from(is_touched) << index);
            Self { hull: Some(covered), parts }
        };
        intervals.filter_map(|interval| interval.intersection(bin)).map(alone).fold(Self::default(), Self::with)
    }

    /// When either is there.
    fn with(self, other: Self) -> Self {
        let hull = self.hull.into_iter().chain(other.hull).reduce(Interval::hull);
        Self { hull, parts: self.parts | other.parts }
    }

    /// Whether another one is there for all of the time.
    fn is_within(self, other: Self) -> bool {
        let Some(own) = self.hull else { return true };
        self.parts & !other.parts == 0 && other.hull.is_some_and(|hull| own.intersection(hull) == Some(own))
    }

    /// The share of the exposure for which it is there.
    fn share(self, bin: Interval, shutter: Shutter) -> f64 {
        let Some(hull) = self.hull else { return 0.0 };
        let missed = parts(bin).enumerate().filter(|(index, _)| self.parts >> index & 1 == 0);
        let missed = missed.filter_map(|(_, part)| part.intersection(hull));
        shutter.share(hull) - missed.map(|part| shutter.share(part)).sum::<f64>()
    }
}

/// The parts of a bin.
fn parts(bin: Interval) -> impl Iterator<Item = Interval> {
    let border = move |index: u32| bin.begin + bin.length() * f64::from(index) / f64::from(BIN_PARTS);
    (0..BIN_PARTS).map(move |index| Interval { begin: border(index), end: border(index + 1) })
}

/// One bin of a sample.
#[derive(Default)]
struct Bin {
    nearest: Pixel,
    covered_by_nearest: Cover,
    /// What is seen besides.
    rest: Pixel,
    /// When anything covers the sample.
    covered: Cover,
}

impl Bin {
    /// Adds a hit's share of the bin.
    fn add(&mut self, hit: &Hit, band: Band, weight: f64, covered: Cover) {
        self.covered = self.covered.with(covered);
        let before = self.nearest.clone();
        match self.nearest.add(hit.kernel.splat, band, weight) {
            Decision::Fail => {
                if !covered.is_within(self.covered_by_nearest) {
                    self.rest.add(hit.kernel.splat, Band::everywhere(band.depth()), weight);
                }
            }
            Decision::Pass => {
                if !self.covered_by_nearest.is_within(covered) {
                    self.rest.merge(&before);
                }
                self.covered_by_nearest = covered;
            }
            Decision::Blend => self.covered_by_nearest = self.covered_by_nearest.with(covered),
        }
    }

    /// Adds what was seen to the exposure; returns the share of it.
    fn resolve(&self, bin: Interval, place: &Place, setting: &Setting, exposed: &mut Exposed) -> f64 {
        let [nearest, all] = [self.covered_by_nearest, self.covered].map(|cover| cover.share(bin, setting.shutter));
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
            let covered = Cover::of(part, hit.pieces.iter().map(|piece| piece.interval));
            let Some(Interval { begin, end }) = covered.hull else { continue };
            let [first, last] = [begin, end].map(|time| hit.kernel.band(time, place, camera, rendering));
            let band = first.hull(last);
            let weight = hit.integral(part, shutter, rendering.kernel_gamma);
            if weight > 0.0 && !band.is_hidden_by(background.depth) {
                bin.add(hit, band, weight, covered);
            }
        }
        rest -= bin.resolve(part, place, setting, &mut exposed);
    }
    background.add_to(&mut exposed, rest);
    exposed
}
