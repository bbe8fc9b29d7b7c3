//! `bus_reader` against its model: a memory that answers in order, now and then with an error or a misplaced `rlast`.

use std::collections::VecDeque;
use std::ops::RangeInclusive;

use pointcore_contract::bus::axi::BurstAddress;
use pointcore_contract::bus::config::ADDRESS_BITS;
use pointcore_contract::bus::units::ReadRequest;
use pointcore_contract::bus::units::reader::Ports;
use pointcore_contract::search::records::Points;
use pointcore_contract::splat::records::Pixel;
use pointcore_contract::{self as contract, Record, Words, read, search, splat};
use pointcore_golden::bus::{Burst, Reader};
use pointcore_hdl::bus::reader;
use pointcore_tb::lockstep::{Stall, Stalls, seeds};

use crate::bus::{Bench, Drain, Feed, SEEDS, stalls, words};

const REQUESTS: usize = 150;
const BORDER_BYTES: u32 = 4096;
const BURSTS_MAX: usize = 16;
/// `INCR`.
const INCREMENTING: u8 = 1;
/// Responses other than `OKAY`.
const ERRORS: RangeInclusive<u64> = 1..=3;

/// A byte of the memory, from its address.
fn byte(address: u32) -> u8 {
    (address.wrapping_mul(0x9e37_79b1) >> 19) as u8
}

fn memory(address: u32, count: u32) -> Vec<u8> {
    (address..address + count).map(byte).collect()
}

/// Beats that come before anything is asked for.
const UNASKED: usize = 20;

/// How often the memory answers wrongly.
#[derive(Clone, Copy)]
enum Memory {
    Sound,
    Faulty,
}

struct Exchange {
    cycles: u64,
    beats: u64,
}

/// Reads all requests, and compares bursts, records and counts.
fn exchange<R: Record<Domain = Words> + PartialEq>(
    config: &R::Config,
    memory_bits: u32,
    requests: &[(u32, u32)],
    records_max: u32,
    memory_kind: Memory,
    seed: u64,
    mut pattern: impl FnMut(&mut fastrand::Rng) -> Stalls,
) -> Exchange {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut bench = Bench::new(reader::module::<R>(config, memory_bits, records_max), seed);
    let ports = Ports::<R>::ALL;
    let patterns: Vec<Stalls> = (0..4).map(|_| pattern(&mut random)).collect();
    let [asks, addresses, answers, taken] = <[Stalls; 4]>::try_from(patterns).unwrap();
    let mut request = Feed::new(&bench, ports.request, &records_max, &mut random, asks);
    let mut address = Drain::new(&bench, ports.memory.address, &ADDRESS_BITS, addresses);
    let mut data = Feed::new(&bench, ports.memory.data, &memory_bits, &mut random, answers);
    let mut record = Drain::new(&bench, ports.record, config, taken);

    if matches!(memory_kind, Memory::Faulty) {
        beats_that_nobody_asked_for(&mut bench, &mut data, &mut record, memory_bits);
    }
    let model = Reader::<R>::new(config, memory_bits);
    let beat_bytes = memory_bits / 8;
    let mut bursts = VecDeque::new();
    let mut records = VecDeque::new();
    for &(first, count) in requests {
        request.items.push_back(contract::words(&records_max, ReadRequest { address: first, records: count }));
        bursts.extend(model.bursts(first, count));
        let addresses = (0..count).map(|number| first + number * model.stride());
        records.extend(addresses.map(|address| model.record(&memory(address, model.stride()))));
    }
    let beats = bursts.iter().map(|burst| u64::from(burst.beats)).sum();
    let (mut errors, mut misplaced) = (0, 0);
    let (mut errors_due, mut misplaced_due) = (0, 0);
    let (mut under_way, mut quiet) = (0usize, 0);
    let mut ends = VecDeque::new();
    while quiet < 50 {
        request.offer(&mut bench);
        address.offer(&mut bench);
        data.offer(&mut bench);
        record.offer(&mut bench);
        bench.step();
        request.taken(&bench);
        errors += bench.get("error");
        misplaced += bench.get("misplaced");
        if let Some(beat) = data.taken(&bench) {
            errors_due += u64::from(beat[beat.len() - 2] != 0);
            let (is_end, is_wrong): (bool, bool) = ends.pop_front().unwrap();
            under_way -= usize::from(is_end);
            misplaced_due += u64::from(is_end && is_wrong);
        }
        if let Some(burst) = address.taken(&bench) {
            let Burst { address: first, beats } = bursts.pop_front().expect("no more bursts than asked for");
            let (length, size) = ((beats - 1) as u8, beat_bytes.ilog2() as u8);
            let expected = BurstAddress { id: 0, address: first, length, size, burst: INCREMENTING };
            assert_eq!(read::<BurstAddress>(&ADDRESS_BITS, &burst), expected, "cycle {}", bench.cycle);
            assert_eq!(
                first / BORDER_BYTES,
                (first + beats * beat_bytes - 1) / BORDER_BYTES,
                "a burst crosses a border"
            );
            under_way += 1;
            assert!(under_way <= BURSTS_MAX, "{under_way} bursts under way");
            let fault =
                |random: &mut fastrand::Rng, chance| matches!(memory_kind, Memory::Faulty) && random.u8(..chance) == 0;
            let has_misplaced = fault(&mut random, 5);
            let early = random.u32(0..beats);
            for beat in 0..beats {
                let is_end = beat + 1 == beats;
                let last = if has_misplaced && early + 1 < beats {
                    beat == early || (is_end && early.is_multiple_of(2))
                } else {
                    is_end != has_misplaced
                };
                let resp = if fault(&mut random, 6) { random.u64(ERRORS) } else { 0 };
                let mut item = vec![random.u64(..16)];
                item.extend(words(&memory(first + beat * beat_bytes, beat_bytes)));
                item.extend([resp, last.into()]);
                data.items.push_back(item);
                ends.push_back((is_end, has_misplaced));
            }
        }
        if let Some(fields) = record.taken(&bench) {
            assert_eq!(Some(read::<R>(config, &fields)), records.pop_front(), "cycle {}", bench.cycle);
        }
        quiet = if records.is_empty() { quiet + 1 } else { 0 };
    }
    assert!(bursts.is_empty() && data.items.is_empty());
    assert_eq!((errors, misplaced), (errors_due, misplaced_due));
    if matches!(memory_kind, Memory::Faulty) {
        assert!(errors > 3 && misplaced > 3, "{errors} errors, {misplaced} misplaced");
    }
    Exchange { cycles: bench.cycle - 50, beats }
}

/// Each is taken, dropped and told of.
fn beats_that_nobody_asked_for(bench: &mut Bench, data: &mut Feed, record: &mut Drain, memory_bits: u32) {
    let words = (memory_bits as usize).div_ceil(64);
    data.items.extend((0..UNASKED).map(|beat| [vec![0; 1 + words], vec![0, u64::from(beat % 3 == 0)]].concat()));
    let (mut told, mut quiet) = (0, 0);
    while quiet < 50 {
        data.offer(bench);
        record.offer(bench);
        bench.step();
        data.taken(bench);
        told += bench.get("misplaced");
        assert_eq!(record.taken(bench), None, "a record of what nobody asked for");
        quiet = if data.items.is_empty() { quiet + 1 } else { 0 };
    }
    assert_eq!(told, UNASKED as u64);
}

/// Requests anywhere in memory, many near a border; none reaches beyond its end.
fn requests(stride: u32, records_max: u32, random: &mut fastrand::Rng) -> Vec<(u32, u32)> {
    let [borders, strides] = [BORDER_BYTES, stride].map(|bytes| (u32::MAX - records_max * stride) / bytes);
    let request = |random: &mut fastrand::Rng| {
        let near =
            BORDER_BYTES * random.u32(1..=borders) - stride * random.u32(0..=records_max.min(BORDER_BYTES / stride));
        let address = if random.bool() { near } else { random.u32(..strides) * stride };
        (address, random.u32(1..=records_max))
    };
    (0..REQUESTS).map(|_| request(random)).collect()
}

fn pixels() -> splat::Config {
    splat::Config { continuous: 3, cardinal: 1, ..splat::Config::default() }
}

fn points() -> search::Config {
    search::Config { lanes: 2, ..search::Config::default() }
}

fn exchange_all<R: Record<Domain = Words> + PartialEq>(config: &R::Config, records_max: u32, seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    for memory_bits in [32, 64, 512] {
        let stride = Reader::<R>::new(config, memory_bits).stride();
        let requests = requests(stride, records_max, &mut random);
        exchange::<R>(config, memory_bits, &requests, records_max, Memory::Faulty, seed, stalls);
    }
}

#[test]
fn bursts_and_records_are_those_asked_for() {
    for seed in seeds(SEEDS).unwrap() {
        exchange_all::<Pixel>(&pixels(), 64, seed);
        exchange_all::<Points>(&points(), 9, seed);
        exchange_all::<Pixel>(&pixels(), 1, seed);
    }
}

fn takes_a_beat_in_every_cycle<R: Record<Domain = Words> + PartialEq>(config: &R::Config, records_max: u32) {
    let never = |_: &mut fastrand::Rng| Stalls::new(Stall::Never, fastrand::Rng::with_seed(1));
    for memory_bits in [32, 64, 512] {
        let stride = Reader::<R>::new(config, memory_bits).stride();
        for count in [1, records_max] {
            let requests: Vec<_> = (0..REQUESTS as u32).map(|number| (number * 3 * stride * count, count)).collect();
            let Exchange { cycles, beats } =
                exchange::<R>(config, memory_bits, &requests, records_max, Memory::Sound, 1, never);
            // The way through the unit, and the memory's.
            assert!(cycles <= beats + 10, "{cycles} cycles for {beats} beats");
        }
    }
}

#[test]
fn it_takes_a_beat_in_every_cycle() {
    takes_a_beat_in_every_cycle::<Pixel>(&pixels(), 64);
    takes_a_beat_in_every_cycle::<Points>(&points(), 9);
    takes_a_beat_in_every_cycle::<Pixel>(&pixels(), 1);
}
