//! What the tests of the bus units share: pins by name, however wide, and channels that stall and hold both sides to the protocol.

pub mod host;
pub mod searched;
pub mod tally;

use std::collections::{HashMap, VecDeque};

use pointcore_contract::bus::{ChannelIn, ChannelOut, VALID};
use pointcore_contract::unit::{In, Out, READY};
use pointcore_contract::{Field, Record, fields};
use pointcore_tb::lockstep::{RESET_CYCLES, Stall, Stalls};
use pointcore_tb::verilated::{
    Direction, Port, RESET, StreamDeclaration, VerilatedError, VerilatedModel, VerilogSource,
};
use rtl::{Module, cat};

use crate::support;

/// Bits of a word that crosses to the hardware.
const WORD_BITS: u32 = 64;
/// No test of a unit or a top takes as many.
const CYCLES_MAX: u64 = 4_000_000;
/// Cycles before the reset, at most.
const SENSELESS_CYCLES: u32 = 200;
/// Runs of one configuration.
pub const SEEDS: u64 = 30;

/// A unit, with ports that are wider than a word split into words `<port>_0`, `<port>_1` …, lowest first.
fn narrow(unit: Module) -> VerilogSource {
    let inner = support::elaborated(&unit);
    let mut m = Module::new("bus_shell", "A unit whose ports fit words.");
    let inside = m.instance("unit", unit);
    let mut split = HashMap::new();
    for Port { name, width, direction } in
        inner.ports().iter().filter(|port| !["clk", "rst"].contains(&port.name.as_str()))
    {
        let words = (0..width.div_ceil(WORD_BITS)).map(|word| {
            let bits = (width - word * WORD_BITS).min(WORD_BITS);
            (if *width > WORD_BITS { format!("{name}_{word}") } else { name.clone() }, word * WORD_BITS, bits)
        });
        split.insert(name.as_str(), words.clone().map(|(word, ..)| word).collect::<Vec<_>>());
        match direction {
            Direction::Input => {
                let words: Vec<_> = words.map(|(word, _, bits)| m.input(&word, bits)).collect();
                m.connect(inside, name, cat(words.into_iter().rev()));
            }
            Direction::Output => {
                let value = m.out(inside, name);
                words.for_each(|(word, low, bits)| m.output(&word, value.bits(low + bits - 1, low)));
            }
        }
    }
    let words = |stream: &StreamDeclaration| {
        let fields = stream.field_ports().flat_map(|port| split[port.as_str()].clone());
        let fields = fields.map(|port| port[stream.name.len() + 1..].to_owned()).collect();
        StreamDeclaration { fields, ..stream.clone() }
    };
    VerilogSource {
        streams: inner.streams().iter().map(words).collect(),
        ..VerilogSource::from(&support::elaborated(&m))
    }
}

/// A unit at work.
pub struct Bench {
    model: VerilatedModel,
    inputs: Vec<u64>,
    outputs: Vec<u64>,
    /// Cycles since the reset.
    pub cycle: u64,
}

impl Bench {
    /// A unit after a reset that found it in the middle of anything.
    pub fn new(unit: Module, seed: u64) -> Self {
        let library = support::build(&narrow(unit));
        let mut model = library.instantiate(seed);
        let (mut inputs, mut outputs) = (vec![0; library.inputs().len()], vec![0; library.outputs().len()]);
        let mut random = fastrand::Rng::with_seed(seed);
        model.reset(RESET_CYCLES).unwrap();
        for _ in 0..random.u32(..SENSELESS_CYCLES) {
            let sides = inputs.iter_mut().zip(library.inputs()).filter(|(_, port)| port.name != RESET);
            sides.for_each(|(input, port)| *input = random.u64(..) >> (WORD_BITS - port.width));
            match model.step(&inputs, &mut outputs) {
                Ok(()) => {}
                // An assertion may object to what makes no sense.
                Err(VerilatedError::Stopped(_)) => {
                    model = library.instantiate(seed);
                    break;
                }
                Err(error) => panic!("{error}"),
            }
        }
        inputs
            .iter_mut()
            .zip(library.inputs())
            .filter(|(_, port)| port.name == RESET)
            .for_each(|(input, _)| *input = 1);
        (0..RESET_CYCLES).for_each(|_| model.step(&inputs, &mut outputs).unwrap());
        Self { inputs: vec![0; inputs.len()], outputs, model, cycle: 0 }
    }

    /// The places of a port's words.
    fn places(&self, name: &str, direction: Direction) -> Vec<usize> {
        let library = self.model.library();
        let side = if direction == Direction::Input { library.inputs() } else { library.outputs() };
        let place = |name: &str| side.iter().position(|port| port.name == name);
        let words = || (0..).map_while(|word| place(&format!("{name}_{word}"))).collect::<Vec<_>>();
        let places = place(name).map_or_else(words, |place| vec![place]);
        assert!(!places.is_empty(), "no {direction:?} {name}");
        places
    }

    /// Sets an input of at most a word.
    pub fn set(&mut self, name: &str, value: u64) {
        let place = self.places(name, Direction::Input)[0];
        self.inputs[place] = value;
    }

    /// An output of at most a word, as it was in the last cycle.
    pub fn get(&self, name: &str) -> u64 {
        self.outputs[self.places(name, Direction::Output)[0]]
    }

    /// One cycle.
    pub fn step(&mut self) {
        let Self { model, inputs, outputs, cycle } = self;
        model.step(inputs, outputs).unwrap_or_else(|error| panic!("cycle {cycle}: {error}"));
        self.cycle += 1;
        assert!(self.cycle < CYCLES_MAX, "the unit is stuck");
    }
}

/// The words of so many bytes.
pub fn words(bytes: &[u8]) -> Vec<u64> {
    let word = |chunk: &[u8]| chunk.iter().rev().fold(0, |word, byte| word << 8 | u64::from(*byte));
    bytes.chunks(WORD_BITS as usize / 8).map(word).collect()
}

/// The bytes of words, so many.
pub fn bytes(words: &[u64], count: usize) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).take(count).collect()
}

/// A pattern of stalls, one of several.
pub fn stalls(random: &mut fastrand::Rng) -> Stalls {
    let patterns = [Stall::Never, Stall::Random(0.3), Stall::Random(0.8), Stall::Bursts(20)];
    let pattern = patterns[random.usize(..patterns.len())];
    Stalls::new(pattern, random.fork())
}

/// Ports with `valid` and `ready`, as the contract has them.
pub trait Carrier {
    /// What the fields depend on.
    type Config;

    /// The name of a port.
    fn port(&self, part: &str) -> String;

    /// What is carried.
    fn fields(config: &Self::Config) -> Vec<Field>;
}

macro_rules! carriers {
    ($($carrier:ident),*) => {
        $(impl<R: Record> Carrier for $carrier<R> {
            type Config = R::Config;

            fn port(&self, part: &str) -> String {
                $carrier::port(self, part)
            }

            fn fields(config: &R::Config) -> Vec<Field> {
                fields::<R>(config)
            }
        })*
    };
}

carriers!(In, Out, ChannelIn, ChannelOut);

/// The places of a carrier's ports: `valid`, `ready`, fields.
fn places<C: Carrier>(
    bench: &Bench,
    carrier: &C,
    config: &C::Config,
    forward: Direction,
) -> (usize, usize, Vec<usize>) {
    let backward = if forward == Direction::Input { Direction::Output } else { Direction::Input };
    let fields = C::fields(config);
    let fields = fields.iter().flat_map(|field| bench.places(&carrier.port(&field.name), forward)).collect();
    (bench.places(&carrier.port(VALID), forward)[0], bench.places(&carrier.port(READY), backward)[0], fields)
}

/// What flows into a unit.
pub struct Feed {
    valid: usize,
    ready: usize,
    fields: Vec<usize>,
    limits: Vec<u64>,
    stalls: Stalls,
    noise: fastrand::Rng,
    offering: bool,
    /// What is still to come, the words of its fields side by side.
    pub items: VecDeque<Vec<u64>>,
}

impl Feed {
    /// Into these ports.
    pub fn new<C: Carrier>(
        bench: &Bench,
        carrier: C,
        config: &C::Config,
        random: &mut fastrand::Rng,
        stalls: Stalls,
    ) -> Self {
        let (valid, ready, fields) = places(bench, &carrier, config, Direction::Input);
        let inputs = bench.model.library().inputs();
        let limits = fields.iter().map(|&field| u64::MAX >> (WORD_BITS - inputs[field].width)).collect();
        let noise = random.fork();
        Self { valid, ready, fields, limits, stalls, noise, offering: false, items: VecDeque::new() }
    }

    /// Before a cycle: an offer once made stands, and where there is none the fields are noise.
    pub fn offer(&mut self, bench: &mut Bench) {
        if self.offering {
            return;
        }
        let item = self.items.front().filter(|_| !self.stalls.stalled());
        self.offering = item.is_some();
        bench.inputs[self.valid] = u64::from(self.offering);
        for (place, &field) in self.fields.iter().enumerate() {
            bench.inputs[field] = item.map_or_else(|| self.noise.u64(0..=self.limits[place]), |item| item[place]);
        }
    }

    /// What has not been taken is not sent, as after a reset of whoever sends.
    pub fn cease(&mut self, bench: &mut Bench) {
        self.items.clear();
        self.offering = false;
        bench.inputs[self.valid] = 0;
    }

    /// After a cycle: what was taken in it.
    pub fn taken(&mut self, bench: &Bench) -> Option<Vec<u64>> {
        let taken = self.offering && bench.outputs[self.ready] == 1;
        self.offering &= !taken;
        if taken { self.items.pop_front() } else { None }
    }
}

/// What flows out of a unit.
pub struct Drain {
    valid: usize,
    ready: usize,
    fields: Vec<usize>,
    stalls: Stalls,
    offered: Option<Vec<u64>>,
}

impl Drain {
    /// Out of these ports.
    pub fn new<C: Carrier>(bench: &Bench, carrier: C, config: &C::Config, stalls: Stalls) -> Self {
        let (valid, ready, fields) = places(bench, &carrier, config, Direction::Output);
        Self { valid, ready, fields, stalls, offered: None }
    }

    /// Before a cycle.
    pub fn offer(&mut self, bench: &mut Bench) {
        bench.inputs[self.ready] = u64::from(!self.stalls.stalled());
    }

    /// Before a cycle in which nothing is taken.
    pub fn wait(&self, bench: &mut Bench) {
        bench.inputs[self.ready] = 0;
    }

    /// After a cycle: what was taken in it. What is offered stands until then.
    pub fn taken(&mut self, bench: &Bench) -> Option<Vec<u64>> {
        let item = || self.fields.iter().map(|&field| bench.outputs[field]).collect();
        let item: Option<Vec<u64>> = (bench.outputs[self.valid] == 1).then(item);
        if self.offered.is_some() {
            assert_eq!(item, self.offered, "cycle {}: an offer changed", bench.cycle);
        }
        let taken = bench.inputs[self.ready] == 1;
        self.offered = if taken { None } else { item.clone() };
        item.filter(|_| taken)
    }
}
