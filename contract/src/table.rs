//! Shape of a sampled function that the hardware looks up, and interpolates linearly where there is room for it.

/// Field widths of a table.
///
/// The argument is `index · fraction`, most significant bit first. With fraction bits the table holds `2^index_bits + 1`
/// samples, so that every interval has both its ends; without them nothing is interpolated, and it holds `2^index_bits`
/// samples, each of the middle of its interval. A sample is an unsigned fraction of `2^value_bits − 1`, which stands for one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TableShape {
    /// Bits of the argument that select the interval.
    pub index_bits: u32,
    /// Bits of the argument that say where in the interval it lies; 0 without interpolation.
    pub fraction_bits: u32,
    /// Width of a sample.
    pub value_bits: u32,
}

impl TableShape {
    /// Samples that the table holds.
    #[must_use]
    pub const fn samples(self) -> usize {
        let intervals = 1 << self.index_bits;
        if self.fraction_bits == 0 { intervals } else { intervals + 1 }
    }
}
