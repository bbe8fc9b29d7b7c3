//! Golden setup and evaluation beside f64, case by case.

use super::bound::{Share, WELL_POSED_ERROR};
use super::depth;
use super::setup::Magnitudes;
use fastrand::Rng;
use glam::DVec3;
use pointcore::number::decode;
use pointcore::stimuli::motion::{Family, Moved, camera, encoded, motion_uniforms, moved, rendering};
use pointcore_contract::Format;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::motion::{SHARE_BITS, TIME_FRACTION_BITS};
use pointcore_contract::splat::records::{self, ImageRectangle, MovingPlace, MovingSample};
use pointcore_golden::reference::motion::{Interval, MovingFootprint, Way};
use pointcore_golden::splat::{MotionEvaluation, MotionSetup, MotionUniforms};

/// A moving splat and a sample, with the truth about it.
#[derive(Clone, Debug)]
pub struct Case {
    /// What it was made of.
    pub moved: Moved,
    /// The splat as setup takes it.
    pub splat: records::Splat,
    /// The footprint of that, in f64.
    pub footprint: MovingFootprint,
    /// Magnitudes of its terms.
    pub magnitudes: Magnitudes,
    /// The bin of the exposure in which it is there.
    bin: u32,
    last: bool,
    slot: u8,
}

/// What came of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The sample is covered for a part of the exposure.
    pub is_inside: bool,
    /// The case is well-posed.
    pub is_well_posed: bool,
    /// The error of its share.
    pub error: f64,
    /// The same in terms of its bound.
    pub of_bound: f64,
    /// What the share may be off.
    pub bound: f64,
}

/// What does not hold of a case.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Violation {
    /// A share is farther from the truth than its bound.
    #[error("share {found} beside {truth}, bound {bound}")]
    Share {
        /// What was computed.
        found: f64,
        /// The truth.
        truth: f64,
        /// What it may be off.
        bound: f64,
    },
    /// A covered time is farther from the truth than its bound.
    #[error("covered for {found} beside {truth}, bound {bound}")]
    Time {
        /// What was computed.
        found: f64,
        /// The truth.
        truth: f64,
        /// What it may be off.
        bound: f64,
    },
    /// A depth is farther from the truth than its bound.
    #[error("depth {found} at time {time}, expected {low} to {high}")]
    Depth {
        /// When.
        time: u32,
        /// What was computed.
        found: f64,
        /// The least that it may be.
        low: f64,
        /// The most.
        high: f64,
    },
    /// Times are in no order, though the sample is covered.
    #[error("times {0:?}")]
    Order([u32; 2]),
    /// A well-posed share is off by more than 2⁻¹⁶.
    #[error("well-posed, but off by {0}")]
    WellPosed(f64),
}

/// A case of a family; none where the splat is culled in f64.
#[must_use]
pub fn case(random: &mut Rng, family: Family, config: &Config) -> Option<Case> {
    let moved = moved(random, family, config);
    let splat = encoded(&moved.splat, config, random);
    let (camera, rendering) = (camera(config), rendering(config));
    let way = way(&splat, config);
    let footprint = MovingFootprint::along(&way, &camera, &rendering).ok()?;
    let magnitudes = Magnitudes::of(&way, &footprint, &camera);
    let (last, slot) = (random.u8(0..8) == 0, random.u8(0..config.tile_slots as u8));
    let middle = 0.5 * (moved.splat.part.middle() + 1.0);
    let bin = (middle * f64::from(config.time_bins)) as u32;
    Some(Case { moved, splat, footprint, magnitudes, bin, last, slot })
}

/// A record's numbers.
fn way(splat: &records::Splat, config: &Config) -> Way {
    let value = |bits: u32| f64::from(decode(config.geometry, bits));
    let vector = |bits: [u32; 3]| DVec3::from_array(bits.map(value));
    let [begin, end] = splat.motion.part.map(value);
    Way {
        center: vector(splat.center),
        motion: vector(splat.motion.way),
        tangents: splat.tangents.map(vector),
        part: Interval { begin, end },
    }
}

impl Case {
    /// The sample as evaluation takes it, with a splat's footprint.
    #[must_use]
    pub fn place(&self, footprint: records::MovingFootprint) -> MovingPlace {
        let (column, row) = (self.moved.place.column as u16, self.moved.place.row as u16);
        MovingPlace { last: self.last, slot: self.slot, column, row, odd_bin: self.bin % 2 == 1, footprint }
    }
}

/// Begin and end of the time for which a sample is covered in a bin of the exposure, in the exposure's own fraction; of one that is not they mean
/// nothing.
fn times(sample: &MovingSample, bin: u32, config: &Config) -> [u32; 2] {
    let [early, late] = sample.time;
    let border = |bin: u32| bin << (TIME_FRACTION_BITS - config.bin_bits());
    [border(bin + 1).wrapping_sub(early), border(bin) + late]
}

/// Both units, and what they are given.
pub struct Units {
    config: Config,
    uniforms: MotionUniforms,
    setup: MotionSetup,
    evaluation: MotionEvaluation,
}

impl Units {
    /// Of a configuration.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let (setup, evaluation) = (MotionSetup::new(config, 1), MotionEvaluation::new(config, 1));
        Self { config: config.clone(), uniforms: motion_uniforms(config), setup, evaluation }
    }

    /// What evaluation makes of a footprint in f64 that is rounded, beside the truth about what it is then.
    ///
    /// # Errors
    /// What does not hold.
    pub fn evaluate(&self, case: &Case) -> Result<Outcome, Violation> {
        let geometry = self.config.geometry;
        let record = case.footprint.encoded(geometry);
        let footprint = MovingFootprint::decoded(&record, geometry, case.footprint.bounds.clone());
        let sample = self.evaluation.evaluate(&case.place(record), self.uniforms.viewport.depth_a);
        self.depths(&sample, &footprint, case)?;
        self.compare(&sample, case, &Share::new(&footprint, &case.moved.place, &self.config, self.bin(case)))
    }

    /// The bin of a case.
    fn bin(&self, case: &Case) -> Interval {
        let border = |bin: u32| 2.0 * f64::from(bin) / f64::from(self.config.time_bins) - 1.0;
        Interval { begin: border(case.bin), end: border(case.bin + 1) }
    }

    /// Holds the depths of a sample against those of a footprint.
    fn depths(&self, sample: &MovingSample, footprint: &MovingFootprint, case: &Case) -> Result<(), Violation> {
        let format = self.config.geometry;
        let depth_a = f64::from(decode(format, self.uniforms.viewport.depth_a));
        let times = times(sample, case.bin, &self.config);
        for (time, depth) in times.into_iter().zip(sample.depth).filter(|_| sample.inside) {
            let found = f64::from(depth) / f64::from(1 << DEPTH_BITS);
            let numbers = [depth_a, depth::unit(format)];
            let range = depth::range(footprint, &case.moved.place, time, numbers, self.config.depth);
            if !range.contains(&found) {
                return Err(Violation::Depth { time, found, low: *range.start(), high: *range.end() });
            }
        }
        Ok(())
    }

    /// What setup and evaluation make of a splat, beside the truth about it.
    ///
    /// # Errors
    /// What does not hold.
    pub fn draw(&self, case: &Case) -> Result<Outcome, Violation> {
        let Case { footprint, magnitudes, moved, .. } = case;
        let truth = Share::of_splat(footprint, magnitudes, &moved.place, &self.config, self.bin(case));
        self.compare(&self.drawn(case), case, &truth)
    }

    /// The sample as evaluation takes it behind setup, or of a splat that setup drops, with the footprint in f64.
    #[must_use]
    pub fn place(&self, case: &Case) -> MovingPlace {
        let splat = self.setup.setup(&case.splat, &self.uniforms);
        case.place(splat.map_or_else(|| case.footprint.encoded(self.config.geometry), |splat| splat.moving.footprint))
    }

    /// The sample as both units have it; not covered where the splat is dropped, or has bounds without it.
    #[must_use]
    pub fn drawn(&self, case: &Case) -> MovingSample {
        let Some(splat) = self.setup.setup(&case.splat, &self.uniforms) else { return MovingSample::default() };
        let place = case.place(splat.moving.footprint);
        let ImageRectangle { left, right, top, bottom } = splat.bounds;
        if !((left..=right).contains(&place.column) && (top..=bottom).contains(&place.row)) {
            return MovingSample::default();
        }
        self.evaluation.evaluate(&place, self.uniforms.viewport.depth_a)
    }

    fn compare(&self, sample: &MovingSample, case: &Case, truth: &Share) -> Result<Outcome, Violation> {
        let [begin, end] = times(sample, case.bin, &self.config);
        if sample.inside && begin > end {
            return Err(Violation::Order([begin, end]));
        }
        let of_inside = |value: f64| if sample.inside { value } else { 0.0 };
        let found = of_inside(f64::from(sample.share) / f64::from(1 << SHARE_BITS));
        let covered = of_inside(2.0 * (f64::from(end) - f64::from(begin)) / f64::from(1 << TIME_FRACTION_BITS));
        let Share { truth: share, bound, .. } = *truth;
        let error = (found - share).abs();
        if error.is_nan() || error > bound {
            return Err(Violation::Share { found, truth: share, bound });
        }
        if (covered - truth.covered).abs() > truth.bound_of_time {
            return Err(Violation::Time { found: covered, truth: truth.covered, bound: truth.bound_of_time });
        }
        let (is_inside, is_well_posed) = (sample.inside, truth.is_well_posed());
        let is_fine = self.config.geometry.mantissa == Format::F32.mantissa;
        if is_well_posed && is_fine && error > WELL_POSED_ERROR {
            return Err(Violation::WellPosed(error));
        }
        Ok(Outcome { is_inside, is_well_posed, error, of_bound: error / bound, bound })
    }
}
