//! `pointcore knn --points FILE`.

mod files;

use super::memory::MemoryArguments;
use super::progress::{with_progress, with_spinner};
use super::results::Results;
use super::search::{Questions, SearchArguments};
use super::simulation::{Engine, Simulated, SimulationArguments};
use super::{Failure, Output, estimator, generate, numbers, waveform, write};
use pointcore::area::device::Device;
use pointcore::area::proxy::Proxy;
use pointcore::area::recorded::Clock;
use pointcore::configuration::Configuration;
use pointcore::package::Package;
use pointcore::scene::InvalidPoints;
use pointcore::search::{
    Checked, HardwareSize, PointSet, PointSource, Rounding, SearchCore, SearchError, SearchOutcome, SearchReport,
    SearchRun, Session, Tree, TruthComparison, check, compare_with_truth, page,
};
use pointcore::waveform::search_view;
use pointcore_contract::search::Config;
use serde_json::json;
use std::path::PathBuf;

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
    /// Leave out points of files that are no numbers; neighbors keep the numbers that their points have in the file.
    #[arg(long)]
    drop_invalid: bool,
    #[command(flatten)]
    search: SearchArguments,
    /// Ask N parts of the queries in turn, so that near ones are not under way together.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = numbers::within(1_usize.., "1 part at least"))]
    interleave: usize,
    /// What answers the queries.
    #[arg(long, value_enum, default_value = "rtl")]
    model: KnnEngine,
    #[command(flatten)]
    simulation: SimulationArguments,
    #[command(flatten)]
    memory: MemoryArguments,
    /// Compare every distance with a search through all points, bit for bit, and count the neighbors that are others than those of the
    /// file's points in f64.
    #[arg(long)]
    check: bool,
    /// The clock for which queries per second are stated, in MHz; by default the recorded one of the configuration, else 100.
    #[arg(long, value_name = "MHZ", value_parser = numbers::positive())]
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
        self.search.check()?;
        self.simulation.check(self.simulated())?;
        Ok(self.memory.settings().validate().map_err(SearchError::from)?)
    }

    const fn simulated(&self) -> Simulated {
        match self.model {
            KnnEngine::Rtl => Simulated::Verilog,
            KnnEngine::Golden => Simulated::Model,
        }
    }

    const fn engine(&self) -> Engine {
        self.simulation.engine(self.simulated())
    }
}

/// The error, with what leaves out points that are no numbers.
fn remedied(failure: Failure) -> Failure {
    match failure {
        Failure::Search(SearchError::Model(error)) => {
            SearchError::Model(error.remedied("; --drop-invalid leaves such points out")).into()
        }
        other => other,
    }
}

impl Arguments {
    /// The hardware, the points, their tree, and what is asked of them.
    fn load(&self) -> Result<(Config, PointSet, Tree, Questions), Failure> {
        let invalid = if self.drop_invalid { InvalidPoints::Drop } else { InvalidPoints::Refuse };
        let (config, points) = self.search.hardware(&self.points, invalid)?;
        let tree = Tree::build(&config, &points, self.search.tree)?;
        let questions = self.search.questions(&config, &points, invalid)?;
        Ok((config, points, tree, questions))
    }

    /// What is searched, in words.
    fn description(&self, points: &PointSet) -> String {
        match points.left_out() {
            0 => self.points.to_string(),
            count => format!("{} without {count} points that are no numbers", self.points),
        }
    }

    /// Opens the core with its tree, on what was chosen.
    fn open(&self, config: &Config, tree: Tree, results: &Results) -> Result<Session, Failure> {
        let waveform = self.simulation.waveform(results.folder().join(WAVEFORM));
        let session =
            with_spinner("generating, verilating and compiling (cached for the next time)", || match waveform {
                Some(waveform) => Session::open_traced(config.clone(), tree, self.memory.settings(), waveform),
                None => Session::open(config.clone(), tree, self.memory.settings(), self.engine().into()),
            })?;
        let command = std::env::args().skip(1).fold("pointcore".to_owned(), |command, word| command + " " + &word);
        let session = session.randomized(self.simulation.stall(), self.search.seed).reproduced_by(command);
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
    let (config, points, tree, questions) = arguments.load().map_err(remedied)?;
    let rounding = Rounding::of(&points, search.k).check()?;
    let results = Results::begin(&arguments.output)?;
    let folder = results.folder();

    let engine = arguments.engine();
    let (statistics, beat_bytes) = (tree.statistics(), tree.beat_bytes());
    let session = arguments.open(&config, tree, &results)?;
    let name = arguments.output.file_name().map_or("knn".into(), std::ffi::OsStr::to_string_lossy);
    let package = Package::search(&name, session.core(), &config)?;
    generate::write_package(&package, &folder.join("verilog"))?;

    let outcome = with_progress(engine.name(), |progress| session.search_with(&questions.queries, progress))?;
    if arguments.simulation.is_traced() {
        waveform::finish(arguments.simulation.trace_window.as_ref(), outcome.simulated_cycles)?;
        waveform::write_view(&search_view(&config), WAVEFORM, folder, &arguments.output)?;
    }
    let file_format = if arguments.csv { Output::Text } else { output };
    files::write_neighbors(&questions, &points, &outcome, file_format, folder)?;
    let (checked, truth) = arguments.compare(&points, &questions, &outcome)?;
    let report = SearchReport::new(&SearchRun {
        points: &arguments.description(&points),
        engine: engine.name(),
        order: &questions.source,
        config: &config,
        tree: statistics,
        splitting: search.tree.name(),
        memory: arguments.memory.settings(),
        beat_bytes,
        k: search.k,
        radius: search.radius,
        outcome: &outcome,
        mismatches: engine.mismatches(),
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
