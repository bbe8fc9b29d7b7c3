//! Beginnings of small frames, recorded at the ports of the golden model: the test that goes with generated Verilog.

use super::generate::SplatCore;
use crate::recording::{Recorder, Recording};
use crate::stimuli::frames::{Lens, Place, about, around};
use crate::stimuli::pace::Paces;
use crate::stimuli::renderer::{DATA, READ, Renderer, Script, WRITE, streams};
use fastrand::Rng;
use glam::Vec3;
use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::Top;
use pointcore_tb::lockstep::{Flow, Stall};

/// Runs of ordinary frames, each with what is in it: paces of streams, and discs that overlap more, or less.
const RUNS: [(Stall, Place, u32); 8] = [
    (Stall::Random(0.2), place(0.2, -4.0), 40),
    (Stall::Varied, place(0.5, -3.0), 20),
    (Stall::Varied, place(0.1, -5.0), 60),
    (Stall::Random(0.4), place(0.8, -3.0), 20),
    (Stall::Never, place(0.6, -4.0), 240),
    (Stall::Varied, place(0.3, -3.5), 120),
    (Stall::Random(0.1), place(0.9, -4.5), 240),
    (Stall::Random(0.5), place(0.2, -2.5), 40),
];
/// Runs of frames whose splats are of all kinds, each in another unit of length, and how many splats they are.
const MIXED_UNITS: [f32; 3] = [1.0, 4096.0, 1.0 / 65536.0];
const MIXED_SPLATS: u32 = 60;
/// Streams that hardly move in a run, in which a few large discs cover tiles.
const HELD: [usize; 3] = [DATA, READ, WRITE];
const LARGE: Place = place(0.4, -2.0);
const LARGE_SPLATS: u32 = 40;
/// Cycles of a run: the whole of a large image would take hundreds of times as many.
const RUN_CYCLES: u64 = 5000;
/// Small discs that overlap, on a few tiles, for the run that fills the heap.
const SMALL: Place = place(0.05, -4.5);
/// The scene is near the first tile, for tiles leave the core in their order.
const LENS: Lens = Lens { scale: [240.0, 260.0], origin: [28.0, 26.0] };
/// A heap that holds so few copies is filled several times.
const SMALL_HEAP: u32 = 64;
const HEAP_RUNS: u64 = 3;
/// Cycles in which a copy that another one follows leaves the heap again.
const COPY_CYCLES: u64 = 16;
/// Cycles of the reset before a run.
const RESET_CYCLES: u64 = 2;
/// Cycles beyond one a tile until the core has cleared its directory of tiles.
const SETTLING_CYCLES: u64 = 8;
/// Streams are held for as long as one likes: nothing is stuck that does not come to its end anyway.
const QUIET_CYCLES: u64 = 1_000_000;

/// Discs about what the camera looks at.
const fn place(spread: f32, log2_radius: f32) -> Place {
    Place { center: Vec3::ZERO, spread, log2_radius }
}

/// Records frames on the hardware of a configuration.
#[must_use]
pub fn record(config: &Config, core: &SplatCore) -> Recording {
    let top = Top::new(config, &core.latencies());
    let mut runs = Runs { config, recorder: Recorder::new(config, &units::top::UNIT, top) };
    for (seed, (pattern, place, splats)) in (0..).zip(RUNS) {
        let random = &mut Rng::with_seed(seed);
        let frames = [splats, splats / 4].map(|splats| about(place, config, splats, LENS, random)).into();
        let paces = Paces::alike(streams(config), pattern, random);
        runs.run(Script { frames, paces, latency: 1 + seed, resets: vec![] }, RUN_CYCLES);
    }
    for (seed, unit) in (0..).zip(MIXED_UNITS) {
        let random = &mut Rng::with_seed(seed);
        let frames = [(); 2].map(|()| around(config, MIXED_SPLATS, LENS, random).in_units(config, unit)).into();
        let paces = Paces::alike(streams(config), Stall::Varied, random);
        runs.run(Script { frames, paces, latency: 1 + seed, resets: vec![] }, RUN_CYCLES);
    }
    for stream in HELD {
        runs.hold(stream);
    }
    let small = if config.heap_capacity() <= SMALL_HEAP { HEAP_RUNS } else { 1 };
    (0..small).for_each(|seed| runs.fill_the_heap(seed));
    runs.recorder.into_recording()
}

/// The golden model, run after run.
struct Runs<'a> {
    config: &'a Config,
    recorder: Recorder<Top>,
}

impl Runs<'_> {
    /// A run from its reset on, for so many cycles at most.
    fn run(&mut self, script: Script, cycles: u64) {
        (0..RESET_CYCLES).for_each(|_| self.recorder.reset());
        (0..self.config.buffer_tiles() as u64 + SETTLING_CYCLES).for_each(|_| self.recorder.clock());
        let mut host = Renderer::new(self.config, script, None, QUIET_CYCLES);
        for cycle in 0..cycles {
            if self.recorder.drive(cycle, &mut host) == Flow::Done {
                break;
            }
        }
    }

    /// Splats on a few tiles, more than there are slots, while a stream of the memory hardly moves: samples wait for
    /// their tiles, and what is before them for room.
    fn hold(&mut self, stream: usize) {
        let random = &mut Rng::with_seed(stream as u64);
        let frames = vec![about(LARGE, self.config, LARGE_SPLATS, LENS, random)];
        let paces = Paces::in_turns(streams(self.config), None).hardly(stream, random);
        self.run(Script { frames, paces, latency: 1, resets: vec![] }, RUN_CYCLES);
    }

    /// More copies than the heap holds, while memory takes nothing: tiles cannot go, and copies have to wait.
    fn fill_the_heap(&mut self, seed: u64) {
        let config = self.config;
        let random = &mut Rng::with_seed(seed);
        let splats = config.heap_capacity() * 5 / 4;
        let interval = u64::from(config.setup_interval.max(config.transform_interval).max(config.heap_interval));
        let held = u64::from(splats) * interval;
        let paces = match seed {
            0 => Paces::in_turns(streams(config), None),
            _ => Paces::alike(streams(config), Stall::Random(0.5), random),
        };
        let paces = paces.after(WRITE, held);
        let frames = vec![about(SMALL, config, splats, LENS, random)];
        self.run(Script { frames, paces, latency: 1, resets: vec![] }, held + u64::from(splats) * COPY_CYCLES);
    }
}
