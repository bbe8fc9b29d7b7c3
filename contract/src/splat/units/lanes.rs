//! Units of which there are as many as rasterizers, and those between them.

use super::events::LaneEvents;
use crate::splat::Config;
use crate::splat::records::{
    Depth, DepthRun, FinishedPixel, Fragment, PayloadPlace, PayloadWord, Pixel, PixelRun, SplatCopy, StoredPixel,
    StoredWord,
};
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
    /// Payloads wanted.
    #[when(config.has_payloads_in_memory())]
    payload_read: Out<PayloadPlace>,
    /// Their words, in order.
    #[when(config.has_payloads_in_memory())]
    payload_data: In<PayloadWord>,
    /// Words of payloads that are kept.
    #[when(config.has_payloads_in_memory())]
    payload_write: Out<StoredWord>,
    /// Depths wanted, behind which samples are hidden.
    #[when(config.tests_samples())]
    depth_read: Out<DepthRun>,
    /// They, in order.
    #[when(config.tests_samples())]
    depth_data: In<Depth>,
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
    /// Where splats may move, depth is `depth_a` and what follows from the distance.
    #[when(config.has_motion())]
    #[bits(config.geometry.width())]
    depth_a: Input<u32>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<LaneEvents>,
}

/// Leads two sides to one port of the reconstruction buffer.
#[unit(splat_arbiter, config: Config)]
#[when(config.rasterizers > 1)]
pub struct Arbiter {
    /// Requests of the lower numbers.
    low_read: In<PixelRun>,
    /// Pixels for them.
    low_data: Out<Pixel>,
    /// What they write.
    low_write: In<StoredPixel>,
    /// Requests of the higher numbers.
    high_read: In<PixelRun>,
    /// Pixels for them.
    high_data: Out<Pixel>,
    /// What they write.
    high_write: In<StoredPixel>,
    /// Requests of both.
    read: Out<PixelRun>,
    /// The pixels requested, in order.
    data: In<Pixel>,
    /// What both write.
    write: Out<StoredPixel>,
}

/// Leads finished pixels of two sides into one stream.
#[unit(splat_collector, config: Config)]
#[when(config.rasterizers_a_port() > 1)]
pub struct Collector {
    /// Those of the lower numbers.
    low: In<FinishedPixel>,
    /// Those of the higher numbers.
    high: In<FinishedPixel>,
    /// Both: a frame ends when both sides have.
    out: Out<FinishedPixel>,
}

/// Leads fragments of two sides into one stream, for a bus.
#[unit(splat_fragment_collector, config: Config)]
#[when(config.memory_ports > 1)]
pub struct FragmentCollector {
    /// Those of the lower numbers.
    low: In<Fragment>,
    /// Those of the higher numbers.
    high: In<Fragment>,
    /// Both: a frame ends when both sides have.
    out: Out<Fragment>,
}
