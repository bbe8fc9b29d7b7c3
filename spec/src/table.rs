//! Shape of a sampled function that the hardware interpolates linearly.

/// Field widths of an interpolation table.
///
/// The argument is `index · fraction`, most significant bit first; the table holds `2^index_bits + 1` samples, so that
/// every interval has both its ends. A sample is an unsigned fraction of `2^value_bits − 1`, which stands for one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TableShape {
    /// Bits of the argument that select the interval.
    pub index_bits: u32,
    /// Bits of the argument that say where in the interval it lies.
    pub fraction_bits: u32,
    /// Width of a sample.
    pub value_bits: u32,
}
