//! What a share of the exposure may be off, as docs/units/splat/motion_evaluation.md derives it.

use super::setup::Magnitudes;
use pointcore_contract::TableShape;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::motion::SHARE_BITS;
use pointcore_golden::reference::motion::distance::SquaredDistance;
use pointcore_golden::reference::motion::{Interval, Met, MovingFootprint, Place, Shutter};

/// Roundings of a place on the splat, in units of half a last place of its terms.
const ROUNDINGS: f64 = 8.0;
/// Roundings of a footprint, in units of half a last place of its terms.
const SETUP_ROUNDINGS: f64 = 16.0;
/// The same of its center.
const CENTER_ROUNDINGS: f64 = 6.0;
/// What roundings behind the tables amount to.
const LATER_ROUNDINGS: f64 = 16.0;
/// A sample is well-posed where roundings of its way move its shares by no more than this together.
const WELL_POSED: f64 = 1.0 / (1 << 17) as f64;
/// A well-posed sample's integral is off by no more, in `f32`.
pub const WELL_POSED_ERROR: f64 = 1.0 / 65536.0;
/// Speed below which a sample is narrow, in an exposure of one bin: with more bins as many times that.
const NARROW: f64 = 1.0 / 32.0;

/// The truth about a sample in a bin of the exposure, and what may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The kernel's integral over the bin.
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

impl Share {
    /// Whether the sample is well-posed.
    #[must_use]
    pub fn is_well_posed(&self) -> bool {
        self.moved <= WELL_POSED
    }

    /// Of a footprint whose numbers are exact, and that is there within a bin.
    #[must_use]
    pub fn new(footprint: &MovingFootprint, place: &Place, config: &Config, bin: Interval) -> Self {
        Sample::new(footprint, place, config).share(bin)
    }

    /// Of a splat whose numbers are exact, with the footprint that it has in f64 and its terms.
    #[must_use]
    pub fn of_splat(
        footprint: &MovingFootprint,
        magnitudes: &Magnitudes,
        place: &Place,
        config: &Config,
        bin: Interval,
    ) -> Self {
        Sample::new(footprint, place, config).set_up(magnitudes, place).share(bin)
    }
}

struct Sample<'a> {
    footprint: &'a MovingFootprint,
    met: Met,
    gamma: f64,
    /// Bins of the exposure.
    bins: usize,
    /// Of the tables.
    table: TableShape,
    /// Half a unit in the last place of one.
    unit: f64,
    /// Sums of magnitudes of the terms over `D`: of place and speed.
    terms: [f64; 2],
    /// The same of `D` itself.
    cancellation: f64,
    /// What either end of the time between near and far plane may be off.
    planes: [f64; 2],
    /// What setup's roundings move place, speed, and what both are divided by, in units of half a last place.
    of_setup: [f64; 3],
}

impl<'a> Sample<'a> {
    fn new(footprint: &'a MovingFootprint, place: &Place, config: &Config) -> Self {
        let Config { geometry: format, kernel_gamma: gamma, time_bins, .. } = *config;
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
        let (bins, table) = (time_bins as usize, config.motion_table());
        Self { footprint, met, gamma, bins, table, unit, terms, cancellation, planes, of_setup: [0.0; 3] }
    }

    /// With setup's roundings.
    fn set_up(self, magnitudes: &Magnitudes, place: &Place) -> Self {
        let Magnitudes { center, determinant, place: places, speed, change } = magnitudes;
        let offset = [0, 1].map(|i: usize| (place.position[i] - self.footprint.center[i]).abs());
        // A form's own roundings, and what the center's make of it.
        let form = |terms: &[f64], form: &[f64]| -> f64 {
            let of_axis =
                |i: usize| SETUP_ROUNDINGS * offset[i] * terms[i] + CENTER_ROUNDINGS * center[i] * form[i].abs();
            of_axis(0) + of_axis(1)
        };
        let divisor = self.met.determinant.abs();
        let footprint = self.footprint;
        let of_places: f64 = places.iter().zip(&footprint.place).map(|(terms, own)| form(terms, own)).sum();
        let of_speeds = speed.iter().zip(&footprint.speed);
        let of_speeds: f64 =
            of_speeds.map(|(terms, own)| SETUP_ROUNDINGS * terms[0] + form(&terms[1..], &own[1..])).sum();
        let of_divisor = SETUP_ROUNDINGS + form(determinant, &footprint.determinant);
        let of_setup = [of_places, of_speeds, of_divisor].map(|sum| sum / divisor);
        let [begin, end, offset] = self.footprint.planes;
        let of_change = 1.0 + change * (offset + self.footprint.time).abs();
        let planes = [begin, end].map(|limit| {
            let limit = limit * divisor;
            if !limit.is_finite() {
                return 0.0;
            }
            let terms = SETUP_ROUNDINGS * (limit.abs() + offset.abs() + 1.0) * of_change;
            self.unit * (limit.abs() * of_setup[2] + terms)
        });
        let planes = [0, 1].map(|end| self.planes[end] + planes[end]);
        Self { of_setup, planes, ..self }
    }

    /// `δ`, the largest in a part of the exposure.
    fn displacement(&self, part: Interval) -> f64 {
        let time = part.begin.abs().max(part.end.abs()) + self.footprint.time.abs();
        let length = |vector: [f64; 2]| vector[0].abs() + vector[1].abs();
        let [of_place, of_speed] = self.terms;
        let terms = of_place + of_speed * time;
        let whole = length(self.met.place) + length(self.met.speed) * time;
        let [of_place, of_speed, of_divisor] = self.of_setup;
        let of_setup = of_place + of_speed * time + of_divisor * whole;
        let displacement = self.unit * (ROUNDINGS * (terms + self.cancellation * whole + 1.0) + of_setup);
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
        let step = 0.25_f64.powi(self.table.index_bits as i32);
        let unit = 0.5_f64.powi(self.table.value_bits as i32);
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
        let narrow = square(NARROW * self.bins as f64);
        if squared_speed < 0.99 * narrow {
            simpson()
        } else if squared_speed > 1.01 * narrow {
            difference()
        } else {
            simpson().max(difference())
        }
    }
}
