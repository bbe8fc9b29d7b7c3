//! The renderer on AXI makes the frames that its model makes, whatever stalls, run after run, and after runs that were aborted.

use pointcore::number;
use pointcore::splat::depth_memory::Depths;
use pointcore::splat::{EncodedFrame, SplatCore, SplatRunner};
use pointcore_contract::bus::Config as Widths;
use pointcore_contract::splat::config::PayloadStore;
use pointcore_contract::splat::records::{Fragment, Splat, Uniforms};
use pointcore_contract::splat::{Config, Feature};
use pointcore_contract::{fields, words};
use pointcore_hdl::bus::splat;
use pointcore_hdl::compiler::Options;
use pointcore_tb::lockstep::seeds;

use crate::bus::host::{Bases, Host, MemoryOrder, RESET, around_renderer, place};
use crate::splat::{configs, fixed_configs, in_order, moving_configs, scene};
use crate::support::cases;

/// Splats and ends of several frames.
const RECORDS: usize = 250;
const BUFFER_BASE: u32 = 0x3000;
/// Radius of a screen filter that is wider than the others'.
const WIDE_PX: f32 = 1.7;
/// A bit of `status`.
const WAITING: u32 = 8;

/// Frames, of which each sees its splats in its own way: moved aside, at last through another screen filter, too.
fn frames(config: &Config) -> Vec<EncodedFrame> {
    let (records, uniforms) = (scene::world(config, RECORDS), scene::registers(config));
    let frame = |(number, splats): (usize, &[Splat])| {
        let mut uniforms = uniforms;
        uniforms.viewport.origin = [config.width, config.height].map(|edge| {
            let moved = edge as f32 / 2.0 + (number % 3) as f32;
            number::encode(config.geometry, moved)
        });
        if number > 1 {
            uniforms.filter_radius = number::encode(config.geometry, WIDE_PX);
            uniforms.filter_scale = number::encode_uniform(config.filter_scale_format(), 1.0 / (WIDE_PX * WIDE_PX));
        }
        EncodedFrame { records: splats.to_vec(), uniforms, depths: config.tests_samples().then(|| depths(config)) }
    };
    records.split_inclusive(|splat| splat.end).enumerate().map(frame).collect()
}

/// The fragments of each frame, as the model makes them without testing them against depths in memory; samples are.
fn reconstructed(config: &Config, frames: &[EncodedFrame]) -> Vec<Vec<Fragment>> {
    let merge = if config.tests_fragments() { Feature::Off } else { config.merge };
    let config = &Config { merge, ..config.clone() };
    let core = SplatCore::generate(config).unwrap_or_else(|error| panic!("{error}"));
    let fragments = |frame| {
        let outcome = SplatRunner::new(config, frame).golden(&core).unwrap_or_else(|error| panic!("{error}"));
        sorted(config, outcome.fragments)
    };
    frames.iter().map(fragments).collect()
}

/// What lies in memory before a frame: of each sample something in the midst of the scene, before it or behind it.
fn depths(config: &Config) -> Depths {
    Depths::new(config, |column, row| Some([0.1, 0.5, 0.7, 0.9][((column / 3 + row / 2) % 4) as usize]))
}

fn sorted(config: &Config, mut fragments: Vec<Fragment>) -> Vec<Fragment> {
    in_order(config, &mut fragments);
    fragments
}

type SplatHost = Host<Splat, Fragment>;

/// The core with a host and memory around it.
fn around(config: &Config, memory_order: MemoryOrder, seed: u64) -> (SplatHost, Bases) {
    let top = splat::core(config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let (around, bases) = around_renderer(config, BUFFER_BASE, memory_order);
    let mut host = Host::new(top.module, config, config.bus, around, seed);
    assert_eq!(host.read("id"), 0x5043_0a01);
    place(&mut host, config, bases);
    (host, bases)
}

/// Puts depths into memory, where something is tested against them.
fn put_depths(host: &mut SplatHost, config: &Config, bases: Bases) {
    if config.merge.is_on() {
        let bytes: Vec<u8> = depths(config).bits().iter().flat_map(|bits| bits.to_le_bytes()).collect();
        host.memory[bases.depths as usize..][..bytes.len()].copy_from_slice(&bytes);
    }
}

/// Writes a frame's uniforms.
fn look(host: &mut SplatHost, config: &Config, frame: &EncodedFrame) {
    for (field, value) in fields::<Uniforms>(config).into_iter().zip(words(config, frame.uniforms)) {
        host.write(&field.name, value as u32);
    }
}

/// The frames over the bus, each a run; a packet now and then is too short, and is sent again.
fn one_by_one(
    (host, bases): (&mut SplatHost, Bases),
    config: &Config,
    frames: &[EncodedFrame],
    seed: u64,
) -> Vec<Vec<Fragment>> {
    let mut random = fastrand::Rng::with_seed(seed);
    let (mut found, mut refused) = (vec![], 0);
    for (number, frame) in frames.iter().enumerate() {
        let splats = &frame.records;
        look(host, config, frame);
        if number != 1 {
            aborted_run(host, config, &splats[..splats.len() - 1], &mut random);
        }
        put_depths(host, config, bases);
        assert!(host.start(if number == 1 { RESET } else { 0 }));
        for splat in splats.iter().map(|splat| words(config, *splat)) {
            if config.bus.stream_bits < 512 && random.u8(..16) == 0 {
                host.send(&splat, 1);
                refused += 1;
            }
            host.send(&splat, 0);
        }
        assert!(!host.start(RESET), "a run is under way");
        host.finish();
        let mut fragments = host.received.clone();
        assert!(fragments.pop().is_some_and(|fragment| fragment.end), "a frame has an end");
        assert_eq!(host.read("packets_in"), splats.len() as u32);
        assert_eq!(host.read("packets_out"), host.received.len() as u32);
        assert!(host.read("event_sample") > 0 && host.read("cycles") > 0);
        host.expect_errors([0, number as u32 + 1, 0, refused, 0]);
        host.received.clear();
        found.push(sorted(config, fragments));
    }
    found
}

/// The frames over the bus in one run, each asked for as soon as the one before has begun.
fn ahead(host: &mut SplatHost, config: &Config, frames: &[EncodedFrame]) -> Vec<Vec<Fragment>> {
    let mut most = 0;
    for (asked, frame) in frames.iter().enumerate() {
        while host.read("status") & WAITING != 0 {}
        most = most.max(asked - host.received.iter().filter(|fragment| fragment.end).count());
        look(host, config, frame);
        assert!(host.start(0));
        frame.records.iter().for_each(|splat| host.send(&words(config, *splat), 0));
    }
    assert!(most > 1, "no frame begins before another has left");
    host.finish();
    let (taken, sent) = (host.read("packets_in"), host.read("packets_out"));
    assert_eq!(taken as usize, frames.iter().map(|frame| frame.records.len()).sum::<usize>());
    assert_eq!(sent as usize, host.received.len());
    let found = std::mem::take(&mut host.received);
    let frames = found.split_inclusive(|fragment| fragment.end);
    frames.map(|fragments| sorted(config, fragments[..fragments.len() - 1].to_vec())).collect()
}

/// A run that ends before its time, somewhere on its way through splats.
fn aborted_run(host: &mut SplatHost, config: &Config, splats: &[Splat], random: &mut fastrand::Rng) {
    assert!(host.start(0));
    splats.iter().for_each(|splat| host.send(&words(config, *splat), 0));
    (0..random.u32(..20_000)).for_each(|_| host.step());
    host.abort();
}

#[test]
fn frames_on_the_bus_are_those_of_the_model() {
    let widths = [(64, 64), (32, 512), (512, 32), (64, 128), (64, 64), (128, 64)];
    let [bare, ..] = configs();
    let payload = PayloadStore::Memory;
    let several = Config { rasterizers: 4, memory_ports: 4, payload, payload_beats: 3, merge: Feature::On, ..bare };
    let [moving, ..] = moving_configs().map(|moving| Config { rasterizers: 2, merge: Feature::On, ..moving });
    let all = configs().into_iter().chain([several, moving]).chain(fixed_configs());
    for (config, (stream_bits, memory_bits)) in cases(all.zip(widths)) {
        let config = Config { bus: Widths { stream_bits, memory_bits }, ..config };
        let frames = frames(&config);
        let all = reconstructed(&config, &frames);
        let merged = |frame: &Vec<Fragment>, depths: &mut Depths| {
            if config.tests_fragments() { depths.merge(&config, frame) } else { frame.clone() }
        };
        let alone: Vec<_> = all.iter().map(|frame| merged(frame, &mut depths(&config))).collect();
        let mut left = depths(&config);
        let in_turn: Vec<_> = all.iter().map(|frame| merged(frame, &mut left)).collect();
        let count = in_turn.iter().map(Vec::len).sum::<usize>();
        assert!(count > 250, "{count} fragments");
        for memory_order in [MemoryOrder::Any, MemoryOrder::ReadsFirst] {
            for seed in seeds(1).unwrap() {
                let (mut host, bases) = around(&config, memory_order, seed);
                let separately = one_by_one((&mut host, bases), &config, &frames, seed);
                put_depths(&mut host, &config, bases);
                let together = ahead(&mut host, &config, &frames);
                for (found, expected, way) in [(separately, &alone, "one by one"), (together, &in_turn, "ahead")] {
                    let count = |frames: &[Vec<Fragment>]| frames.iter().map(Vec::len).sum::<usize>();
                    let counts = format!("{} fragments instead of {}", count(&found), count(expected));
                    assert!(found == *expected, "{way}, {memory_order:?}, seed {seed}: {counts}");
                }
            }
        }
    }
}
