//! `bus_writer` against its model.

use std::collections::VecDeque;
use std::ops::RangeInclusive;

use pointcore_contract::bus::axi::BurstAddress;
use pointcore_contract::bus::config::ADDRESS_BITS;
use pointcore_contract::bus::units::Addressed;
use pointcore_contract::bus::units::writer::Ports;
use pointcore_contract::splat::records::Pixel;
use pointcore_contract::{read, splat, words};
use pointcore_golden::bus::{Burst, Writer};
use pointcore_hdl::bus::writer;
use pointcore_tb::lockstep::{Stall, Stalls, seeds};

use crate::bus::{Bench, Drain, Feed, SEEDS, bytes, stalls};
use crate::splat::scene;

const RECORDS: u32 = 200;
const WRITES_MAX: u32 = 16;
/// `INCR`.
const INCREMENTING: u8 = 1;
/// Responses other than `OKAY`.
const ERRORS: RangeInclusive<u64> = 1..=3;
/// A share of idle cycles such that hardly anything moves.
const HARDLY: f64 = 0.98;

fn pixels() -> splat::Config {
    splat::Config { continuous: 3, cardinal: 1, ..splat::Config::default() }
}

/// What came of an exchange.
struct Exchange {
    cycles: u64,
    beats: u64,
    /// Records at a time at most that were not answered.
    unanswered: u32,
}

/// Writes records.
fn exchange(
    config: &splat::Config,
    memory_bits: u32,
    seed: u64,
    mut pattern: impl FnMut(&mut fastrand::Rng) -> Stalls,
) -> Exchange {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut bench = Bench::new(writer::module::<Pixel>(config, memory_bits), seed);
    let ports = Ports::<Pixel>::ALL;
    let patterns: Vec<Stalls> = (0..4).map(|_| pattern(&mut random)).collect();
    let [source, addresses, data, answers] = <[Stalls; 4]>::try_from(patterns).unwrap();
    let mut input = Feed::new(&bench, ports.input, config, &mut random, source);
    let mut address = Drain::new(&bench, ports.memory.address, &ADDRESS_BITS, addresses);
    let mut data = Drain::new(&bench, ports.memory.data, &memory_bits, data);
    let mut answer = Feed::new(&bench, ports.memory.answer, &(), &mut random, answers);

    let model = Writer::new(config, memory_bits);
    let beat_bytes = memory_bits as usize / 8;
    let (mut bursts, mut beats) = (VecDeque::new(), VecDeque::new());
    for _ in 0..RECORDS {
        let record: Pixel = scene::noise(config, &mut random);
        let base = random.u32(..(1 << 26) - (1 << 14)) * 64;
        let (burst, packet) = model.burst(base, record);
        input.items.push_back(words(config, Addressed { address: base, record }));
        let count = packet.len() / beat_bytes;
        beats.extend(packet.chunks(beat_bytes).enumerate().map(|(place, beat)| (beat.to_vec(), place + 1 == count)));
        bursts.push_back(burst);
    }
    let total = beats.len() as u64;
    let mut unanswered = 0;
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
        unanswered = unanswered.max(accepted - answered);
        if let Some(burst) = address.taken(&bench) {
            let Burst { address: first, beats } = bursts.pop_front().unwrap();
            let (length, size) = ((beats - 1) as u8, beat_bytes.ilog2() as u8);
            let expected = BurstAddress { id: 0, address: first, length, size, burst: INCREMENTING };
            assert_eq!(read::<BurstAddress>(&ADDRESS_BITS, &burst), expected, "cycle {}", bench.cycle);
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
            answer.items.push_back(vec![random.u64(..16), if random.u8(..6) == 0 { random.u64(ERRORS) } else { 0 }]);
        }
    }
    let cycles = bench.cycle;
    bench.set("m_axi_bvalid", 0);
    bench.step();
    errors += bench.get("error");
    assert_eq!((errors, bench.get("idle")), (errors_due, 1));
    assert!(errors > 5, "{errors} errors");
    Exchange { cycles, beats: total, unanswered }
}

#[test]
fn every_record_is_a_burst() {
    for seed in seeds(SEEDS).unwrap() {
        for memory_bits in [32, 64, 512] {
            exchange(&pixels(), memory_bits, seed, stalls);
        }
    }
}

#[test]
fn it_waits_for_a_memory_that_owes_it_many_answers() {
    for memory_bits in [32, 64, 512] {
        let mut channels = [Stall::Never, Stall::Never, Stall::Never, Stall::Random(HARDLY)].into_iter();
        let each = |random: &mut fastrand::Rng| Stalls::new(channels.next().unwrap(), random.fork());
        let most = exchange(&pixels(), memory_bits, 1, each).unanswered;
        assert_eq!(most, WRITES_MAX);
    }
}

#[test]
fn it_sends_a_beat_in_every_cycle() {
    let never = |_: &mut fastrand::Rng| Stalls::new(Stall::Never, fastrand::Rng::with_seed(1));
    for memory_bits in [32, 64, 512] {
        let Exchange { cycles, beats, .. } = exchange(&pixels(), memory_bits, 1, never);
        assert!(cycles <= beats + 8, "{cycles} cycles for {beats} beats");
    }
}
