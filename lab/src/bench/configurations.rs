//! The named configurations: what each is for, its area, its clock and its cycles; README's table of them.

use crate::synthesis::{AreaEntry, AreaRecord, Target, markdown};
use crate::{Figures, LabError};
use pointcore::configuration::{Configuration, parse, read_text, wrong};
use pointcore::plan::Plan;
use pointcore::process::{Cloud, Operation, Process, Queries, Simulation, Timed, process};
use pointcore::scene::{InvalidPoints, NormalSource, Scene};
use pointcore::search::{MemorySettings, Order, PointSet, PointSource, Query, SearchEngine, Session, Splitting, Tree};
use pointcore::splat::{EncodedFrame, SplatCore, SplatRunner};
use pointcore_contract::{Rendering, points, search, splat};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;

/// The line before README's table.
const TABLE_BEGIN: &str = "<!-- configurations -->\n";
/// The line after it.
const TABLE_END: &str = "<!-- end of configurations -->";
/// What stands for the area and clock of a core that was not placed and routed.
const NOT_PLACED: [&str; 6] = ["–"; 6];
/// Seed of shuffled queries.
const SEED: u64 = 1;

/// The table's columns.
const HEADER: [&str; 10] =
    ["configuration", "what it is for", "LUT4", "FF", "block RAM", "DSP", "MHz", "revision", "cycles", "verification"];

/// What is counted of a core's cycles.
enum Workload {
    /// A frame of a scene in `scenes/`, in the size of the configuration's image where that is smaller.
    Frame(&'static str),
    /// Neighbors of every point of a procedural surface, asked in random order.
    Search { points: u32, neighbors: u32 },
    /// One iteration of the program for as many points of a procedural surface, in coherent order.
    Process { points: u32, neighbors: u32 },
}

/// A configuration that the project ships.
struct Named {
    /// The name of its file in `configs/`.
    name: &'static str,
    /// Its unit in the record of areas, where it is placed and routed.
    unit: Option<&'static str>,
    workload: Workload,
}

const NAMED: [Named; 8] = [
    Named { name: "fpga", unit: None, workload: Workload::Frame("knot") },
    Named { name: "ecp5", unit: Some("splat"), workload: Workload::Frame("knot") },
    Named { name: "asic", unit: None, workload: Workload::Frame("plane") },
    Named { name: "tiny", unit: Some("tiny"), workload: Workload::Frame("plane") },
    Named { name: "knn", unit: Some("search"), workload: Workload::Search { points: 100_000, neighbors: 10 } },
    Named { name: "points", unit: None, workload: Workload::Process { points: 20_000, neighbors: 10 } },
    Named { name: "upsample", unit: Some("upsample"), workload: Workload::Search { points: 100_000, neighbors: 10 } },
    Named { name: "tiny_knn", unit: Some("tiny_knn"), workload: Workload::Search { points: 500, neighbors: 8 } },
];

/// Cycles of a workload.
enum Cycles {
    Frame(u64),
    Query(f64),
}

impl Workload {
    /// How the core is verified, in the words that README explains.
    const fn verification(&self) -> &'static str {
        match self {
            Self::Frame(_) => "units, recorded frame",
            Self::Search { .. } => "units, proofs, recorded search",
            Self::Process { .. } => "units, recorded run",
        }
    }

    /// Cycles on the golden model.
    fn cycles(&self, root: &Path, configuration: &Configuration) -> Result<Cycles, LabError> {
        match (self, configuration) {
            (Self::Frame(scene), Configuration::Splat(config)) => {
                let path = root.join("scenes").join(scene).with_extension("toml");
                frame_cycles(&path, config).map(Cycles::Frame)
            }
            (Self::Search { points, neighbors }, Configuration::Search(config)) => {
                query_cycles(*points, *neighbors, config).map(Cycles::Query)
            }
            (Self::Process { points, neighbors }, Configuration::Points(config)) => {
                program_cycles(*points, *neighbors, config).map(Cycles::Query)
            }
            _ => Err(wrong(root, "a configuration is of the other core than its workload").into()),
        }
    }
}

fn frame_cycles(path: &Path, config: &splat::Config) -> Result<u64, LabError> {
    let scene = Scene::load(path, &[])?;
    let size = |key, wanted: usize, largest: u32| format!("image.{key}={}", wanted.min(largest as usize));
    let Rendering { width, height, .. } = scene.rendering;
    let settings = [size("width", width, config.width), size("height", height, config.height)];
    let scene = Scene::load(path, &settings)?;
    let plan = Plan::on(&scene, config)?;
    let core = SplatCore::generate(&plan.config)?;
    let frame = EncodedFrame::new(&scene, &plan);
    Ok(SplatRunner::new(&plan.config, &frame).golden(&core)?.counters.cycles)
}

fn program_cycles(points: u32, k: u32, config: &points::Config) -> Result<f64, LabError> {
    let surface = PointSource::Surface(points as usize);
    let cloud = Cloud::load(config.search.geometry, &surface, InvalidPoints::Refuse, NormalSource::Estimate)?;
    let operation = Operation::named(config.process.program.name())?;
    let queries = Queries::Points(Order::Morton.indices(cloud.points(), None, SEED));
    let (settings, attributes) = (BTreeMap::new(), BTreeMap::new());
    let asked = Process {
        operation: &operation,
        k,
        radius: None,
        iterations: 1,
        passes: 1,
        settings: &settings,
        attributes: &attributes,
    };
    let hardware = Some(config.clone());
    let engine = Timed::new(Simulation { hardware, ..Simulation::of(SearchEngine::Golden) });
    let processed = process(&cloud, &queries, &asked, &engine, &|_| ())?;
    let timing = processed.summary.timings.last().expect("the model counts time");
    Ok(timing.cycles_per_query())
}

fn query_cycles(points: u32, k: u32, config: &search::Config) -> Result<f64, LabError> {
    let points = PointSet::load(config.geometry, &PointSource::Surface(points as usize))?;
    let places = Order::Random.places(&points, None, SEED);
    let query = |place| Query { point: points.rounded(place), k, radius: None };
    let queries: Vec<_> = places.into_iter().map(query).collect();
    let tree = Tree::build(config, &points, Splitting::Packed)?;
    let session = Session::open(config.clone(), tree, MemorySettings::default(), SearchEngine::Golden)?;
    let outcome = session.search(&queries)?;
    Ok(outcome.counters.cycles as f64 / queries.len() as f64)
}

/// A configuration as it is measured: what its file says that it is for, and its cycles.
struct Measured {
    named: &'static Named,
    purpose: String,
    cycles: Cycles,
}

impl Measured {
    /// Measures a configuration of the project at `root`.
    fn new(root: &Path, named: &'static Named) -> Result<Self, LabError> {
        let path = root.join("configs").join(named.name).with_extension("toml");
        let text = read_text(&path)?;
        let purpose = text.lines().next().and_then(|line| line.strip_prefix("# ")?.strip_suffix('.'));
        let purpose = purpose.ok_or_else(|| wrong(&path, "expected a first line `# What it is for.`"))?.to_owned();
        let cycles = named.workload.cycles(root, &parse(&path, &text)?)?;
        Ok(Self { named, purpose, cycles })
    }

    /// Its line of the table.
    fn row(&self, areas: &AreaRecord) -> Vec<String> {
        let Self { named: Named { name, unit, workload }, purpose, cycles } = self;
        let mut row = vec![format!("[`{name}`](configs/{name}.toml)"), purpose.clone()];
        let is_own = |entry: &&AreaEntry| Some(entry.unit.as_str()) == *unit && entry.target == Target::Ecp5;
        row.extend(areas.entries().iter().find(is_own).map_or_else(|| NOT_PLACED.map(String::from), placed));
        row.push(match (cycles, workload) {
            (Cycles::Frame(cycles), Workload::Frame(scene)) => format!("{} ({scene})", thousands(*cycles)),
            (Cycles::Frame(cycles), _) => thousands(*cycles),
            (Cycles::Query(cycles), _) => format!("{cycles:.1} a query"),
        });
        row.push(workload.verification().to_owned());
        row
    }
}

/// What a core takes that was placed and routed, its clock, and the revision that this is of.
fn placed(entry: &AreaEntry) -> [String; 6] {
    let area = &entry.area;
    let [lut, flip_flop, block_ram, dsp] = [area.lut, area.flip_flop, area.block_ram, area.dsp].map(thousands);
    let clock = entry.timing.as_ref().map_or_else(|| "–".to_owned(), |timing| format!("{:.0}", timing.fmax_mhz));
    [
        lut,
        flip_flop,
        block_ram,
        dsp,
        clock,
        entry.revision.as_ref().map_or_else(|| "this".to_owned(), ToString::to_string),
    ]
}

/// 1,234,567.
fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<_> = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy).collect();
    groups.join(",")
}

/// All named configurations, of the project at `root`.
fn measure(root: &Path) -> Result<Vec<Measured>, LabError> {
    NAMED.par_iter().map(|named| Measured::new(root, named)).collect()
}

/// README with its table as it should be.
///
/// # Errors
/// As [`figures`]; or there is no table between its marks.
pub fn tabulate(root: &Path, readme: &str) -> Result<String, LabError> {
    let parts = readme.split_once(TABLE_BEGIN).and_then(|(head, rest)| Some((head, rest.split_once(TABLE_END)?.1)));
    let missing = || wrong(&root.join("README.md"), format!("expected `{}` and `{TABLE_END}`", TABLE_BEGIN.trim_end()));
    let (head, tail) = parts.ok_or_else(missing)?;
    let areas = AreaRecord::load(&root.join("docs/area.json"))?;
    let mut rows = vec![HEADER.map(String::from).to_vec()];
    rows.extend(measure(root)?.iter().map(|measured| measured.row(&areas)));
    Ok(format!("{head}{TABLE_BEGIN}\n{}\n{TABLE_END}{tail}", markdown(&rows)))
}

/// Cycles of every named configuration: of a frame, or of a query.
///
/// # Errors
/// A configuration or a scene cannot be read, or a model does not come to its end.
pub fn figures(root: &Path, figures: &mut Figures) -> Result<(), LabError> {
    for Measured { named: Named { name, .. }, cycles, .. } in measure(root)? {
        let (key, value) = match cycles {
            Cycles::Frame(cycles) => ("cycles", cycles.into()),
            Cycles::Query(cycles) => ("cycles_per_query", cycles.into()),
        };
        figures.insert(format!("configuration.{name}.{key}"), value);
    }
    Ok(())
}
