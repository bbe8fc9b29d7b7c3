//! `bus_packet_out` against its model.

use pointcore_contract::bus::packets;
use pointcore_contract::search;
use pointcore_contract::{Field, fields, splat};
use pointcore_golden::bus::PacketOut;
use pointcore_hdl::bus::packet_out;
use pointcore_tb::lockstep::{Stall, Stalls, seeds};

use crate::bus::{Bench, Drain, Feed, SEEDS, bytes, stalls, words};

const RECORDS: usize = 300;

fn records() -> [Vec<Field>; 2] {
    let fragment =
        fields::<splat::records::Fragment>(&splat::Config { continuous: 5, cardinal: 1, ..splat::Config::default() });
    let [_, result] = packets::query_and_result(&search::Config::default());
    [fragment, result]
}

/// Sends records; returns the cycles that it took.
fn exchange(fields: &[Field], stream_bits: u32, seed: u64, patterns: [Stalls; 2]) -> (u64, u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut bench = Bench::new(packet_out::module(fields, stream_bits), seed);
    let names: Vec<&str> = fields.iter().map(|field| field.name.as_str()).collect();
    let [source_stalls, sink_stalls] = patterns;
    let mut source = Feed::new(&bench, "in_", &names, &mut random, source_stalls);
    let mut sink = Drain::new(&bench, "m_axis_t", &["data", "last"], sink_stalls);
    let model = PacketOut::new(fields, stream_bits);
    let mut expected = vec![];
    for _ in 0..RECORDS {
        let record: Vec<u64> = fields.iter().map(|field| random.u64(..) >> (64 - field.width)).collect();
        expected.extend(model.beats(&record));
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
            for fields in records() {
                exchange(&fields, stream_bits, seed, [stalls(&mut random), stalls(&mut random)]);
            }
        }
    }
}

#[test]
fn it_sends_a_beat_in_every_cycle() {
    for stream_bits in [32, 64, 512] {
        for fields in records() {
            let never = || Stalls::new(Stall::Never, fastrand::Rng::with_seed(1));
            let (cycles, beats) = exchange(&fields, stream_bits, 1, [never(), never()]);
            assert!(cycles <= beats + 2, "{cycles} cycles for {beats} beats");
        }
    }
}
