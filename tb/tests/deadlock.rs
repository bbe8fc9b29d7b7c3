//! Cores of random configurations under stalls that are meant to lock them: each stream is held for long in its turn,
//! memory answers late and out of order, reads before writes. Everything that goes in comes out, within a bound.

use std::sync::Arc;

use fastrand::Rng;
use pointcore::splat::{EncodedFrame, SplatCore, SplatCounters, SplatRunner};
use pointcore::stimuli::configuration::renderer as random_renderer;
use pointcore::stimuli::frames::{Lens, frames};
use pointcore::stimuli::pace::{Paces, Turns};
use pointcore::stimuli::{renderer, searcher};
use pointcore_contract::bus::Config as Widths;
use pointcore_contract::fields;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Fragment, Splat, Uniforms};
use pointcore_contract::{read, words};
use pointcore_hdl::bus::splat;
use pointcore_hdl::compiler::Options;
use pointcore_lab::soak::device::{AnyConfig, Core, Device, Ran};
use pointcore_lab::soak::extent;
use pointcore_tb::lockstep::seeds;
use pointcore_tb::verilated::{BuildOptions, Builder};

use crate::bus::host::{Host, MemoryOrder, around_renderer, place};

/// Configurations of each core.
const CONFIGURATIONS: u64 = 2;
/// Every stream stands still for longer than any of these cores takes to fill up.
const TURNS: Turns = Turns { held: 3000, free: 2000 };
/// Cycles until a memory answers.
const LATE: u64 = 400;
/// Nothing that a run waits for comes so much later than it would on average.
const SLACK: u64 = 2;

fn device(core: Core, seed: u64) -> Device {
    let config = AnyConfig::random(core, &mut Rng::with_seed(seed));
    let builder: Arc<Builder> = Builder::new().unwrap_or_else(|error| panic!("{error}"));
    Device::build(&config, &builder, BuildOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Cycles that a run may take in which streams are held, by those that it takes when none is: of each time in which all
/// are free, half is spent on getting under way again.
fn bound(free: &Ran, streams: usize) -> u64 {
    let times = free.cycles.div_ceil(TURNS.free / 2) + streams as u64;
    SLACK * times * (TURNS.held + TURNS.free)
}

/// Runs without turns and with them, memory being as late; what is done does not hang on them.
fn check(seed: u64, streams: usize, run: impl Fn(Paces) -> Ran) {
    let [free, held] = [None, Some(TURNS)].map(|turns| run(Paces::in_turns(streams, turns)));
    let bound = bound(&free, streams);
    assert!(held.cycles <= bound, "seed {seed}: {} cycles instead of {bound}", held.cycles);
    assert!(held.pending == free.pending && held.pending.done > 0, "seed {seed}: {:?}", held.pending);
    let least = free.cycles.min(TURNS.held);
    assert!(held.cycles > free.cycles + least / 2, "seed {seed}: nothing was held in {} cycles", held.cycles);
}

#[test]
fn renderers_come_to_their_end_whatever_is_held() {
    for seed in seeds(CONFIGURATIONS).unwrap() {
        let device = device(Core::Splat, seed);
        let AnyConfig::Splat(config) = AnyConfig::random(Core::Splat, &mut Rng::with_seed(seed)) else {
            unreachable!()
        };
        check(seed, renderer::streams(&config), |paces| {
            let script = extent::renderer(&config, &mut Rng::with_seed(seed));
            let script = renderer::Script { paces, latency: LATE, resets: vec![], ..script };
            let ran = device.render(script, seed, "this test");
            ran.unwrap_or_else(|error| panic!("seed {seed}: {error}"))
        });
    }
}

#[test]
fn search_cores_come_to_their_end_whatever_is_held_and_in_whatever_order_memory_answers() {
    for seed in seeds(CONFIGURATIONS).unwrap() {
        let device = device(Core::Search, seed);
        let AnyConfig::Search(config) = AnyConfig::random(Core::Search, &mut Rng::with_seed(seed)) else {
            unreachable!()
        };
        for window in [1, usize::MAX] {
            check(seed, searcher::STREAMS, |paces| {
                let script = searcher::Script::random(&config, extent::SEARCH, &mut Rng::with_seed(seed));
                let answers = searcher::Answers { latency: LATE, window };
                let script = searcher::Script { paces, answers, resets: vec![], ..script };
                let ran = device.search(script, seed, "this test");
                ran.unwrap_or_else(|error| panic!("seed {seed}: {error}"))
            });
        }
    }
}

/// Streams on the bus move in one of five cycles at least, and several of them one after the other.
const BUS_SHARE: u64 = 5 * 8;
/// Frames among which one is sought that shows something.
const FRAMES: usize = 20;
/// Beats of the largest packet, or of the largest pixel, on the narrowest bus.
const BEATS: u64 = 32;

/// What a frame comes to on the model alone, and the cycles it may take on the bus.
fn expected(config: &Config, frame: &EncodedFrame) -> (Vec<Fragment>, u64) {
    let core = SplatCore::generate(config).unwrap_or_else(|error| panic!("{error}"));
    let outcome = SplatRunner::new(config, frame).golden(&core).unwrap_or_else(|error| panic!("{error}"));
    let SplatCounters { buffer, payloads, depths, .. } = outcome.counters;
    let packets = (frame.records.len() + outcome.fragments.len()) as u64;
    let moved = packets + [buffer, payloads, depths].iter().map(|passed| passed.read + passed.written).sum::<u64>();
    (outcome.fragments, BUS_SHARE * (outcome.counters.cycles + BEATS * moved))
}

#[test]
fn renderers_on_a_bus_come_to_their_end_whichever_memory_does_first() {
    for seed in seeds(1).unwrap() {
        let random = &mut Rng::with_seed(seed);
        let bus = Widths { stream_bits: 32 << random.u32(..5), memory_bits: 32 << random.u32(..5) };
        let config = Config { bus, ..random_renderer(random) };
        let (frame, (expected, bound)) =
            frames(&config, FRAMES, extent::RENDERER.splats, Lens::whole(&config), Some(extent::HARD_CASES), random)
                .into_iter()
                .map(|frame| {
                    let uniforms: Uniforms = read(&config, &frame.uniforms);
                    let expected =
                        expected(&config, &EncodedFrame { records: frame.records.clone(), uniforms, depths: None });
                    (frame, expected)
                })
                .find(|(_, (fragments, _))| !fragments.is_empty())
                .unwrap_or_else(|| panic!("seed {seed}: nothing is drawn in {FRAMES} frames"));
        let mut expected = expected;
        crate::splat::in_order(&config, &mut expected);
        for memory_order in [MemoryOrder::Any, MemoryOrder::ReadsFirst] {
            let top = splat::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
            let (around, bases) = around_renderer(&config, 0, memory_order);
            let mut host = Host::<Splat, Fragment>::new(top.module, &config, config.bus, around, seed);
            place(&mut host, &config, bases);
            host.memory[bases.depths as usize..].fill(0xff);
            for (field, &value) in fields::<Uniforms>(&config).iter().zip(&frame.uniforms) {
                host.write(&field.name, value as u32);
            }
            let begin = host.cycles();
            assert!(host.start(0));
            frame.records.iter().for_each(|splat| host.send(&words(&config, *splat), 0));
            host.finish();
            let cycles = host.cycles() - begin;
            assert!(cycles <= bound, "{memory_order:?}, seed {seed}: {cycles} cycles instead of {bound}");
            assert!(host.received.pop().is_some_and(|fragment| fragment.end), "a frame has an end");
            crate::splat::in_order(&config, &mut host.received);
            assert!(host.received == expected, "{memory_order:?}, seed {seed}: {} fragments", host.received.len());
        }
    }
}
