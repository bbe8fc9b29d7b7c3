//! What is asked of `process`.

use super::hardware::HardwareArguments;
use crate::commands::search::Limit;
use crate::commands::{Failure, numbers};
use pointcore::process::{Cloud, ITERATIONS_LIMIT, NEIGHBORS_LIMIT, Operation, Queries};
use pointcore::scene::{InvalidPoints, NormalSource};
use pointcore::search::{Order, PointSource};
use pointcore_contract::Format;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::str::FromStr;

/// Neighbors of a query where nothing says how many.
const NEIGHBORS: u32 = 16;

/// Arguments of `process`.
#[derive(clap::Args)]
pub struct Arguments {
    /// What is done: normals, covariance, mls, apss, smooth, resample or sph.
    #[arg(long, value_name = "NAME", required_unless_present = "program", conflicts_with = "program")]
    op: Option<String>,
    /// A program of your own instead (docs/programs.md).
    #[arg(long, value_name = "FILE.pasm")]
    program: Option<PathBuf>,
    /// The points: a model file (PLY, OBJ, glTF, PCD, LAS, LAZ, XYZ, CSV), or `surface:COUNT` for a procedural surface.
    #[arg(long, value_name = "FILE|surface:COUNT")]
    pub points: PointSource,
    /// Leave out points of files that are no numbers.
    #[arg(long)]
    drop_invalid: bool,
    /// Neighbors of each query, nearest first, itself among them; 1 to 64, by default 16, with --radius 64.
    #[arg(long, value_name = "COUNT", value_parser = numbers::within(1_u32..=NEIGHBORS_LIMIT, "1 to 64 neighbors"))]
    k: Option<u32>,
    /// Only neighbors nearer than this count; weights reach as far.
    #[arg(long, value_name = "LENGTH", value_parser = numbers::within(f32::MIN_POSITIVE..=f32::MAX, numbers::POSITIVE))]
    radius: Option<f32>,
    /// Iterations of a query at most; one that is not done by then is marked `capped`.
    #[arg(long, value_name = "COUNT", default_value_t = 16, value_parser = numbers::within(1_u32..=ITERATIONS_LIMIT, "1 to 65535 iterations"))]
    pub iterations: u32,
    /// Run over all points so often, each time in the place of those before.
    #[arg(long, value_name = "COUNT", default_value_t = 1, value_parser = numbers::within(1_u32.., "1 pass at least"))]
    passes: u32,
    /// A setting of the program instead of what follows from the points: `tolerance=0.001`, `viewpoint=0,0,10`.
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<Assignment>,
    /// A field of all points, instead of the attribute of that name: `area=0.5`, `normal=0,0,1`.
    #[arg(long, value_name = "NAME=VALUE")]
    attribute: Vec<Assignment>,
    /// Where normals come from: those of the file if it has any, else the program `normals` (auto); file; estimate.
    #[arg(long, value_name = "SOURCE", default_value = "auto", value_parser = clap::builder::PossibleValuesParser::new(["auto", "file", "estimate"]))]
    normals: String,
    /// Query points, the vertices of a model file in their order, with their attributes.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["order", "passes", "pattern"])]
    queries: Option<PathBuf>,
    /// Ask for the points themselves: `file`, `random` or `morton` order, or `grid:BxB` queries around each.
    #[arg(long, default_value_t = Order::File)]
    order: Order,
    /// How many queries to ask (of a pattern how many points), or `all`.
    #[arg(long, value_name = "COUNT", default_value = "all")]
    limit: Limit,
    /// Columns and rows of queries around each point, for programs whose queries carry offsets `u` and `v`, as `resample`; by default 2x2.
    #[arg(long, value_name = "CxR")]
    pattern: Option<Pattern>,
    /// Seed of everything random: shuffles, and in a simulation stalls, the memory's order and uninitialized values.
    #[arg(long, default_value_t = 1, value_parser = numbers::whole())]
    pub seed: u64,
    #[command(flatten)]
    pub hardware: HardwareArguments,
    /// The format of floats: f32, f24, f32-ftz or f24-ftz.
    #[arg(long, value_name = "FORMAT", default_value_t = Format::F32.flushed())]
    pub format: Format,
    /// Cycles a neighbor, 1 to 8: the kernel's operators are shared among as many.
    #[arg(long, value_name = "CYCLES", default_value_t = 1, value_parser = numbers::within(1_u32..=8, "1 to 8 cycles"))]
    pub rate: u32,
    /// Estimate look-up tables by the project's record of areas.
    #[arg(long)]
    pub luts: bool,
    /// Compare every output with the formulas in f64, within bounds that are derived.
    #[arg(long)]
    pub check: bool,
    /// Files of results, separated by commas: ply, csv, npy (an array an output).
    #[arg(long, value_name = "KINDS", value_delimiter = ',', default_value = "ply", value_enum)]
    pub write: Vec<FileKind>,
    /// The folder for the results.
    #[arg(short, long, value_name = "DIR", default_value = "out/process")]
    pub output: PathBuf,
}

/// A kind of result files.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum FileKind {
    /// points.ply, binary.
    Ply,
    /// points.csv.
    Csv,
    /// A file an output, such as normal.npy.
    Npy,
}

/// Numbers that have a name.
#[derive(Clone)]
struct Assignment {
    name: String,
    values: Vec<f64>,
}

impl FromStr for Assignment {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "expected NAME=NUMBER, or NAME=X,Y,Z for a vector".to_owned();
        let (name, values) = text.split_once('=').ok_or_else(wrong)?;
        let values = values.split(',').map(|value| value.trim().parse()).collect::<Result<_, _>>();
        Ok(Self { name: name.trim().to_owned(), values: values.map_err(|_| wrong())? })
    }
}

/// Columns and rows around a point.
#[derive(Clone, Copy)]
struct Pattern([u32; 2]);

/// The most queries on a side of a pattern.
const PATTERN_LIMIT: u32 = 64;

impl FromStr for Pattern {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |text: &str| text.parse().ok().filter(|side| (1..=PATTERN_LIMIT).contains(side));
        let sides = text.split_once('x').and_then(|(columns, rows)| Some([side(columns)?, side(rows)?]));
        sides.map(Self).ok_or_else(|| format!("expected a pattern from 1x1 to {PATTERN_LIMIT}x{PATTERN_LIMIT}"))
    }
}

impl Arguments {
    /// What is done.
    pub fn operation(&self) -> Result<Operation, Failure> {
        let operation = match (&self.program, &self.op) {
            (Some(path), _) => Operation::load(path),
            (None, name) => Operation::named(name.as_deref().unwrap_or_default()),
        }?;
        if self.pattern.is_some() && !operation.has_pattern() {
            let message = "--pattern: queries of `{}` carry no offsets `u` and `v`, as those of `resample` do; --order grid:BxB asks around each point";
            return Err(Failure::Usage(message.replace("{}", operation.name())));
        }
        Ok(operation)
    }

    /// Neighbors of a query at most.
    pub fn k(&self) -> u32 {
        self.k.unwrap_or(if self.radius.is_some() { NEIGHBORS_LIMIT } else { NEIGHBORS })
    }

    /// Only neighbors nearer than this count.
    pub fn radius(&self) -> Option<f64> {
        self.radius.map(f64::from)
    }

    /// How often the points are replaced.
    pub const fn passes(&self) -> u32 {
        self.passes
    }

    const fn invalid(&self) -> InvalidPoints {
        if self.drop_invalid { InvalidPoints::Drop } else { InvalidPoints::Refuse }
    }

    /// The points with their attributes.
    pub fn cloud(&self) -> Result<Cloud, Failure> {
        let normals = match self.normals.as_str() {
            "file" => NormalSource::File,
            "estimate" => NormalSource::Estimate,
            _ => NormalSource::Auto,
        };
        Ok(Cloud::load(self.format, &self.points, self.invalid(), normals)?)
    }

    /// What is asked.
    pub fn queries(&self, operation: &Operation, cloud: &Cloud) -> Result<Queries, Failure> {
        let Limit(limit) = self.limit;
        if let Some(path) = &self.queries {
            let source = PointSource::File(path.clone());
            let queries = Cloud::load(self.format, &source, self.invalid(), NormalSource::Auto)?;
            return Ok(Queries::Cloud(Box::new(queries.limited(limit)?)));
        }
        let points = self.order.indices(cloud.points(), limit, self.seed);
        Ok(match self.order {
            Order::Grid { .. } => Queries::Places(self.order.places(cloud.points(), limit, self.seed)),
            _ if operation.has_pattern() => {
                let Pattern(sides) = self.pattern.unwrap_or(Pattern([2, 2]));
                Queries::Pattern { points, sides }
            }
            _ => Queries::Points(points),
        })
    }

    /// Settings that were given.
    pub fn settings(&self) -> Result<BTreeMap<String, Vec<f64>>, Failure> {
        named("--set", &self.set)
    }

    /// Fields that were given.
    pub fn attributes(&self) -> Result<BTreeMap<String, Vec<f64>>, Failure> {
        named("--attribute", &self.attribute)
    }
}

fn named(option: &str, assignments: &[Assignment]) -> Result<BTreeMap<String, Vec<f64>>, Failure> {
    let mut all = BTreeMap::new();
    for Assignment { name, values } in assignments {
        if all.insert(name.clone(), values.clone()).is_some() {
            return Err(Failure::Usage(format!("{option} gives `{name}` twice: expected once")));
        }
    }
    Ok(all)
}
