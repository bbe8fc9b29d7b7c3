//! Ports of the renderer's units in order, `rst` first; every unit also has `clk`. The golden models, the hardware and the test bench
//! all take names and order from here.

use super::config::{Config, DEPTH_BITS, DEPTH_SUM_BITS, WEIGHT_SUM_BITS};
use super::records::{self, Field, PIXEL_BITS};

/// Which way a port points, seen from the unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Into the unit.
    Input,
    /// Out of the unit.
    Output,
}

/// A port: name, width in bits (at most 64) and direction.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Port {
    /// Verilog name.
    pub name: String,
    /// Width in bits.
    pub width: u32,
    /// Direction.
    pub direction: Direction,
}

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

    /// A record the unit always takes: `valid`, fields.
    pub fn pulse_in(self, name: &str, fields: &[Field]) -> Self {
        self.input(format!("{name}_valid"), 1).inputs(&format!("{name}_"), fields)
    }

    /// A record that whoever receives it always takes: `valid`, fields.
    pub fn pulse_out(self, name: &str, fields: &[Field]) -> Self {
        self.output(format!("{name}_valid"), 1).outputs(&format!("{name}_"), fields)
    }

    /// The ports collected.
    pub fn list(self) -> Vec<Port> {
        self.0
    }

    /// The reconstruction buffer's port: tiles requested, their pixels, pixels written.
    fn memory(self, config: &Config) -> Self {
        let pixel = records::pixel(config);
        let mut write = tile_and_pixel(config);
        write.extend(pixel.clone());
        self.stream_out("read", &field("tile", config.tile_bits()))
            .stream_in("data", &pixel)
            .stream_out("write", &write)
    }

    fn uniforms(self, config: &Config, names: &[&str]) -> Self {
        names.iter().fold(self, |ports, name| ports.input(*name, config.uniform_format(name).width()))
    }
}

/// Numbers of inputs and of outputs.
#[must_use]
pub fn count(ports: &[Port]) -> (usize, usize) {
    let inputs = ports.iter().filter(|port| port.direction == Direction::Input).count();
    (inputs, ports.len() - inputs)
}

fn field(name: &str, width: u32) -> Vec<Field> {
    vec![(name.to_owned(), width)]
}

fn tile_and_pixel(config: &Config) -> Vec<Field> {
    vec![("tile".to_owned(), config.tile_bits()), ("pixel".to_owned(), PIXEL_BITS)]
}

/// Ports of the transform unit.
#[must_use]
pub fn transform(config: &Config) -> Vec<Port> {
    let splat = records::splat(config);
    let ports = Ports::new().stream_in("in", &splat).stream_out("out", &splat);
    ports.uniforms(config, &UNIFORMS[..12]).uniforms(config, &["near_plane"]).0
}

/// Ports of the setup unit.
#[must_use]
pub fn setup(config: &Config) -> Vec<Port> {
    let ports = Ports::new().stream_in("in", &records::splat(config)).stream_out("out", &records::setup(config));
    let ports = ports.uniforms(config, &UNIFORMS[12..18]).uniforms(config, &["epsilon_scale", "epsilon_bias"]);
    if config.screen_filter.is_on() { ports.uniforms(config, &["filter_radius"]).0 } else { ports.0 }
}

/// Ports of the splitter.
#[must_use]
pub fn splitter(config: &Config) -> Vec<Port> {
    Ports::new().stream_in("in", &records::setup(config)).stream_out("out", &records::copy(config)).0
}

/// Ports of the pipelined heap: entries are a tile index and the pointer to the copy's payload.
#[must_use]
pub fn heap(config: &Config) -> Vec<Port> {
    let entry = vec![("tile".to_owned(), config.tile_bits()), ("pointer".to_owned(), config.heap_levels)];
    Ports::new().stream_in("in", &entry).stream_out("out", &entry).output("empty", 1).0
}

/// Ports of the reorder stage.
#[must_use]
pub fn reorder(config: &Config) -> Vec<Port> {
    let copy = records::copy(config);
    Ports::new().stream_in("in", &copy).stream_out("out", &copy).0
}

/// Ports of the tile cache's control: copies in and out, the reconstruction buffer's memory port, and the accumulator's slots.
#[must_use]
pub fn tile_cache(config: &Config) -> Vec<Port> {
    let pixel = records::pixel(config);
    Ports::new()
        .stream_in("in", &records::copy(config))
        .stream_out("out", &records::placed_copy(config))
        .memory(config)
        .stream_out("pixel", &records::finished_pixel(config))
        .output("slot_ready", config.tile_slots)
        .input("retire_valid", 1)
        .input("retire_slot", config.slot_bits())
        .input("frame_end", 1)
        .output("fill_valid", 1)
        .output("fill_slot", config.slot_bits())
        .output("fill_pixel", PIXEL_BITS)
        .outputs("fill_", &pixel)
        .output("drain_enable", 1)
        .output("drain_slot", config.slot_bits())
        .output("drain_pixel", PIXEL_BITS)
        .inputs("drain_", &pixel)
        .0
}

/// Ports of the rasterizer.
#[must_use]
pub fn rasterizer(config: &Config) -> Vec<Port> {
    let ports = Ports::new().stream_in("in", &records::placed_copy(config)).stream_out("out", &records::sample(config));
    let ports = if config.screen_filter.is_on() { ports.uniforms(config, &["filter_scale"]) } else { ports };
    EVENTS[..3].iter().fold(ports, |ports, event| ports.output(*event, 1)).0
}

/// Ports of the weighting unit.
#[must_use]
pub fn weighting(config: &Config) -> Vec<Port> {
    Ports::new().stream_in("in", &records::sample(config)).stream_out("out", &records::weighted_sample(config)).0
}

/// Ports of the depth test: a pipeline without stalls; `fail` and `pass` follow their inputs two cycles later.
#[must_use]
pub fn depth_test(_config: &Config) -> Vec<Port> {
    Ports::new()
        .input("weight", WEIGHT_SUM_BITS)
        .input("depth", DEPTH_SUM_BITS)
        .input("depth_low", DEPTH_BITS)
        .input("depth_high", DEPTH_BITS)
        .output("fail", 1)
        .output("pass", 1)
        .0
}

/// Ports of the accumulator with its tile slots.
#[must_use]
pub fn accumulator(config: &Config) -> Vec<Port> {
    let pixel = records::pixel(config);
    let ports = Ports::new()
        .stream_in("in", &records::weighted_sample(config))
        .input("slot_ready", config.tile_slots)
        .output("retire_valid", 1)
        .output("retire_slot", config.slot_bits())
        .output("frame_end", 1)
        .input("fill_valid", 1)
        .input("fill_slot", config.slot_bits())
        .input("fill_pixel", PIXEL_BITS)
        .inputs("fill_", &pixel)
        .input("drain_enable", 1)
        .input("drain_slot", config.slot_bits())
        .input("drain_pixel", PIXEL_BITS)
        .outputs("drain_", &pixel);
    EVENTS[3..].iter().fold(ports, |ports, event| ports.output(*event, 1)).0
}

/// Ports of the normalizer.
#[must_use]
pub fn normalizer(config: &Config) -> Vec<Port> {
    Ports::new().stream_in("in", &records::finished_pixel(config)).stream_out("out", &records::fragment(config)).0
}

/// Ports of the whole core.
#[must_use]
pub fn top(config: &Config) -> Vec<Port> {
    let ports = Ports::new()
        .input("uniform_valid", 1)
        .input("uniform_address", UNIFORM_ADDRESS_BITS)
        .input("uniform_data", config.geometry.width())
        .stream_in("splat", &records::splat(config))
        .memory(config)
        .stream_out("fragment", &records::fragment(config));
    EVENTS.iter().fold(ports, |ports, event| ports.output(*event, 1)).0
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn ports_have_unique_names_and_fit_a_word() {
        let config = Config { cardinal: 1, ..Config::default() };
        let units = [
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
            top,
        ];
        for unit in units {
            let ports = unit(&config);
            let names: HashSet<_> = ports.iter().map(|port| &port.name).collect();
            assert_eq!(names.len(), ports.len());
            assert!(ports.iter().all(|port| (1..=64).contains(&port.width)));
        }
    }
}
