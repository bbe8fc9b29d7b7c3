//! `pointcore knn --points FILE`.

use super::configuration;
use super::progress::{with_progress, with_spinner};
use super::{Failure, Output, generate, write};
use pointcore::core_b::{
    Engine, Error as SearchError, Measured, MemorySettings, Order, Outcome, PointSet, Query, Report, Reuse, Session,
    Source, Splitting, Tree, check, config_for,
};
use pointcore::lockstep::Stall;
use pointcore_spec::core_b::Config;
use serde_json::json;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Neighborhoods of the thesis' neighbor cache.
const CACHE_ENTRIES: u32 = 8;
/// Requests among which an out-of-order memory chooses.
const REORDER_WINDOW: usize = 8;

/// What answers the queries.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Model {
    /// The generated Verilog under Verilator, in lockstep with the golden model.
    Rtl,
    /// The bit-exact, cycle-accurate golden model alone.
    Golden,
}

/// How many queries are asked.
#[derive(Clone, Copy)]
struct Limit(Option<usize>);

impl std::str::FromStr for Limit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let count = text.parse().ok().filter(|count| *count > 0);
        match (text, count) {
            ("all", _) => Ok(Self(None)),
            (_, Some(count)) => Ok(Self(Some(count))),
            _ => Err("expected a number of queries from 1 up, or `all`".to_owned()),
        }
    }
}

/// Arguments of `knn`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The points: a PLY or OBJ file, or `surface:COUNT` for a procedural surface.
    #[arg(long, value_name = "FILE|surface:COUNT")]
    points: Source,
    /// Neighbors of each query, 1 to 64.
    #[arg(long, value_name = "COUNT", default_value_t = 10)]
    k: u32,
    /// Only neighbors nearer than this count.
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
    radius: Option<f32>,
    /// Query points, the vertices of a PLY or OBJ file in their order.
    #[arg(long, value_name = "FILE", conflicts_with = "order")]
    queries: Option<PathBuf>,
    /// Ask for the points themselves: `random`, `file` or `morton` order, or `grid:BxB` queries around each.
    #[arg(long, default_value_t = Order::Random)]
    order: Order,
    /// Ask N parts of the queries in turn, so that near ones are not under way together.
    #[arg(long, value_name = "N", default_value_t = 1)]
    interleave: usize,
    /// How many queries to ask, or `all`.
    #[arg(long, value_name = "COUNT", default_value = "2000")]
    limit: Limit,
    /// How the tree divides points.
    #[arg(long, value_enum, default_value = "packed")]
    tree: Splitting,
    /// The hardware's configuration, such as configs/knn.toml.
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Neighborhoods that a coherent neighbor cache holds, up to 32; 0 leaves it out. By default 8 with --epsilon or --alpha, else 0.
    #[arg(long, value_name = "COUNT", conflicts_with = "config")]
    cache: Option<u32>,
    /// How much farther than the true ones neighbors from the neighbor cache may be, as a share; by default not at all.
    #[arg(long, value_name = "SHARE")]
    epsilon: Option<f32>,
    /// The factor by which balls are searched larger for the neighbor cache; by default 1.25.
    #[arg(long, value_name = "FACTOR")]
    alpha: Option<f32>,
    /// What answers the queries.
    #[arg(long, value_enum, default_value = "rtl")]
    model: Model,
    /// Do not compare the Verilog with the golden model: faster, but trusts it.
    #[arg(long)]
    no_lockstep: bool,
    /// Cycles from a request to the memory to its answer, 1 to 500.
    #[arg(long, value_name = "CYCLES", default_value_t = MemorySettings::default().latency_cycles)]
    latency: u64,
    /// Bytes that the memory moves in a cycle, may be fractional; by default a beat of points.
    #[arg(long, value_name = "BYTES")]
    bandwidth: Option<f64>,
    /// Bytes that the memory can only move together.
    #[arg(long, value_name = "BYTES", default_value_t = MemorySettings::default().burst_bytes)]
    burst: u32,
    /// Let answers of the memory overtake each other.
    #[arg(long)]
    out_of_order: bool,
    /// Hold every stream back in this share of the cycles, at random.
    #[arg(long, value_name = "SHARE", default_value_t = 0.0)]
    stalls: f64,
    /// Seed of shuffles, stalls, the memory's order and the hardware's uninitialized values.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Compare every distance with a search through all points, bit for bit.
    #[arg(long)]
    check: bool,
    /// The clock for which queries per second are stated.
    #[arg(long, value_name = "MHZ", default_value_t = 100.0)]
    clock_mhz: f64,
    /// Write neighbors.csv (query, rank, point, distance2), as without --json, which writes neighbors.json instead.
    #[arg(long)]
    csv: bool,
    /// The folder for the results.
    #[arg(short, long, value_name = "DIR", default_value = "out/knn")]
    output: PathBuf,
}

impl Arguments {
    fn check(&self) -> Result<(), Failure> {
        let usage = |message| Err(Failure::Usage(message));
        if !(1..=64).contains(&self.k) {
            return usage(format!("--k {}: expected 1 to 64 neighbors", self.k));
        }
        match self.radius {
            Some(radius) if !(radius > 0.0 && radius.is_finite()) => {
                return usage(format!("--radius {radius}: expected a positive number"));
            }
            _ => {}
        }
        if !(0.0..1.0).contains(&self.stalls) {
            return usage(format!("--stalls {}: expected a share from 0 up to, but not, 1", self.stalls));
        }
        if !(self.clock_mhz > 0.0 && self.clock_mhz.is_finite()) {
            return usage(format!("--clock-mhz {}: expected a positive number", self.clock_mhz));
        }
        if self.interleave == 0 {
            return usage("--interleave 0: expected 1 part at least".to_owned());
        }
        if self.model == Model::Golden && self.no_lockstep {
            return usage("--no-lockstep goes with --model rtl".to_owned());
        }
        if self.cache == Some(0) && self.wants_reuse() {
            return usage(
                "--cache 0: --epsilon and --alpha go with a neighbor cache of 1 to 32 neighborhoods".to_owned(),
            );
        }
        self.memory().validate()?;
        self.reuse().validate()?;
        Ok(())
    }

    fn memory(&self) -> MemorySettings {
        MemorySettings {
            latency_cycles: self.latency,
            bytes_per_cycle: self.bandwidth,
            burst_bytes: self.burst,
            reorder_window: if self.out_of_order { REORDER_WINDOW } else { 1 },
        }
    }

    fn reuse(&self) -> Reuse {
        let Reuse { epsilon, alpha } = Reuse::default();
        Reuse { epsilon: self.epsilon.unwrap_or(epsilon), alpha: self.alpha.unwrap_or(alpha) }
    }

    /// Whether something is said that only a neighbor cache heeds.
    const fn wants_reuse(&self) -> bool {
        self.epsilon.is_some() || self.alpha.is_some()
    }

    /// Neighborhoods in the neighbor cache, where no configuration says.
    fn cache(&self) -> u32 {
        self.cache.unwrap_or(if self.wants_reuse() { CACHE_ENTRIES } else { 0 })
    }

    const fn engine(&self) -> (Engine, &'static str, Option<u64>) {
        match (self.model, self.no_lockstep) {
            (Model::Golden, _) => (Engine::Golden, "golden", None),
            (Model::Rtl, true) => (Engine::Hardware, "rtl", None),
            // A difference would end the run.
            (Model::Rtl, false) => (Engine::Lockstep, "rtl in lockstep with golden", Some(0)),
        }
    }

    /// The hardware, and the points in its format.
    fn hardware(&self) -> Result<(Config, PointSet), Failure> {
        if let Some(path) = &self.config {
            let config = configuration::parse_core_b(path, &configuration::read_text(path)?)?;
            if config.neighbor_cache == 0 && self.wants_reuse() {
                let message = "--epsilon and --alpha go with a neighbor cache: set `neighbor_cache` in";
                return Err(Failure::Usage(format!("{message} {}", path.display())));
            }
            let points = PointSet::load(config.geometry, &self.points)?;
            return Ok((config, points));
        }
        let points = PointSet::load(Config::default().geometry, &self.points)?;
        // The neighbor cache needs one neighbor more to tell how far a neighborhood reaches.
        let cache = self.cache();
        let searched = if cache > 0 && self.radius.is_none() { self.k + 1 } else { self.k };
        let config = config_for(points.points().len(), searched, self.tree);
        let config = Config { neighbor_cache: cache, ..config };
        config.validate().map_err(SearchError::from)?;
        Ok((config, points))
    }

    /// Queries, and where they come from.
    fn queries(&self, points: &PointSet) -> Result<(Vec<Query>, String), Failure> {
        let Limit(limit) = self.limit;
        let (mut places, source) = match &self.queries {
            Some(path) => {
                let vertices = PointSet::load(points.format(), &Source::File(path.clone()))?;
                (vertices.points().to_vec(), path.display().to_string())
            }
            None => (self.order.places(points, limit, self.seed), format!("{} order", self.order)),
        };
        places.truncate(limit.unwrap_or(usize::MAX));
        let query = |point: &[f32; 3]| Query { point: *point, k: self.k, radius: self.radius };
        let queries: Vec<Query> = places.iter().map(query).collect();
        let limited = limit.filter(|limit| *limit == queries.len());
        let limited = limited.map_or(String::new(), |limit| format!(" (--limit {limit})"));
        Ok((queries, source + &limited))
    }
}

/// Writes the queries, and the neighbors of each.
fn write_neighbors(queries: &[Query], outcome: &Outcome, output: Output, folder: &Path) -> Result<(), Failure> {
    let mut places = "query,x,y,z\n".to_owned();
    for (query, Query { point: [x, y, z], .. }) in queries.iter().enumerate() {
        _ = writeln!(places, "{query},{x:e},{y:e},{z:e}");
    }
    write(&folder.join("queries.csv"), &places)?;
    if output == Output::Json {
        let text = serde_json::to_string(&outcome.neighbors).expect("neighbors are lists");
        return write(&folder.join("neighbors.json"), &text);
    }
    let mut text = "query,rank,point,distance2\n".to_owned();
    for (query, neighbors) in outcome.neighbors.iter().enumerate() {
        for (rank, neighbor) in neighbors.iter().enumerate() {
            _ = writeln!(text, "{query},{rank},{},{:e}", neighbor.point, neighbor.distance2);
        }
    }
    write(&folder.join("neighbors.csv"), &text)
}

/// Searches neighbors.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    arguments.check()?;
    let (config, points) = arguments.hardware()?;
    let tree = Tree::build(&config, &points, arguments.tree)?;
    let (queries, order) = arguments.queries(&points)?;
    queries.iter().enumerate().try_for_each(|(index, query)| query.check(&config, index))?;
    let folder = &arguments.output;
    std::fs::create_dir_all(folder).map_err(|source| Failure::Write { path: folder.clone(), source })?;

    let (engine, engine_name, mismatches) = arguments.engine();
    let (statistics, beat_bytes) = (tree.statistics(), tree.beat_bytes());
    let stall = if arguments.stalls > 0.0 { Stall::Random(arguments.stalls) } else { Stall::Never };
    let command = std::env::args().skip(1).fold("pointcore".to_owned(), |command, word| command + " " + &word);
    let session = with_spinner("generating, verilating and compiling (cached for the next time)", || {
        Session::open(config.clone(), tree, arguments.memory(), engine)
    })?;
    let session = session
        .randomized(stall, arguments.seed)
        .reproduced_by(command)
        .reusing(arguments.reuse())?
        .interleaved(arguments.interleave);
    generate::write_core_b(session.core(), &config, &folder.join("verilog"))?;

    let outcome = with_progress(engine_name, |progress| session.search_with(&queries, progress))?;
    let file_format = if arguments.csv { Output::Text } else { output };
    write_neighbors(&queries, &outcome, file_format, folder)?;
    let checked = if arguments.check {
        let checking = || check(&points, &queries, &outcome.neighbors, arguments.reuse().epsilon);
        Some(with_spinner("searching through all points", checking).map_err(Failure::Neighbors)?)
    } else {
        None
    };
    let report = Report::new(&Measured {
        points: &arguments.points.to_string(),
        engine: engine_name,
        order: &order,
        config: &config,
        tree: statistics,
        splitting: arguments.tree.name(),
        memory: arguments.memory(),
        beat_bytes,
        k: arguments.k,
        radius: arguments.radius,
        outcome: &outcome,
        mismatches,
        checked,
        reuse: arguments.reuse(),
        clock_mhz: arguments.clock_mhz,
    });
    let markdown = report.markdown();
    write(&folder.join("report.md"), &markdown)?;
    write(&folder.join("report.json"), &serde_json::to_string_pretty(&report).expect("reports have string keys"))?;
    output.print(&json!(report), &format!("{markdown}\nWritten to {}.", folder.display()));
    Ok(())
}
