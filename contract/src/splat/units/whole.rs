//! The whole core.

use super::events::Events;
use crate::splat::Config;
use crate::splat::records::{Fragment, Pixel, PixelRun, Splat, StoredPixel, UniformWrite};
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
    read: Out<PixelRun>,
    /// The pixels requested, in order.
    data: In<Pixel>,
    /// Pixels of evicted tiles.
    write: Out<StoredPixel>,
    /// Fragments of the image.
    fragment: Out<Fragment>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<Events>,
}
