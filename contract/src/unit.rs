//! Units at their ports: how a description made by [`unit`](macro@crate::unit) is read by hardware, models, tests and documents.

use std::marker::PhantomData;

use crate::record::Field;
use crate::{Direction, Port};

/// How the fields of a group of ports travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Into the unit with `valid` and `ready`.
    In,
    /// Out of the unit with `valid` and `ready`.
    Out,
    /// Into the unit with `valid`, always taken.
    PulseIn,
    /// Out of the unit with `valid`, always taken.
    PulseOut,
    /// Into the unit in every cycle.
    Input,
    /// Out of the unit in every cycle.
    Output,
}

impl Kind {
    /// Which way the fields go.
    #[must_use]
    pub const fn direction(self) -> Direction {
        match self {
            Self::In | Self::PulseIn | Self::Input => Direction::Input,
            Self::Out | Self::PulseOut | Self::Output => Direction::Output,
        }
    }

    /// A flag says whether the fields are there.
    #[must_use]
    pub const fn has_flag(self) -> bool {
        !matches!(self, Self::Input | Self::Output)
    }

    /// Whoever receives it says whether it is taken.
    #[must_use]
    pub const fn has_ready(self) -> bool {
        matches!(self, Self::In | Self::Out)
    }
}

/// What the port is called that says whether an item of a stream is taken.
pub const READY: &str = "ready";

/// The name of a part of a group of ports; either may be empty.
fn port_name(group: &str, part: &str) -> String {
    match (group, part) {
        ("", part) => part.to_owned(),
        (group, "") => group.to_owned(),
        (group, part) => format!("{group}_{part}"),
    }
}

/// The name of a part of a bus's channel, where buses put nothing between.
pub(crate) fn channel_port(bus: &str, channel: &str, part: &str) -> String {
    format!("{bus}_{channel}{part}")
}

/// Ports that belong together: `<name>_<flag>`, `<name>_ready` and `<name>_<field>`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// What their names begin with; may be empty.
    pub name: &'static str,
    /// What their names go on with where they are a channel of the bus of that name: `<name>_<channel><flag>`.
    pub channel: Option<&'static str>,
    /// What they are for.
    pub doc: &'static str,
    /// What the flag is called, usually `valid`.
    pub flag: &'static str,
    /// The record that travels, or the integer.
    pub record: &'static str,
    /// How the fields travel.
    pub kind: Kind,
    /// The fields; a single one without a name is called as the group.
    pub fields: Vec<Field>,
}

impl Group {
    /// The name of a port.
    #[must_use]
    pub fn port_name(&self, part: &str) -> String {
        match self.channel {
            Some(channel) => channel_port(self.name, channel, part),
            None => port_name(self.name, part),
        }
    }

    /// The group's ports: flag, `ready`, fields.
    pub fn ports(&self) -> impl Iterator<Item = Port> {
        let port = |part: &str, width, direction| Port { name: self.port_name(part), width, direction };
        let direction = self.kind.direction();
        let flag = self.kind.has_flag().then(|| port(self.flag, 1, direction));
        let ready = self.kind.has_ready().then(|| port(READY, 1, direction.reversed()));
        let fields = self.fields.iter().map(move |field| port(&field.name, field.width, direction));
        flag.into_iter().chain(ready).chain(fields)
    }
}

/// All ports of a unit but `clk` and `rst`, group by group.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Interface {
    /// The groups.
    pub groups: Vec<Group>,
}

impl Interface {
    /// The ports in order, `rst` first.
    #[must_use]
    pub fn ports(&self) -> Vec<Port> {
        let rst = Port { name: "rst".into(), width: 1, direction: Direction::Input };
        std::iter::once(rst).chain(self.groups.iter().flat_map(Group::ports)).collect()
    }
}

/// A unit in a list of all.
#[derive(Debug)]
pub struct Unit<C: 'static> {
    /// Its Verilog module: room and unit, `search_sieve`.
    pub module: &'static str,
    /// What it does.
    pub doc: &'static str,
    /// Its ports in a configuration.
    pub interface: fn(&C) -> Interface,
    /// Whether a configuration has it.
    pub is_present: fn(&C) -> bool,
}

impl<C> Unit<C> {
    /// Its ports in a configuration, `rst` first.
    #[must_use]
    pub fn ports(&self, config: &C) -> Vec<Port> {
        (self.interface)(config).ports()
    }

    /// Its name within its room.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.module.split_once('_').map_or(self.module, |(_, name)| name)
    }
}

macro_rules! descriptors {
    ($($(#[doc = $doc:literal])* $kind:ident),* $(,)?) => {
        $(
            $(#[doc = $doc])*
            #[derive(Debug)]
            pub struct $kind<R> {
                /// What the ports' names begin with.
                pub name: &'static str,
                /// What the flag is called.
                pub flag: &'static str,
                /// What the ports are for.
                pub doc: &'static str,
                record: PhantomData<R>,
            }

            impl<R> $kind<R> {
                /// Ports of these names.
                #[must_use]
                pub const fn new(name: &'static str, flag: &'static str, doc: &'static str) -> Self {
                    Self { name, flag, doc, record: PhantomData }
                }

                /// The name of one of the ports: of the flag, of [`READY`], of a field.
                #[must_use]
                pub fn port(&self, part: &str) -> String {
                    port_name(self.name, part)
                }
            }

            impl<R> Clone for $kind<R> {
                fn clone(&self) -> Self {
                    *self
                }
            }

            impl<R> Copy for $kind<R> {}
        )*
    };
}

descriptors! {
    /// A stream of records into a unit.
    In,
    /// A stream of records out of a unit.
    Out,
    /// Records into a unit that are always taken.
    PulseIn,
    /// Records out of a unit that are always taken.
    PulseOut,
    /// A record or an integer into a unit in every cycle.
    Input,
    /// A record or an integer out of a unit in every cycle.
    Output,
}

/// Numbers of inputs and of outputs.
#[must_use]
pub fn count(ports: &[Port]) -> (usize, usize) {
    let inputs = ports.iter().filter(|port| port.direction == Direction::Input).count();
    (inputs, ports.len() - inputs)
}
