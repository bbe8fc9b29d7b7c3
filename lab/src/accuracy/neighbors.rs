//! What accuracy costs in neighbor search: tolerance, neighborhoods in the neighbor cache and points in a leaf against cycles and hardware.
//!
//! Queries are points sampled up, as the thesis measures the cache (6.7.1): without coherence there is nothing to trade.

use super::figures::PointEngine;
use super::sweep::SOURCES;
use super::{read_result, write_result};
use crate::LabError;
use pointcore::area::estimate::Estimator;
use pointcore::area::proxy::Proxy;
use pointcore::search::{
    self, MemorySettings, Order, PointSet, Query, Reuse, Session, Splitting, Tree, check, config_for,
};
use pointcore_contract::search::Config;
use pointcore_tb::cache::{Cache, digest, key};
use serde::{Deserialize, Serialize};

/// Queries along each edge of a point's cell.
const SIDE: u32 = 8;
/// Cycles from a request to the memory to its answer.
const LATENCY_CYCLES: u64 = 40;
/// Queries under way: results leave one a cycle, which as many threads keep up with.
const THREADS: u32 = 8;
/// Tolerances ε of thesis 6.4.2.
const EPSILONS: [f32; 4] = [0.0, 0.1, 0.2, 0.5];
/// Neighborhoods in the neighbor cache; none, the thesis' number, and as many as the core holds.
const ENTRIES: [u32; 3] = [0, 8, 32];
/// Points of a leaf.
const BUCKETS: [u32; 3] = [8, 16, 32];

/// A point of the sweep.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct NeighborSetting {
    /// How much farther than the true ones neighbors may be, as a share.
    pub epsilon: f32,
    /// Neighborhoods in the neighbor cache; 0 leaves it out.
    pub entries: u32,
    /// Points of a leaf.
    pub bucket: u32,
}

impl NeighborSetting {
    /// All points: a tolerance only where there is a cache to use it.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let all = BUCKETS.into_iter().flat_map(|bucket| {
            ENTRIES.into_iter().flat_map(move |entries| EPSILONS.map(|epsilon| Self { epsilon, entries, bucket }))
        });
        all.filter(|setting| setting.entries > 0 || setting.epsilon == 0.0).collect()
    }

    /// What tables call it.
    #[must_use]
    pub fn name(&self) -> String {
        let Self { epsilon, entries, bucket } = self;
        if *entries == 0 {
            format!("no cache, bucket {bucket}")
        } else {
            format!("ε {epsilon}, {entries} entries, bucket {bucket}")
        }
    }
}

/// What a point of the sweep comes to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Found {
    /// The point.
    pub setting: NeighborSetting,
    /// What answered.
    pub engine: PointEngine,
    /// Queries asked.
    pub queries: usize,
    /// Share of the queries whose distances equal the true ones bit for bit.
    pub exact: f64,
    /// The greatest ratio of the distance of the farthest neighbor to the true one's.
    pub worst_ratio: f64,
    /// Share of the queries that needed no search.
    pub saved: f64,
    /// Cycles a query.
    pub cycles_per_query: f64,
    /// Operators and memories.
    pub proxy: Proxy,
}

/// What is searched.
pub struct Task<'a> {
    /// The points.
    pub points: &'a PointSet,
    /// Neighbors of a query.
    pub k: u32,
    /// Queries asked.
    pub limit: usize,
    /// What answers.
    pub engine: PointEngine,
}

impl Task<'_> {
    /// Measures a point, unless it is kept.
    ///
    /// # Errors
    /// The search cannot be run, or its neighbors are not the nearest within the tolerance.
    pub fn measure(&self, cache: &Cache, setting: NeighborSetting) -> Result<Found, LabError> {
        let Self { points, k, limit, engine } = self;
        let key = key(["neighbors", SOURCES, &digest(points), &digest(&(k, limit, setting)), engine.name()]);
        let folder = cache.entry(&key, |folder| write_result(folder, &self.search(setting)?))?;
        read_result(&folder)
    }

    fn search(&self, setting: NeighborSetting) -> Result<Found, LabError> {
        let Self { points, k, limit, engine } = *self;
        let NeighborSetting { epsilon, entries, bucket } = setting;
        let splitting = Splitting::Packed;
        // A tree is as deep as its points need in buckets of the default's size. The neighbor cache needs one neighbor more to tell how far a
        // neighborhood reaches.
        let alike = (points.points().len() * Config::default().bucket as usize).div_ceil(bucket as usize);
        let derived = config_for(alike, k + u32::from(entries > 0), splitting);
        let config = Config { neighbor_cache: entries, threads: THREADS, bucket, ..derived };
        let order = Order::Grid { columns: SIDE, rows: SIDE };
        let places = order.places(points, Some(limit), 1);
        let queries: Vec<Query> =
            places.into_iter().map(|place| Query { point: points.rounded(place), k, radius: None }).collect();

        let tree = Tree::build(&config, points, splitting)?;
        let memory = MemorySettings { latency_cycles: LATENCY_CYCLES, ..MemorySettings::default() };
        let runs_on =
            if engine == PointEngine::Lockstep { search::SearchEngine::Lockstep } else { search::SearchEngine::Golden };
        let session = Session::open(config.clone(), tree, memory, runs_on)?
            .reusing(Reuse { epsilon, ..Reuse::default() })?
            .interleaved(entries.max(1) as usize);
        let outcome = session.search(&queries)?;
        let checked = check(points, &queries, &outcome.neighbors, epsilon).map_err(LabError::Neighbors)?;
        let share = |count: u64| count as f64 / queries.len() as f64;
        let events = outcome.counters.events(&config);
        Ok(Found {
            setting,
            engine,
            queries: queries.len(),
            exact: checked.exact as f64 / checked.queries as f64,
            worst_ratio: checked.worst_ratio.into(),
            saved: share(events.neighbor_cache.hit),
            cycles_per_query: share(outcome.counters.cycles),
            proxy: Proxy::of(&session.core().design),
        })
    }
}

/// A found point beside all others.
#[derive(Clone, Debug, Serialize)]
pub struct Ranked {
    /// The point.
    pub found: Found,
    /// Look-up tables, estimated as those of the renderer are.
    pub lut4: Option<f64>,
    /// No other point is as accurate, as fast and as small, and better in one of these.
    pub on_front: bool,
}

/// Finds the front.
#[must_use]
pub fn rank(found: Vec<Found>, estimator: &Estimator) -> Vec<Ranked> {
    let costs =
        |found: &Found| [found.worst_ratio, found.cycles_per_query, estimator.lut4(&found.proxy).unwrap_or(0.0)];
    let betters = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).all(|(a, b)| a <= b) && a != b;
    let all: Vec<_> = found.iter().map(costs).collect();
    let ranked = |(found, own): (Found, &[f64; 3])| {
        let (lut4, on_front) = (estimator.lut4(&found.proxy), !all.iter().any(|other| betters(other, own)));
        Ranked { found, lut4, on_front }
    };
    found.into_iter().zip(&all).map(ranked).collect()
}

/// A Markdown table.
#[must_use]
pub fn markdown(ranked: &[Ranked]) -> String {
    let mut text = "| point | front | engine | farthest neighbor too far by at most | exact | searches saved | cycles a query | LUT4 |\n|---|---|---|---:|---:|---:|---:|---:|\n".to_owned();
    for Ranked { found, lut4, on_front } in ranked {
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let cells = [
            found.setting.name(),
            if *on_front { "●" } else { "" }.to_owned(),
            found.engine.name().to_owned(),
            format!("{:.3}", found.worst_ratio),
            percent(found.exact),
            percent(found.saved),
            format!("{:.1}", found.cycles_per_query),
            lut4.map_or("–".to_owned(), |lut4| format!("{lut4:.0}")),
        ];
        text += &format!("| {} |\n", cells.join(" | "));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(worst_ratio: f64, cycles_per_query: f64) -> Found {
        let setting = NeighborSetting { epsilon: 0.1, entries: 8, bucket: 16 };
        let (engine, proxy) = (PointEngine::Golden, Proxy::default());
        Found { setting, engine, queries: 1, exact: 1.0, worst_ratio, saved: 0.0, cycles_per_query, proxy }
    }

    #[test]
    fn a_tolerance_needs_a_cache() {
        let all = NeighborSetting::all();
        assert_eq!(all.len(), BUCKETS.len() * (1 + 2 * EPSILONS.len()));
        assert!(all.iter().all(|setting| setting.entries > 0 || setting.epsilon == 0.0));
    }

    #[test]
    fn the_front_is_what_nothing_betters() {
        let points = vec![found(1.0, 30.0), found(1.1, 20.0), found(1.1, 25.0), found(1.2, 20.0)];
        let ranked = rank(points, &Estimator::new(&[]));
        let front: Vec<_> = ranked.iter().map(|point| point.on_front).collect();
        assert_eq!(front, [true, true, false, false]);
        assert!(
            markdown(&ranked)
                .contains("| ε 0.1, 8 entries, bucket 16 | ● | golden | 1.000 | 100.0 % | 0.0 % | 30.0 | – |")
        );
    }

    #[test]
    fn tolerance_saves_cycles_and_is_kept() {
        let points = PointSet::load(Config::default().geometry, &search::PointSource::Surface(300)).expect("a surface");
        let task = Task { points: &points, k: 6, limit: 600, engine: PointEngine::Golden };
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let cache = Cache::new(folder.path().to_owned());
        let measure = |epsilon, entries| {
            let setting = NeighborSetting { epsilon, entries, bucket: 8 };
            task.measure(&cache, setting).unwrap_or_else(|error| panic!("{error}"))
        };
        let [exact, tolerant] = [measure(0.0, 0), measure(0.5, 8)];
        assert_eq!((exact.exact, exact.worst_ratio, exact.saved), (1.0, 1.0, 0.0));
        assert!(tolerant.saved > 0.1 && tolerant.worst_ratio <= 1.5 && tolerant.exact < 1.0, "{tolerant:?}");
        assert!(tolerant.proxy.memory_bits > exact.proxy.memory_bits);
        assert_eq!(measure(0.5, 8), tolerant);
    }
}
