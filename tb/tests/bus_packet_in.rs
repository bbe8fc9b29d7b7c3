//! `bus_packet_in` against its model: good packets between short, long and senseless ones.

use pointcore_contract::bus::packets::Packet;
use pointcore_contract::bus::units::packet_in::Ports;
use pointcore_contract::search::records::CachedQuery;
use pointcore_contract::splat::records::Splat;
use pointcore_contract::{self as contract, Field, Words, fields, read, search, splat};
use pointcore_golden::bus::{PacketIn, PacketOut, Verdict};
use pointcore_hdl::bus::packet_in;
use pointcore_tb::lockstep::{Stall, Stalls, seeds};

use crate::bus::{Bench, Drain, Feed, SEEDS, bytes, stalls, words};

const PACKETS: usize = 300;
/// Cycles after the last beat; longer than any stall.
const QUIET_CYCLES: u32 = 100;
/// Packets of a run where they do not say themselves which is the last.
const RUN: u64 = 5;

/// A record that comes as a packet.
trait Received: Packet<Domain = Words> + PartialEq {}

impl<R: Packet<Domain = Words> + PartialEq> Received for R {}

/// Random values of a record, now and then one out of its range.
fn record<R: Received>(config: &R::Config, random: &mut fastrand::Rng) -> R {
    let (ranges, end) = (R::ranges(config), R::end(config));
    let value = |(place, field): (usize, Field)| match ranges.iter().find(|range| range.field == place) {
        Some(range) if random.u8(..8) > 0 => random.u32(range.low..=range.high).into(),
        _ if end == Some(place) => u64::from(random.u8(..6) == 0),
        _ => random.u64(..) >> (64 - field.width),
    };
    let values: Vec<u64> = fields::<R>(config).into_iter().enumerate().map(value).collect();
    read(config, &values)
}

/// What a packet holds where it holds no field is noise.
fn fill_with_noise(packet: &mut [(Vec<u8>, bool)], fields: &[(Vec<u8>, bool)], random: &mut fastrand::Rng) {
    for ((beat, _), (holds, _)) in packet.iter_mut().zip(fields) {
        beat.iter_mut().zip(holds).for_each(|(byte, holds)| *byte |= random.u8(..) & !holds);
    }
}

/// The beats of many packets, some of a wrong length.
fn beats<R: Received>(config: &R::Config, stream_bits: u32, random: &mut fastrand::Rng) -> Vec<(Vec<u8>, bool)> {
    let sender = PacketOut::<R>::new(config, stream_bits);
    let ones: Vec<u64> = fields::<R>(config).iter().map(|field| u64::MAX >> (64 - field.width)).collect();
    let ones = sender.beats(read(config, &ones));
    let mut all = vec![];
    for _ in 0..PACKETS {
        let mut packet = sender.beats(record(config, random));
        fill_with_noise(&mut packet, &ones, random);
        let whole = packet.len();
        match random.u8(..8) {
            0 => packet.truncate(random.usize(1..=whole)),
            1 => (0..random.usize(1..=whole + 1))
                .for_each(|_| packet.push((vec![0xa5; stream_bits as usize / 8], false))),
            _ => {}
        }
        let last = packet.len() - 1;
        packet.iter_mut().enumerate().for_each(|(place, beat)| beat.1 = place == last);
        all.extend(packet);
    }
    all
}

/// Sends all beats; the unit must take and refuse what the model does, in the same cycles, and be open when it is to be.
fn exchange<R: Received>(config: &R::Config, stream_bits: u32, seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut bench = Bench::new(packet_in::module::<R>(config, stream_bits), seed);
    let (end, ports) = (R::end(config), Ports::<R>::ALL);
    let pattern = stalls(&mut random);
    let mut source = Feed::new(&bench, ports.packets.beats, &stream_bits, &mut random, pattern);
    let mut sink = Drain::new(&bench, ports.out, config, stalls(&mut random));
    let mut sent = beats::<R>(config, stream_bits, &mut random);
    // A good packet that ends the last run, whatever came before.
    let mut closing = vec![0; fields::<R>(config).len()];
    end.into_iter().for_each(|end| closing[end] = 1);
    R::ranges(config).into_iter().for_each(|range| closing[range.field] = range.low.into());
    let closing: R = read(config, &closing);
    (0..RUN).for_each(|_| sent.extend(PacketOut::new(config, stream_bits).beats(closing)));
    for (data, tlast) in &sent {
        let mut item = words(data);
        item.push(u64::from(*tlast));
        source.items.push_back(item);
    }

    let mut model = PacketIn::<R>::new(config, stream_bits);
    let (mut expected, mut received) = (vec![], vec![]);
    let (mut is_open, mut in_packet, mut left) = (false, false, RUN);
    let (mut verdict, mut refused) = (None, 0);
    let beat_bytes = stream_bits as usize / 8;
    let mut idle = 0;
    while idle < QUIET_CYCLES {
        let opening = !is_open && !in_packet && random.u8(..10) == 0;
        bench.set("opens", opening.into());
        if end.is_none() {
            bench.set("last", u64::from(left == 1));
        }
        source.offer(&mut bench);
        sink.offer(&mut bench);
        bench.step();
        let shown = [bench.get("taken"), bench.get("refused")];
        let due = [matches!(verdict, Some(Verdict::Taken(_))), verdict == Some(Verdict::Refused)].map(u64::from);
        assert_eq!(shown, due, "cycle {}: taken, refused", bench.cycle);
        refused += shown[1];
        verdict = None;
        if let Some(beat) = source.taken(&bench) {
            assert!(is_open || in_packet, "cycle {}: a beat was taken while closed", bench.cycle);
            let (data, tlast) = beat.split_at(beat.len() - 1);
            in_packet = tlast[0] == 0;
            verdict = model.beat(&bytes(data, beat_bytes), tlast[0] == 1);
            if let Some(Verdict::Taken(record)) = verdict {
                left -= 1;
                is_open = end.map_or(left > 0, |end| contract::words(config, record)[end] == 0);
                left = if left == 0 { RUN } else { left };
                expected.push(record);
            }
        }
        is_open |= opening;
        received.extend(sink.taken(&bench).map(|item| read::<R>(config, &item)));
        idle = if source.items.is_empty() { idle + 1 } else { 0 };
    }
    assert_eq!(received, expected);
    assert!(refused > 10 && expected.len() > PACKETS / 2, "{refused} refused, {} taken", expected.len());
}

fn splats() -> splat::Config {
    splat::Config { continuous: 3, ..splat::Config::default() }
}

fn queries() -> search::Config {
    search::Config { neighbors: 20, ..search::Config::default() }
}

#[test]
fn good_packets_come_out_and_others_are_counted() {
    for seed in seeds(SEEDS).unwrap() {
        for stream_bits in [32, 64, 512] {
            exchange::<Splat>(&splats(), stream_bits, seed);
            exchange::<CachedQuery>(&queries(), stream_bits, seed);
        }
    }
}

/// A query of which all is in its range.
fn query(config: &search::Config, random: &mut fastrand::Rng) -> CachedQuery {
    let mut query: CachedQuery = record(config, random);
    query.query.k = query.query.k.clamp(1, config.neighbors as u8);
    query.query.radius2 = query.query.radius2.min(config.geometry.infinity() as u32);
    query
}

#[test]
fn it_takes_a_beat_in_every_cycle() {
    let config = &queries();
    let ports = Ports::<CachedQuery>::ALL;
    for stream_bits in [32, 512] {
        let mut random = fastrand::Rng::with_seed(1);
        let mut bench = Bench::new(packet_in::module::<CachedQuery>(config, stream_bits), 1);
        let never = || Stalls::new(Stall::Never, fastrand::Rng::with_seed(1));
        let mut source = Feed::new(&bench, ports.packets.beats, &stream_bits, &mut random, never());
        let mut sink = Drain::new(&bench, ports.out, config, never());
        let sender = PacketOut::<CachedQuery>::new(config, stream_bits);
        for _ in 0..PACKETS {
            for (data, tlast) in sender.beats(query(config, &mut random)) {
                source.items.push_back(words(&data).into_iter().chain([u64::from(tlast)]).collect());
            }
        }
        let beats = source.items.len() as u64;
        let mut received = 0;
        bench.set("opens", 1);
        bench.set("last", 0);
        while received < PACKETS {
            source.offer(&mut bench);
            sink.offer(&mut bench);
            bench.step();
            bench.set("opens", 0);
            source.taken(&bench);
            received += usize::from(sink.taken(&bench).is_some());
        }
        // One to open, three through the unit.
        assert!(bench.cycle <= beats + 4, "{} cycles for {beats} beats", bench.cycle);
    }
}
