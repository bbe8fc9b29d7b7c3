//! Figures of the search core: search against its bound, threads, orders, coherent queries, brute force, the CPU beside it.

mod page;
mod reuse;
mod sets;

use crate::bench::page::{FigurePage, PageLine};
use crate::note;
use crate::{Figures, LabError};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use pointcore::area::recorded::{Clock, ClockOrigin};
use pointcore::search::{
    MemorySettings, Order, PointSet, PointSource, Query, Reuse, SearchEngine, SearchOutcome, SearchReport, SearchRun,
    Session, Splitting, Tree, check,
};
use pointcore_contract::search::Config;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Neighbors of a query, as in the figures the thesis compares with (6.7.1).
const NEIGHBORS: u32 = 10;
/// Points of a leaf at most.
const BUCKET: u32 = 16;
/// Threads of the thesis' prototype.
const THREADS: u32 = 16;
/// Cycles from a request to the memory to its answer.
const LATENCY_CYCLES: u64 = 40;
/// Queries of a run that varies a parameter.
const SAMPLE: usize = 20_000;
/// Seed of shuffles.
const SEED: u64 = 1;
/// The clock for which queries per second are stated, until the core has been placed and routed.
const CLOCK_MHZ: f64 = 100.0;

/// Points by a name for the keys.
struct Cloud {
    name: String,
    source: PointSource,
    points: PointSet,
}

impl Cloud {
    /// The scan, or as large a procedural surface as the thesis measured.
    fn new(scan: Option<&Path>) -> Result<Self, LabError> {
        let source = scan.map_or(PointSource::Surface(100_000), |path| PointSource::File(path.to_owned()));
        let name =
            scan.and_then(Path::file_stem).map_or("surface".to_owned(), |stem| stem.to_string_lossy().into_owned());
        let points = PointSet::load(Config::default().geometry, &source)?;
        Ok(Self { name, source, points })
    }

    fn queries(&self, order: Order, limit: Option<usize>, k: u32) -> Vec<Query> {
        let places = order.places(&self.points, limit, SEED);
        places.into_iter().map(|place| Query { point: self.points.rounded(place), k, radius: None }).collect()
    }
}

/// A core as it is measured: a point a cycle with small leaves, or several with full ones.
#[derive(Clone, Copy)]
struct CoreShape {
    lanes: u32,
    leaves_in_flight: u32,
    splitting: Splitting,
}

const ONE_LANE: CoreShape = CoreShape { lanes: 1, leaves_in_flight: 1, splitting: Splitting::Median };
const FOUR_LANES: CoreShape = CoreShape { lanes: 4, leaves_in_flight: 2, splitting: Splitting::Packed };

impl CoreShape {
    fn config(self, points: usize, k: u32) -> Config {
        let Self { lanes, leaves_in_flight, splitting } = self;
        let derived = pointcore::search::config_for(points, k, splitting);
        Config { lanes, leaves_in_flight, threads: THREADS, bucket: BUCKET, neighbors: k, ..derived }
    }
}

/// A search that was run.
struct Run {
    report: SearchReport,
    outcome: SearchOutcome,
}

/// How a search is made.
#[derive(Clone, Copy)]
struct Setting<'a> {
    config: &'a Config,
    splitting: Splitting,
    engine: SearchEngine,
    reuse: Reuse,
    /// Runs of queries that take turns.
    runs: usize,
}

impl<'a> Setting<'a> {
    const fn new(config: &'a Config, splitting: Splitting, engine: SearchEngine) -> Self {
        Self { config, splitting, engine, reuse: Reuse { epsilon: 0.0, alpha: 1.0 }, runs: 1 }
    }

    /// On the golden model, which lockstep has shown equal.
    const fn golden(config: &'a Config, splitting: Splitting) -> Self {
        Self::new(config, splitting, SearchEngine::Golden)
    }
}

/// Searches among a cloud's points.
fn search(cloud: &Cloud, setting: Setting<'_>, queries: &[Query]) -> Result<Run, LabError> {
    let Setting { config, splitting, engine, reuse, runs } = setting;
    let tree = Tree::build(config, &cloud.points, splitting)?;
    let (statistics, beat_bytes) = (tree.statistics(), tree.beat_bytes());
    let memory = MemorySettings { latency_cycles: LATENCY_CYCLES, ..MemorySettings::default() };
    let session = Session::open(config.clone(), tree, memory, engine)?.reusing(reuse)?.interleaved(runs);
    let outcome = session.search(queries)?;
    let report = SearchReport::new(&SearchRun {
        points: &cloud.source.to_string(),
        engine: if engine == SearchEngine::Golden { "golden" } else { "rtl in lockstep with golden" },
        order: "",
        config,
        tree: statistics,
        splitting: splitting.name(),
        memory,
        beat_bytes,
        k: queries.first().map_or(0, |query| query.k),
        radius: None,
        reuse,
        outcome: &outcome,
        mismatches: (engine == SearchEngine::Lockstep).then_some(0),
        checked: None,
        rounding: None,
        truth: None,
        hardware: None,
        clock: Clock { mhz: CLOCK_MHZ, origin: ClockOrigin::Nominal },
    });
    Ok(Run { report, outcome })
}

/// Every point as a query in random order, hardware in lockstep, every distance compared with brute force.
fn bound_figures(cloud: &Cloud, figures: &mut Figures, page: &mut FigurePage) -> Result<(), LabError> {
    let queries = cloud.queries(Order::Random, None, NEIGHBORS);
    for shape in [ONE_LANE, FOUR_LANES] {
        note!("{}: {} lanes, {} queries in lockstep", cloud.name, shape.lanes, queries.len());
        let config = shape.config(cloud.points.points().len(), NEIGHBORS);
        let Run { report, outcome } =
            search(cloud, Setting::new(&config, shape.splitting, SearchEngine::Lockstep), &queries)?;
        let mismatches = match check(&cloud.points, &queries, &outcome.neighbors, 0.0) {
            Ok(_) => 0,
            Err(difference) => {
                note!("{difference}");
                1
            }
        };
        let mut insert = |key: &str, value: serde_json::Value| {
            figures.insert(format!("knn.{}.k{NEIGHBORS}.lanes{}.{key}", cloud.name, shape.lanes), value)
        };
        insert("cycles_per_query", report.cycles_per_query.into());
        insert("bound_cycles", report.bound.cycles_per_query.into());
        insert("bound_fraction", report.share_of_bound.into());
        insert("bytes_per_query", report.bytes_per_query.into());
        insert("mismatches", mismatches.into());
        page.bound(shape.lanes, &report);
    }
    Ok(())
}

/// Cycles a query with more and more threads.
fn thread_figures(cloud: &Cloud, figures: &mut Figures, page: &mut FigurePage) -> Result<(), LabError> {
    let queries = cloud.queries(Order::Random, Some(SAMPLE), NEIGHBORS);
    let counts = [1, 2, 4, 8, 16, 32];
    let mut lines = Vec::new();
    for (shape, name) in [(ONE_LANE, "one lane"), (FOUR_LANES, "four lanes")] {
        let mut line = PageLine::new(name);
        for threads in counts {
            note!("{}: {name}, {threads} threads", cloud.name);
            let config = Config { threads, ..shape.config(cloud.points.points().len(), NEIGHBORS) };
            let cycles = search(cloud, Setting::golden(&config, shape.splitting), &queries)?.report.cycles_per_query;
            let lanes = if shape.lanes == 1 { String::new() } else { format!(".lanes{}", shape.lanes) };
            figures.insert(format!("knn.threads{threads}{lanes}.cycles_per_query"), cycles.into());
            line.push(cycles);
        }
        lines.push(line);
    }
    page.lines(
        "threads",
        "Cycles a query by threads",
        "threads",
        "cycles",
        &counts.map(|count| count.to_string()),
        lines,
    )
}

/// Cycles a query for more neighbors, in random and in coherent order.
fn order_figures(cloud: &Cloud, figures: &mut Figures, page: &mut FigurePage) -> Result<(), LabError> {
    let counts = [8, 16, 32];
    let mut lines = Vec::new();
    for order in [Order::Random, Order::Morton] {
        let mut line = PageLine::new(&order.to_string());
        for k in counts {
            note!("{}: {order} order, k = {k}", cloud.name);
            let queries = cloud.queries(order, Some(SAMPLE), k);
            let config = FOUR_LANES.config(cloud.points.points().len(), k);
            let report = search(cloud, Setting::golden(&config, FOUR_LANES.splitting), &queries)?.report;
            figures.insert(format!("knn.{order}.k{k}.cycles_per_query"), report.cycles_per_query.into());
            figures.insert(format!("knn.{order}.k{k}.bytes_per_query"), report.bytes_per_query.into());
            line.push(report.cycles_per_query);
        }
        lines.push(line);
    }
    page.lines(
        "orders",
        "Cycles a query by k, four lanes",
        "k",
        "cycles",
        &counts.map(|count| count.to_string()),
        lines,
    )
}

/// The same queries on one core of this machine, by a kd-tree library.
fn cpu_figures(cloud: &Cloud, figures: &mut Figures) {
    note!("{}: kiddo on one core", cloud.name);
    let queries = cloud.queries(Order::Random, None, NEIGHBORS);
    let tree = ImmutableKdTree::<f32, 3>::new_from_slice(cloud.points.points());
    let k = NonZero::new(NEIGHBORS as usize).expect("neighbors are asked for");
    let started = Instant::now();
    let found: usize = queries.iter().map(|query| tree.nearest_n::<SquaredEuclidean>(&query.point, k).len()).sum();
    let seconds = started.elapsed().as_secs_f64();
    assert_eq!(found, queries.len() * k.get().min(cloud.points.points().len()), "kiddo finds what is there");
    figures.insert("knn.kiddo.queries_per_s".to_owned(), (queries.len() as f64 / seconds).into());
}

/// Measures neighbor search among the points of a scan, or of a procedural surface; pictures and tables go to `folder`.
///
/// # Errors
/// The points cannot be loaded, a search fails, or the folder cannot be written.
pub fn figures(scan: Option<&Path>, models: &[PathBuf], folder: &Path, figures: &mut Figures) -> Result<(), LabError> {
    let cloud = Cloud::new(scan)?;
    let mut page = FigurePage::new(folder, "Neighbor search", &cloud.source.to_string());
    bound_figures(&cloud, figures, &mut page)?;
    thread_figures(&cloud, figures, &mut page)?;
    order_figures(&cloud, figures, &mut page)?;
    reuse::figures(&cloud, figures, &mut page)?;
    cpu_figures(&cloud, figures);
    sets::figures(&cloud, models, figures)?;
    page.resources(&FOUR_LANES.config(cloud.points.points().len(), NEIGHBORS))?;
    page.save()
}
