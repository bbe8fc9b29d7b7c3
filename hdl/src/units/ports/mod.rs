//! The contract's descriptions of ports, declared, driven and wired up.
//!
//! A unit takes them from its own `PORTS` and declares them on its module; whoever places the unit takes them from there as well and
//! connects the instance.

mod channel;
mod level;
mod pulse;
mod stream;

pub(crate) use channel::{ChannelInPorts, ChannelOutPorts, export};
pub(crate) use level::{InputPorts, OutputPorts, WordPort, held};
pub(crate) use pulse::{Pulse, PulseInPorts, PulseOutPorts, pulse};
pub(crate) use stream::{Flow, QueueOut, StreamInPorts, StreamOutPorts, pipe};
