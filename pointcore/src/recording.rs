//! What a golden model did at its ports in every cycle, as vectors for a test.

use pointcore_contract::Direction;
use pointcore_contract::Port;
use rtl::StreamDeclaration;
use std::fmt::Write as _;

/// The words of every port in every cycle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recording {
    ports: Vec<Port>,
    rows: Vec<Vec<u64>>,
    settling_cycles: u64,
}

impl Recording {
    /// An empty recording at these ports.
    #[must_use]
    pub fn new(ports: Vec<Port>) -> Self {
        Self { ports, rows: Vec::new(), settling_cycles: 0 }
    }

    /// A recording that begins so many idle cycles after the reset.
    #[must_use]
    pub fn after(self, settling_cycles: u64) -> Self {
        Self { settling_cycles, ..self }
    }

    /// Idle cycles between the reset and the first that is recorded.
    #[must_use]
    pub const fn settling_cycles(&self) -> u64 {
        self.settling_cycles
    }

    /// Adds a cycle: the inputs and the outputs, each in the order of the ports.
    pub fn push(&mut self, inputs: &[u64], outputs: &[u64]) {
        let (mut inputs, mut outputs) = (inputs.iter(), outputs.iter());
        let mut word = |port: &Port| {
            let side = if port.direction == Direction::Input { &mut inputs } else { &mut outputs };
            *side.next().expect("a word for each port")
        };
        self.rows.push(self.ports.iter().map(&mut word).collect());
    }

    /// Number of cycles.
    #[must_use]
    pub fn cycles(&self) -> usize {
        self.rows.len()
    }

    /// The ports; the place of a port in a vector is above those before it.
    #[must_use]
    pub fn ports(&self) -> &[Port] {
        &self.ports
    }

    /// Bits of a vector.
    #[must_use]
    pub fn width(&self) -> usize {
        self.ports.iter().map(|port| port.width as usize).sum()
    }

    /// Cycles in which a stream's item changes hands.
    #[must_use]
    pub fn transfers(&self, stream: &StreamDeclaration) -> usize {
        let place = |name: String| self.ports.iter().position(|port| port.name == name);
        let (Some(valid), Some(ready)) = (place(stream.flag_port()), stream.ready_port().and_then(place)) else {
            return 0;
        };
        self.rows.iter().filter(|row| row[valid] != 0 && row[ready] != 0).count()
    }

    /// A vector a line, as `$readmemh` reads it.
    #[must_use]
    pub fn hexadecimal(&self) -> String {
        let mut text = String::new();
        for row in &self.rows {
            let bits: Vec<bool> = self.ports.iter().zip(row).flat_map(|(port, word)| bits(port, *word)).collect();
            for digit in bits.chunks(4).rev() {
                let value = digit.iter().rev().fold(0_u8, |value, bit| value << 1 | u8::from(*bit));
                write!(text, "{value:x}").expect("a string can be written");
            }
            text.push('\n');
        }
        text
    }
}

fn bits(port: &Port, word: u64) -> impl Iterator<Item = bool> + use<> {
    (0..port.width).map(move |bit| word >> bit & 1 != 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_has_its_first_port_in_its_lowest_bits() {
        let port = |name: &str, width, direction| Port { name: name.into(), width, direction };
        let mut recording = Recording::new(vec![
            port("in_valid", 1, Direction::Input),
            port("in_data", 7, Direction::Input),
            port("in_ready", 1, Direction::Output),
        ]);
        let stream = StreamDeclaration::stream("in", rtl::Direction::Input, ["data"]);
        recording.push(&[1, 0x55], &[1]);
        recording.push(&[1, 0], &[0]);
        assert_eq!((recording.width(), recording.cycles(), recording.transfers(&stream)), (9, 2, 1));
        assert_eq!(recording.hexadecimal(), "1ab\n001\n");
    }
}
