//! The whole core.

use super::events::Events;
use crate::splat::Config;
use crate::splat::records::{
    Depth, DepthRun, Fragment, PayloadPlace, PayloadWord, Pixel, PixelRun, Splat, StoredDepth, StoredPixel, StoredWord,
    UniformWrite,
};
use crate::unit;

/// The renderer.
#[unit(splat_top, config: Config)]
pub struct Top {
    /// Write to a uniform register: after `frame_set_up` of the last frame and before the first splat of the next, `filter_scale`
    /// while no frame is under way.
    uniform: PulseIn<UniformWrite>,
    /// Splats in world space.
    splat: In<Splat>,
    /// All splats of a frame were set up in the last cycle.
    frame_set_up: Output<bool>,
    /// Request for pixels of a tile.
    #[count(config.memory_ports)]
    read: [Out<PixelRun>; 4],
    /// The pixels requested, in order.
    #[count(config.memory_ports)]
    data: [In<Pixel>; 4],
    /// Pixels of evicted tiles.
    #[count(config.memory_ports)]
    write: [Out<StoredPixel>; 4],
    /// Fragments of the image, each of one stream; a frame ends when all streams have ended it.
    #[count(config.memory_ports)]
    fragment: [Out<Fragment>; 4],
    /// Payloads wanted, where they are in memory: one port a rasterizer.
    #[count(config.payload_ports())]
    payload_read: [Out<PayloadPlace>; 8],
    /// Their words, in order.
    #[count(config.payload_ports())]
    payload_data: [In<PayloadWord>; 8],
    /// Words of payloads that are kept.
    #[count(config.payload_ports())]
    payload_write: [Out<StoredWord>; 8],
    /// Depths in memory that fragments are tested against, one port for each of `fragment`; or samples of what moves, one for each rasterizer.
    #[count(config.merge_ports())]
    depth_read: [Out<DepthRun>; 8],
    /// They, in order.
    #[count(config.merge_ports())]
    depth_data: [In<Depth>; 8],
    /// Depths of fragments that were nearer.
    #[count(config.depth_writers())]
    depth_write: [Out<StoredDepth>; 4],
    /// What happened in the last cycle.
    #[port("")]
    events: Output<Events>,
}
