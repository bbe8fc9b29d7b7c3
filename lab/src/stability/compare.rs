//! The hardware's method beside others, on the samples of one case.

use super::case::Case;
use super::check::RIM;

use super::analysis::Analysis;
use super::hardware::{Fate, Units};
use super::hit::InRange;
use super::methods::{Method, Prepared};
use super::search::{PixelArea, area, whole_image};
use super::truth::Truth;
use fastrand::Rng;

/// Samples of each method's choice and of the truth's.
const SAMPLES: usize = 4;

/// How well `ρ²` is known: far better than the formats resolve it.
const RESOLVED: f64 = 1.0 / (1_u64 << 34) as f64;

/// How one method did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MethodOutcome {
    /// A sample well inside the splat is not drawn, or one well outside is.
    pub failed: bool,
    /// Of the samples inside, the sum of squared errors of `ρ²`, none counted as more than one.
    pub squared_error: f64,
    /// Samples inside.
    pub inside: u32,
    /// Samples it visits.
    pub visited: u64,
}

/// One method, ready to be asked.
enum Device<'a> {
    Nothing,
    Ours(&'a Units, Box<pointcore_contract::splat::records::SetupSplat>),
    Other(Box<Prepared>),
}

impl Device<'_> {
    fn visited(&self) -> u64 {
        match self {
            Self::Nothing => 0,
            Self::Ours(_, drawn) => {
                let PixelArea { first, last } = area(drawn);
                [0, 1].map(|axis| u64::from(last[axis] + 1 - first[axis])).into_iter().product()
            }
            Self::Other(prepared) => prepared.visited(),
        }
    }

    fn area(&self) -> Option<PixelArea> {
        match self {
            Self::Nothing => None,
            Self::Ours(_, drawn) => Some(area(drawn)),
            Self::Other(prepared) => prepared.bounds.iter().all(|range| !range.is_empty()).then(|| PixelArea {
                first: prepared.bounds.each_ref().map(|range| range.start),
                last: prepared.bounds.each_ref().map(|range| range.end - 1),
            }),
        }
    }

    /// `ρ²` as it finds it; infinite where it does not look.
    fn squared_distance(&self, case: &Case, pixel: [u32; 2]) -> f64 {
        let visits = self.area().is_some_and(|area| area.holds(pixel));
        let squared = match self {
            Self::Nothing => f64::INFINITY,
            Self::Ours(units, drawn) => units.squared_distance(case, &drawn.footprint, pixel).value().into(),
            Self::Other(prepared) => prepared.squared_distance(pixel),
        };
        if visits { squared } else { f64::INFINITY }
    }
}

/// Compares the methods; `None` where there is nothing to draw by every method's rules, or where a screen filter hides the differences.
#[must_use]
pub fn compare(units: &Units, case: &Case, seed: u64) -> Option<[MethodOutcome; Method::ALL.len()]> {
    let truth = Truth::new(case).filter(|truth| !truth.faces_away() && !case.filter.is_on())?;
    let analysis = Analysis::new(case, units.division);
    let is_far = analysis.center_depth.is_above(1.0) != Some(false);
    if case.numbers()[2] <= case.lens.near || is_far {
        return None;
    }
    let mut random = Rng::with_seed(seed);
    let devices = Method::ALL.map(|method| match (method, units.fate(case)) {
        (Method::Ours, Fate::Drawn(drawn)) => Device::Ours(units, drawn),
        (Method::Ours, _) => Device::Nothing,
        (other, _) => Device::Other(Box::new(Prepared::new(other, case))),
    });
    let [[low_x, high_x], [low_y, high_y]] = analysis.bounds.map(|ends| ends.map(|bound| bound.value));
    let ends = [low_x, high_x, low_y, high_y];
    let about = if truth.is_whole() && ends.iter().all(|end| end.is_finite()) {
        PixelArea::about([low_x, low_y], [high_x, high_y])?
    } else {
        whole_image()
    };
    let mut pixels: Vec<_> = (0..SAMPLES).map(|_| about.pixel(&mut random)).collect();
    for area in devices.iter().filter_map(Device::area) {
        pixels.push(area.pixel(&mut random));
    }
    // The others know of no near and far plane.
    pixels.retain(|&pixel| truth.hit(pixel, RESOLVED).range != InRange::No && !truth.is_at_plane(pixel));
    let exact: Vec<_> = pixels.iter().map(|&pixel| truth.hit(pixel, RESOLVED).squared_distance).collect();
    Some(devices.map(|device| {
        let mut outcome = MethodOutcome { visited: device.visited(), ..MethodOutcome::default() };
        for (&pixel, &exact) in pixels.iter().zip(&exact) {
            let found = device.squared_distance(case, pixel);
            let is_drawn = found < 1.0;
            outcome.failed |= (exact <= 1.0 - RIM && !is_drawn) || (exact >= 1.0 + RIM && is_drawn);
            if exact < 1.0 {
                let error = (found - exact).abs();
                outcome.inside += 1;
                outcome.squared_error += if error < 1.0 { error * error } else { 1.0 };
            }
        }
        outcome
    }))
}
