//! `bus_writer` against its model.

use std::collections::VecDeque;

use pointcore_contract::{Field, fields, splat};
use pointcore_golden::bus::{Burst, Writer};
use pointcore_hdl::bus::writer;
use pointcore_tb::lockstep::{Stall, Stalls, seeds};

use crate::bus::{Bench, Drain, Feed, SEEDS, bytes, stalls};

const RECORDS: u32 = 200;
const WRITES_MAX: u32 = 16;
/// `INCR`.
const INCREMENTING: u64 = 1;
const SLAVE_ERROR: u64 = 2;

fn pixel() -> Vec<Field> {
    fields::<splat::records::Pixel>(&splat::Config { continuous: 3, cardinal: 1, ..splat::Config::default() })
}

/// Writes records; returns cycles and beats.
fn exchange(
    fields: &[Field],
    memory_bits: u32,
    seed: u64,
    mut pattern: impl FnMut(&mut fastrand::Rng) -> Stalls,
) -> (u64, u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut bench = Bench::new(writer::module(fields, memory_bits), seed);
    let names: Vec<&str> = ["address"].into_iter().chain(fields.iter().map(|field| field.name.as_str())).collect();
    let patterns: Vec<Stalls> = (0..4).map(|_| pattern(&mut random)).collect();
    let [source, addresses, data, answers] = <[Stalls; 4]>::try_from(patterns).unwrap();
    let mut input = Feed::new(&bench, "in_", &names, &mut random, source);
    let mut address = Drain::new(&bench, "m_axi_aw", &["id", "addr", "len", "size", "burst"], addresses);
    let mut data = Drain::new(&bench, "m_axi_w", &["data", "strb", "last"], data);
    let mut answer = Feed::new(&bench, "m_axi_b", &["id", "resp"], &mut random, answers);

    let model = Writer::new(fields, memory_bits);
    let beat_bytes = memory_bits as usize / 8;
    let (mut bursts, mut beats) = (VecDeque::new(), VecDeque::new());
    for _ in 0..RECORDS {
        let record: Vec<u64> = fields.iter().map(|field| random.u64(..) >> (64 - field.width)).collect();
        let base = random.u32(..1 << 20) * 64;
        let (burst, packet) = model.burst(base, &record);
        input.items.push_back([base.into()].into_iter().chain(record).collect());
        let count = packet.len() / beat_bytes;
        beats.extend(packet.chunks(beat_bytes).enumerate().map(|(place, beat)| (beat.to_vec(), place + 1 == count)));
        bursts.push_back(burst);
    }
    let total = beats.len() as u64;
    let (mut addressed, mut sent, mut answerable, mut accepted, mut answered) = (0, 0, 0, 0u32, 0);
    let (mut errors, mut errors_due) = (0, 0);
    while answered < RECORDS {
        [&mut input, &mut answer].into_iter().for_each(|feed| feed.offer(&mut bench));
        [&mut address, &mut data].into_iter().for_each(|drain| drain.offer(&mut bench));
        bench.step();
        assert_eq!(bench.get("idle"), u64::from(accepted == answered), "cycle {}", bench.cycle);
        errors += bench.get("error");
        accepted += u32::from(input.taken(&bench).is_some());
        assert!(accepted - answered <= WRITES_MAX + 1, "{accepted} accepted, {answered} answered");
        if let Some(item) = answer.taken(&bench) {
            answered += 1;
            errors_due += u64::from(item[1] != 0);
        }
        assert!(accepted - answered <= WRITES_MAX);
        if let Some(burst) = address.taken(&bench) {
            let Burst { address: first, beats } = bursts.pop_front().unwrap();
            let size = u64::from(beat_bytes.ilog2());
            assert_eq!(burst, [0, first.into(), u64::from(beats) - 1, size, INCREMENTING], "cycle {}", bench.cycle);
            addressed += 1;
        }
        if let Some(item) = data.taken(&bench) {
            let (words, marks) = item.split_at(item.len() - 2);
            let (expected, last) = beats.pop_front().unwrap();
            assert_eq!(bytes(words, beat_bytes), expected, "cycle {}", bench.cycle);
            assert_eq!(marks, [u64::MAX >> (64 - beat_bytes), last.into()]);
            sent += u32::from(last);
        }
        // A memory answers when it has both.
        while answerable < u32::min(addressed, sent) {
            answerable += 1;
            answer.items.push_back(vec![random.u64(..16), if random.u8(..6) == 0 { SLAVE_ERROR } else { 0 }]);
        }
    }
    let cycles = bench.cycle;
    bench.set("m_axi_bvalid", 0);
    bench.step();
    errors += bench.get("error");
    assert_eq!((errors, bench.get("idle")), (errors_due, 1));
    assert!(errors > 5, "{errors} errors");
    (cycles, total)
}

#[test]
fn every_record_is_a_burst() {
    for seed in seeds(SEEDS).unwrap() {
        for memory_bits in [32, 64, 512] {
            exchange(&pixel(), memory_bits, seed, stalls);
        }
    }
}

#[test]
fn it_sends_a_beat_in_every_cycle() {
    let never = |_: &mut fastrand::Rng| Stalls::new(Stall::Never, fastrand::Rng::with_seed(1));
    for memory_bits in [32, 64, 512] {
        let (cycles, beats) = exchange(&pixel(), memory_bits, 1, never);
        assert!(cycles <= beats + 8, "{cycles} cycles for {beats} beats");
    }
}
