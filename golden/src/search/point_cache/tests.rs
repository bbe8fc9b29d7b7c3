use super::*;
use crate::testing::for_each_seed;
use fastrand::Rng;
use pointcore_contract::search::records::Thread;
use std::collections::VecDeque;

fn unit(point_cache: u32) -> PointCache {
    PointCache::new(&Config { point_cache, lanes: 1, bucket: 4, threads: 4, ..Config::default() })
}

fn fetch(thread: u8, address: u32, beats: u8) -> Fetch {
    Fetch { thread: Thread { thread }, address, beats }
}

/// What the memory answers: every beat's point tells its address.
fn answer(Fetch { thread, address, beats }: Fetch) -> Vec<Beat> {
    let beat = |number| {
        let address = address + u32::from(number);
        let mut points = [Point::default(); LANES_MAX];
        points[0] = [address, address + 1, address + 2];
        Beat { place: BeatPlace { thread, address, last: number + 1 == beats }, points: Points { lane: points } }
    };
    (0..beats).map(beat).collect()
}

/// The unit with requests that wait, and a memory.
struct Bench {
    cache: PointCache,
    requests: VecDeque<Fetch>,
    missed: Vec<Fetch>,
    fill: VecDeque<Beat>,
    beats: Vec<Beat>,
    hits: usize,
}

impl Bench {
    fn new(point_cache: u32) -> Self {
        let cache = unit(point_cache);
        Self { cache, requests: VecDeque::new(), missed: vec![], fill: VecDeque::new(), beats: vec![], hits: 0 }
    }

    fn clock(&mut self, goes_on: [bool; 4]) {
        let [requests, takes_beats, takes_misses, fills] = goes_on;
        let out = self.cache.outputs();
        let inputs = In {
            fetch: self.requests.front().copied().filter(|_| requests),
            beat_ready: takes_beats,
            miss_ready: takes_misses,
            fill: self.fill.front().copied().filter(|_| fills),
        };
        if inputs.fetch.is_some() && out.fetch_ready {
            self.requests.pop_front();
        }
        if inputs.fill.is_some() && out.fill_ready {
            self.fill.pop_front();
        }
        self.missed.extend(out.miss.filter(|_| takes_misses));
        self.beats.extend(out.beat.filter(|_| takes_beats));
        self.hits += usize::from(out.events.hit);
        self.cache.clock(&inputs);
    }

    /// Sends requests, answers what is missed after all of them, and waits; returns how many were missed.
    fn serve(&mut self, requests: &[Fetch]) -> usize {
        self.requests.extend(requests);
        for cycle in 0..100 {
            self.clock([true; 4]);
            if cycle == 50 {
                self.fill.extend(self.missed.iter().copied().flat_map(answer));
            }
        }
        std::mem::take(&mut self.missed).len()
    }
}

#[test]
fn a_leaf_is_fetched_once_and_then_served_to_any_thread() {
    let mut bench = Bench::new(2);
    assert_eq!(bench.serve(&[fetch(0, 8, 3)]), 1);
    assert_eq!(bench.serve(&[fetch(3, 8, 3), fetch(1, 8, 3)]), 0);
    let expected: Vec<_> = [0, 3, 1].into_iter().flat_map(|thread| answer(fetch(thread, 8, 3))).collect();
    assert!(bench.beats == expected && bench.hits == 2);
}

#[test]
fn a_leaf_gives_way_to_the_next_of_its_slot() {
    let (first, second, other) = (0b0100, 0b1000, 0b1100);
    assert_eq!([first, second, other].map(|address| slot(address, 4)), [1, 2, 3]);
    assert_eq!(slot(0b01_01_01, 4), slot(first, 4));
    let mut bench = Bench::new(4);
    assert_eq!(bench.serve(&[fetch(0, first, 1), fetch(1, second, 4)]), 2);
    assert_eq!(bench.serve(&[fetch(0, 0b01_01_01, 1)]), 1);
    assert_eq!(bench.serve(&[fetch(2, first, 1), fetch(2, second, 4)]), 1, "only the first is gone");
}

#[test]
fn a_slot_is_the_xor_of_an_addresss_pieces() {
    assert_eq!(slot(0b1_0110_1001, 16), 0b1 ^ 0b0110 ^ 0b1001);
    assert_eq!(slot(0xffff_ffff, 2), 0, "an even number of ones");
}

#[test]
fn a_leaf_from_memory_does_not_take_the_slot_of_a_request_under_way() {
    let mut bench = Bench::new(2);
    bench.serve(&[fetch(0, 2, 2)]);
    // Leaf 4 is of the same slot; its answer comes while leaf 2 is looked up behind a leaf that is being read.
    bench.requests.extend([fetch(1, 4, 1)]);
    (0..10).for_each(|_| bench.clock([true; 4]));
    let missed = bench.missed.pop().unwrap();
    bench.requests.extend([fetch(2, 2, 2), fetch(3, 2, 2), fetch(1, 2, 2)]);
    (0..10).for_each(|_| bench.clock([true, false, true, true]));
    bench.fill.extend(answer(missed));
    assert_eq!(bench.serve(&[fetch(0, 2, 2)]), 0, "leaf 2 is still there");
    let (from_memory, from_slot): (Vec<_>, Vec<_>) = bench.beats.iter().partition(|beat| beat.place.address == 4);
    assert_eq!((from_memory, bench.hits), (answer(missed), 4), "and leaf 4 was served");
    let expected: Vec<_> = [0, 2, 3, 1, 0].into_iter().flat_map(|thread| answer(fetch(thread, 2, 2))).collect();
    assert_eq!(from_slot, expected, "with its points");
}

/// Any requests in any order of answers under random stalls: every thread gets the leaves it asked for, whole.
#[test]
fn whole_leaves_come_whatever_the_memory_does() {
    for_each_seed("point_cache", |random: &mut Rng| {
        let mut bench = Bench::new([2, 8, 64][random.usize(..3)]);
        let leaves: Vec<_> = (0..20).map(|leaf| (leaf * 7, random.u8(1..=4))).collect();
        let mut expected = Vec::new();
        let mut memory = Vec::new();
        let (mut misses, mut requests) = (0, 0);
        for cycle in 0..10_000 {
            if bench.requests.is_empty() && expected.len() < 12 && cycle < 9_000 {
                let (address, beats) = leaves[random.usize(..leaves.len())];
                let request = fetch(random.u8(0..4), address, beats);
                bench.requests.push_back(request);
                expected.push(request);
                requests += 1;
            }
            bench.clock([(); 4].map(|()| random.u8(0..4) > 0));
            misses += bench.missed.len();
            memory.append(&mut bench.missed);
            // The memory answers seldom, so that a few requests wait in it, and in any order.
            if bench.fill.is_empty() && !memory.is_empty() && random.u8(0..8) == 0 {
                bench.fill.extend(answer(memory.swap_remove(random.usize(..memory.len()))));
            }
            while let Some(end) = bench.beats.iter().position(|beat| beat.place.last) {
                let leaf: Vec<_> = bench.beats.drain(..=end).collect();
                let request = expected.iter().position(|request| answer(*request) == leaf);
                expected.swap_remove(request.expect("a leaf comes as it was asked for"));
            }
        }
        assert!(expected.is_empty(), "{} requests are not answered", expected.len());
        assert!(bench.hits > 50 && misses > 50, "{} hits and {misses} misses of {requests}", bench.hits);
    });
}
