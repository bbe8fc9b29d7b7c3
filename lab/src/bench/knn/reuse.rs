//! How many searches the coherent neighbor cache saves when points are sampled up (thesis 6.7.1, figures 6.13 to 6.15).

use super::{Cloud, FOUR_LANES, Setting, THREADS, search};
use crate::bench::page::{FigurePage, PageLine};
use crate::note;
use crate::{Figures, LabError};
use pointcore::search::{Neighbor, Order, Query, Reuse, check};
use pointcore_contract::search::Config;

/// Neighbors of a query, and in a ball around a point.
const NEIGHBORS: u32 = 30;
/// Room for those of a ball that is searched larger.
const BALL_NEIGHBORS: u32 = 64;
/// Points that are sampled up.
const PATCHES: usize = 512;
/// The caches that are measured: the thesis' eight neighborhoods with its sixteen threads, queries asked patch by patch; and one
/// large enough that as many runs of queries take turns, so that those of one patch are not under way together. Results leave one a
/// cycle, which eight threads keep up with there.
const CACHES: [Cache; 2] = [
    Cache { entries: 32, threads: 8, runs: 32, key: "" },
    Cache { entries: 8, threads: THREADS, runs: 1, key: ".entries8" },
];
/// How much larger balls are searched.
const ALPHA: f32 = 1.5;
/// Up-sampling patterns.
const SIDES: [u32; 3] = [2, 4, 8];
/// Tolerances with their names in keys.
const EPSILONS: [(f32, &str); 4] = [(0.0, "e0"), (0.1, "e0_1"), (0.2, "e0_2"), (0.5, "e0_5")];

/// A neighbor cache and how it is asked.
#[derive(Clone, Copy)]
struct Cache {
    entries: u32,
    threads: u32,
    /// Runs of queries that take turns.
    runs: usize,
    /// What tells it apart in keys.
    key: &'static str,
}

/// What a run with the cache brought.
struct Saved {
    /// Share of the queries that needed no search.
    saved: f64,
    /// How much too far the farthest neighbor of any query was.
    worst_ratio: f64,
    cycles_per_query: f64,
}

/// Queries around the first points, `k` each; with `radii`, within each point's own.
fn queries(cloud: &Cloud, side: u32, k: u32, radii: Option<&[f32]>) -> Vec<Query> {
    let grid = Order::Grid { columns: side, rows: side };
    let per_patch = (side * side) as usize;
    let mut queries = cloud.queries(grid, Some(PATCHES * per_patch), k);
    for (patch, radius) in queries.chunks_mut(per_patch).zip(radii.into_iter().flatten()) {
        patch.iter_mut().for_each(|query| query.radius = Some(*radius));
    }
    queries
}

fn run(cloud: &Cloud, queries: &[Query], cache: Cache, reuse: Reuse) -> Result<Saved, LabError> {
    let searched = queries.first().map_or(0, |query| query.k + u32::from(query.radius.is_none()));
    let config = FOUR_LANES.config(cloud.points.points().len(), searched);
    let Cache { entries, threads, runs, .. } = cache;
    let config = Config { neighbor_cache: entries, threads, ..config };
    let setting = Setting { reuse, runs, ..Setting::golden(&config, FOUR_LANES.splitting) };
    let found = search(cloud, setting, queries)?;
    let checked =
        check(&cloud.points, queries, &found.outcome.neighbors, reuse.epsilon).map_err(LabError::Neighbors)?;
    let hits = found.outcome.counters.events(&config).neighbor_cache.hit;
    Ok(Saved {
        saved: hits as f64 / queries.len() as f64,
        worst_ratio: checked.worst_ratio.into(),
        cycles_per_query: found.report.cycles_per_query,
    })
}

/// k nearest neighbors at rising tolerance.
fn nearest_figures(cloud: &Cloud, figures: &mut Figures, page: &mut FigurePage) -> Result<(), LabError> {
    let queries = queries(cloud, 8, NEIGHBORS, None);
    let mut lines = Vec::new();
    for cache in CACHES {
        let Cache { entries, key: which, .. } = cache;
        let mut line = PageLine::new(&format!("{entries} entries"));
        for (epsilon, name) in EPSILONS {
            note!("{}: 8×8, k = {NEIGHBORS}, ε = {epsilon}, {entries} entries", cloud.name);
            let found = run(cloud, &queries, cache, Reuse { epsilon, ..Reuse::default() })?;
            let mut insert =
                |key: &str, value: f64| figures.insert(format!("knn.aknn{which}.{name}.{key}"), value.into());
            insert("saved", found.saved);
            insert("max_error_ratio", found.worst_ratio);
            insert("cycles_per_query", found.cycles_per_query);
            line.push(found.saved);
        }
        lines.push(line);
    }
    let categories = EPSILONS.map(|(epsilon, _)| epsilon.to_string());
    page.lines("aknn", "Searches saved, 8×8 up-sampling, k = 30", "ε", "share of queries", &categories, lines)
}

/// The distance of each point's k-th neighbor: a ball of that radius holds as many, however dense the points are.
fn radii(cloud: &Cloud) -> Result<Vec<f32>, LabError> {
    let queries = cloud.queries(Order::File, Some(PATCHES), NEIGHBORS);
    let config = FOUR_LANES.config(cloud.points.points().len(), NEIGHBORS);
    let neighbors = search(cloud, Setting::golden(&config, FOUR_LANES.splitting), &queries)?.outcome.neighbors;
    let farthest = |found: &Vec<Neighbor>| found.last().map_or(0.0, |neighbor| neighbor.distance2.sqrt());
    Ok(neighbors.iter().map(farthest).collect())
}

/// Ball queries in patterns of rising density.
fn ball_figures(cloud: &Cloud, figures: &mut Figures, page: &mut FigurePage) -> Result<(), LabError> {
    let radii = radii(cloud)?;
    let mut lines = Vec::new();
    for cache in CACHES {
        let Cache { entries, key: which, .. } = cache;
        let mut line = PageLine::new(&format!("{entries} entries"));
        for side in SIDES {
            note!("{}: balls, {side}×{side}, {entries} entries", cloud.name);
            let reuse = Reuse { epsilon: 0.0, alpha: ALPHA };
            let found = run(cloud, &queries(cloud, side, BALL_NEIGHBORS, Some(&radii)), cache, reuse)?;
            figures.insert(format!("knn.ball{which}.{side}x{side}.saved"), found.saved.into());
            line.push(found.saved);
        }
        lines.push(line);
    }
    let categories = SIDES.map(|side| format!("{side}×{side}"));
    page.lines("ball", "Searches saved, ball queries, α = 1.5", "up-sampling", "share of queries", &categories, lines)
}

/// Both, with what the thesis reports beside them.
pub fn figures(cloud: &Cloud, figures: &mut Figures, page: &mut FigurePage) -> Result<(), LabError> {
    nearest_figures(cloud, figures, page)?;
    page.paragraph("The thesis reports more than half of the searches saved at ε = 0.1, and few for exact neighbors (6.7.1, eight entries).");
    ball_figures(cloud, figures, page)?;
    page.paragraph("The thesis reports up to three quarters of the searches saved from 2×2 on (6.7.1).");
    Ok(())
}
