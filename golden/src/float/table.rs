//! A function sampled at equal distances, interpolated linearly where the argument has fraction bits.
//!
//! With the argument `t = index · fraction`, `v[i] + ⌊(v[i+1] − v[i]) · fraction / 2^fraction_bits⌋` (the floor of a
//! negative product too). The result lies between its two samples. Without fraction bits the samples are those of the
//! intervals' middles, and `v[index]` is the result.

use pointcore_contract::TableShape;

/// A table of as many samples as its shape says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    shape: TableShape,
    values: Vec<i64>,
}

impl Table {
    /// Samples `function`, which maps [0, 1] to [0, 1]: `v[i] = round(function(i / 2^index_bits) · (2^value_bits − 1))`,
    /// with `i + ½` in the place of `i` where nothing is interpolated.
    pub(super) fn sample(shape: TableShape, function: impl Fn(f64) -> f64) -> Self {
        let intervals = 1_u64 << shape.index_bits;
        let one = ((1_u64 << shape.value_bits) - 1) as f64;
        let value = |i: f64| (function(i / intervals as f64) * one).round() as i64;
        let values = match shape.fraction_bits {
            0 => (0..intervals).map(|i| value(i as f64 + 0.5)).collect(),
            _ => (0..=intervals).map(|i| value(i as f64)).collect(),
        };
        Self { shape, values }
    }

    /// The samples, as they stand in the hardware's memory.
    #[must_use]
    pub fn values(&self) -> &[i64] {
        &self.values
    }

    /// The interpolated value at `t`, an unsigned number of `index_bits + fraction_bits` bits.
    ///
    /// # Panics
    /// If `t` has more bits.
    #[must_use]
    pub fn interpolate(&self, t: u64) -> u64 {
        let index = (t >> self.shape.fraction_bits) as usize;
        if self.shape.fraction_bits == 0 {
            return self.values[index] as u64;
        }
        let fraction = (t & ((1 << self.shape.fraction_bits) - 1)) as i64;
        let (low, high) = (self.values[index], self.values[index + 1]);
        (low + (((high - low) * fraction) >> self.shape.fraction_bits)) as u64
    }
}
