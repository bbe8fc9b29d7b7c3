//! A bin's share: the kernel along a line, integrated. Fast samples take a difference of the integral's table, slow ones Simpson's rule.

use super::course::Course;
use crate::float::{Table, kernel_integral_table, kernel_table};
use crate::number::Number;
use pointcore_contract::splat::motion::{MOTION_TABLE, SHARE_BITS, TIME_BINS, TIMES};
use std::sync::Arc;

/// Bits of an argument and of a value of the tables.
const UNIT_BITS: u32 = MOTION_TABLE.value_bits;
/// Bits of a sum of six kernels.
const SUM_BITS: u32 = UNIT_BITS + 3;
/// A squared speed below this power of ½ is that of a narrow sample.
const NARROW: i64 = 6;

/// `exp(−γt)` and `∫₀ᵗ exp(−γy²) dy`.
#[derive(Clone, Debug)]
pub(super) struct Kernel {
    weight: Arc<Table>,
    integral: Arc<Table>,
}

impl Kernel {
    pub fn new(gamma: f64) -> Self {
        let weight = Arc::new(kernel_table(gamma, MOTION_TABLE));
        Self { weight, integral: Arc::new(kernel_integral_table(gamma, MOTION_TABLE)) }
    }

    /// The share of each bin between those times.
    pub fn shares(&self, course: &Course, times: [Number; TIMES]) -> [u32; TIME_BINS] {
        let one = course.speed.of(1.0);
        let places = times.map(|time| course.speed * time + course.along);
        let weight = self.weight.interpolate(course.across.to_fixed(UNIT_BITS, UNIT_BITS));
        let half = Number::from_fixed(one.format(), weight, u64::BITS, UNIT_BITS + 1);
        let is_narrow = course.squared_speed.is_below(one.raised(-NARROW));
        let of_length = half * one.of(1.0 / 6.0);
        std::array::from_fn(|bin| {
            let ends = [places[bin], places[bin + 1]];
            let (sum, factor) = if is_narrow {
                (self.simpson(ends), (times[bin + 1] - times[bin]) * of_length)
            } else {
                (self.difference(ends), half * course.slowness)
            };
            let share = Number::from_fixed(one.format(), sum, SUM_BITS, UNIT_BITS) * factor;
            share.to_fixed(SHARE_BITS, SHARE_BITS) as u32
        })
    }

    /// Six times the mean of the kernel between two places on a line.
    fn simpson(&self, [from, to]: [Number; 2]) -> u64 {
        let [first, last] = [from, to].map(|place| (place * place).to_fixed(UNIT_BITS, UNIT_BITS));
        let double = from + to;
        let middle = (double * double).to_fixed(UNIT_BITS, UNIT_BITS - 2);
        let weight = |squared: u64| self.weight.interpolate(squared);
        weight(first) + 4 * weight(middle) + weight(last)
    }

    /// The integral of the kernel between two places on a line; modulo `2^SUM_BITS`, where they are in no order outside the splat.
    fn difference(&self, ends: [Number; 2]) -> u64 {
        let [from, to] = ends.map(|place| {
            let integral = self.integral.interpolate(place.abs().to_fixed(UNIT_BITS, UNIT_BITS));
            let middle = 1 << UNIT_BITS;
            if place.is_negative() { middle - integral } else { middle + integral }
        });
        to.wrapping_sub(from) & ((1 << SUM_BITS) - 1)
    }
}
