//! Which words of the exchanged arrays belong to which stream, read off the port names.

use crate::verilated::{Direction, Library, Port};

/// A `valid`/`ready` stream of the hardware: positions in the arrays of inputs and outputs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StreamPorts {
    /// The prefix of its ports.
    pub name: String,
    /// Whether the hardware consumes it (`Input`) or produces it (`Output`): the side of `valid` and the fields.
    pub direction: Direction,
    /// Position of `<name>_valid`.
    pub valid: usize,
    /// Position of `<name>_ready` among the ports of the other direction; without one, every valid cycle is a transfer.
    pub ready: Option<usize>,
    /// Positions of `<name>_<field>`, in the order of the ports.
    pub fields: Vec<usize>,
}

impl StreamPorts {
    /// The arrays as this stream sees them: first that of `valid` and the fields, then that of `ready`.
    #[must_use]
    pub fn sides<'a>(&self, inputs: &'a [u64], outputs: &'a [u64]) -> (&'a [u64], &'a [u64]) {
        match self.direction {
            Direction::Input => (inputs, outputs),
            Direction::Output => (outputs, inputs),
        }
    }

    /// Whether data is offered in this cycle.
    #[must_use]
    pub fn offers(&self, inputs: &[u64], outputs: &[u64]) -> bool {
        self.sides(inputs, outputs).0[self.valid] != 0
    }

    /// Whether an item changes hands in this cycle.
    #[must_use]
    pub fn transfers(&self, inputs: &[u64], outputs: &[u64]) -> bool {
        let (forward, backward) = self.sides(inputs, outputs);
        forward[self.valid] != 0 && self.ready.is_none_or(|ready| backward[ready] != 0)
    }
}

/// All streams of a top module.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Streams(Vec<StreamPorts>);

impl Streams {
    /// The streams of a library's ports.
    #[must_use]
    pub fn of(library: &Library) -> Self {
        Self::from_ports(library.inputs(), library.outputs())
    }

    /// The streams of these ports: one for each `<name>_valid`, with the fields of the longest name that fits them.
    #[must_use]
    pub fn from_ports(inputs: &[Port], outputs: &[Port]) -> Self {
        let mut streams = Vec::new();
        for (direction, forward, backward) in
            [(Direction::Input, inputs, outputs), (Direction::Output, outputs, inputs)]
        {
            let names: Vec<&str> = forward.iter().filter_map(|port| port.name.strip_suffix("_valid")).collect();
            for &name in &names {
                let position = |ports: &[Port], suffix: &str| {
                    ports.iter().position(|port| port.name.strip_prefix(name) == Some(suffix))
                };
                let Some(valid) = position(forward, "_valid") else { continue };
                let owns = |port: &Port| {
                    let fitting = names.iter().filter(|other| is_field_of(&port.name, other));
                    fitting.max_by_key(|other| other.len()) == Some(&name)
                };
                let ready = position(backward, "_ready");
                let fields = (0..forward.len()).filter(|&index| index != valid && owns(&forward[index])).collect();
                streams.push(StreamPorts { name: name.to_owned(), direction, valid, ready, fields });
            }
        }
        Self(streams)
    }

    /// The stream of this name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&StreamPorts> {
        self.iter().find(|stream| stream.name == name)
    }

    /// All streams: those the hardware consumes, then those it produces.
    pub fn iter(&self) -> std::slice::Iter<'_, StreamPorts> {
        self.0.iter()
    }
}

impl<'a> IntoIterator for &'a Streams {
    type Item = &'a StreamPorts;
    type IntoIter = std::slice::Iter<'a, StreamPorts>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// Whether `port` is called `<stream>_<something>`, where something is not `ready`: that is a port of the other direction.
fn is_field_of(port: &str, stream: &str) -> bool {
    port.strip_prefix(stream).and_then(|rest| rest.strip_prefix('_')).is_some_and(|field| field != "ready")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_go_to_the_longest_stream_name() {
        let inputs = ["in_valid", "in_x", "in_far_valid", "in_far_x", "out_ready", "threshold"];
        let outputs = ["in_ready", "out_valid", "out_sum", "pulse_valid"];
        let ports = |names: &[&str], direction| -> Vec<_> {
            names.iter().map(|name| Port { name: (*name).to_owned(), width: 1, direction }).collect()
        };
        let streams = Streams::from_ports(&ports(&inputs, Direction::Input), &ports(&outputs, Direction::Output));
        let find = |name| streams.get(name).unwrap_or_else(|| panic!("no stream {name}"));
        assert_eq!(find("in").fields, [1]);
        assert_eq!(find("in").ready, Some(0));
        assert_eq!(find("in_far").fields, [3]);
        assert_eq!(find("in_far").ready, None);
        assert_eq!((find("out").valid, find("out").ready, find("out").fields.as_slice()), (1, Some(4), &[2][..]));
        assert_eq!((find("pulse").direction, find("pulse").ready), (Direction::Output, None));
        assert_eq!(streams.iter().count(), 4);
    }
}
