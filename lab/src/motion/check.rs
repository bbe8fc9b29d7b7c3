//! Golden evaluation beside f64, case by case.

use super::bound::{Shares, WELL_POSED_ERROR};
use fastrand::Rng;
use pointcore::stimuli::motion::{Family, Moved, camera, moved, rendering};
use pointcore_contract::Format;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::motion::{SHARE_BITS, TIME_BINS, TIME_FRACTION_BITS, TIMES};
use pointcore_contract::splat::records::{MovingPlace, MovingSample};
use pointcore_golden::reference::motion::MovingFootprint;
use pointcore_golden::splat::MotionEvaluation;

/// A sample as the unit takes it, with the footprint that its numbers stand for.
#[derive(Clone, Debug)]
pub struct Case {
    /// What it was made of.
    pub moved: Moved,
    /// What the unit takes.
    pub place: MovingPlace,
    /// The same numbers in f64.
    pub footprint: MovingFootprint,
}

/// What came of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The sample is covered for a part of the exposure.
    pub is_inside: bool,
    /// The case is well-posed.
    pub is_well_posed: bool,
    /// The largest error of a share.
    pub error: f64,
    /// The largest error of a share in terms of its bound.
    pub of_bound: f64,
}

/// What does not hold of a case.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Violation {
    /// A share is farther from the truth than its bound.
    #[error("bin {bin}: share {found} beside {truth}, bound {bound}")]
    Share {
        /// The bin.
        bin: usize,
        /// What was computed.
        found: f64,
        /// The truth.
        truth: f64,
        /// What it may be off.
        bound: f64,
    },
    /// A covered time is farther from the truth than its bound.
    #[error("bin {bin}: covered for {found} beside {truth}, bound {bound}")]
    Time {
        /// The bin.
        bin: usize,
        /// What was computed.
        found: f64,
        /// The truth.
        truth: f64,
        /// What it may be off.
        bound: f64,
    },
    /// Times are in no order, though the sample is covered.
    #[error("times {0:?}")]
    Order([u32; TIMES]),
    /// A well-posed share is off by more than 2⁻¹⁶.
    #[error("well-posed, but off by {0}")]
    WellPosed(f64),
}

/// A case of a family; none where the splat is culled.
#[must_use]
pub fn case(random: &mut Rng, family: Family, config: &Config) -> Option<Case> {
    let moved = moved(random, family, config);
    let exact = MovingFootprint::new(&moved.splat, &camera(config), &rendering(config)).ok()?;
    let record = exact.encoded(config.geometry);
    let place = MovingPlace {
        last: random.u8(0..8) == 0,
        slot: random.u8(0..config.tile_slots as u8),
        column: moved.place.column as u16,
        row: moved.place.row as u16,
        footprint: record,
    };
    let footprint = MovingFootprint::decoded(&record, config.geometry, exact.bounds);
    Some(Case { moved, place, footprint })
}

/// The uniform `depth_a` of the cases' camera.
#[must_use]
pub fn depth_a(config: &Config) -> u32 {
    pointcore::number::encode(config.geometry, camera(config).depth_a as f32)
}

/// Evaluates a case, and holds it against f64.
///
/// # Errors
/// What does not hold.
pub fn check(unit: &MotionEvaluation, case: &Case, config: &Config) -> Result<Outcome, Violation> {
    let sample = unit.evaluate(&case.place, depth_a(config));
    let truth = Shares::new(&case.footprint, &case.moved.place, config.geometry, config.kernel_gamma);
    let outcome = compare(&sample, &truth)?;
    if outcome.is_well_posed && config.geometry.mantissa == Format::F32.mantissa && outcome.error > WELL_POSED_ERROR {
        return Err(Violation::WellPosed(outcome.error));
    }
    Ok(outcome)
}

fn compare(sample: &MovingSample, truth: &Shares) -> Result<Outcome, Violation> {
    if sample.inside && !sample.time.is_sorted() {
        return Err(Violation::Order(sample.time));
    }
    let of_inside = |value: f64| if sample.inside { value } else { 0.0 };
    let (mut error, mut of_bound) = (0.0_f64, 0.0_f64);
    for bin in 0..TIME_BINS {
        let share = truth.bins[bin];
        let found = of_inside(f64::from(sample.share[bin]) / f64::from(1 << SHARE_BITS));
        let time = |index: usize| 2.0 * f64::from(sample.time[index]) / f64::from(1 << TIME_FRACTION_BITS);
        let covered = of_inside(time(bin + 1) - time(bin));
        let off = (found - share.truth).abs();
        if off.is_nan() || off > share.bound {
            return Err(Violation::Share { bin, found, truth: share.truth, bound: share.bound });
        }
        if (covered - share.covered).abs() > share.bound_of_time {
            let (truth, bound) = (share.covered, share.bound_of_time);
            return Err(Violation::Time { bin, found: covered, truth, bound });
        }
        error = error.max(off);
        of_bound = of_bound.max(off / share.bound);
    }
    Ok(Outcome { is_inside: sample.inside, is_well_posed: truth.is_well_posed(), error, of_bound })
}
