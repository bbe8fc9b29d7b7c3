//! `pointcore knn --points FILE`.

mod files;

use super::progress::{with_progress, with_spinner};
use super::results::Results;
use super::search::{Questions, SearchArguments};
use super::{Failure, Output, estimator, generate, waveform, write};
use pointcore::area::device::Device;
use pointcore::area::proxy::Proxy;
use pointcore::area::recorded::Clock;
use pointcore::configuration::Configuration;
use pointcore::package::Package;
use pointcore::search::{
    Checked, HardwareSize, MemorySettings, PointSet, PointSource, Rounding, SearchCore, SearchEngine, SearchOutcome,
    SearchReport, SearchRun, Session, Tree, TruthComparison, check, compare_with_truth, page,
};
use pointcore::waveform::{Waveform, Window, search_view};
use pointcore_contract::search::Config;
use pointcore_tb::lockstep::Stall;
use serde_json::json;
use std::path::PathBuf;

/// Requests among which an out-of-order memory chooses.
const REORDER_WINDOW: usize = 8;
/// The waveform of a run.
const WAVEFORM: &str = "search.fst";
/// What some runs leave and others do not.
const OWN_FILES: [&str; 4] = ["neighbors.csv", "neighbors.json", WAVEFORM, "search.gtkw"];

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
    /// The points: a model file (PLY, OBJ, glTF, PCD, LAS, LAZ, XYZ, CSV), or `surface:COUNT` for a procedural surface.
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
    /// Compare every distance with a search through all points, bit for bit, and count the neighbors that are others than those of the
    /// file's points in f64.
    #[arg(long)]
    check: bool,
    /// Write a waveform of the whole run (search.fst, and search.gtkw for GTKWave); implies --no-lockstep, slow and large.
    #[arg(long)]
    trace: bool,
    /// Write a waveform of these cycles of the run alone, A up to, but not, B; implies --trace.
    #[arg(long, value_name = "A..B")]
    trace_window: Option<Window>,
    /// The clock for which queries per second are stated, in MHz; by default the recorded one of the configuration, else 100.
    #[arg(long, value_name = "MHZ")]
    clock_mhz: Option<f64>,
    /// Say whether the core fits this device, such as LFE5U-45F or XC7A100T.
    #[arg(long, value_name = "NAME")]
    device: Option<Device>,
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
        if let Some(mhz) = self.clock_mhz.filter(|mhz| !(*mhz > 0.0 && mhz.is_finite())) {
            return usage(format!("--clock-mhz {mhz}: expected a positive number"));
        }
        if self.interleave == 0 {
            return usage("--interleave 0: expected 1 part at least".to_owned());
        }
        if self.model == KnnEngine::Golden && (self.no_lockstep || self.is_traced()) {
            return usage("--no-lockstep, --trace and --trace-window go with --model rtl".to_owned());
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

    const fn is_traced(&self) -> bool {
        self.trace || self.trace_window.is_some()
    }

    const fn engine(&self) -> (SearchEngine, &'static str, Option<u64>) {
        match (self.model, self.no_lockstep || self.is_traced()) {
            (KnnEngine::Golden, _) => (SearchEngine::Golden, "golden", None),
            (KnnEngine::Rtl, true) => (SearchEngine::Hardware, "rtl", None),
            // A difference would end the run.
            (KnnEngine::Rtl, false) => (SearchEngine::Lockstep, "rtl in lockstep with golden", Some(0)),
        }
    }
}

impl Arguments {
    /// Opens the core with its tree, on what was chosen.
    fn open(&self, config: &Config, tree: Tree, results: &Results) -> Result<Session, Failure> {
        let (engine, ..) = self.engine();
        let waveform = self
            .is_traced()
            .then(|| Waveform { path: results.folder().join(WAVEFORM), window: self.trace_window.clone() });
        let session =
            with_spinner("generating, verilating and compiling (cached for the next time)", || match waveform {
                Some(waveform) => Session::open_traced(config.clone(), tree, self.memory(), waveform),
                None => Session::open(config.clone(), tree, self.memory(), engine),
            })?;
        let stall = if self.stalls > 0.0 { Stall::Random(self.stalls) } else { Stall::Never };
        let command = std::env::args().skip(1).fold("pointcore".to_owned(), |command, word| command + " " + &word);
        let session = session.randomized(stall, self.search.seed).reproduced_by(command);
        Ok(session.reusing(self.search.reuse())?.interleaved(self.interleave))
    }

    /// The size of the core; its look-up tables are only estimated where a device is to hold them.
    fn hardware(&self, core: &SearchCore, config: &Config) -> Result<HardwareSize, Failure> {
        let lut4 = match self.device {
            Some(_) => with_spinner("looking through the record of areas (cached for the next time)", || {
                Ok::<_, Failure>(estimator()?.lut4(&Proxy::of(&core.design)))
            })?,
            None => None,
        };
        Ok(HardwareSize::of(core, config, self.device, lut4)?)
    }

    /// Compares the answers with a search through all points, and with the truth.
    fn compare(
        &self,
        points: &PointSet,
        Questions { queries, places, .. }: &Questions,
        outcome: &SearchOutcome,
    ) -> Result<(Option<Checked>, Option<TruthComparison>), Failure> {
        if !self.check {
            return Ok((None, None));
        }
        let checking = || check(points, queries, &outcome.neighbors, self.search.reuse().epsilon);
        let checked = with_spinner("searching through all points", checking).map_err(Failure::Neighbors)?;
        Ok((Some(checked), Some(compare_with_truth(points, places, queries, &outcome.neighbors))))
    }
}

/// Searches neighbors.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    arguments.check()?;
    let search = &arguments.search;
    let (config, points) = search.hardware(&arguments.points)?;
    let tree = Tree::build(&config, &points, search.tree)?;
    let questions = search.questions(&config, &points)?;
    let rounding = Rounding::of(&points, search.k).check()?;
    let results = Results::begin(&arguments.output)?;
    let folder = results.folder();

    let (_, engine_name, mismatches) = arguments.engine();
    let (statistics, beat_bytes) = (tree.statistics(), tree.beat_bytes());
    let session = arguments.open(&config, tree, &results)?;
    let name = arguments.output.file_name().map_or("knn".into(), std::ffi::OsStr::to_string_lossy);
    let package = Package::search(&name, session.core(), &config)?;
    generate::write_package(&package, &folder.join("verilog"))?;

    let outcome = with_progress(engine_name, |progress| session.search_with(&questions.queries, progress))?;
    if arguments.is_traced() {
        waveform::finish(arguments.trace_window.as_ref(), outcome.simulated_cycles)?;
        waveform::write_view(&search_view(&config), WAVEFORM, folder, &arguments.output)?;
    }
    let file_format = if arguments.csv { Output::Text } else { output };
    files::write_neighbors(&questions, &outcome, file_format, folder)?;
    let (checked, truth) = arguments.compare(&points, &questions, &outcome)?;
    let report = SearchReport::new(&SearchRun {
        points: &arguments.points.to_string(),
        engine: engine_name,
        order: &questions.source,
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
        rounding: Some(rounding),
        truth,
        reuse: search.reuse(),
        hardware: Some(arguments.hardware(session.core(), &config)?),
        clock: Clock::of(&Configuration::Search(config.clone()), arguments.clock_mhz),
    });
    let markdown = report.markdown();
    write(&folder.join("report.md"), &markdown)?;
    write(&folder.join("report.json"), &serde_json::to_string_pretty(&report).expect("reports have string keys"))?;
    write(&folder.join("index.html"), &page(&report, &points, &questions.queries, &outcome.query_cycles))?;
    results.finish(&OWN_FILES)?;
    output.print(&json!(report), &format!("{markdown}\nWritten to {}.", arguments.output.display()))
}
