//! Lists of ports under construction.

use super::axi::Bus;
use crate::{Direction, Field, Port};

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
        fields.iter().fold(self, |ports, field| ports.input(format!("{prefix}{}", field.name), field.width))
    }

    pub fn outputs(self, prefix: &str, fields: &[Field]) -> Self {
        fields.iter().fold(self, |ports, field| ports.output(format!("{prefix}{}", field.name), field.width))
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

    /// A bus, its ports called `<prefix>_…`.
    pub fn bus(self, bus: Bus, prefix: &str) -> Self {
        bus.ports(prefix)
            .into_iter()
            .fold(self, |ports, Port { name, width, direction }| ports.port(name, width, direction))
    }

    /// The ports collected.
    pub fn list(self) -> Vec<Port> {
        self.0
    }
}
