//! `splat_lists` against its model, in every cycle.

use std::collections::VecDeque;

use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::Lists;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::lists;
use pointcore_tb::lockstep::{Flow, Run, Stall, Stalls, Stimulus, StreamPorts, Streams, seeds};

use crate::splat::{Device, scene};

const ENTRIES: usize = 8000;
const SEEDS: u64 = 12;

/// Sends entries whose pointers come again when they have left.
#[derive(Clone)]
struct Recycled {
    input: StreamPorts,
    out: StreamPorts,
    random: fastrand::Rng,
    /// Tiles that entries are of for a while: those of the image.
    tiles: Vec<u32>,
    free: VecDeque<u64>,
    sent: Vec<[u64; 2]>,
    received: Vec<[u64; 2]>,
    /// Entries that were there at the same time, at most.
    most: usize,
    stalls: [Stalls; 2],
}

impl Stimulus for Recycled {
    fn drive(&mut self, _cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        if self.out.transfers(inputs, outputs) {
            let entry = [0, 1].map(|field| outputs[self.out.fields[field]]);
            self.received.push(entry);
            self.free.push_back(entry[1]);
        }
        let [source, sink] = &mut self.stalls;
        let waits = self.input.offers(inputs, outputs) && !self.input.transfers(inputs, outputs);
        if !waits {
            let offered = !source.stalled() && self.sent.len() < ENTRIES;
            let pointer = if offered { self.free.pop_front() } else { None };
            inputs[self.input.valid] = u64::from(pointer.is_some());
            if let Some(pointer) = pointer {
                let spread = if self.sent.len() % 256 < 128 { self.tiles.len().min(3) } else { self.tiles.len() };
                let entry = [self.tiles[self.random.usize(0..spread)].into(), pointer];
                self.input.fields.iter().zip(entry).for_each(|(&field, value)| inputs[field] = value);
                self.sent.push(entry);
                self.most = self.most.max(self.sent.len() - self.received.len());
            }
        }
        let ready = self.out.ready.expect("the stream has one");
        inputs[ready] = u64::from(!sink.stalled());
        if self.received.len() == ENTRIES { Flow::Done } else { Flow::Continue }
    }
}

/// The pointers of a tile, in the order of their entries.
fn of_tile(entries: &[[u64; 2]], tile: u64) -> Vec<u64> {
    entries.iter().filter(|entry| entry[0] == tile).map(|entry| entry[1]).collect()
}

/// Levels, tiles in turn and image width: one tile at a time and many, more turns than entries, one column of tiles and many.
#[test]
fn it_agrees_with_the_model_at_every_size() {
    for (heap_levels, tiles_in_turn, width) in
        [(2, 1, 8), (2, 8, 61), (4, 2, 130), (5, 3, 61), (7, 4, 61), (10, 16, 61)]
    {
        let config = Config { heap_levels, tiles_in_turn, tile_slots: 20, width, height: 37, ..Config::default() };
        let device = Device::new(&config, &lists::module(&config), &units::lists::UNIT);
        let streams = Streams::of(device.library());
        let stream = |name| streams.get(name).expect("lists have it").clone();
        let (mut filled, mut interleaved) = (0, 0);
        for seed in seeds(SEEDS).expect("POINTCORE_SEED is a number") {
            let kinds =
                [[Stall::Never, Stall::Random(0.9)], [Stall::Random(0.5), Stall::Never], [Stall::Bursts(40); 2]];
            let stimulus = Recycled {
                input: stream("in"),
                out: stream("out"),
                random: fastrand::Rng::with_seed(seed),
                tiles: scene::tiles(&config),
                free: (0..1 << heap_levels).collect(),
                sent: vec![],
                received: vec![],
                most: 0,
                stalls: kinds[seed as usize % kinds.len()]
                    .map(|stall| Stalls::new(stall, fastrand::Rng::with_seed(seed))),
            };
            let run = device.lockstep(Ported::new(&config, Lists::new(&config)), seed).run(stimulus);
            let Run { stimulus, report } = run.unwrap_or_else(|error| panic!("{error}"));
            assert!(report.events("empty") > 0, "seed {seed}: it is empty before the first and after the last");
            let Recycled { sent, received, most, tiles, .. } = &stimulus;
            for tile in tiles.iter().copied().map(u64::from) {
                assert_eq!(of_tile(received, tile), of_tile(sent, tile), "tile {tile}, seed {seed}");
            }
            filled += usize::from(*most == 1 << heap_levels);
            interleaved += received.windows(3).filter(|of| of[0][0] == of[2][0] && of[0][0] != of[1][0]).count();
        }
        assert!(filled > 0, "{heap_levels} levels were never full");
        assert!(tiles_in_turn == 1 || interleaved > 0, "{tiles_in_turn} tiles took turns");
    }
}
