//! What must hold of every case, and whether it does.

use super::analysis::Analysis;
use super::case::{Case, IMAGE_EDGE_PX};
use super::hardware::{Fate, Units};
use super::hit::InRange;
use super::rounding::Bounded;
use super::search::{InsideSearch, PixelArea, ROUGHLY, area};
use super::truth::{Side, Truth};
use fastrand::Rng;
use pointcore_contract::Format;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::SetupSplat;
use pointcore_golden::number::Number;
use pointcore_golden::splat::Dropped;
use serde::Serialize;

/// Samples looked at in a case.
const SAMPLES: usize = 6;
/// Bounds may be off by this without losing a sample: the margin of setup's rounding.
const MARGIN_PX: f64 = 1.0 / 256.0;
/// How far inside (or outside) a sample lies, in `ρ²`, that is more than a matter of the rim.
pub const RIM: f64 = 1.0 / 8.0;
/// Rounding of the f64 arithmetic around a bound.
const SLACK: f64 = 1.0 + 1.0 / 1024.0;
/// Units in the last place by which the kernel's table may be off.
const KERNEL_UNITS: f64 = 2.0;
/// The kernel's `γ` in every case.
const KERNEL_GAMMA: f64 = 2.0;

/// What must hold. Docs/stability.md says why, and which are known not to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Property {
    /// A computed `ρ²` lies within the bound of its error.
    Distance,
    /// A splat's depth does.
    Depth,
    /// A sample's weight does.
    Weight,
    /// Bounds whose error is within setup's margin hold every sample of the splat.
    Bounds,
    /// So do those whose error may exceed it, but for samples at the rim.
    Rim,
    /// No sample well inside the splat is left out of its bounds, or dropped with it.
    Lost,
    /// Nothing is drawn well outside the splat.
    Stray,
    /// A splat with a number that is none draws nothing but its filter's disc.
    Malformed,
    /// The reconstruction buffer holds numbers only.
    Finite,
    /// No splat with a visible sample is dropped as one before the near plane.
    Near,
    /// … as one behind the far plane.
    Far,
    /// … since rounding took it for one that faces away.
    Facing,
}

impl Property {
    /// All of them.
    pub const ALL: [Self; 12] = [
        Self::Distance,
        Self::Depth,
        Self::Weight,
        Self::Bounds,
        Self::Rim,
        Self::Lost,
        Self::Stray,
        Self::Malformed,
        Self::Finite,
        Self::Near,
        Self::Far,
        Self::Facing,
    ];

    /// Its name in keys and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Depth => "depth",
            Self::Weight => "weight",
            Self::Bounds => "bounds",
            Self::Rim => "rim",
            Self::Lost => "lost",
            Self::Stray => "stray",
            Self::Malformed => "malformed",
            Self::Finite => "finite",
            Self::Near => "near",
            Self::Far => "far",
            Self::Facing => "facing",
        }
    }

    /// Whether docs/stability.md proves it, so that one violation is a fault of the proof or of the arithmetic.
    #[must_use]
    pub fn is_proved(self) -> bool {
        matches!(self, Self::Distance | Self::Depth | Self::Weight | Self::Bounds | Self::Finite)
    }
}

/// A property that does not hold.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BrokenProperty {
    /// Which.
    pub property: Property,
    /// Where, if it is about a sample.
    pub pixel: Option<[u32; 2]>,
    /// What is there.
    pub found: String,
    /// How bad, in the property's own measure; more is worse.
    pub excess: f64,
}

/// What checking a case brought.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// What does not hold, at most one of each property.
    pub violations: Vec<BrokenProperty>,
    /// Samples looked at.
    pub samples: u32,
    /// Samples about which rounding leaves nothing to say.
    pub undetermined: u32,
    /// The largest error of a `ρ²` as a share of its bound.
    pub used: f64,
}

impl Findings {
    fn violate(&mut self, property: Property, pixel: Option<[u32; 2]>, excess: f64, found: String) {
        let violation = BrokenProperty { property, pixel, found, excess };
        match self.violations.iter_mut().find(|known| known.property == property) {
            Some(known) if known.excess >= excess => {}
            Some(known) => *known = violation,
            None => self.violations.push(violation),
        }
    }

    /// The violation of a property.
    #[must_use]
    pub fn of(&self, property: Property) -> Option<&BrokenProperty> {
        self.violations.iter().find(|violation| violation.property == property)
    }
}

/// Checks every property; `seed` chooses samples.
#[must_use]
pub fn check(units: &Units, case: &Case, seed: u64) -> Findings {
    let mut findings = Findings::default();
    let mut random = Rng::with_seed(seed);
    let fate = units.fate(case);
    if let Fate::Drawn(drawn) = &fate {
        finite(units, drawn, &mut findings);
    }
    let Some(truth) = Truth::new(case) else {
        if let Fate::Drawn(drawn) = &fate {
            malformed(units, case, drawn, &mut random, &mut findings);
        }
        return findings;
    };
    let analysis = Analysis::new(case, units.division);
    match &fate {
        Fate::Dropped(dropped) => nothing_drawn(*dropped, &truth, &analysis, &mut random, &mut findings),
        Fate::Drawn(drawn) => {
            depth(&truth, &analysis, drawn, &mut findings);
            contained(case, &truth, &analysis, drawn, &mut random, &mut findings);
            samples(units, case, &truth, &analysis, drawn, &mut random, &mut findings);
        }
    }
    findings
}

/// Two samples of full weight on one pixel.
fn finite(units: &Units, drawn: &SetupSplat, findings: &mut Findings) {
    for samples in [1, 2] {
        let pixel = units.accumulated(drawn, u16::MAX, samples);
        let values = pixel.attributes[..6].iter().map(|&bits| Number::new(Format::F16, bits as u32).value());
        if let Some((index, value)) = values.enumerate().find(|(_, value)| !value.is_finite()) {
            let given = Number::new(Format::F16, drawn.attributes[index]).value();
            let found = format!("{samples} samples of attribute {index} = {given:e} sum to {value}");
            return findings.violate(Property::Finite, None, 2.0 - f64::from(samples), found);
        }
    }
}

fn malformed(units: &Units, case: &Case, drawn: &SetupSplat, random: &mut Rng, findings: &mut Findings) {
    let center = drawn.footprint.center.map(|bits| f64::from(Number::new(case.format, bits).value()));
    for _ in 0..SAMPLES {
        let pixel = area(drawn).pixel(random);
        findings.samples += 1;
        let away = [0, 1].map(|axis| f64::from(pixel[axis]) + 0.5 - center[axis]);
        let in_disc = case.filter.is_on() && away[0].hypot(away[1]) < 1.0 + RIM;
        let squared = units.squared_distance(case, &drawn.footprint, pixel);
        if let Some(weight) = units.weight(squared).filter(|_| !in_disc) {
            let found = format!("weight {weight} at ρ² = {}", squared.value());
            findings.violate(Property::Malformed, Some(pixel), f64::from(weight), found);
        }
    }
}

/// A splat that draws nothing should have no sample between near and far plane.
fn nothing_drawn(dropped: Dropped, truth: &Truth, analysis: &Analysis, random: &mut Rng, findings: &mut Findings) {
    // Who faces away may be dropped for any reason.
    if matches!(dropped, Dropped::Facing | Dropped::Near) && truth.faces_away() {
        return;
    }
    let search = InsideSearch { truth, analysis, bounds: None, is_closed: false };
    // A filter's disc counts where its splat's plane is seen.
    let seen = search.samples(random).filter(|(pixel, _)| truth.hit(*pixel, ROUGHLY).range == InRange::Yes);
    if let Some((pixel, squared)) = seen.min_by(|a, b| a.1.total_cmp(&b.1)) {
        let property = match dropped {
            Dropped::Near => Property::Near,
            Dropped::Far => Property::Far,
            Dropped::Facing => Property::Facing,
            // One at the rim of bounds that came out empty is no more than that.
            Dropped::Beside if squared > 1.0 - RIM => Property::Rim,
            Dropped::Beside => Property::Lost,
        };
        let found = format!("nothing is drawn, but ρ² = {squared:.6} at distance {:e}", truth.distance(pixel));
        findings.violate(property, Some(pixel), 1.0 - squared, found);
    }
}

fn depth(truth: &Truth, analysis: &Analysis, drawn: &SetupSplat, findings: &mut Findings) {
    let unit = 0.5_f64.powi(DEPTH_BITS as i32);
    let depth = f64::from(drawn.footprint.band.depth) * unit;
    if !analysis.is_centered {
        // Of what has its centre before the near plane, that plane's.
        if depth != 0.0 {
            findings.violate(Property::Depth, None, depth, format!("depth {depth}, not the near plane's"));
        }
        return;
    }
    let depths = truth.depths();
    let is_beyond_near = analysis.near_depth.is_above(0.0);
    let excess = |exact: f64, bounded: &Bounded| {
        let error = (depth - exact.clamp(0.0, 1.0 - unit)).abs();
        if bounded.error.is_finite() && exact.is_finite() { error - bounded.error * SLACK - unit } else { 0.0 }
    };
    let center = excess(depths.center, &analysis.center_depth);
    let middle = excess(depths.middle, &analysis.middle_depth);
    let excess = match (analysis.is_whole, is_beyond_near) {
        (Some(true), Some(true)) => middle,
        (Some(false), _) | (Some(true), Some(false)) => center,
        _ => center.min(middle),
    };
    if excess > 0.0 {
        let found = format!("depth {depth}, not {} (centre) or {} (middle)", depths.center, depths.middle);
        findings.violate(Property::Depth, None, excess, found);
    }
}

/// Whether the bounds hold every sample of the splat.
fn contained(
    case: &Case,
    truth: &Truth,
    analysis: &Analysis,
    drawn: &SetupSplat,
    random: &mut Rng,
    findings: &mut Findings,
) {
    let PixelArea { first, last } = area(drawn);
    let diagonals = drawn.diagonals;
    let is_open = |axis: usize| {
        (first[axis] > 0 && truth.reaches(axis, first[axis] - 1, Side::Below))
            || (last[axis] + 1 < IMAGE_EDGE_PX && truth.reaches(axis, last[axis] + 1, Side::Above))
    };
    let is_closed = truth.is_whole() && !is_open(0) && !is_open(1);
    let search = InsideSearch { truth, analysis, bounds: Some(drawn), is_closed };
    let Some((pixel, squared)) = search.samples(random).min_by(|a, b| a.1.total_cmp(&b.1)) else { return };
    let error = analysis.bounds.iter().flatten().map(|bound| bound.error).fold(0.0, f64::max);
    let found =
        format!("ρ² = {squared:.6} outside the bounds {first:?} to {last:?}, {diagonals:?}, known to {error:e} px");

    let is_known = match analysis.is_whole {
        Some(true) => error * SLACK <= MARGIN_PX,
        // The box is known to far less than that, but not the disc.
        Some(false) => !case.filter.is_on(),
        None => false,
    };
    let property = if is_known {
        Property::Bounds
    } else if squared > 1.0 - RIM {
        Property::Rim
    } else {
        Property::Lost
    };
    findings.violate(property, Some(pixel), 1.0 - squared, found);
}

fn samples(
    units: &Units,
    case: &Case,
    truth: &Truth,
    analysis: &Analysis,
    drawn: &SetupSplat,
    random: &mut Rng,
    findings: &mut Findings,
) {
    for _ in 0..SAMPLES {
        let pixel = area(drawn).pixel(random);
        findings.samples += 1;
        let squared = units.squared_distance(case, &drawn.footprint, pixel);
        let computed = f64::from(squared.value());
        let weight = units.weight(squared);
        let bounded = analysis.squared_distance(pixel);
        let tolerance = if bounded.error.is_finite() { bounded.error * (SLACK - 1.0) / 2.0 } else { ROUGHLY };
        let hit = truth.hit(pixel, tolerance.min(ROUGHLY));
        let exact = hit.squared_distance;
        // Beyond near and far plane a distance is asked for only of splats that reach there.
        let is_beside = hit.range == InRange::No && weight.is_none();
        // Nor is the disc of a centre that is no origin.
        let has_other_origin = analysis.turned && exact >= 1.0 && weight.is_none();
        if is_beside || has_other_origin {
            continue;
        }
        if bounded.error.is_finite() {
            sample(pixel, exact, computed, weight, bounded, findings);
        } else {
            findings.undetermined += 1;
        }
        if truth.is_at_plane(pixel) {
            continue;
        }
        if exact <= 1.0 - RIM && weight.is_none() {
            let found = format!("ρ² = {exact:.6}, but computed as {computed:e}");
            findings.violate(Property::Lost, Some(pixel), 1.0 - exact, found);
        }
        if exact >= 1.0 + RIM && weight.is_some() {
            let found = format!("ρ² = {exact:e}, but computed as {computed:.6}");
            findings.violate(Property::Stray, Some(pixel), exact - 1.0, found);
        }
    }
}

/// A sample whose error has a bound.
fn sample(pixel: [u32; 2], exact: f64, computed: f64, weight: Option<u16>, bounded: Bounded, findings: &mut Findings) {
    let bound = bounded.error * SLACK;
    let error = if computed == exact { 0.0 } else { (computed - exact).abs() };
    findings.used = findings.used.max(if error > 0.0 { error / bound } else { 0.0 });
    if error.is_nan() || error > bound {
        let found = format!("computed as {computed:e}, is {exact:e}, bound {bound:e}");
        findings.violate(Property::Distance, Some(pixel), error / bound, found);
    }
    if let (Some(weight), true) = (weight, exact < 1.0) {
        let units = f64::from(u16::MAX);
        // The table's index is ρ² truncated to 16 bits.
        let allowed = KERNEL_GAMMA * (bound * units + 1.0) + KERNEL_UNITS;
        let error = (f64::from(weight) - units * (-KERNEL_GAMMA * exact).exp()).abs();
        if error > allowed {
            let found = format!("weight {weight} at ρ² = {exact}: off by {error:.2}, allowed {allowed:.2}");
            findings.violate(Property::Weight, Some(pixel), error / allowed, found);
        }
    }
}
