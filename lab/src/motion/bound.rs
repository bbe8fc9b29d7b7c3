//! What a share of the exposure may be off, as docs/units/splat/motion_evaluation.md derives it.

use pointcore_contract::Format;
use pointcore_contract::splat::motion::{MOTION_TABLE, SHARE_BITS, TIME_BINS};
use pointcore_golden::reference::motion::distance::SquaredDistance;
use pointcore_golden::reference::motion::{Interval, Met, MovingFootprint, Place, Shutter};

/// Roundings of a place on the splat, in units of half a last place of its terms.
const ROUNDINGS: f64 = 8.0;
/// What roundings behind the tables amount to.
const LATER_ROUNDINGS: f64 = 16.0;
/// A sample is well-posed where roundings of its way move no share by more than this.
const WELL_POSED: f64 = 1.0 / (1 << 17) as f64;
/// A well-posed sample's share is off by no more, in `f32`.
pub const WELL_POSED_ERROR: f64 = 1.0 / 65536.0;
/// Squared speed below which a sample is narrow.
const NARROW: f64 = 1.0 / 64.0;

/// The truth about a bin of a sample, and what may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The kernel's integral.
    pub truth: f64,
    /// The time that is covered, in units of `τ`.
    pub covered: f64,
    /// What roundings of the sample's way over the splat may move the integral by.
    pub moved: f64,
    /// What the integral may be off.
    pub bound: f64,
    /// What the covered time may be off.
    pub bound_of_time: f64,
}

/// The truth about a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shares {
    /// Of each bin.
    pub bins: [Share; TIME_BINS],
}

impl Shares {
    /// Whether the sample is well-posed.
    #[must_use]
    pub fn is_well_posed(&self) -> bool {
        self.bins.iter().all(|share| share.moved <= WELL_POSED)
    }

    /// Of a footprint whose numbers are exact.
    #[must_use]
    pub fn new(footprint: &MovingFootprint, place: &Place, format: Format, gamma: f64) -> Self {
        let sample = Sample::new(footprint, place, format, gamma);
        let mut bins = Interval::equal_parts(TIME_BINS).map(|part| sample.share(part));
        Self { bins: std::array::from_fn(|_| bins.next().expect("there are as many parts as bins")) }
    }
}

struct Sample<'a> {
    footprint: &'a MovingFootprint,
    met: Met,
    gamma: f64,
    /// Half a unit in the last place of one.
    unit: f64,
    /// Sums of magnitudes of the terms over `D`: of place and speed.
    terms: [f64; 2],
    /// The same of `D` itself.
    cancellation: f64,
    /// What either end of the time between near and far plane may be off.
    planes: [f64; 2],
}

impl<'a> Sample<'a> {
    fn new(footprint: &'a MovingFootprint, place: &Place, format: Format, gamma: f64) -> Self {
        let met = footprint.meet(place);
        let unit = 0.5_f64.powi(format.mantissa as i32 + 1);
        let [x, y] = [0, 1].map(|axis: usize| (place.position[axis] - footprint.center[axis]).abs());
        let determinant = met.determinant.abs();
        let [of_x, of_y] = footprint.determinant.map(f64::abs);
        let of_places: f64 = footprint.place.iter().map(|form| x * form[0].abs() + y * form[1].abs()).sum();
        let of_speeds: f64 =
            footprint.speed.iter().map(|form| form[0].abs() + x * form[1].abs() + y * form[2].abs()).sum();
        let [begin, end, offset] = footprint.planes;
        let cancellation = (1.0 + x * of_x + y * of_y) / determinant;
        let planes = [begin, end].map(|limit| {
            let limit = limit * determinant;
            if limit.is_finite() { 4.0 * unit * (limit.abs() * (1.0 + cancellation) + offset.abs()) } else { 0.0 }
        });
        let terms = [of_places, of_speeds].map(|sum| sum / determinant);
        Self { footprint, met, gamma, unit, terms, cancellation, planes }
    }

    /// `δ`, the largest in a part of the exposure.
    fn displacement(&self, part: Interval) -> f64 {
        let time = part.begin.abs().max(part.end.abs()) + self.footprint.time.abs();
        let length = |vector: [f64; 2]| vector[0].abs() + vector[1].abs();
        let [of_place, of_speed] = self.terms;
        let terms = of_place + of_speed * time;
        let whole = length(self.met.place) + length(self.met.speed) * time;
        let displacement = ROUNDINGS * self.unit * (terms + self.cancellation * whole + 1.0);
        if displacement.is_nan() { f64::INFINITY } else { displacement }
    }

    /// The time in a part for which the sample is nearer to the splat's centre than a radius.
    fn within(&self, radius: f64, part: Interval) -> f64 {
        let scaled = |vector: [f64; 2]| vector.map(|component| component / radius);
        let Met { place, speed, .. } = self.met;
        let met = Met { place: scaled(place), speed: scaled(speed), ..self.met };
        let inside = met.squared_distance(self.footprint.time).within_kernel(part);
        inside.map_or(0.0, Interval::length)
    }

    /// The time in a part for which the kernel may be cut or not.
    fn doubt(&self, part: Interval, displacement: f64) -> f64 {
        let Some(alive) = part.intersection(self.footprint.life) else { return 0.0 };
        if !displacement.is_finite() {
            return alive.length();
        }
        let inner = if displacement < 1.0 { self.within(1.0 - displacement, alive) } else { 0.0 };
        let of_planes: f64 = self.planes.iter().map(|error| 2.0 * error).sum();
        // In f64 both have roundings of their own.
        (self.within(1.0 + displacement, alive) - inner).max(0.0) + of_planes.min(alive.length()) + 1e-12
    }

    fn squared_distance(&self) -> SquaredDistance {
        self.met.squared_distance(self.footprint.time)
    }

    fn share(&self, part: Interval) -> Share {
        let squared_distance = self.squared_distance();
        let covered = self
            .met
            .life
            .and_then(|life| squared_distance.within_kernel(life))
            .and_then(|covered| covered.intersection(part));
        let truth = covered.map_or(0.0, |covered| squared_distance.integral(Shutter::Box, self.gamma, covered));
        let covered = covered.map_or(0.0, Interval::length);
        let displacement = self.displacement(part);
        let doubt = self.doubt(part, displacement);
        let reached = 0.5 * (covered + doubt);
        let slope = (2.0 * self.gamma / std::f64::consts::E).sqrt();
        let cut = (-self.gamma * (1.0 - displacement).max(0.0).powi(2)).exp();
        let moved = slope * displacement * reached + 0.5 * cut * doubt;
        let floor = 0.5_f64.powi(SHARE_BITS as i32);
        let later = LATER_ROUNDINGS * self.unit * reached;
        let bound = floor + self.tables(reached, part) + later + moved;
        // A share is no more than the bin.
        let bound =
            if bound.is_finite() { bound.min(0.5 * part.length() + floor) } else { 0.5 * part.length() + floor };
        Share { truth, covered, moved, bound, bound_of_time: doubt + 0.5_f64.powi(13).max(8.0 * self.unit) }
    }

    /// What interpolation in the tables, their own rounding and that of their arguments amount to.
    fn tables(&self, reached: f64, part: Interval) -> f64 {
        let square = |value: f64| value * value;
        let step = 0.25_f64.powi(MOTION_TABLE.index_bits as i32);
        let unit = 0.5_f64.powi(MOTION_TABLE.value_bits as i32);
        let argument = unit.max(self.unit);
        let of_kernel = square(self.gamma) / 8.0 * step + 2.0 * unit + self.gamma * argument;
        let squared_speed: f64 = self.met.speed.iter().map(|&component| square(component)).sum();
        // On which side of the border the computed speed is, is open.
        let difference = || {
            let of_integral = (2.0 * self.gamma / std::f64::consts::E).sqrt() / 8.0 * step + 2.0 * unit + argument;
            of_integral / squared_speed.sqrt() + of_kernel * reached
        };
        let simpson = || {
            let bend = 12.0 * square(self.gamma) * square(squared_speed * square(part.length())) / 2880.0;
            (2.0 * of_kernel + bend) * reached
        };
        if squared_speed < 0.99 * NARROW {
            simpson()
        } else if squared_speed > 1.01 * NARROW {
            difference()
        } else {
            simpson().max(difference())
        }
    }
}
