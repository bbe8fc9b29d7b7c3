mod together;

use super::*;
use crate::testing::for_each_seed;
use fastrand::Rng;
use pointcore_contract::search::records::{CachedQuery, CachedResult, QueryResult};
use std::collections::{HashMap, VecDeque};

/// Cycles without any transfer after which the unit counts as stuck.
const PATIENCE: u32 = 3000;

const K: u8 = 4;

fn config(neighbor_cache: u32) -> Config {
    Config { neighbor_cache, neighbors: 6, threads: 4, ..Config::default() }
}

/// Balls that are reused out to the farthest neighbor.
fn balls() -> CacheSetup {
    CacheSetup { ball: true, far_scale: 1f32.to_bits(), margin_scale: 1f32.to_bits() }
}

fn query(number: u32, x: f32, radius: f32, reach: f32) -> CachedQuery {
    let query = Query { number, k: K, radius2: (radius * radius).to_bits(), point: [x, 0.0, 0.0].map(f32::to_bits) };
    CachedQuery { query, reach: reach.to_bits() }
}

/// The unit with a search that answers in any order with neighborhoods which tell their query's place: neighbor `i` of `n` of a
/// query at `x` has the index `16·x + i` and the squared distance `radius²·i/n`.
struct Bench {
    cache: NeighborCache,
    latency: u64,
    /// In how many of eight cycles a stream pauses.
    pauses: u8,
    cycle: u64,
    searches: Vec<(Query, u64)>,
    found: VecDeque<QueryResult>,
    hits: u32,
    misses: u32,
}

/// What a query was answered with.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Answer {
    number: u32,
    indices: Vec<u32>,
    cached: bool,
}

fn neighborhood(query: &Query) -> Vec<QueryResult> {
    let x = f32::from_bits(query.point[0]);
    let count = (x as u8) % (query.k + 1);
    let result = |i: u8| QueryResult {
        number: query.number,
        last: i + 1 >= count,
        found: i < count,
        index: if i < count { 16 * (x as u32) + u32::from(i) } else { 0 },
        distance2: (f32::from_bits(query.radius2) * f32::from(i) / f32::from(count.max(1))).to_bits(),
    };
    (0..count.max(1)).map(result).collect()
}

impl Bench {
    fn new(config: &Config, latencies: CacheLatencies, setup: CacheSetup) -> Self {
        let mut cache = NeighborCache::new(config, latencies);
        cache.clock(&In { setup: Some(setup), ..In::default() });
        Self {
            cache,
            latency: 1,
            pauses: 0,
            cycle: 0,
            searches: Vec::new(),
            found: VecDeque::new(),
            hits: 0,
            misses: 0,
        }
    }

    fn idle(&mut self, cycles: u32) {
        (0..cycles).for_each(|_| self.cache.clock(&In::default()));
    }

    /// Answers in the order in which they come.
    fn run(&mut self, queries: &[CachedQuery], random: &mut Rng) -> Vec<Answer> {
        let mut left = queries.iter();
        let (mut answers, mut answer) = (Vec::new(), Answer::default());
        let mut patience = PATIENCE;
        while answers.len() < queries.len() {
            let out = self.cache.outputs();
            let mut goes_on = || random.u8(0..8) >= self.pauses;
            let inputs = In {
                setup: None,
                query: left.as_slice().first().copied().filter(|_| goes_on()),
                search_ready: self.searches.len() < 4 && goes_on(),
                found: self.found.front().copied().filter(|_| goes_on()),
                result_ready: goes_on(),
            };
            patience -= 1;
            if inputs.query.is_some() && out.query_ready {
                left.next();
                patience = PATIENCE;
            }
            if inputs.found.is_some() && out.found_ready {
                self.found.pop_front();
                patience = PATIENCE;
            }
            if let Some(CachedResult { result, cached }) = out.result.filter(|_| inputs.result_ready) {
                assert!(answer.indices.is_empty() || (result.number, cached) == (answer.number, answer.cached));
                (answer.number, answer.cached) = (result.number, cached);
                answer.indices.extend(result.found.then_some(result.index));
                if result.last {
                    answers.push(std::mem::take(&mut answer));
                }
                patience = PATIENCE;
            }
            if let Some(search) = out.search.filter(|_| inputs.search_ready) {
                self.searches.push((search, self.cycle + random.u64(1..=self.latency)));
                patience = PATIENCE;
            }
            if self.found.is_empty() {
                let ready: Vec<_> = (0..self.searches.len()).filter(|i| self.searches[*i].1 <= self.cycle).collect();
                if let Some(i) = random.choice(ready) {
                    self.found = neighborhood(&self.searches.swap_remove(i).0).into();
                }
            }
            self.hits += u32::from(out.events.hit);
            self.misses += u32::from(out.events.miss);
            self.cache.clock(&inputs);
            self.cycle += 1;
            assert!(patience > 0, "stuck in cycle {}: {:?}", self.cycle, self.cache);
        }
        answers
    }

    /// One query, until all that it sets off is over.
    fn ask(&mut self, query: CachedQuery) -> Answer {
        let answer = self.run(&[query], &mut Rng::with_seed(0)).remove(0);
        self.idle(40);
        answer
    }
}

const LATENCIES: CacheLatencies = CacheLatencies { check: 5, cover: 9 };

#[test]
fn a_ball_is_covered_well_inside_a_larger_one() {
    let mut bench = Bench::new(&config(2), LATENCIES, balls());
    let expected = Answer { number: 7, indices: vec![208, 209, 210], cached: false };
    assert_eq!(bench.ask(query(7, 13.0, 2.0, 1.0)), expected);
    // A ball of radius 1 at distance 0.99 lies within the radius 2.
    for (x, cached) in [(13.0, true), (13.99, true), (12.01, true), (14.0, false)] {
        assert_eq!(bench.ask(query(8, x, 2.0, 1.0)).cached, cached, "at {x}");
    }
    // The last one has taken the other entry.
    assert!(bench.ask(query(9, 13.5, 2.0, 1.0)).cached);
    assert_eq!((bench.hits, bench.misses), (4, 2));
}

#[test]
fn the_least_recently_used_entry_is_replaced() {
    let mut bench = Bench::new(&config(3), LATENCIES, balls());
    let places = [10.0, 20.0, 30.0, 10.0, 40.0, 10.0, 30.0, 20.0, 40.0];
    let cached = places.map(|x| bench.ask(query(0, x, 2.0, 1.0)).cached);
    // 40 takes the place of 20, and 20 that of 40.
    assert_eq!(cached, [false, false, false, true, false, true, true, false, false]);
}

#[test]
fn the_farthest_of_one_more_than_wanted_is_left_out_and_tells_the_tolerance() {
    let setup = CacheSetup { ball: false, far_scale: 1f32.to_bits(), margin_scale: 0.5f32.to_bits() };
    let mut bench = Bench::new(&config(2), LATENCIES, setup);
    // Squared distances 0, 1/4, 1/2, 3/4 of 16: roots of 8 and 12 for the last two.
    let far = 12f32.sqrt() - 8f32.sqrt();
    let answer = bench.ask(query(1, 14.0, 4.0, 0.0));
    assert_eq!(answer, Answer { number: 1, indices: vec![224, 225, 226], cached: false });
    assert!(bench.ask(query(2, 14.0 + 0.49 * far, 4.0, 0.0)).cached);
    assert!(!bench.ask(query(3, 14.0 - 0.51 * far, 4.0, 0.0)).cached);
}

#[test]
fn neighborhoods_of_other_settings_are_forgotten() {
    let ask = |bench: &mut Bench| bench.run(&[query(0, 13.0, 2.0, 1.0)], &mut Rng::with_seed(0))[0].cached;
    // The settings change before, when and after the comparison value of what was found is known.
    for wait in 0..60 {
        let mut bench = Bench::new(&config(1), CacheLatencies { check: 1, cover: 40 }, balls());
        assert!(!ask(&mut bench));
        bench.idle(wait);
        bench.cache.clock(&In { setup: Some(balls()), ..In::default() });
        bench.idle(60);
        assert!(!ask(&mut bench), "{wait} cycles after it was found, the settings changed");
        bench.idle(60);
        assert!(ask(&mut bench), "what was found since then is reused");
    }
}

#[test]
fn queries_are_not_compared_long_before_they_are_searched_for() {
    let accepted = |threads| {
        let config = Config { threads, ..config(1) };
        let mut cache = NeighborCache::new(&config, CacheLatencies { check: 20, cover: 1 });
        let mut accepted = 0;
        for number in 0..100 {
            accepted += u32::from(cache.outputs().query_ready);
            cache.clock(&In { query: Some(query(number, 13.0, 2.0, 1.0)), ..In::default() });
        }
        accepted
    };
    assert_eq!(accepted(32), 2 + 8 + 2 + 2, "two wait for the search, eight are compared, two and two wait for that");
    assert_eq!(accepted(3), 2 + 5 + 2 + 2, "no more are compared than will find a ticket");
}

/// What covers a query may be replaced while the query waits for those before it to be delivered.
#[test]
fn an_entry_that_is_given_away_answers_no_more() {
    const A: f32 = 14.0;
    const B: f32 = 24.0;
    const C: f32 = 34.0;
    for_each_seed("neighbor_cache", |random| {
        let mut given_away = 0;
        for _ in 0..100 {
            let mut bench = Bench::new(&config(2), LATENCIES, balls());
            let ask = |number: usize, x| query(number as u32, x, 2.0, 1.0);
            [B, A].iter().for_each(|x| assert!(!bench.ask(ask(0, *x)).cached));
            (bench.latency, bench.pauses) = (60, 6);
            let queries: Vec<_> = [C, A, A, A, B].into_iter().enumerate().map(|(i, x)| ask(i, x)).collect();
            for Answer { number, indices, cached } in bench.run(&queries, random) {
                let own = neighborhood(&queries[number as usize].query).into_iter().map(|result| result.index);
                assert_eq!(indices, own.collect::<Vec<_>>(), "query {number}");
                given_away += u32::from(number == 4 && !cached);
            }
        }
        assert!((1..100).contains(&given_away), "{given_away} times B was replaced in time");
    });
}

/// Entries are replaced while others, and their own former neighborhoods, are checked and delivered.
#[test]
fn an_answer_is_never_overwritten_while_it_is_delivered() {
    for_each_seed("neighbor_cache", |random| {
        let mut hits = 0;
        for entries in [1, 2, 5, 8, 32] {
            let latencies = CacheLatencies { check: random.u32(1..40), cover: random.u32(1..60) };
            let mut bench = Bench::new(&config(entries), latencies, balls());
            bench.latency = [1, 20, 500][random.usize(0..3)];
            bench.pauses = random.u8(0..7);
            let places = entries as u8 + random.u8(1..5);
            let mut place = 0;
            let mut query_near_the_last = |number| {
                if random.u8(0..20) == 0 {
                    place = random.u8(0..places);
                }
                query(number, f32::from(place), 2.0, 1.5 + random.f32() * 0.4)
            };
            let queries: Vec<_> = (0..400).map(&mut query_near_the_last).collect();
            let mut answers = Vec::new();
            for burst in queries.chunks(random.usize(1..40)) {
                answers.extend(bench.run(burst, random));
                bench.idle(random.u32(0..100));
            }
            let by_number: HashMap<_, _> = answers.iter().map(|answer| (answer.number, answer)).collect();
            assert_eq!(by_number.len(), queries.len(), "a query is answered once");
            for CachedQuery { query, .. } in &queries {
                let answer = by_number[&query.number];
                let own = neighborhood(query).into_iter().filter(|result| result.found).map(|result| result.index);
                assert_eq!(answer.indices, own.collect::<Vec<_>>());
            }
            let cached = answers.iter().filter(|answer| answer.cached).count();
            assert_eq!((bench.hits as usize, bench.misses as usize), (cached, queries.len() - cached));
            hits += cached;
        }
        assert!(hits > 400, "{hits} queries reuse a neighborhood");
    });
}
