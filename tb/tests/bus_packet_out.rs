//! `bus_packet_out` against its model.

use pointcore_contract::bus::units::packet_out::Ports;
use pointcore_contract::search::records::CachedResult;
use pointcore_contract::splat::records::Fragment;
use pointcore_contract::{Field, Record, Words, fields, read, search, splat};
use pointcore_golden::bus::PacketOut;
use pointcore_hdl::bus::packet_out;
use pointcore_tb::lockstep::{Stall, Stalls, seeds};

use crate::bus::{Bench, Drain, Feed, SEEDS, bytes, stalls, words};

const RECORDS: usize = 300;

fn fragments() -> splat::Config {
    splat::Config { continuous: 5, cardinal: 1, ..splat::Config::default() }
}

/// Sends records; returns the cycles that it took.
fn exchange<R: Record<Domain = Words>>(
    config: &R::Config,
    stream_bits: u32,
    seed: u64,
    patterns: [Stalls; 2],
) -> (u64, u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut bench = Bench::new(packet_out::module::<R>(config, stream_bits), seed);
    let ports = Ports::<R>::ALL;
    let [source_stalls, sink_stalls] = patterns;
    let mut source = Feed::new(&bench, ports.input, config, &mut random, source_stalls);
    let mut sink = Drain::new(&bench, ports.packets.beats, &stream_bits, sink_stalls);
    let model = PacketOut::<R>::new(config, stream_bits);
    let mut expected = vec![];
    for _ in 0..RECORDS {
        let mut word = |field: &Field| {
            let word = random.u64(..) >> (64 - field.width);
            field.below.map_or(word, |below| word % below)
        };
        let record: Vec<u64> = fields::<R>(config).iter().map(&mut word).collect();
        expected.extend(model.beats(read(config, &record)));
        source.items.push_back(record);
    }
    let (mut received, mut sent_due, mut inside) = (vec![], false, 0i64);
    while received.len() < expected.len() {
        source.offer(&mut bench);
        sink.offer(&mut bench);
        bench.step();
        assert_eq!(bench.get("sent"), u64::from(sent_due), "cycle {}", bench.cycle);
        assert_eq!(bench.get("idle"), u64::from(inside == 0), "cycle {}", bench.cycle);
        inside += i64::from(source.taken(&bench).is_some());
        sent_due = false;
        if let Some(beat) = sink.taken(&bench) {
            let (data, last) = beat.split_at(beat.len() - 1);
            sent_due = last[0] == 1;
            inside -= i64::from(sent_due);
            received.push((bytes(data, stream_bits as usize / 8), sent_due));
            assert_eq!(received.last(), expected.get(received.len() - 1), "cycle {}", bench.cycle);
        }
    }
    assert!(words(&received[0].0).len() == (stream_bits as usize).div_ceil(64));
    (bench.cycle, expected.len() as u64)
}

#[test]
fn packets_are_the_records_in_order() {
    for seed in seeds(SEEDS).unwrap() {
        let mut random = fastrand::Rng::with_seed(seed);
        for stream_bits in [32, 64, 512] {
            let [fragment_stalls, result_stalls] = [(); 2].map(|()| [stalls(&mut random), stalls(&mut random)]);
            exchange::<Fragment>(&fragments(), stream_bits, seed, fragment_stalls);
            exchange::<CachedResult>(&search::Config::default(), stream_bits, seed, result_stalls);
        }
    }
}

#[test]
fn it_sends_a_beat_in_every_cycle() {
    for stream_bits in [32, 64, 512] {
        let never = || [(); 2].map(|()| Stalls::new(Stall::Never, fastrand::Rng::with_seed(1)));
        let fragments = exchange::<Fragment>(&fragments(), stream_bits, 1, never());
        let results = exchange::<CachedResult>(&search::Config::default(), stream_bits, 1, never());
        for (cycles, beats) in [fragments, results] {
            assert!(cycles <= beats + 2, "{cycles} cycles for {beats} beats");
        }
    }
}
