//! The coherent neighbor cache against its model, and its answers against brute force.

use std::cell::RefCell;
use std::collections::BTreeSet;

use pointcore_contract::Format;
use pointcore_contract::search::{Config, units};
use pointcore_golden::search::{CacheLatencies, NeighborCache};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::search::neighbor_cache;

use crate::search::environment::Feeds;
use crate::search::neighborhoods::{
    INDEX_BITS, Mode, Neighbor, PHASES, Point, QUERIES, Query, Surroundings, distance2, nearest, place,
};
use crate::search::{all, lockstep};
use crate::support::cases;

fn indices<'a>(neighbors: impl IntoIterator<Item = &'a Neighbor>) -> BTreeSet<u64> {
    neighbors.into_iter().map(|(index, _)| *index).collect()
}

/// What answers and searches there must have been.
#[derive(Debug, Default)]
struct Seen {
    cached_nearest: usize,
    cached_balls: usize,
    full_nearest: usize,
    full_balls: usize,
    sparse_nearest: usize,
    sparse_balls: usize,
    empty: usize,
}

/// Compares an answer from a search with that, and one from the cache with brute force.
fn check(config: &Config, cloud: &[Point], query: &Query, seen: &mut Seen) {
    let mode = PHASES[query.phase].0;
    let all = |k, radius2| nearest(config, cloud, query.point, k, radius2);
    let mut found = all(query.wanted, query.radius2);
    let is_full = found.len() == query.wanted;
    if mode != Mode::Ball && is_full {
        found.pop();
    }
    match (query.cached, mode) {
        (false, _) => {
            assert_eq!(query.answer, found, "{query:?}");
            seen.empty += usize::from(found.is_empty());
            let count = match (mode, is_full) {
                (Mode::Ball, true) => &mut seen.full_balls,
                (Mode::Ball, false) => &mut seen.sparse_balls,
                (_, true) => &mut seen.full_nearest,
                (_, false) => &mut seen.sparse_nearest,
            };
            *count += 1;
        }
        (true, Mode::Nearest) => {
            assert_eq!(indices(&query.answer), indices(&found), "{query:?}");
            seen.cached_nearest += 1;
        }
        (true, Mode::Ball) => {
            let reach2 = query.reach * query.reach;
            let is_near = |(index, _): &&Neighbor| distance2(config, cloud[place(*index)], query.point) < reach2;
            let near = indices(query.answer.iter().filter(is_near));
            assert_eq!(near, indices(&all(cloud.len(), reach2)), "{query:?}");
            seen.cached_balls += 1;
        }
        (true, Mode::NearestWithin(_)) => {}
    }
}

/// One entry, fewer than a power of two, as many as the thesis has, and so many that queries wait to be compared.
fn configs() -> [Config; 4] {
    let base = Config {
        geometry: Format::F32.flushed(),
        index_bits: INDEX_BITS,
        tree_depth: 4,
        bucket: 8,
        ..Config::default()
    };
    [
        Config { neighbor_cache: 1, threads: 1, neighbors: 2, ..base.clone() },
        Config { neighbor_cache: 3, threads: 3, neighbors: 8, geometry: Format::F24.flushed(), ..base.clone() },
        Config { neighbor_cache: 8, threads: 16, neighbors: 5, ..base.clone() },
        Config { neighbor_cache: 32, threads: 2, neighbors: 3, ..base },
    ]
}

#[test]
fn neighborhoods_agree_with_the_model_and_with_brute_force() {
    for config in cases(configs()) {
        let seen = RefCell::new(Seen::default());
        let unit = neighbor_cache::unit(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let model =
            NeighborCache::new(&config, CacheLatencies { check: unit.check.latency, cover: unit.cover.latency });
        let begin = |feeds: &mut Feeds| Surroundings::begin(&config, feeds);
        lockstep(&config, &unit.module, &model, &units::neighbor_cache::UNIT, begin, all, |surroundings, report| {
            assert_eq!(surroundings.closed, PHASES.len() * QUERIES);
            for query in &surroundings.queries {
                check(&config, &surroundings.clouds[query.phase], query, &mut seen.borrow_mut());
            }
            let cached = surroundings.queries.iter().filter(|query| query.cached).count() as u64;
            let misses = surroundings.queries.len() as u64 - cached;
            assert!(cached > 0 && misses > 0, "{cached} hits, {misses} misses");
            assert_eq!(["event_cache_hit", "event_cache_miss"].map(|event| report.events(event)), [cached, misses]);
            assert_eq!(report.transfers("search"), misses);
        });
        let seen = seen.into_inner();
        let Seen { cached_nearest, cached_balls, full_nearest, full_balls, sparse_nearest, sparse_balls, empty } = seen;
        for count in [cached_nearest, cached_balls, full_nearest, full_balls, sparse_nearest, sparse_balls, empty] {
            assert!(count > 0, "{seen:?}");
        }
    }
}
