//! Stalling sources and sinks around every stream of a unit.

use super::stall::{Stall, Stalls};
use super::stimulus::{Flow, Stimulus};
use super::stream::{StreamPorts, Streams};
use crate::verilated::{Direction, Library, Port};

/// Cycles without a transfer, after the last item went in, that end a run; longer than any stall pattern in use.
const DEFAULT_QUIET_CYCLES: u64 = 200;

/// Why a testbench does not fit the hardware.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TestbenchError {
    /// No such stream, or it points the other way.
    #[error("the hardware has no {direction:?} stream `{name}`; its streams are {present}")]
    NoStream {
        /// The name asked for.
        name: String,
        /// The direction asked for.
        direction: Direction,
        /// What there is.
        present: String,
    },
    /// No such input.
    #[error("the hardware has no input `{name}`")]
    NoInput {
        /// The name asked for.
        name: String,
    },
    /// An item has not one value a field.
    #[error("item {item} of stream `{stream}` has {found} values for {fields} fields")]
    Fields {
        /// The stream.
        stream: String,
        /// Index of the item.
        item: usize,
        /// Values it has.
        found: usize,
        /// Fields of the stream.
        fields: usize,
    },
    /// A value is wider than its port.
    #[error("{value:#x} does not fit the {width} bits of `{port}`")]
    TooWide {
        /// The port.
        port: String,
        /// Its width.
        width: u32,
        /// The value.
        value: u64,
    },
}

/// Feeds items to the hardware's input streams, collects those of its output streams, and is done when everything is in
/// and nothing has moved for a while.
#[derive(Debug, Clone)]
pub struct StreamTestbench {
    inputs: Vec<Port>,
    streams: Streams,
    random: fastrand::Rng,
    sources: Vec<Source>,
    sinks: Vec<Sink>,
    constants: Vec<(usize, u64)>,
    quiet_cycles: u64,
    quiet: u64,
}

/// Feeds one stream. The item on offer stays until it is taken.
#[derive(Debug, Clone)]
struct Source {
    stream: StreamPorts,
    items: Vec<Vec<u64>>,
    next: usize,
    offering: bool,
    stalls: Stalls,
    /// What the fields hold while there is no item; a unit that looks at it is wrong.
    noise: fastrand::Rng,
    /// Largest value of each field.
    field_limits: Vec<u64>,
}

/// Collects one stream.
#[derive(Debug, Clone)]
struct Sink {
    stream: StreamPorts,
    items: Vec<Vec<u64>>,
    stalls: Stalls,
}

impl StreamTestbench {
    /// Around instances of `library`; `seed` decides all stalls.
    #[must_use]
    pub fn new(library: &Library, seed: u64) -> Self {
        Self {
            inputs: library.inputs().to_vec(),
            streams: Streams::of(library),
            random: fastrand::Rng::with_seed(seed),
            sources: Vec::new(),
            sinks: Vec::new(),
            constants: Vec::new(),
            quiet_cycles: DEFAULT_QUIET_CYCLES,
            quiet: 0,
        }
    }

    /// Feeds `items`, one value a field in the order of the ports, to the input stream `name`.
    ///
    /// # Errors
    /// When there is no such stream or an item does not fit it.
    pub fn source(mut self, name: &str, items: Vec<Vec<u64>>, stall: Stall) -> Result<Self, TestbenchError> {
        let stream = self.stream(name, Direction::Input)?;
        for (item, values) in items.iter().enumerate() {
            let (found, fields) = (values.len(), stream.fields.len());
            if found != fields {
                return Err(TestbenchError::Fields { stream: stream.name, item, found, fields });
            }
            stream.fields.iter().zip(values).try_for_each(|(&field, &value)| fits(&self.inputs[field], value))?;
        }
        let stalls = Stalls::new(stall, self.random.fork());
        let noise = self.random.fork();
        let field_limits = stream.fields.iter().map(|&field| largest(&self.inputs[field])).collect();
        self.sources.push(Source { stream, items, next: 0, offering: false, stalls, noise, field_limits });
        Ok(self)
    }

    /// Collects the items of the output stream `name`.
    ///
    /// # Errors
    /// When there is no such stream.
    pub fn sink(mut self, name: &str, stall: Stall) -> Result<Self, TestbenchError> {
        let stream = self.stream(name, Direction::Output)?;
        let stalls = Stalls::new(stall, self.random.fork());
        self.sinks.push(Sink { stream, items: Vec::new(), stalls });
        Ok(self)
    }

    /// Holds the input `name` at `value`.
    ///
    /// # Errors
    /// When there is no such input or the value does not fit it.
    pub fn constant(mut self, name: &str, value: u64) -> Result<Self, TestbenchError> {
        let position = self.inputs.iter().position(|port| port.name == name);
        let position = position.ok_or_else(|| TestbenchError::NoInput { name: name.to_owned() })?;
        fits(&self.inputs[position], value)?;
        self.constants.push((position, value));
        Ok(self)
    }

    /// The number of cycles without transfer that ends the run; more than the unit's longest silence.
    #[must_use]
    pub fn quiet_cycles(mut self, cycles: u64) -> Self {
        self.quiet_cycles = cycles;
        self
    }

    /// What the sink of stream `name` has collected; nothing where there is no such sink.
    #[must_use]
    pub fn collected(&self, name: &str) -> &[Vec<u64>] {
        self.sinks.iter().find(|sink| sink.stream.name == name).map_or(&[], |sink| &sink.items)
    }

    fn stream(&self, name: &str, direction: Direction) -> Result<StreamPorts, TestbenchError> {
        let found = self.streams.get(name).filter(|stream| stream.direction == direction);
        found.cloned().ok_or_else(|| {
            let present: Vec<_> = self.streams.iter().map(|stream| stream.name.as_str()).collect();
            TestbenchError::NoStream { name: name.to_owned(), direction, present: present.join(", ") }
        })
    }
}

impl Stimulus for StreamTestbench {
    fn drive(&mut self, _cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let mut moved = false;
        for sink in &mut self.sinks {
            if sink.stream.transfers(inputs, outputs) {
                moved = true;
                sink.items.push(sink.stream.fields.iter().map(|&field| outputs[field]).collect());
            }
            if let Some(ready) = sink.stream.ready {
                inputs[ready] = u64::from(!sink.stalls.stalled());
            }
        }
        for source in &mut self.sources {
            if source.offering && source.stream.transfers(inputs, outputs) {
                moved = true;
                source.offering = false;
                source.next += 1;
            }
            source.offer(inputs);
        }
        for &(position, value) in &self.constants {
            inputs[position] = value;
        }
        let fed = self.sources.iter().all(|source| source.next == source.items.len());
        self.quiet = if moved || !fed { 0 } else { self.quiet + 1 };
        if self.quiet > self.quiet_cycles { Flow::Done } else { Flow::Continue }
    }
}

impl Source {
    /// Sets the inputs of the next cycle.
    fn offer(&mut self, inputs: &mut [u64]) {
        let fields = self.stream.fields.iter();
        if !self.offering && self.next < self.items.len() && !self.stalls.stalled() {
            self.offering = true;
            fields.zip(&self.items[self.next]).for_each(|(&field, &value)| inputs[field] = value);
        } else if !self.offering {
            fields.zip(&self.field_limits).for_each(|(&field, &limit)| inputs[field] = self.noise.u64(0..=limit));
        }
        inputs[self.stream.valid] = u64::from(self.offering);
    }
}

/// The largest value of a port.
fn largest(port: &Port) -> u64 {
    u64::MAX >> (64 - port.width)
}

fn fits(port: &Port, value: u64) -> Result<(), TestbenchError> {
    if value > largest(port) {
        return Err(TestbenchError::TooWide { port: port.name.clone(), width: port.width, value });
    }
    Ok(())
}
