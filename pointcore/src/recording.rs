//! What a golden model did at its ports in every cycle, as vectors for a test.

use pointcore_contract::{Direction, Port, Unit, count, read, write};
use pointcore_golden::unit::{Model, Ported, Unit as _};
use pointcore_tb::lockstep::{Flow, Stimulus};
use rtl::StreamDeclaration;
use std::iter;

/// The words of every port in every cycle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recording {
    ports: Vec<Port>,
    rows: Vec<Vec<u64>>,
}

impl Recording {
    /// An empty recording at these ports.
    #[must_use]
    pub fn new(ports: Vec<Port>) -> Self {
        Self { ports, rows: Vec::new() }
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

    /// Cycles in which a stream's item changes hands: one that is always taken has no port that says so.
    #[must_use]
    pub fn transfers(&self, stream: &StreamDeclaration) -> usize {
        let agreed: Vec<_> = iter::once(stream.flag_port()).chain(stream.ready_port()).collect();
        let place = |name: &String| self.ports.iter().position(|port| port.name == *name);
        let Some(places) = agreed.iter().map(place).collect::<Option<Vec<_>>>() else { return 0 };
        self.rows.iter().filter(|row| places.iter().all(|&place| row[place] != 0)).count()
    }

    /// The ports that change together, each group with the port that says whether it counts: the fields of each stream with
    /// its flag, and before them, without one, all other ports, first those of one bit, which change often.
    #[must_use]
    pub fn groups(&self, streams: &[StreamDeclaration]) -> Vec<Group> {
        let place = |name: &str| self.ports.iter().position(|port| port.name == name).expect("the core has the port");
        let of_stream = |stream: &StreamDeclaration| {
            let members: Vec<_> = stream.field_ports().map(|name| place(&name)).collect();
            Group { members, flag: Some(place(&stream.flag_port())) }
        };
        let fields: Vec<_> = streams.iter().map(of_stream).filter(|group| !group.members.is_empty()).collect();
        let is_field = |port: &usize| fields.iter().any(|group| group.members.contains(port));
        let (bits, words): (Vec<_>, Vec<_>) =
            (0..self.ports.len()).filter(|port| !is_field(port)).partition(|port| self.ports[*port].width == 1);
        let others = [bits, words].into_iter().filter(|members| !members.is_empty());
        others.map(|members| Group { members, flag: None }).chain(fields).collect()
    }

    /// The recording as a sequence of bits: in every cycle a bit, whether anything changes, and if so a bit for each group,
    /// whether it does, then the new words of those that do, lowest bits first. A group that does not count keeps its words.
    #[must_use]
    pub fn encode(&self, groups: &[Group]) -> BitSequence {
        let mut sequence = BitSequence::default();
        let mut shown: Vec<u64> = vec![0; self.ports.len()];
        for row in &self.rows {
            let changes = |group: &&Group| {
                let counts = group.flag.is_none_or(|flag| row[flag] != 0);
                counts && group.members.iter().any(|&port| row[port] != shown[port])
            };
            let is_change = groups.iter().any(|group| changes(&group));
            sequence.push(u64::from(is_change), 1);
            if !is_change {
                continue;
            }
            groups.iter().for_each(|group| sequence.push(u64::from(changes(&group)), 1));
            let changed: Vec<_> = groups.iter().filter(changes).flat_map(|group| &group.members).copied().collect();
            for port in changed {
                sequence.push(row[port], self.ports[port].width);
                shown[port] = row[port];
            }
        }
        sequence
    }
}

/// A golden model, of which every cycle is recorded.
#[derive(Clone, Debug)]
pub struct Recorder<M: Model> {
    config: M::Config,
    golden: Ported<M>,
    inputs: Vec<u64>,
    outputs: Vec<u64>,
    recording: Recording,
}

impl<M: Model> Recorder<M> {
    /// Begins with a model in its initial state, as a reset leaves it.
    pub fn new(config: &M::Config, unit: &Unit<M::Config>, model: M) -> Self {
        let list = unit.ports(config);
        let (inputs, outputs) = count(&list);
        let (inputs, outputs) = (vec![0; inputs], vec![0; outputs]);
        Self {
            config: config.clone(),
            golden: Ported::new(config, model),
            inputs,
            outputs,
            recording: Recording::new(list),
        }
    }

    /// A cycle with what the inputs hold.
    pub fn clock(&mut self) {
        self.golden.step(&self.inputs, &mut self.outputs);
        self.recording.push(&self.inputs, &self.outputs);
    }

    /// A cycle of reset, in which all other inputs are low; they stay so.
    pub fn reset(&mut self) {
        self.inputs.fill(0);
        // It is the first of the inputs.
        self.inputs[0] = 1;
        self.clock();
        self.inputs[0] = 0;
    }

    /// A cycle, unless the host is done.
    pub fn drive(&mut self, cycle: u64, host: &mut impl Stimulus) -> Flow {
        let flow = host.drive(cycle, &self.outputs, &mut self.inputs);
        if flow == Flow::Continue {
            self.clock();
        }
        flow
    }

    /// A cycle without reset in which the unit sees this; returns what it shows.
    pub fn step(&mut self, seen: &M::In) -> M::Out {
        write(&self.config, *seen, &mut self.inputs[1..]);
        self.clock();
        read(&self.config, &self.outputs)
    }

    /// What it did.
    #[must_use]
    pub fn into_recording(self) -> Recording {
        self.recording
    }
}

/// Ports that change together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// Their places among the recording's ports.
    pub members: Vec<usize>,
    /// The port without which they mean nothing.
    pub flag: Option<usize>,
}

/// Bits, one after the other.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct BitSequence {
    words: Vec<u64>,
    bits: usize,
}

impl BitSequence {
    /// Bits of a line.
    pub const WORD_BITS: usize = 64;

    fn push(&mut self, word: u64, width: u32) {
        for bit in 0..width {
            if self.bits.is_multiple_of(Self::WORD_BITS) {
                self.words.push(0);
            }
            let place = self.bits % Self::WORD_BITS;
            *self.words.last_mut().expect("one was pushed before the first bit") |= (word >> bit & 1) << place;
            self.bits += 1;
        }
    }

    /// Number of lines.
    #[must_use]
    pub fn lines(&self) -> usize {
        self.words.len()
    }

    /// A word a line, as `$readmemh` reads it; the first bit is the lowest of the first line.
    #[must_use]
    pub fn hexadecimal(&self) -> String {
        self.words.iter().map(|word| format!("{word:016x}\n")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_changes_and_counts_is_kept() {
        let port = |name: &str, width, direction| Port { name: name.into(), width, direction };
        let mut recording = Recording::new(vec![
            port("in_valid", 1, Direction::Input),
            port("in_data", 7, Direction::Input),
            port("in_ready", 1, Direction::Output),
        ]);
        let stream = StreamDeclaration::stream("in", rtl::Direction::Input, ["data"]);
        recording.push(&[1, 0x55], &[1]);
        recording.push(&[0, 3], &[1]);
        recording.push(&[0, 4], &[1]);
        assert_eq!((recording.width(), recording.cycles(), recording.transfers(&stream)), (9, 3, 1));
        let groups = recording.groups(&[stream]);
        assert_eq!(groups, [Group { members: vec![0, 2], flag: None }, Group { members: vec![1], flag: Some(0) }]);
        // Both, `in_valid` and `in_ready`, `in_data`; the first alone; none.
        let bits = ["1", "11", "11", "1010101", "1", "10", "01", "0"].concat();
        let value = u64::from_str_radix(&bits.chars().rev().collect::<String>(), 2);
        assert_eq!(recording.encode(&groups).hexadecimal(), format!("{:016x}\n", value.unwrap_or_default()));
    }
}
