//! Ports of the renderer's units in order, `rst` first; every unit also has `clk`.

use super::config::Config;
use super::lists::Field;
use super::units;
use crate::{Direction, Port};

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

/// Collects ports in order.
#[derive(Default)]
pub(crate) struct Ports(Vec<Port>);

impl Ports {
    pub fn new() -> Self {
        Self::default().input("rst", 1)
    }

    fn port(mut self, name: impl Into<String>, width: u32, direction: Direction) -> Self {
        self.0.push(Port { name: name.into(), width, direction });
        self
    }

    pub fn input(self, name: impl Into<String>, width: u32) -> Self {
        self.port(name, width, Direction::Input)
    }

    pub fn output(self, name: impl Into<String>, width: u32) -> Self {
        self.port(name, width, Direction::Output)
    }

    pub fn inputs(self, prefix: &str, fields: &[Field]) -> Self {
        fields.iter().fold(self, |ports, (name, width)| ports.input(format!("{prefix}{name}"), *width))
    }

    pub fn outputs(self, prefix: &str, fields: &[Field]) -> Self {
        fields.iter().fold(self, |ports, (name, width)| ports.output(format!("{prefix}{name}"), *width))
    }

    /// A stream the unit receives: `valid`, `ready`, fields.
    pub fn stream_in(self, name: &str, fields: &[Field]) -> Self {
        let ports = self.input(format!("{name}_valid"), 1).output(format!("{name}_ready"), 1);
        ports.inputs(&format!("{name}_"), fields)
    }

    /// A stream the unit sends: `valid`, `ready`, fields.
    pub fn stream_out(self, name: &str, fields: &[Field]) -> Self {
        let ports = self.output(format!("{name}_valid"), 1).input(format!("{name}_ready"), 1);
        ports.outputs(&format!("{name}_"), fields)
    }

    /// A record that whoever receives it always takes: `valid`, fields.
    pub fn pulse_out(self, name: &str, fields: &[Field]) -> Self {
        self.output(format!("{name}_valid"), 1).outputs(&format!("{name}_"), fields)
    }

    /// The ports collected.
    pub fn list(self) -> Vec<Port> {
        self.0
    }
}

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
