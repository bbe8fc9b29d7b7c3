//! The renderer on AXI makes the frames that its model makes, whatever stalls, run after run, and after runs that were aborted.

use pointcore::splat::{EncodedFrame, SplatCore, SplatRunner};
use pointcore_contract::bus::Config as Widths;
use pointcore_contract::bus::registers::{RegisterMap, SplatRegisters};
use pointcore_contract::bus::units::splat_axi::Ports;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Fragment, Splat};
use pointcore_contract::words;
use pointcore_hdl::bus::splat;
use pointcore_hdl::compiler::Options;
use pointcore_tb::lockstep::seeds;

use crate::bus::host::{Around, Host, MemoryOrder, RESET};
use crate::splat::{configs, fixed_configs, scene, in_order};

/// Splats and ends of several frames.
const RECORDS: usize = 250;
const TOP: Ports = Ports::ALL;
const BUFFER_BASE: u32 = 0x3000;
const MEMORY_BYTES: usize = 1 << 20;

fn frames(config: &Config) -> EncodedFrame {
    EncodedFrame { records: scene::world(config, RECORDS), uniforms: scene::registers(config) }
}

/// The fragments of each frame, as the model makes them.
fn expected(config: &Config, frames: &EncodedFrame) -> Vec<Vec<Fragment>> {
    let core = SplatCore::generate(config).unwrap_or_else(|error| panic!("{error}"));
    let fragments = |splats: &[Splat]| {
        let frame = EncodedFrame { records: splats.to_vec(), ..frames.clone() };
        let outcome = SplatRunner::new(config, &frame).golden(&core).unwrap_or_else(|error| panic!("{error}"));
        sorted(config, outcome.fragments)
    };
    frames.records.split_inclusive(|splat| splat.end).map(fragments).collect()
}

fn sorted(config: &Config, mut fragments: Vec<Fragment>) -> Vec<Fragment> {
    in_order(config, &mut fragments);
    fragments
}

/// The frames over the bus; a packet now and then is too short, and is sent again.
fn on_the_bus(config: &Config, frame: &EncodedFrame, memory_order: MemoryOrder, seed: u64) -> Vec<Vec<Fragment>> {
    let top = splat::core(config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let around = Around {
        map: SplatRegisters::registers(config),
        registers: TOP.registers,
        packets: (TOP.splats, TOP.fragments),
        reads: vec![TOP.reads],
        writes: Some(TOP.writes),
        window: None,
        memory: MEMORY_BYTES,
        memory_order,
    };
    let mut host = Host::<Splat, Fragment>::new(top.module, config, config.bus, around, seed);
    assert_eq!(host.read("id"), 0x5043_0a01);
    host.write("buffer_base", BUFFER_BASE);
    for (name, value) in scene::uniforms(config) {
        host.write(&name, value as u32);
    }
    let mut random = fastrand::Rng::with_seed(seed);
    let (mut frames, mut refused) = (vec![], 0);
    for (number, splats) in frame.records.split_inclusive(|splat| splat.end).enumerate() {
        if number != 1 {
            aborted_run(&mut host, config, &splats[..splats.len() - 1], &mut random);
        }
        assert!(host.start(if number == 1 { RESET } else { 0 }));
        for splat in splats.iter().map(|splat| words(config, *splat)) {
            if config.bus.stream_bits < 512 && random.u8(..16) == 0 {
                host.send(&splat, 1);
                refused += 1;
            }
            host.send(&splat, 0);
        }
        assert!(!host.start(0), "a run is under way");
        host.finish();
        let mut fragments = host.received.clone();
        assert!(fragments.pop().is_some_and(|fragment| fragment.end), "a frame has an end");
        assert_eq!(host.read("packets_in"), splats.len() as u32);
        assert_eq!(host.read("packets_out"), host.received.len() as u32);
        assert!(host.read("event_sample") > 0 && host.read("cycles") > 0);
        host.expect_errors([0, number as u32 + 1, 0, refused, 0]);
        host.received.clear();
        frames.push(sorted(config, fragments));
    }
    frames
}

/// A run that ends before its time, somewhere on its way through splats.
fn aborted_run(host: &mut Host<Splat, Fragment>, config: &Config, splats: &[Splat], random: &mut fastrand::Rng) {
    assert!(host.start(0));
    splats.iter().for_each(|splat| host.send(&words(config, *splat), 0));
    (0..random.u32(..20_000)).for_each(|_| host.step());
    host.abort();
}

#[test]
fn frames_on_the_bus_are_those_of_the_model() {
    let widths = [(64, 64), (32, 512), (512, 32), (64, 128)];
    for (config, (stream_bits, memory_bits)) in configs().into_iter().chain(fixed_configs()).zip(widths) {
        let config = Config { bus: Widths { stream_bits, memory_bits }, ..config };
        let frame = frames(&config);
        let expected = expected(&config, &frame);
        let count = expected.iter().map(Vec::len).sum::<usize>();
        assert!(count > 250, "{count} fragments");
        for memory_order in [MemoryOrder::Any, MemoryOrder::ReadsFirst] {
            for seed in seeds(1).unwrap() {
                let found = on_the_bus(&config, &frame, memory_order, seed);
                let found_count = found.iter().map(Vec::len).sum::<usize>();
                let counts = format!("{found_count} fragments instead of {count}");
                assert!(found == expected, "{memory_order:?}, seed {seed}: {counts}");
            }
        }
    }
}
