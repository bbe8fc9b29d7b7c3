//! `splat_heap` against its model, in every cycle.

use pointcore_contract::splat::records::HeapEntry;
use pointcore_contract::splat::{Config, units};
use pointcore_contract::words;
use pointcore_golden::splat::Heap;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::heap;
use pointcore_tb::lockstep::{
    Flow, Recorded, Run, Stall, Stalls, Stimulus, StreamPorts, StreamTestbench, Streams, seeds,
};

use crate::splat::{Device, RUNS, scene, stalls};

const ENTRIES: usize = 6000;
/// A tile from which others differ in one bit.
const COMMON: u32 = 0xa5a5;

/// Entries in bursts: of few tiles, so that many have the same tile and differ in arrival only; of any; and of tiles that
/// differ in one bit from a common one.
fn entries(config: &Config, count: usize, random: &mut fastrand::Rng) -> Vec<HeapEntry> {
    let (tiles, pointers) = (1 << config.tile_bits(), 1 << config.heap_levels);
    let entry = |index: usize| {
        let tile = match index / 32 % 3 {
            0 => random.u32(0..3),
            1 => random.u32(0..tiles),
            _ => (COMMON ^ 1 << random.u32(0..config.tile_bits())) % tiles,
        };
        HeapEntry { tile, pointer: random.u16(0..pointers) }
    };
    (0..count).map(entry).collect()
}

fn sorted(mut entries: Vec<HeapEntry>) -> Vec<HeapEntry> {
    entries.sort_by_key(|entry| (entry.tile, entry.pointer));
    entries
}

/// Entries that pass a heap in four states.
const IN_FOUR_STATES: usize = 600;

/// What nothing has written does not show, not even in the parity of marks.
fn is_known(device: &Device, config: &Config, model: &Heap) {
    for seed in seeds(2).expect("POINTCORE_SEED is a number") {
        let entries = entries(config, IN_FOUR_STATES, &mut fastrand::Rng::with_seed(seed));
        let sent = entries.iter().map(|entry| words(config, *entry)).collect();
        let testbench = StreamTestbench::new(device.library(), seed).source("in", sent, stalls(seed));
        let testbench = testbench.and_then(|testbench| testbench.sink("out", stalls(seed + 1)));
        let recorded = Recorded::new(testbench.unwrap_or_else(|error| panic!("{error}")));
        let run = device.lockstep(Ported::new(config, model.clone()), seed).run(recorded);
        let Run { stimulus, .. } = run.unwrap_or_else(|error| panic!("{error}"));
        stimulus.replay(device.library()).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
    }
}

/// Levels, cycles of an operation, bits of the arrival number and image width: epochs as short as two arrivals, longer ones than
/// the heap is large, one column of tiles and many. Numbers are enough to fill the heap.
#[test]
fn it_agrees_with_the_model_at_every_size() {
    for (heap_levels, heap_interval, sequence_bits, width) in [
        (2, 2, 2, 8),
        (2, 4, 2, 61),
        (3, 2, 3, 61),
        (3, 2, 6, 61),
        (4, 2, 4, 61),
        (4, 4, 7, 61),
        (5, 2, 5, 130),
        (5, 4, 5, 130),
        (7, 2, 9, 61),
    ] {
        let config = Config { heap_levels, heap_interval, width, height: 37, ..Config::default() };
        let device = Device::new(&config, &heap::numbered(&config, sequence_bits), &units::heap::UNIT);
        let model = Heap::numbered(&config, sequence_bits);
        is_known(&device, &config, &model);
        let entries = entries(&config, ENTRIES, &mut scene::random());
        let runs = device.runs(&model, &entries, &[]);
        let reordered = runs.iter().filter(|run| **run != entries).count() as u64;
        // Without stalls every entry leaves at once, and a slow heap lets them with few stalls as well.
        assert!(reordered >= RUNS - u64::from(heap_interval) / 2, "{reordered} runs of {RUNS} were reordered");
        for run in runs {
            assert!(sorted(run) == sorted(entries.clone()), "what leaves is what entered");
        }
    }
}

/// Levels and cycles of an operation of heaps that are filled.
const FILLED: [(u32, u32); 8] = [(3, 2), (4, 4), (5, 2), (7, 4), (10, 2), (10, 4), (12, 2), (12, 4)];
/// Entries that take the places of others in a full heap, at least; so many that their numbers begin anew more than once: whether
/// all of an epoch have left shows when the next one of its kind begins.
const REPLACED: usize = 20_000;
/// Epochs that begin meanwhile; a number's first bit tells one from the next.
const EPOCHS: usize = 4;
/// Quarters of an epoch in which all that enters is of one tile: what is of others stays for longer than numbers are told apart.
const OF_ONE_TILE: usize = 9;
/// Entries that come last, each only where there are few: what moves in a large heap that holds a handful.
const TRICKLED: usize = 4000;
/// As many as there are then at most, with those in the queue behind; by turns there are fewer.
const FEW: usize = 8;
/// Entries that come before there are fewer, or more.
const AS_FEW: usize = 50;
/// Cycles in which a full heap takes nothing, to be sure that it is full: more than an operation takes.
const FULL_CYCLES: u32 = 16;
/// Entries that leave a heap at once, for the queue behind it.
const BEHIND: usize = 2;

/// Fills a heap while nothing leaves it, has others take the places of those that leave, empties it, and has the last ones trickle
/// through.
#[derive(Clone)]
struct Brim {
    input: StreamPorts,
    out: StreamPorts,
    entries: Vec<Vec<u64>>,
    sent: usize,
    received: Vec<Vec<u64>>,
    /// Entries there are at most while they trickle.
    few: usize,
    /// Cycles in which an entry was refused.
    refused: u32,
    /// Entries that were in it when it took no more.
    held: Option<usize>,
    /// Entries that had left it when the last one entered that does not trickle.
    left: Option<usize>,
    stalls: [Stalls; 2],
}

impl Stimulus for Brim {
    fn drive(&mut self, _cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let was_offered = self.input.offers(inputs, outputs);
        let was_taken = was_offered && self.input.transfers(inputs, outputs);
        self.sent += usize::from(was_taken);
        if self.out.transfers(inputs, outputs) {
            self.received.push(self.out.fields.iter().map(|&field| outputs[field]).collect());
        }
        self.refused = if was_offered && !was_taken { self.refused + 1 } else { 0 };
        if self.refused == FULL_CYCLES && self.held.is_none() {
            self.held = Some(self.sent);
        }
        let trickles = self.sent >= self.entries.len() - TRICKLED;
        if trickles {
            self.left.get_or_insert(self.received.len());
        }
        let [source, sink] = &mut self.stalls;
        // It fills as fast as it can, and an offer stands.
        let few = 1 + self.sent / AS_FEW % self.few;
        let are_enough = trickles && self.sent - self.received.len() >= few;
        let is_held_back = (are_enough || source.stalled() && self.held.is_some()) && (!was_offered || was_taken);
        let entry = self.entries.get(self.sent).filter(|_| !is_held_back);
        inputs[self.input.valid] = u64::from(entry.is_some());
        if let Some(entry) = entry {
            self.input.fields.iter().zip(entry).for_each(|(&field, &value)| inputs[field] = value);
        }
        let ready = self.out.ready.expect("the stream has one");
        inputs[ready] = u64::from(!sink.stalled() && self.held.is_some());
        if self.received.len() == self.entries.len() { Flow::Done } else { Flow::Continue }
    }
}

/// The pointers of a tile, in the order of their entries.
fn of_tile(entries: &[Vec<u64>], tile: u64) -> Vec<u64> {
    entries.iter().filter(|entry| entry[0] == tile).map(|entry| entry[1]).collect()
}

/// Heaps of up to 4,095 entries, full, with many of the same tile, or all of it for long, and with few entries; both ends stall.
#[test]
fn heaps_are_filled_to_the_brim_and_emptied() {
    for (heap_levels, heap_interval) in FILLED {
        let config = Config { heap_levels, heap_interval, width: 61, height: 37, ..Config::default() };
        let capacity = config.heap_capacity() as usize;
        let sequence_bits = config.sequence_bits();
        let replaced = REPLACED.max(EPOCHS << (sequence_bits - 1));
        let device = Device::new(&config, &heap::numbered(&config, sequence_bits), &units::heap::UNIT);
        let model = Heap::numbered(&config, sequence_bits);
        is_known(&device, &config, &model);
        let streams = Streams::of(device.library());
        let stream = |name| streams.get(name).expect("a heap has it").clone();
        for seed in seeds(2).expect("POINTCORE_SEED is a number") {
            let mut random = fastrand::Rng::with_seed(seed);
            let mut entries = entries(&config, capacity + BEHIND + replaced + TRICKLED, &mut random);
            let of_one_tile = &mut entries[capacity + BEHIND..][..OF_ONE_TILE << (sequence_bits - 1) >> 2];
            of_one_tile.iter_mut().for_each(|entry| entry.tile = COMMON % (1 << config.tile_bits()));
            let brim = Brim {
                input: stream("in"),
                out: stream("out"),
                entries: entries.iter().map(|entry| vec![entry.tile.into(), entry.pointer.into()]).collect(),
                sent: 0,
                few: FEW.min(capacity / 4),
                received: vec![],
                refused: 0,
                held: None,
                left: None,
                stalls: [Stall::Random(0.1), Stall::Bursts(40)]
                    .map(|stall| Stalls::new(stall, fastrand::Rng::with_seed(seed))),
            };
            let run = device.lockstep(Ported::new(&config, model.clone()), seed).run(brim);
            let Run { stimulus, report } = run.unwrap_or_else(|error| panic!("{error}"));
            let Brim { held, left, entries, received, few, .. } = &stimulus;
            assert_eq!(*held, Some(capacity + BEHIND), "seed {seed}: it holds as many as it should");
            assert!(report.events("empty") > 0, "seed {seed}: it is empty before the first and after the last");
            for tile in 0..1 << config.tile_bits() {
                assert_eq!(of_tile(received, tile), of_tile(entries, tile), "tile {tile}, seed {seed}");
            }
            // What was in it last leaves tile after tile, from wherever it was on, with one turn at most.
            let last = left.expect("all entered") + BEHIND..entries.len() - TRICKLED - few;
            let last: Vec<_> = received[last].iter().map(|entry| entry[0]).collect();
            assert!(last.len() > capacity / 2, "seed {seed}: {} entries are left at the end", last.len());
            let turns = last.windows(2).filter(|pair| pair[0] > pair[1]).count();
            assert!(turns <= 1, "seed {seed}: {turns} turns");
        }
    }
}
