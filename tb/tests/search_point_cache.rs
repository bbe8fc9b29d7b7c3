//! The point cache against its model, with leaves that compete for slots and a memory that answers out of order.

use std::iter;
use std::ops::BitXor;

use pointcore_contract::search::{Config, units};
use pointcore_golden::search::PointCache;
use pointcore_hdl::search::point_cache;

use crate::search::environment::{Feeds, Rule};
use crate::search::memory::Memory;
use crate::search::{all, configs, lockstep};
use crate::support::cases;

const REQUESTS: u64 = 400;
const LEAVES: u64 = 96;
/// Leaves that are asked for again and again, by their distance from the first of them, and for how many requests.
const FAVORITES: [u64; 3] = [0, 1, LEAVES / 2];
const FASHION: u64 = 20;
/// By how many leaves favorites then move on: over nearly all of them, and by an even number, as pairs of them lie.
const STEP: u64 = 4;

/// The slot of a leaf: the bits of its address, laid over each other.
fn slot(config: &Config, address: u64) -> u64 {
    let slots = u64::from(config.point_cache);
    iter::successors(Some(address), |rest| Some(rest / slots)).take_while(|&rest| rest > 0).fold(0, BitXor::bitxor)
        % slots
}

/// Threads that ask for leaves.
#[derive(Clone)]
struct Requests {
    config: Config,
    /// First address and beats of each leaf.
    leaves: Vec<[u64; 2]>,
    left: u64,
    /// Seed of the points.
    seed: u64,
    memory: Memory,
    /// Requests without an answer.
    open: Vec<Vec<u64>>,
    /// The answer that has begun: its request, and the beats so far.
    answer: Option<(Vec<u64>, u64)>,
}

/// The points of a beat, as good as any.
fn points(config: &Config, seed: u64, address: u64) -> impl Iterator<Item = u64> {
    let mut random = fastrand::Rng::with_seed(seed ^ address);
    let width = config.geometry.width();
    (0..3 * config.lanes).map(move |_| random.u64(..1 << width))
}

impl Requests {
    /// Some leaves are asked for more often than others.
    fn ask(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.left > 0 {
            self.left -= 1;
            let favorite = STEP * (self.left / FASHION) + FAVORITES[feeds.random.usize(..FAVORITES.len())];
            let leaf = if feeds.random.u8(..4) == 0 { feeds.random.u64(..LEAVES) } else { favorite % LEAVES };
            let [address, beats] = self.leaves[leaf as usize];
            let request = vec![thread, address, beats];
            self.open.push(request.clone());
            feeds.feed("fetch", request);
        }
    }

    fn beat(&mut self, feeds: &mut Feeds, fields: &[u64]) {
        let (request, count) = self.answer.take().unwrap_or_else(|| {
            let begun = self.open.iter().position(|request| request[..2] == fields[..2]);
            (self.open.swap_remove(begun.expect("a leaf's first beat is that of a request")), 0)
        });
        let [thread, address, beats] = request[..] else { panic!("a request has three fields") };
        let last = count + 1 == beats;
        assert_eq!(fields[..3], [thread, address + count, u64::from(last)]);
        let expected = points(&self.config, self.seed, address + count);
        assert!(fields[3..].iter().copied().eq(expected), "the points of {address}");
        if last {
            self.ask(feeds, thread);
        } else {
            self.answer = Some((request, count + 1));
        }
    }
}

fn answer(config: &Config, seed: u64, feeds: &mut Feeds, request: &[u64]) {
    let &[thread, address, beats] = request else { panic!("a request has three fields") };
    for beat in address..address + beats {
        let place = [thread, beat, u64::from(beat + 1 == address + beats)];
        feeds.feed("fill", place.into_iter().chain(points(config, seed, beat)).collect());
    }
}

impl Rule for Requests {
    const SEEDS: u64 = 240;

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        let (config, seed) = (&self.config, self.seed);
        match stream {
            "miss" => self.memory.request(feeds, fields, |feeds, request| answer(config, seed, feeds, request)),
            "fill" if fields[2] == 1 => {
                self.memory.answered(feeds, |feeds, request| answer(config, seed, feeds, request));
            }
            "beat" => self.beat(feeds, fields),
            _ => {}
        }
    }
}

#[test]
fn leaves_are_kept_and_replaced_as_in_the_model() {
    for (config, point_cache) in cases(configs().into_iter().zip([2, 64, 8, 4])) {
        let config = Config { point_cache, ..config };
        let begin = |feeds: &mut Feeds| {
            // Over all of memory, so that every slot has some.
            let most = u64::from(config.bucket.div_ceil(config.lanes));
            let room = (1 << config.beat_bits()) / LEAVES;
            let leaves = (0..LEAVES).map(|leaf| {
                let beats = feeds.random.u64(1..=most);
                [leaf * room + feeds.random.u64(..=room - beats), beats]
            });
            let mut leaves: Vec<_> = leaves.collect();
            // Two favorites may share a slot, and take it from each other. Where slots are few, they do anyway.
            if u64::from(config.point_cache) > LEAVES / 2 && feeds.random.bool() {
                leaves.sort_by_key(|[address, _]| slot(&config, *address));
                leaves.rotate_left(feeds.random.usize(..LEAVES as usize));
            }
            let mut requests = Requests {
                config: config.clone(),
                leaves,
                left: REQUESTS,
                seed: feeds.random.u64(..),
                memory: Memory::default(),
                open: vec![],
                answer: None,
            };
            // Two at least: one may be looked up while the other comes.
            for thread in 0..(config.threads * config.leaves_in_flight).max(2) {
                requests.ask(feeds, (thread % config.threads).into());
            }
            requests
        };
        let (module, model) = (point_cache::module(&config), PointCache::new(&config));
        lockstep(&config, &module, &model, &units::point_cache::UNIT, begin, all, |requests, report| {
            assert!(requests.left == 0 && requests.open.is_empty() && requests.answer.is_none());
            let [hits, misses] = ["event_point_hit", "event_point_miss"].map(|event| report.events(event));
            assert_eq!((hits + misses, misses), (REQUESTS, report.transfers("miss")));
            assert!(hits > REQUESTS / 20 && misses >= FAVORITES.len() as u64, "{hits} hits, {misses} misses");
        });
    }
}
