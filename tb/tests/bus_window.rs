//! `bus_window` against its model: bursts of every kind, in the way of a run and not.

use std::collections::VecDeque;

use pointcore_contract::bus::axi::{BurstAddress, ReadBeat, Slave, WriteAnswer, WriteBeat};
use pointcore_contract::bus::config::TREE_WORD_BITS;
use pointcore_contract::bus::units::window::Ports;
use pointcore_contract::bus::units::window_bits;
use pointcore_contract::words;
use pointcore_golden::bus::Window;
use pointcore_golden::bus::window::Outcome;
use pointcore_hdl::bus::window;
use pointcore_tb::lockstep::{Stall, Stalls, seeds};

use crate::bus::{Bench, Drain, Feed, SEEDS, stalls};

const BURSTS: usize = 400;
const OKAY: u8 = 0;
const SLAVE_ERROR: u8 = 2;
const HOST: Slave = Ports::ALL.host;

/// Mostly what is accepted; of the others some begin beyond the window, just behind its end or anywhere in the range of addresses.
fn address(index_bits: u32, random: &mut fastrand::Rng) -> BurstAddress {
    let inside = random.u32(..1 << index_bits) * 8;
    let longest = [4, 4, 32, 255][random.usize(..4)];
    let length = random.u8(..longest);
    let length =
        if random.u8(..3) > 0 { length.min(((1 << index_bits) - 1 - inside / 8).min(255) as u8) } else { length };
    let id = random.u8(..16);
    let mut chosen = BurstAddress { id, address: inside, length, size: 3, burst: 1 };
    let (end, range) = (8 << index_bits, 1 << window_bits(index_bits).address);
    match random.u8(..12) {
        0 => chosen.address |= random.u32(1..8),
        3 if end < range => chosen.address = end,
        4 if end < range => chosen.address = random.u32(end / 8..range / 8) * 8,
        1 => chosen.size = random.u8(..3),
        2 => chosen.burst = [0, 2, 3][random.usize(..3)],
        _ => {}
    }
    chosen
}

fn beats(length: u8, random: &mut fastrand::Rng) -> Vec<WriteBeat> {
    let is_sound = random.u8(..5) > 0;
    let beat = |place: u8, random: &mut fastrand::Rng| {
        let mut beat: WriteBeat = WriteBeat { data: random.u64(..), strobes: 0xff, last: place == length };
        match random.u8(..6) {
            0 if !is_sound => beat.strobes = random.u64(..0xff),
            1 if !is_sound => beat.last = !beat.last,
            _ => {}
        }
        beat
    };
    (0..=length).map(|place| beat(place, random)).collect()
}

#[test]
fn what_is_accepted_is_written_and_all_is_answered() {
    for seed in seeds(SEEDS).unwrap() {
        for index_bits in [2, 5, 10] {
            exchange(index_bits, seed);
        }
    }
}

/// A burst on its way, and its answer.
struct Burst {
    address: BurstAddress,
    beats: Vec<WriteBeat>,
}

fn exchange(index_bits: u32, seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut bench = Bench::new(window::module(index_bits), seed);
    let patterns: Vec<Stalls> = (0..5).map(|_| stalls(&mut random)).collect();
    let [a, w, b, ar, r] = <[Stalls; 5]>::try_from(patterns).unwrap();
    let address_bits = window_bits(index_bits).address;
    let mut address_feed = Feed::new(&bench, HOST.write_address, &address_bits, &mut random, a);
    let mut data = Feed::new(&bench, HOST.write_data, &TREE_WORD_BITS, &mut random, w);
    let mut answer = Drain::new(&bench, HOST.write_answer, &(), b);
    let mut read_address = Feed::new(&bench, HOST.read_address, &address_bits, &mut random, ar);
    let mut read_data = Drain::new(&bench, HOST.read_data, &TREE_WORD_BITS, r);

    let model = Window::new(index_bits);
    let (mut bursts, mut reads) = (VecDeque::new(), VecDeque::new());
    for _ in 0..BURSTS {
        let [to, from] = [(); 2].map(|()| address(index_bits, &mut random));
        let beats = beats(to.length, &mut random);
        address_feed.items.push_back(words(&address_bits, to));
        data.items.extend(beats.iter().map(|beat| words(&TREE_WORD_BITS, *beat)));
        bursts.push_back(Burst { address: to, beats });
        read_address.items.push_back(words(&address_bits, from));
        let beat = |place| ReadBeat { id: from.id, data: 0, response: SLAVE_ERROR, last: place == from.length };
        reads.extend((0..=from.length).map(beat));
    }
    let has_beyond = bursts.iter().any(|Burst { address, .. }| address.address == 8 << index_bits);
    assert_eq!(has_beyond, 8 << index_bits < 1 << address_bits, "bursts right behind the end of the window");
    let (mut written, mut expected_writes) = (vec![], vec![]);
    let mut answers = VecDeque::new();
    // Every read is refused for what it is.
    let (mut refused, mut due) = ([0, 0], [BURSTS as u64, 0]);
    let (mut judged, mut is_locked, mut answered, mut okay) = (false, false, 0, 0);
    let mut left = 0;
    while answered < BURSTS || !reads.is_empty() {
        is_locked = if random.u8(..40) == 0 { !is_locked } else { is_locked };
        bench.set("locked", is_locked.into());
        [&mut address_feed, &mut data, &mut read_address].into_iter().for_each(|feed| feed.offer(&mut bench));
        [&mut answer, &mut read_data].into_iter().for_each(|drain| drain.offer(&mut bench));
        bench.step();
        assert_eq!(bench.get("occupied"), u64::from(judged || left > 0), "cycle {}", bench.cycle);
        if judged {
            // The lock counts in the cycle after the address was taken.
            let Burst { address, beats } = bursts.pop_front().unwrap();
            left = beats.len();
            let (writes, outcome) = model.write(address, &beats, is_locked);
            expected_writes.extend(writes);
            let response = if outcome == Outcome::Okay { OKAY } else { SLAVE_ERROR };
            answers.push_back(words(&(), WriteAnswer { id: address.id, response }));
            due[0] += u64::from(outcome == Outcome::RefusedBurst);
            due[1] += u64::from(outcome == Outcome::RefusedBusy);
            okay += u32::from(outcome == Outcome::Okay);
        }
        judged = address_feed.taken(&bench).is_some();
        if data.taken(&bench).is_some() {
            assert!(left > 0, "cycle {}: a word was taken without an address", bench.cycle);
            left -= 1;
        }
        if bench.get("write_valid") == 1 {
            written.push((bench.get("write_index") as u32, bench.get("write_data")));
        }
        refused[0] += bench.get("refused_burst");
        refused[1] += bench.get("refused_busy");
        read_address.taken(&bench);
        if let Some(item) = answer.taken(&bench) {
            assert_eq!(Some(item), answers.pop_front(), "cycle {}", bench.cycle);
            assert_eq!(left, 0, "cycle {}: answered before its last word", bench.cycle);
            answered += 1;
        }
        if let Some(item) = read_data.taken(&bench) {
            assert_eq!(Some(item), reads.pop_front().map(|beat| words(&TREE_WORD_BITS, beat)), "cycle {}", bench.cycle);
        }
    }
    for _ in 0..3 {
        bench.set("s_axi_awvalid", 0);
        bench.set("s_axi_arvalid", 0);
        bench.step();
        refused[0] += bench.get("refused_burst");
        refused[1] += bench.get("refused_busy");
    }
    assert_eq!(written, expected_writes);
    assert_eq!(refused, due, "refused for what they are, for a run");
    assert!(okay > 20 && refused[1] > 20, "{okay} accepted, {refused:?} refused");
}

#[test]
fn a_burst_takes_a_word_in_every_cycle() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut bench = Bench::new(window::module(10), 1);
    let never = || Stalls::new(Stall::Never, fastrand::Rng::with_seed(1));
    let mut address = Feed::new(&bench, HOST.write_address, &window_bits(10).address, &mut random, never());
    let mut data = Feed::new(&bench, HOST.write_data, &TREE_WORD_BITS, &mut random, never());
    let mut answer = Drain::new(&bench, HOST.write_answer, &(), never());
    address.items.push_back(vec![3, 0, 255, 3, 1]);
    data.items.extend((0..256).map(|word| vec![word, 0xff, u64::from(word == 255)]));
    let mut is_answered = false;
    while !is_answered {
        [&mut address, &mut data].into_iter().for_each(|feed| feed.offer(&mut bench));
        answer.offer(&mut bench);
        bench.step();
        address.taken(&bench);
        data.taken(&bench);
        is_answered = answer.taken(&bench).is_some();
        // The address, its judgement, the words, the answer.
        assert!(bench.cycle <= 1 + 1 + 256 + 1, "no answer after {} cycles", bench.cycle);
    }
}
