//! The kernel's integral over a bin.

use super::course::Course;
use super::{Frame, unsigned};
use crate::compiler::{CompileError, Table, Value, name};
use crate::float::{erf, exp_neg};
use pointcore_contract::splat::motion::{MOTION_TABLE_BITS, SHARE_BITS};
use std::rc::Rc;

/// Bits of an argument and of a value of the tables.
const UNIT_BITS: u32 = MOTION_TABLE_BITS;
/// Bits of a sum of six kernels.
const SUM_BITS: u32 = UNIT_BITS + 3;
/// Below as many of it as there are bins a speed is that of a narrow sample.
const NARROW: f64 = 1.0 / 32.0;

/// The share of a bin between two times.
pub(super) fn share(frame: Frame, course: &Course, times: [Value; 2]) -> Result<Value, CompileError> {
    let Frame { config, program, format, .. } = frame;
    let (gamma, table) = (config.kernel_gamma, config.motion_table());
    let kernel = Table::new(table, exp_neg::samples(gamma, table)).map(Rc::new)?;
    let integral = Table::new(table, erf::integral_samples(gamma, table)).map(Rc::new)?;
    let weight = |squared: Value, fraction: u32| squared.to_fixed(unsigned(UNIT_BITS, fraction)).kernel(&kernel);
    let places = times.map(|time| course.speed * time + course.along);

    let half = weight(course.across, UNIT_BITS).to_float(format, UNIT_BITS + 1);
    let narrow = course.squared_speed.lt(frame.constant((NARROW * f64::from(config.time_bins)).powi(2)));
    let of_length = half * frame.constant(1.0 / 6.0);
    let of_integral = half * course.slowness;
    name!(half, narrow, of_length, of_integral);

    let middle = program.lit(UNIT_BITS + 1, 1 << UNIT_BITS);
    let integral_to = |place: Value| {
        let area = place.abs().to_fixed(unsigned(UNIT_BITS, UNIT_BITS)).kernel(&integral).resize(UNIT_BITS + 1);
        let negative = place.bits(format.width() - 1, format.width() - 1);
        negative.mux(middle - area, middle + area).resize(SUM_BITS)
    };
    let [begin, end] = places;
    let of_square = |place: Value| weight(place * place, UNIT_BITS).resize(SUM_BITS);
    let double = begin + end;
    let four = weight(double * double, UNIT_BITS - 2).resize(SUM_BITS) << 2;
    let simpson = of_square(begin) + four + of_square(end);
    let sum = narrow.mux(simpson, integral_to(end) - integral_to(begin));
    let factor = narrow.mux((times[1] - times[0]) * of_length, of_integral);
    let share = sum.to_float(format, UNIT_BITS) * factor;
    Ok(share.to_fixed(unsigned(SHARE_BITS, SHARE_BITS)))
}
