//! What a configuration of the renderer may be refused for.

use super::ATTRIBUTES_MAX;
use crate::configuration::OutOfRange;
use crate::splat::RasterFormat;
use crate::{Format, bus};

/// A configuration the hardware cannot hold.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConfigError {
    /// A number lies outside its range.
    #[error(transparent)]
    Range(#[from] OutOfRange),
    /// A pace the heap does not have.
    #[error("`heap_interval` = {0}: expected 2 cycles an operation, or 4 for a higher clock")]
    HeapInterval(u32),
    /// A number of rasterizers that tiles cannot be dealt out to evenly.
    #[error("`rasterizers` = {0}: expected 1, 2, 4 or 8")]
    Rasterizers(u32),
    /// An image with fewer columns of tiles than rasterizers.
    #[error(
        "`rasterizers` = {rasterizers} with `width` = {width}: expected {most} at most, as many as there are columns of tiles"
    )]
    NarrowImage {
        /// Samples in a row.
        width: u32,
        /// Rasterizers.
        rasterizers: u32,
        /// As many as there may be.
        most: u32,
    },
    /// A number of ports that rasterizers cannot share evenly.
    #[error(
        "`memory_ports` = {ports} with `rasterizers` = {rasterizers}: expected 1, 2 or 4, and no more than rasterizers"
    )]
    MemoryPorts {
        /// Ports.
        ports: u32,
        /// Rasterizers.
        rasterizers: u32,
    },
    /// A row of samples that ends within a pixel.
    #[error("`width` = {width}: expected a multiple of {columns}, the samples that a pixel has in a row by `sampling`")]
    CutPixel {
        /// Samples in a row.
        width: u32,
        /// Samples of a pixel in a row.
        columns: u32,
    },
    /// A number of bins that there may not be.
    #[error("`time_bins` = {bins}: expected 0 where nothing moves, or a power of two up to {most}")]
    TimeBins {
        /// Parts of the exposure.
        bins: u32,
        /// As many as there may be.
        most: u32,
    },
    /// A key that hardware for motion does not know in any other way.
    #[error("`time_bins` = {bins}: expected `{key}` = \"{value}\", for {reason}")]
    Motion {
        /// Parts of the exposure.
        bins: u32,
        /// The key.
        key: &'static str,
        /// What would be right.
        value: &'static str,
        /// Why.
        reason: &'static str,
    },
    /// More or fewer attributes than the accumulators hold.
    #[error("`continuous` + `cardinal` = {0}: expected 1 to {ATTRIBUTES_MAX} attributes")]
    Attributes(u32),
    /// A format the operators cannot compute in.
    #[error("`{key}` = \"{format}\": expected one of {expected}")]
    Format {
        /// The TOML key.
        key: &'static str,
        /// Its value.
        format: Format,
        /// What would be right.
        expected: &'static str,
    },
    /// Depths of samples where there is no number to hold them.
    #[error(
        "`rasterizer` = \"{0}\" with `depth` = \"plane\": expected `depth` = \"center\", or a floating-point `rasterizer`, in which \
         samples have depths of their own"
    )]
    PlaneInFixedPoint(RasterFormat),
    /// A width that no bus has.
    #[error(transparent)]
    Bus(#[from] bus::ConfigError),
}
