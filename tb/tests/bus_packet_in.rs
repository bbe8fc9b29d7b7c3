//! `bus_packet_in` against its model: good packets between short, long and senseless ones.

use pointcore_contract::bus::packets::{self, FieldRange};
use pointcore_contract::search;
use pointcore_contract::{Field, fields, splat};
use pointcore_golden::bus::{PacketIn, PacketOut, Verdict};
use pointcore_hdl::bus::packet_in;
use pointcore_tb::lockstep::{Stall, Stalls, seeds};

use crate::bus::{Bench, Drain, Feed, SEEDS, bytes, stalls, words};

const PACKETS: usize = 300;
/// Cycles after the last beat; longer than any stall.
const QUIET_CYCLES: u32 = 100;
/// Packets of a run where they do not say themselves which is the last.
const RUN: u64 = 5;

/// Random values of a record, now and then one out of its range.
fn record(fields: &[Field], range: Option<FieldRange>, random: &mut fastrand::Rng) -> Vec<u64> {
    let value = |Field { name, width, .. }: &Field, random: &mut fastrand::Rng| match range {
        Some(range) if range.name == name && random.u8(..8) > 0 => random.u32(range.low..=range.high).into(),
        _ if name == "end" => u64::from(random.u8(..6) == 0),
        _ => random.u64(..) >> (64 - width),
    };
    fields.iter().map(|field| value(field, random)).collect()
}

/// The beats of many packets, some of a wrong length.
fn beats(
    fields: &[Field],
    stream_bits: u32,
    range: Option<FieldRange>,
    random: &mut fastrand::Rng,
) -> Vec<(Vec<u8>, bool)> {
    let sender = PacketOut::new(fields, stream_bits);
    let mut all = vec![];
    for _ in 0..PACKETS {
        let mut packet = sender.beats(&record(fields, range, random));
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
fn exchange(fields: &[Field], stream_bits: u32, range: Option<FieldRange>, seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut bench = Bench::new(packet_in::module(fields, stream_bits, range.as_ref()), seed);
    let has_end = fields[0].name == "end";
    let pattern = stalls(&mut random);
    let mut source = Feed::new(&bench, "s_axis_t", &["data", "last"], &mut random, pattern);
    let names: Vec<&str> = fields.iter().map(|field| field.name.as_str()).collect();
    let mut sink = Drain::new(&bench, "out_", &names, stalls(&mut random));
    let mut sent = beats(fields, stream_bits, range, &mut random);
    // A good packet that ends the last run, whatever came before.
    let mut closing = vec![0; fields.len()];
    closing[0] = 1;
    if let Some(range) = range {
        closing[names.iter().position(|name| *name == range.name).unwrap()] = range.low.into();
    }
    (0..RUN).for_each(|_| sent.extend(PacketOut::new(fields, stream_bits).beats(&closing)));
    for (data, tlast) in &sent {
        let mut item = words(data);
        item.push(u64::from(*tlast));
        source.items.push_back(item);
    }

    let mut model = PacketIn::new(fields, stream_bits, range);
    let (mut expected, mut received) = (vec![], vec![]);
    let (mut is_open, mut in_packet, mut left) = (false, false, RUN);
    let (mut verdict, mut refused) = (None, 0);
    let beat_bytes = stream_bits as usize / 8;
    let mut idle = 0;
    while idle < QUIET_CYCLES {
        let opening = !is_open && !in_packet && random.u8(..10) == 0;
        bench.set("opens", opening.into());
        if !has_end {
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
            if let Some(Verdict::Taken(record)) = &verdict {
                left -= 1;
                is_open = if has_end { record[0] == 0 } else { left > 0 };
                left = if left == 0 { RUN } else { left };
                expected.push(record.clone());
            }
        }
        is_open |= opening;
        received.extend(sink.taken(&bench));
        idle = if source.items.is_empty() { idle + 1 } else { 0 };
    }
    assert_eq!(received, expected);
    assert!(refused > 10 && expected.len() > PACKETS / 2, "{refused} refused, {} taken", expected.len());
}

fn splat() -> Vec<Field> {
    fields::<splat::records::Splat>(&splat::Config { continuous: 3, ..splat::Config::default() })
}

fn query() -> (Vec<Field>, FieldRange) {
    let config = search::Config { neighbors: 20, ..search::Config::default() };
    let [query, _] = packets::query_and_result(&config);
    (query, packets::query_range(&config))
}

#[test]
fn good_packets_come_out_and_others_are_counted() {
    for seed in seeds(SEEDS).unwrap() {
        for stream_bits in [32, 64, 512] {
            exchange(&splat(), stream_bits, None, seed);
            let (query, range) = query();
            exchange(&query, stream_bits, Some(range), seed);
        }
    }
}

#[test]
fn it_takes_a_beat_in_every_cycle() {
    let (fields, _) = query();
    for stream_bits in [32, 512] {
        let mut random = fastrand::Rng::with_seed(1);
        let mut bench = Bench::new(packet_in::module(&fields, stream_bits, None), 1);
        let never = || Stalls::new(Stall::Never, fastrand::Rng::with_seed(1));
        let mut source = Feed::new(&bench, "s_axis_t", &["data", "last"], &mut random, never());
        let names: Vec<&str> = fields.iter().map(|field| field.name.as_str()).collect();
        let mut sink = Drain::new(&bench, "out_", &names, never());
        let sender = PacketOut::new(&fields, stream_bits);
        for _ in 0..PACKETS {
            for (data, tlast) in sender.beats(&record(&fields, None, &mut random)) {
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
