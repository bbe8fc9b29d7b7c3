//! The kernel's integral over each bin.

use super::course::Course;
use super::{Frame, unsigned};
use crate::compiler::{CompileError, Table, Value, name};
use crate::float::{erf, exp_neg};
use pointcore_contract::splat::motion::{MOTION_TABLE, SHARE_BITS};
use std::rc::Rc;

/// Bits of an argument and of a value of the tables.
const UNIT_BITS: u32 = MOTION_TABLE.value_bits;
/// Bits of a sum of six kernels.
const SUM_BITS: u32 = UNIT_BITS + 3;
/// Below as many of it as there are bins a speed is that of a narrow sample.
const NARROW: f64 = 1.0 / 32.0;

/// The share of each bin between those times.
pub(super) fn shares(frame: Frame, course: &Course, times: &[Value]) -> Result<Vec<Value>, CompileError> {
    let Frame { config, program, format, .. } = frame;
    let gamma = config.kernel_gamma;
    let kernel = Table::new(MOTION_TABLE, exp_neg::samples(gamma, MOTION_TABLE)).map(Rc::new)?;
    let integral = Table::new(MOTION_TABLE, erf::integral_samples(gamma, MOTION_TABLE)).map(Rc::new)?;
    let weight = |squared: Value, fraction: u32| squared.to_fixed(unsigned(UNIT_BITS, fraction)).kernel(&kernel);
    let places: Vec<_> = times.iter().map(|&time| course.speed * time + course.along).collect();

    let half = weight(course.across, UNIT_BITS).to_float(format, UNIT_BITS + 1);
    let narrow = course.squared_speed.lt(frame.constant((NARROW * f64::from(config.time_bins)).powi(2)));
    let of_length = half * frame.constant(1.0 / 6.0);
    let of_integral = half * course.slowness;
    name!(half, narrow, of_length, of_integral);

    let middle = program.lit(UNIT_BITS + 1, 1 << UNIT_BITS);
    let integral_to = |&place: &Value| {
        let area = place.abs().to_fixed(unsigned(UNIT_BITS, UNIT_BITS)).kernel(&integral).resize(UNIT_BITS + 1);
        let negative = place.bits(format.width() - 1, format.width() - 1);
        negative.mux(middle - area, middle + area).resize(SUM_BITS)
    };
    let integrals: Vec<_> = places.iter().map(integral_to).collect();
    let ends: Vec<_> = places.iter().map(|&place| weight(place * place, UNIT_BITS).resize(SUM_BITS)).collect();
    let share = |bin: usize| {
        let double = places[bin] + places[bin + 1];
        let four = weight(double * double, UNIT_BITS - 2).resize(SUM_BITS) << 2;
        let simpson = ends[bin] + four + ends[bin + 1];
        let sum = narrow.mux(simpson, integrals[bin + 1] - integrals[bin]);
        let factor = narrow.mux((times[bin + 1] - times[bin]) * of_length, of_integral);
        let share = sum.to_float(format, UNIT_BITS) * factor;
        share.to_fixed(unsigned(SHARE_BITS, SHARE_BITS))
    };
    Ok((0..config.time_bins as usize).map(share).collect())
}
