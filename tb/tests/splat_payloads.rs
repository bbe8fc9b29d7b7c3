//! `splat_payloads` against its model, in every cycle, with copies that come back in another order.

use std::collections::{HashMap, VecDeque};

use pointcore_contract::splat::config::PayloadStore;
use pointcore_contract::splat::records::{CompleteCopy, PayloadWord, PlacedCopy, SplatCopy, StoredWord, TileCopy};
use pointcore_contract::splat::{Config, units};
use pointcore_contract::{read, words};
use pointcore_golden::splat::Payloads;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::payloads;
use pointcore_tb::lockstep::{Flow, Run, Stall, Stalls, Stimulus, StreamPorts, Streams, seeds};

use crate::splat::{Device, configs, offer, scene};
use crate::support::cases;

const SPLATS: u32 = 400;
const SEEDS: u64 = 12;

/// The memory of payloads, and what is on its way from there.
#[derive(Clone)]
struct Memory {
    write: StreamPorts,
    data: StreamPorts,
    /// By place; a payload begins with its first word.
    words: HashMap<u16, Vec<PayloadWord>>,
    asked: VecDeque<PayloadWord>,
    stalls: [Stalls; 2],
}

impl Memory {
    fn step(&mut self, config: &Config, outputs: &[u64], inputs: &mut [u64]) {
        if self.write.transfers(inputs, outputs) {
            let fields: Vec<_> = self.write.fields.iter().map(|&field| outputs[field]).collect();
            let StoredWord { splat, word, value } = read(config, &fields);
            let words = self.words.entry(splat).or_default();
            words.truncate(word.into());
            words.push(value);
        }
        let [write, data] = self.stalls.each_mut().map(Stalls::stalled);
        if !self.data.offers(inputs, outputs) || self.data.transfers(inputs, outputs) {
            let word = if data { None } else { self.asked.pop_front() };
            offer(&self.data, inputs, word.map(|word| words(config, word)));
        }
        inputs[self.write.ready.expect("the stream has one")] = u64::from(!write);
    }
}

/// Sends copies in, and those that come out in another order back in.
#[derive(Clone)]
struct Shuffled {
    config: Config,
    input: StreamPorts,
    copy: StreamPorts,
    placed: StreamPorts,
    out: StreamPorts,
    random: fastrand::Rng,
    copies: std::vec::IntoIter<SplatCopy>,
    /// Copies between the two sides, and as many as have room there.
    between: Vec<TileCopy>,
    room: usize,
    filled: bool,
    /// Copies in all.
    count: usize,
    received: Vec<CompleteCopy>,
    /// Ends of frames, which do not come back.
    ends: usize,
    stalls: [Stalls; 4],
    memory: Option<Memory>,
}

impl Shuffled {
    fn new(config: &Config, streams: &Streams, copies: &[SplatCopy], seed: u64) -> Self {
        let stream = |name| streams.get(name).expect("payloads have it").clone();
        let kinds = [
            [Stall::Never; 4],
            [Stall::Random(0.5); 4],
            [Stall::Never, Stall::Never, Stall::Bursts(40), Stall::Random(0.3)],
            [Stall::Bursts(40), Stall::Random(0.2), Stall::Never, Stall::Never],
            [Stall::Never, Stall::Never, Stall::Never, Stall::Random(0.8)],
            [Stall::Varied; 4],
        ];
        let mut random = fastrand::Rng::with_seed(seed);
        let memory_stalls = [(); 2].map(|()| Stalls::new(kinds[(seed / 2) as usize % kinds.len()][0], random.fork()));
        let memory = config.has_payloads_in_memory().then(|| Memory {
            write: stream("write"),
            data: stream("data"),
            words: HashMap::new(),
            asked: VecDeque::new(),
            stalls: memory_stalls,
        });
        Self {
            memory,
            config: config.clone(),
            input: stream("in"),
            copy: stream("copy"),
            placed: stream("placed"),
            out: stream("out"),
            copies: Vec::from(copies).into_iter(),
            between: vec![],
            room: random.usize(1..40),
            filled: false,
            count: copies.len(),
            received: vec![],
            ends: 0,
            stalls: kinds[seed as usize % kinds.len()].map(|stall| Stalls::new(stall, random.fork())),
            random,
        }
    }

    /// One of those between, with a slot.
    fn pick(&mut self) -> Option<PlacedCopy> {
        let index = (!self.between.is_empty()).then(|| self.random.usize(..self.between.len()))?;
        let TileCopy { bounds, diagonals, tile, splat, .. } = self.between.remove(index);
        let slot = self.random.u8(..self.config.tile_slots as u8);
        if let Some(Memory { words, asked, .. }) = &mut self.memory {
            asked.extend(words.get(&splat).into_iter().flatten());
        }
        Some(PlacedCopy { bounds, diagonals, tile, splat, slot })
    }
}

impl Stimulus for Shuffled {
    fn drive(&mut self, _cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let fields = |stream: &StreamPorts| stream.fields.iter().map(|&field| outputs[field]).collect::<Vec<_>>();
        if self.copy.transfers(inputs, outputs) {
            let copy: TileCopy = read(&self.config, &fields(&self.copy));
            self.ends += usize::from(copy.end);
            self.between.extend(Some(copy).filter(|copy| !copy.end));
            self.filled |= self.between.len() == self.room;
        }
        if self.out.transfers(inputs, outputs) {
            self.received.push(read(&self.config, &fields(&self.out)));
        }
        let [source, copy_sink, placed_source, sink] = self.stalls.each_mut().map(Stalls::stalled);
        let is_free =
            |stream: &StreamPorts, inputs: &[u64]| !stream.offers(inputs, outputs) || stream.transfers(inputs, outputs);
        if is_free(&self.input, inputs) {
            let copy = if source { None } else { self.copies.next() };
            offer(&self.input, inputs, copy.map(|copy| words(&self.config, copy)));
        }
        if is_free(&self.placed, inputs) {
            let copy = if placed_source { None } else { self.pick() };
            offer(&self.placed, inputs, copy.map(|copy| words(&self.config, copy)));
        }
        if let Some(memory) = &mut self.memory {
            memory.step(&self.config, outputs, inputs);
        }
        let has_room = self.between.len() < self.room;
        let [copy_ready, out_ready] = [&self.copy, &self.out].map(|stream| stream.ready.expect("the stream has one"));
        inputs[copy_ready] = u64::from(has_room && !copy_sink);
        inputs[out_ready] = u64::from(!sink);
        if self.received.len() + self.ends == self.count { Flow::Done } else { Flow::Continue }
    }
}

/// Splats of noise with a few copies, some with more, some with one for each tile; here and there the end of a frame, once two of them.
fn copies(config: &Config) -> Vec<SplatCopy> {
    let mut random = scene::random();
    let mut copies = Vec::new();
    for splat in 0..SPLATS {
        let payload: SplatCopy = scene::noise(config, &mut random);
        let tiles = 1 << config.tile_bits();
        let count = match splat % 64 {
            7 => tiles,
            23 | 55 => random.u32(1..=tiles),
            _ => random.u32(1..5),
        };
        for number in 0..count {
            let SplatCopy { bounds, diagonals, tile, .. } = scene::noise(config, &mut random);
            copies.push(SplatCopy { end: false, first: number == 0, bounds, diagonals, tile, ..payload });
        }
        if splat % 50 == 49 || [80, 81].contains(&splat) {
            let ends = if splat == 81 { 2 } else { 1 };
            copies.extend((0..ends).map(|_| SplatCopy { end: true, ..scene::noise(config, &mut random) }));
        }
    }
    copies
}

/// What a copy is known by.
type Identity = Vec<u64>;

/// Copies with their payload, sorted.
fn sorted(config: &Config, copies: &[CompleteCopy]) -> Vec<Identity> {
    let known = |copy: &CompleteCopy| words(config, CompleteCopy { slot: 0, ..*copy });
    let mut copies: Vec<_> = copies.iter().map(known).collect();
    copies.sort();
    copies
}

/// The configurations of every unit's test and more, with few places and many words and the other way round.
fn sizes() -> Vec<Config> {
    let [bare, full, mixed] = configs();
    let sized = |config: &Config, splat_levels, payload_beats| Config { splat_levels, payload_beats, ..config.clone() };
    let in_memory = |config: Config, payload_ahead| Config { payload: PayloadStore::Memory, payload_ahead, ..config };
    vec![
        in_memory(sized(&bare, 0, 1), 1),
        in_memory(sized(&full, 2, 3), 4),
        in_memory(sized(&mixed, 4, 8), 16),
        sized(&bare, 0, 1),
        sized(&full, 0, 3),
        sized(&mixed, 1, 2),
        sized(&bare, 2, 8),
        sized(&full, 3, 4),
        sized(&mixed, 4, 1),
        sized(&bare, 5, 2),
        sized(&mixed, 2, 5),
        sized(&full, 1, 7),
    ]
}

#[test]
fn it_agrees_with_the_model() {
    for config in cases(sizes()) {
        let mut filled = 0;
        let device = Device::new(&config, &payloads::module(&config), &units::payloads::UNIT);
        let streams = Streams::of(device.library());
        let copies = copies(&config);
        let complete: Vec<_> = copies.iter().filter(|copy| !copy.end).map(complete).collect();
        for seed in seeds(SEEDS).expect("POINTCORE_SEED is a number") {
            let stimulus = Shuffled::new(&config, &streams, &copies, seed);
            let run = device.lockstep(Ported::new(&config, Payloads::new(&config)), seed).run(stimulus);
            let Run { stimulus, .. } = run.unwrap_or_else(|error| panic!("{error}"));
            let [expected, received] = [&complete, &stimulus.received].map(|copies| sorted(&config, copies));
            assert!(expected == received, "seed {seed}: every copy has its payload");
            filled += usize::from(stimulus.filled);
        }
        assert!(filled > 0, "what lies between was never full");
    }
}

/// What comes out for a copy.
fn complete(copy: &SplatCopy) -> CompleteCopy {
    let SplatCopy { footprint, moving, attributes, bounds, diagonals, tile, .. } = *copy;
    CompleteCopy { footprint, moving, attributes, bounds, diagonals, tile, slot: 0 }
}
