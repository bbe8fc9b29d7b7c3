//! Which words of the exchanged arrays belong to which stream, as the design declares them.

use crate::verilated::{Direction, Library, Port, StreamDeclaration};

/// A `valid`/`ready` stream of the hardware: positions in the arrays of inputs and outputs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StreamPorts {
    /// What the names of its ports begin with.
    pub name: String,
    /// Whether the hardware consumes it (`Input`) or produces it (`Output`): the side of `valid` and the fields.
    pub direction: Direction,
    /// Position of its flag.
    pub valid: usize,
    /// Position of `<name>_ready` among the ports of the other direction; without one, every valid cycle is a transfer.
    pub ready: Option<usize>,
    /// Positions of `<name>_<field>`, in the order of the ports.
    pub fields: Vec<usize>,
}

impl StreamPorts {
    fn among(declared: &StreamDeclaration, inputs: &[Port], outputs: &[Port]) -> Self {
        let (forward, backward) = match declared.direction {
            Direction::Input => (inputs, outputs),
            Direction::Output => (outputs, inputs),
        };
        let place = |ports: &[Port], name: &str| {
            let place = ports.iter().position(|port| port.name == name);
            place.unwrap_or_else(|| panic!("stream `{}` has no port `{name}`", declared.name))
        };
        Self {
            name: declared.name.clone(),
            direction: declared.direction,
            valid: place(forward, &declared.flag_port()),
            ready: declared.ready_port().map(|ready| place(backward, &ready)),
            fields: declared.field_ports().map(|field| place(forward, &field)).collect(),
        }
    }

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
    /// The streams of a library's design.
    ///
    /// # Panics
    /// When a declared port is not among the design's.
    #[must_use]
    pub fn of(library: &Library) -> Self {
        Self::among(&library.source().streams, library.inputs(), library.outputs())
    }

    fn among(declared: &[StreamDeclaration], inputs: &[Port], outputs: &[Port]) -> Self {
        let streams = |direction| {
            let declared = declared.iter().filter(move |stream| stream.direction == direction);
            declared.map(|stream| StreamPorts::among(stream, inputs, outputs))
        };
        Self(streams(Direction::Input).chain(streams(Direction::Output)).collect())
    }

    /// The stream of this name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&StreamPorts> {
        self.iter().find(|stream| stream.name == name)
    }

    /// Whether an output of the hardware is a stream's.
    #[must_use]
    pub fn have_output(&self, output: usize) -> bool {
        self.iter().any(|stream| match stream.direction {
            Direction::Input => stream.ready == Some(output),
            Direction::Output => stream.valid == output || stream.fields.contains(&output),
        })
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_have_the_ports_they_declare() {
        let inputs = ["in_valid", "in_x", "in_far_enable", "in_far_x", "in_other", "out_ready"];
        let outputs = ["in_ready", "out_valid", "out_sum", "pulse_valid", "event"];
        let ports = |names: &[&str], direction| -> Vec<_> {
            names.iter().map(|name| Port { name: (*name).to_owned(), width: 1, direction }).collect()
        };
        let declared = [
            StreamDeclaration::stream("out", Direction::Output, ["sum"]),
            StreamDeclaration::stream("in", Direction::Input, ["x"]),
            StreamDeclaration::pulse("in_far", "enable", Direction::Input, ["x"]),
            StreamDeclaration::pulse("pulse", "valid", Direction::Output, [] as [&str; 0]),
        ];
        let (inputs, outputs) = (ports(&inputs, Direction::Input), ports(&outputs, Direction::Output));
        let streams = Streams::among(&declared, &inputs, &outputs);
        let find = |name| streams.get(name).unwrap_or_else(|| panic!("no stream {name}"));
        assert_eq!((find("in").valid, find("in").ready, find("in").fields.as_slice()), (0, Some(0), &[1][..]));
        assert_eq!((find("in_far").valid, find("in_far").ready, find("in_far").fields.as_slice()), (2, None, &[3][..]));
        assert_eq!((find("out").valid, find("out").ready, find("out").fields.as_slice()), (1, Some(5), &[2][..]));
        assert_eq!((find("pulse").direction, find("pulse").ready), (Direction::Output, None));
        let free: Vec<_> = (0..outputs.len()).filter(|output| !streams.have_output(*output)).collect();
        assert_eq!(free, [4], "what belongs to no stream");
        let names: Vec<_> = streams.iter().map(|stream| stream.name.as_str()).collect();
        assert_eq!(names, ["in", "in_far", "out", "pulse"], "those that come in come first");
    }
}
