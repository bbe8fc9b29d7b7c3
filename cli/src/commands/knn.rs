//! `pointcore knn --points FILE`.

use super::progress::{with_progress, with_spinner};
use super::search::SearchArguments;
use super::{Failure, Output, generate, write};
use pointcore::package::Package;
use pointcore::search::{
    MemorySettings, PointSource, Query, SearchEngine, SearchOutcome, SearchReport, SearchRun, Session, Tree, check,
};
use pointcore_tb::lockstep::Stall;
use serde_json::json;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Requests among which an out-of-order memory chooses.
const REORDER_WINDOW: usize = 8;

/// What answers the queries.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum KnnEngine {
    /// The generated Verilog under Verilator, in lockstep with the golden model.
    Rtl,
    /// The bit-exact, cycle-accurate golden model alone.
    Golden,
}

/// Arguments of `knn`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The points: a PLY or OBJ file, or `surface:COUNT` for a procedural surface.
    #[arg(long, value_name = "FILE|surface:COUNT")]
    points: PointSource,
    #[command(flatten)]
    search: SearchArguments,
    /// Ask N parts of the queries in turn, so that near ones are not under way together.
    #[arg(long, value_name = "N", default_value_t = 1)]
    interleave: usize,
    /// What answers the queries.
    #[arg(long, value_enum, default_value = "rtl")]
    model: KnnEngine,
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
        self.search.check()?;
        if !(0.0..1.0).contains(&self.stalls) {
            return usage(format!("--stalls {}: expected a share from 0 up to, but not, 1", self.stalls));
        }
        if !(self.clock_mhz > 0.0 && self.clock_mhz.is_finite()) {
            return usage(format!("--clock-mhz {}: expected a positive number", self.clock_mhz));
        }
        if self.interleave == 0 {
            return usage("--interleave 0: expected 1 part at least".to_owned());
        }
        if self.model == KnnEngine::Golden && self.no_lockstep {
            return usage("--no-lockstep goes with --model rtl".to_owned());
        }
        Ok(self.memory().validate()?)
    }

    fn memory(&self) -> MemorySettings {
        MemorySettings {
            latency_cycles: self.latency,
            bytes_per_cycle: self.bandwidth,
            burst_bytes: self.burst,
            reorder_window: if self.out_of_order { REORDER_WINDOW } else { 1 },
        }
    }

    const fn engine(&self) -> (SearchEngine, &'static str, Option<u64>) {
        match (self.model, self.no_lockstep) {
            (KnnEngine::Golden, _) => (SearchEngine::Golden, "golden", None),
            (KnnEngine::Rtl, true) => (SearchEngine::Hardware, "rtl", None),
            // A difference would end the run.
            (KnnEngine::Rtl, false) => (SearchEngine::Lockstep, "rtl in lockstep with golden", Some(0)),
        }
    }
}

/// Writes the queries, and the neighbors of each.
fn write_neighbors(queries: &[Query], outcome: &SearchOutcome, output: Output, folder: &Path) -> Result<(), Failure> {
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
    let search = &arguments.search;
    let (config, points) = search.hardware(&arguments.points)?;
    let tree = Tree::build(&config, &points, search.tree)?;
    let (queries, order) = search.queries(&config, &points)?;
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
        .randomized(stall, search.seed)
        .reproduced_by(command)
        .reusing(search.reuse())?
        .interleaved(arguments.interleave);
    let name = folder.file_name().map_or("knn".into(), std::ffi::OsStr::to_string_lossy);
    let package = Package::search(&name, session.core(), &config)?;
    generate::write_package(&package, &folder.join("verilog"))?;

    let outcome = with_progress(engine_name, |progress| session.search_with(&queries, progress))?;
    let file_format = if arguments.csv { Output::Text } else { output };
    write_neighbors(&queries, &outcome, file_format, folder)?;
    let checked = if arguments.check {
        let checking = || check(&points, &queries, &outcome.neighbors, search.reuse().epsilon);
        Some(with_spinner("searching through all points", checking).map_err(Failure::Neighbors)?)
    } else {
        None
    };
    let report = SearchReport::new(&SearchRun {
        points: &arguments.points.to_string(),
        engine: engine_name,
        order: &order,
        config: &config,
        tree: statistics,
        splitting: search.tree.name(),
        memory: arguments.memory(),
        beat_bytes,
        k: search.k,
        radius: search.radius,
        outcome: &outcome,
        mismatches,
        checked,
        reuse: search.reuse(),
        clock_mhz: arguments.clock_mhz,
    });
    let markdown = report.markdown();
    write(&folder.join("report.md"), &markdown)?;
    write(&folder.join("report.json"), &serde_json::to_string_pretty(&report).expect("reports have string keys"))?;
    output.print(&json!(report), &format!("{markdown}\nWritten to {}.", folder.display()));
    Ok(())
}
