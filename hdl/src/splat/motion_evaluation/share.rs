//! The kernel's integral over each bin.

use super::course::Course;
use super::{Frame, unsigned};
use crate::compiler::{CompileError, Table, Value, name};
use crate::float::{erf, exp_neg};
use pointcore_contract::splat::motion::{MOTION_TABLE, SHARE_BITS, TIME_BINS, TIMES};
use std::rc::Rc;

/// Bits of an argument and of a value of the tables.
const UNIT_BITS: u32 = MOTION_TABLE.value_bits;
/// Bits of a sum of six kernels.
const SUM_BITS: u32 = UNIT_BITS + 3;
/// Below it a squared speed is that of a narrow sample.
const NARROW: f64 = 1.0 / 64.0;

/// The share of each bin between those times.
pub(super) fn shares(frame: Frame, course: &Course, times: [Value; TIMES]) -> Result<[Value; TIME_BINS], CompileError> {
    let Frame { config, program, format, .. } = frame;
    let gamma = config.kernel_gamma;
    let kernel = Table::new(MOTION_TABLE, exp_neg::samples(gamma, MOTION_TABLE)).map(Rc::new)?;
    let integral = Table::new(MOTION_TABLE, erf::integral_samples(gamma, MOTION_TABLE)).map(Rc::new)?;
    let weight = |squared: Value, fraction: u32| squared.to_fixed(unsigned(UNIT_BITS, fraction)).kernel(&kernel);
    let places = times.map(|time| course.speed * time + course.along);

    let half = weight(course.across, UNIT_BITS).to_float(format, UNIT_BITS + 1);
    let narrow = course.squared_speed.lt(frame.constant(NARROW));
    let of_length = half * frame.constant(1.0 / 6.0);
    let of_integral = half * course.slowness;
    name!(half, narrow, of_length, of_integral);

    let middle = program.lit(UNIT_BITS + 1, 1 << UNIT_BITS);
    let integrals = places.map(|place| {
        let area = place.abs().to_fixed(unsigned(UNIT_BITS, UNIT_BITS)).kernel(&integral).resize(UNIT_BITS + 1);
        let negative = place.bits(format.width() - 1, format.width() - 1);
        negative.mux(middle - area, middle + area).resize(SUM_BITS)
    });
    let ends = places.map(|place| weight(place * place, UNIT_BITS).resize(SUM_BITS));
    Ok(std::array::from_fn(|bin| {
        let double = places[bin] + places[bin + 1];
        let four = weight(double * double, UNIT_BITS - 2).resize(SUM_BITS) << 2;
        let simpson = ends[bin] + four + ends[bin + 1];
        let sum = narrow.mux(simpson, integrals[bin + 1] - integrals[bin]);
        let factor = narrow.mux((times[bin + 1] - times[bin]) * of_length, of_integral);
        let share = sum.to_float(format, UNIT_BITS) * factor;
        share.to_fixed(unsigned(SHARE_BITS, SHARE_BITS))
    }))
}
