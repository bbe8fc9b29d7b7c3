//! Ports of the renderer's units in order, `rst` first; every unit also has `clk`.

use super::config::Config;
use super::units;
use crate::Port;

/// Names of the uniform registers: constants of a frame, written before its first splat. Their order is their address.
///
/// `m00…m23` model-view matrix by rows, `scale_x…origin_y` viewport (px), `depth_a + depth_b/z` depth in `[0, 1]`, `near_plane`,
/// `epsilon_scale` and `epsilon_bias` of eq. 5.9, `filter_radius` (px) and the reciprocal of its square.
pub const UNIFORMS: [&str; 23] = [
    "m00",
    "m01",
    "m02",
    "m03",
    "m10",
    "m11",
    "m12",
    "m13",
    "m20",
    "m21",
    "m22",
    "m23",
    "scale_x",
    "scale_y",
    "origin_x",
    "origin_y",
    "depth_a",
    "depth_b",
    "near_plane",
    "epsilon_scale",
    "epsilon_bias",
    "filter_radius",
    "filter_scale",
];

/// Bits of a uniform register's address.
pub const UNIFORM_ADDRESS_BITS: u32 = 5;

/// What the core does in a cycle, one output port each, for utilisation and stalls by cause.
pub const EVENTS: [&str; 6] = [
    // The rasterizer evaluated a sample.
    "event_sample",
    // The rasterizer had no copy to work on.
    "event_starved",
    // The rasterizer's pipeline was held by what follows it.
    "event_blocked",
    // The accumulator took a sample.
    "event_accumulate",
    // The accumulator waited for an earlier sample of the same pixel.
    "event_hazard",
    // The accumulator waited for its tile to arrive in the cache.
    "event_slot_wait",
];

macro_rules! lists {
    ($($unit:ident),* $(,)?) => {
        $(
            /// Ports of that unit.
            #[must_use]
            pub fn $unit(config: &Config) -> Vec<Port> {
                units::$unit::UNIT.ports(config)
            }
        )*
    };
}

lists!(
    transform,
    setup,
    splitter,
    heap,
    reorder,
    tile_cache,
    rasterizer,
    weighting,
    depth_test,
    accumulator,
    normalizer,
    top
);
