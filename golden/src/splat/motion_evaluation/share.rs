//! A bin's share: the kernel along a line, integrated. Fast samples take a difference of the integral's table, slow ones Simpson's rule.

use super::course::Course;
use crate::float::{Table, kernel_integral_table, kernel_table};
use crate::number::Number;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::motion::{MOTION_TABLE_BITS, SHARE_BITS};
use std::sync::Arc;

/// Bits of an argument and of a value of the tables.
const UNIT_BITS: u32 = MOTION_TABLE_BITS;
/// Bits of a sum of six kernels.
const SUM_BITS: u32 = UNIT_BITS + 3;
/// A speed below this power of ½, times the number of bins, is that of a narrow sample: of a bin it passes 1/16 of a radius at most.
const NARROW: i64 = 5;

/// `exp(−γt)` and `∫₀ᵗ exp(−γy²) dy`.
#[derive(Clone, Debug)]
pub(super) struct Kernel {
    weight: Arc<Table>,
    integral: Arc<Table>,
    /// A squared speed below this power of ½ is that of a narrow sample.
    narrow: i64,
}

impl Kernel {
    pub fn new(config: &Config) -> Self {
        let (gamma, table) = (config.kernel_gamma, config.motion_table());
        let weight = Arc::new(kernel_table(gamma, table));
        let narrow = 2 * (NARROW - i64::from(config.bin_bits()));
        Self { weight, integral: Arc::new(kernel_integral_table(gamma, table)), narrow }
    }

    /// The share of a bin between two times.
    pub fn share(&self, course: &Course, times: [Number; 2]) -> u32 {
        let one = course.speed.of(1.0);
        let ends = times.map(|time| course.speed * time + course.along);
        let weight = self.weight.interpolate(course.across.to_fixed(UNIT_BITS, UNIT_BITS));
        let half = Number::from_fixed(one.format(), weight, u64::BITS, UNIT_BITS + 1);
        let (sum, factor) = if course.squared_speed.is_below(one.raised(-self.narrow)) {
            (self.simpson(ends), (times[1] - times[0]) * (half * one.of(1.0 / 6.0)))
        } else {
            (self.difference(ends), half * course.slowness)
        };
        let share = Number::from_fixed(one.format(), sum, SUM_BITS, UNIT_BITS) * factor;
        share.to_fixed(SHARE_BITS, SHARE_BITS) as u32
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
