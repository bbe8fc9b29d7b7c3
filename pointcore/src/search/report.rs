//! What a search cost: figures with their definitions, as JSON and as a page to read.

use super::check::Checked;
use super::hardware::HardwareSize;
use super::kdtree::TreeStatistics;
use super::reuse::Reuse;
use super::rounding::{Rounding, TruthComparison};
use super::run::SearchOutcome;
use crate::area::recorded::Clock;
use crate::memory::MemorySettings;
use pointcore_contract::search::Config;
use serde::Serialize;
use std::fmt::Write as _;

/// A resource and the cycles it would take for a query if it never waited.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bound {
    /// What is used.
    pub name: &'static str,
    /// Cycles in use, for each query.
    pub cycles_per_query: f64,
}

/// How often a cache had what was asked for.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HitRate {
    /// The cache.
    pub cache: &'static str,
    /// Requests it answered.
    pub hits: u64,
    /// Requests it passed on.
    pub misses: u64,
    /// Share of the requests that it answered.
    pub rate: f64,
}

/// The run behind a report.
pub struct SearchRun<'a> {
    /// Where the points come from.
    pub points: &'a str,
    /// What ran.
    pub engine: &'a str,
    /// Where queries lie and how they are ordered.
    pub order: &'a str,
    /// The hardware's configuration.
    pub config: &'a Config,
    /// The tree.
    pub tree: TreeStatistics,
    /// How the tree was divided.
    pub splitting: &'a str,
    /// The memory.
    pub memory: MemorySettings,
    /// Bytes of a beat of points.
    pub beat_bytes: u32,
    /// Neighbors wanted.
    pub k: u32,
    /// Radius within which they count.
    pub radius: Option<f32>,
    /// What the run brought.
    pub outcome: &'a SearchOutcome,
    /// Outputs that differed, where they were compared.
    pub mismatches: Option<u64>,
    /// What a comparison with a search through all points brought.
    pub checked: Option<Checked>,
    /// What rounding did to the points, where it was measured.
    pub rounding: Option<Rounding>,
    /// What a comparison with the points as they were given brought.
    pub truth: Option<TruthComparison>,
    /// What the neighbor cache may answer.
    pub reuse: Reuse,
    /// The size of the core, where it was measured.
    pub hardware: Option<HardwareSize>,
    /// The clock for which times are stated.
    pub clock: Clock,
}

/// The figures of a search.
#[derive(Clone, Debug, Serialize)]
pub struct SearchReport {
    /// Where the points come from.
    pub points: String,
    /// What ran: `rtl` (in lockstep or not) or `golden`.
    pub engine: String,
    /// Where queries lie and how they are ordered.
    pub order: String,
    /// How the tree was divided.
    pub splitting: String,
    /// The tree.
    pub tree: TreeStatistics,
    /// The hardware's configuration.
    pub config: Config,
    /// Neighbors wanted.
    pub k: u32,
    /// Radius within which they count.
    pub radius: Option<f32>,
    /// Queries asked.
    pub queries: usize,
    /// Neighbors found.
    pub neighbors: u64,
    /// Outputs on which hardware and model differed; absent where they were not compared.
    pub mismatches: Option<u64>,
    /// What a comparison with a search through all points brought; absent where there was none.
    pub checked: Option<Checked>,
    /// What rounding did to the points; absent where it was not measured.
    pub rounding: Option<Rounding>,
    /// What a comparison with the points as they were given brought; absent where there was none.
    pub truth: Option<TruthComparison>,
    /// What the neighbor cache may answer; absent where there is none.
    pub reuse: Option<Reuse>,
    /// Cycles from the first query to the last result.
    pub cycles: u64,
    /// Cycles for each query.
    pub cycles_per_query: f64,
    /// The size of the core; absent where it was not measured.
    pub hardware: Option<HardwareSize>,
    /// The clock for which queries per second are stated, and where it comes from.
    pub clock: Clock,
    /// Queries answered in a second at that clock.
    pub queries_per_second: f64,
    /// The memory's latency.
    pub latency_cycles: u64,
    /// The memory's bandwidth.
    pub bytes_per_cycle: f64,
    /// Requests to the memory for each query.
    pub requests_per_query: f64,
    /// Bytes moved for each query, whole bursts.
    pub bytes_per_query: f64,
    /// Every resource of the search.
    pub bounds: Vec<Bound>,
    /// The one that limits the search.
    pub bound: Bound,
    /// The bound's share of the cycles.
    pub share_of_bound: f64,
    /// The caches that the core has.
    pub hit_rates: Vec<HitRate>,
    /// Share of the cycles in which a query waited for a free thread.
    pub thread_wait: f64,
    /// Share of the cycles in which a beat stayed with the queues for another insertion.
    pub insert_wait: f64,
    /// Share of the cycles in which the core did not take a beat that the memory offered.
    pub beat_wait: f64,
    /// Cycles simulated in a second.
    pub simulated_cycles_per_second: f64,
}

impl SearchReport {
    /// Derives the figures.
    #[must_use]
    pub fn new(run: &SearchRun) -> Self {
        let counters = &run.outcome.counters;
        let (queries, cycles) = (run.outcome.neighbors.len(), counters.cycles);
        let each = |count: f64| count / queries.max(1) as f64;
        let share = |count: u64| count as f64 / cycles.max(1) as f64;
        let bytes_per_cycle = run.memory.bytes_per_cycle.unwrap_or(run.beat_bytes.into());
        let events = counters.events(run.config);
        let insertions = events.queue.insert;
        // No event counts the beats that the point cache answers with: its leaves are taken to be as large as those from memory.
        let points = events.point_cache;
        let beats = counters.beats as f64 * (1.0 + points.hit as f64 / (points.miss as f64).max(1.0));
        let bounds: Vec<Bound> = [
            ("nodes visited", events.node as f64),
            ("paths popped", events.pop as f64),
            ("beats of points", beats),
            ("records of the tree from memory", counters.records as f64),
            ("insertions", insertions as f64),
            ("beats in the priority queues", (events.queue.beat + events.queue.insert_wait) as f64),
            ("results", counters.results as f64),
            ("memory bus", counters.bytes as f64 / bytes_per_cycle),
        ]
        .map(|(name, count)| Bound { name, cycles_per_query: each(count) })
        .into();
        let by_cycles = |a: &&Bound, b: &&Bound| a.cycles_per_query.total_cmp(&b.cycles_per_query);
        let bound = bounds.iter().max_by(by_cycles).expect("a search uses resources").clone();
        let (config, tree, neighbors) = (run.config, events.tree_cache, events.neighbor_cache);
        let caches = [
            ("point cache", config.point_cache, points.hit, points.miss),
            ("tree cache", config.tree_cache, tree.hit, tree.miss),
            ("neighbor cache", config.neighbor_cache, neighbors.hit, neighbors.miss),
        ];
        let present = caches.into_iter().filter(|(_, lines, ..)| *lines > 0);
        let hit_rates = present.map(|(cache, _, hits, misses)| {
            let rate = hits as f64 / (hits + misses).max(1) as f64;
            HitRate { cache, hits, misses, rate }
        });
        Self {
            points: run.points.to_owned(),
            engine: run.engine.to_owned(),
            order: run.order.to_owned(),
            splitting: run.splitting.to_owned(),
            tree: run.tree,
            config: run.config.clone(),
            k: run.k,
            radius: run.radius,
            queries,
            neighbors: run.outcome.neighbors.iter().map(|neighbors| neighbors.len() as u64).sum(),
            mismatches: run.mismatches,
            checked: run.checked,
            rounding: run.rounding,
            truth: run.truth,
            reuse: (run.config.neighbor_cache > 0).then_some(run.reuse),
            cycles,
            cycles_per_query: each(cycles as f64),
            hardware: run.hardware.clone(),
            clock: run.clock.clone(),
            queries_per_second: run.clock.mhz * 1e6 / each(cycles as f64).max(f64::MIN_POSITIVE),
            latency_cycles: run.memory.latency_cycles,
            bytes_per_cycle,
            requests_per_query: each(counters.requests as f64),
            bytes_per_query: each(counters.bytes as f64),
            share_of_bound: bound.cycles_per_query / each(cycles as f64).max(f64::MIN_POSITIVE),
            bounds,
            bound,
            hit_rates: hit_rates.collect(),
            thread_wait: share(events.thread_wait),
            insert_wait: share(events.queue.insert_wait),
            beat_wait: share(counters.beat_wait),
            simulated_cycles_per_second: run.outcome.simulated_cycles as f64 / run.outcome.elapsed.as_secs_f64(),
        }
    }

    /// The figures in words, by name.
    #[must_use]
    pub fn rows(&self) -> Vec<(&'static str, String)> {
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let compared = match self.mismatches {
            Some(count) => format!("{count} mismatches, every output compared in every cycle"),
            None => "not compared".to_owned(),
        };
        let checked = match self.checked {
            Some(Checked { queries, exact, .. }) if queries == exact => {
                format!("{queries} of {} queries, every distance equal bit for bit", self.queries)
            }
            Some(Checked { queries, exact, worst_ratio }) => format!(
                "{queries} of {} queries, {exact} exact, the farthest neighbor up to {worst_ratio:.3} times too far",
                self.queries
            ),
            None => "not compared (`--check` does)".to_owned(),
        };
        let truth = match self.truth {
            Some(TruthComparison { queries, neighbors, others }) => {
                format!("{others} of the {neighbors} neighbors of {queries} queries are others than in f64")
            }
            None => "not compared (`--check` does)".to_owned(),
        };
        let within = self.radius.map_or(String::new(), |radius| format!(" within {radius}"));
        let Config { threads, lanes, leaves_in_flight, bucket, geometry, .. } = &self.config;
        let rows = [
            ("engine", self.engine.clone()),
            ("lockstep", compared),
            ("search through all points, as rounded", checked),
            ("points as they were given", truth),
            ("points", self.points.clone()),
            ("rounding", self.rounding.map_or_else(|| "not measured".to_owned(), |rounding| rounding.to_string())),
            ("tree", format!("{}, {}", self.splitting, self.tree)),
            (
                "core",
                format!(
                    "{threads} threads, {lanes} lanes, buckets of {bucket}, {leaves_in_flight} leaves in flight, {geometry}"
                ),
            ),
            ("memory", format!("{} cycles latency, {} bytes a cycle", self.latency_cycles, self.bytes_per_cycle)),
            ("queries", format!("{}, {}, for {} neighbors{within}", self.queries, self.order, self.k)),
            ("neighbors found", self.neighbors.to_string()),
            ("cycles", self.cycles.to_string()),
            ("cycles per query", format!("{:.2}", self.cycles_per_query)),
            ("queries per second", format!("{:.0} at {}", self.queries_per_second, self.clock)),
            ("requests per query", format!("{:.2}", self.requests_per_query)),
            ("bytes per query", format!("{:.1}", self.bytes_per_query)),
            ("bound", format!("{}: {} of the cycles", self.bound.name, percent(self.share_of_bound))),
            ("queries wait for a thread", percent(self.thread_wait)),
            ("queues stay for another insertion", percent(self.insert_wait)),
            ("memory waits for the core", percent(self.beat_wait)),
            ("simulation", format!("{:.0} cycles/s", self.simulated_cycles_per_second)),
        ];
        let mut rows = rows.to_vec();
        rows.extend(self.hardware.iter().flat_map(HardwareSize::rows));
        if let Some(Reuse { epsilon, alpha }) = self.reuse {
            rows.push(("reuse", format!("ε = {epsilon}, α = {alpha}")));
        }
        for HitRate { cache, hits, misses, rate } in &self.hit_rates {
            rows.push((*cache, format!("{} of {} requests", percent(*rate), hits + misses)));
        }
        rows
    }

    /// The report as Markdown.
    #[must_use]
    pub fn markdown(&self) -> String {
        let mut text = "# Nearest neighbors\n\n| figure | value |\n|---|---|\n".to_owned();
        for (name, value) in self.rows() {
            _ = writeln!(text, "| {name} | {value} |");
        }
        text += "\nEvery resource takes one item a cycle; the one with the most items bounds the search.\n\n";
        text += "| resource | cycles per query |\n|---|---|\n";
        for Bound { name, cycles_per_query } in &self.bounds {
            _ = writeln!(text, "| {name} | {cycles_per_query:.2} |");
        }
        text
    }
}
