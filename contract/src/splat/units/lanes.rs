//! Units of which there are as many as rasterizers, and those between them.

use super::events::LaneEvents;
use crate::splat::Config;
use crate::splat::records::{FinishedPixel, Pixel, PixelRun, SplatCopy, StoredPixel};
use crate::unit;

/// Sends copies to one of two sides, by the rasterizer whose tile it is.
#[unit(splat_distributor, config: Config)]
#[when(config.rasterizers > 1)]
pub struct Distributor {
    /// Copies for both sides.
    #[port("in")]
    input: In<SplatCopy>,
    /// Those of the lower numbers.
    low: Out<SplatCopy>,
    /// Those of the higher numbers.
    high: Out<SplatCopy>,
}

/// A rasterizer and all that it has to itself, from copies to finished pixels.
#[unit(splat_lane, config: Config)]
pub struct Lane {
    /// Copies for its tiles.
    #[port("in")]
    input: In<SplatCopy>,
    /// Request for pixels of a tile.
    read: Out<PixelRun>,
    /// The pixels requested, in order.
    data: In<Pixel>,
    /// Pixels of evicted tiles.
    write: Out<StoredPixel>,
    /// Pixels of a finished frame.
    pixel: Out<FinishedPixel>,
    /// Its number.
    #[when(config.rasterizers > 1)]
    #[bits(config.rasterizer_bits())]
    number: Input<u8>,
    /// The end of a frame has left all lanes, a cycle long.
    #[when(config.rasterizers > 1)]
    frame_sent: Input<bool>,
    /// The reciprocal of the squared radius of the screen filter.
    #[when(config.screen_filter.is_on())]
    #[bits(config.filter_scale_format().width())]
    filter_scale: Input<u32>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<LaneEvents>,
}

/// Leads two sides to one memory, and their pixels into one stream.
#[unit(splat_collector, config: Config)]
#[when(config.rasterizers > 1)]
pub struct Collector {
    /// Requests of the lower numbers.
    low_read: In<PixelRun>,
    /// Pixels for them.
    low_data: Out<Pixel>,
    /// What they write.
    low_write: In<StoredPixel>,
    /// What they have finished.
    low_pixel: In<FinishedPixel>,
    /// Requests of the higher numbers.
    high_read: In<PixelRun>,
    /// Pixels for them.
    high_data: Out<Pixel>,
    /// What they write.
    high_write: In<StoredPixel>,
    /// What they have finished.
    high_pixel: In<FinishedPixel>,
    /// Requests of both.
    read: Out<PixelRun>,
    /// The pixels requested, in order.
    data: In<Pixel>,
    /// What both write.
    write: Out<StoredPixel>,
    /// What both have finished.
    pixel: Out<FinishedPixel>,
}
