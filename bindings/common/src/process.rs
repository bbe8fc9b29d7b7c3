//! Programs on neighborhoods: points and attributes in, what leaves with each query out.

use crate::attributes::{Points, columns, settings_of};
use crate::search::CONFIGURATION;
use crate::{BackEnd, BindingError, Named};
use glam::DVec3;
use pointcore::configuration::{self, Configuration};
use pointcore::process::{
    Cloud, Column, Engine, Interpreted, NEIGHBORS_LIMIT, Numbers, Operation, Process as Asked, ProcessError, Processed,
    Queries, Simulation, Timed, process,
};
use pointcore_contract::Format;
use pointcore_contract::points::Config;
use std::collections::BTreeMap;
use std::path::Path;

/// What errors call a program that is a text.
const PROGRAM: &str = "program";
/// Neighbors of a query at most, where neither their number nor a radius is said.
const NEIGHBORS: u32 = 16;
/// Columns and rows of a pattern, where none is said.
const PATTERN: [u32; 2] = [2, 2];
/// The most queries on a side of a pattern.
const PATTERN_LIMIT: u32 = 64;

/// Where a program is.
#[derive(Clone, Copy, Debug)]
pub enum ProgramSource<'a> {
    /// The name of an operation or program that comes with the project, the path of a `.pasm` file, or a text of several
    /// lines.
    Said(&'a str),
    /// A file.
    File(&'a Path),
}

/// What is asked of a program.
#[derive(Clone, Debug)]
pub struct ProcessSettings {
    /// Neighbors of a query at most, itself among them; 16 without it, 64 where there is a radius.
    pub k: Option<u32>,
    /// Only neighbors nearer than this count.
    pub radius: Option<f64>,
    /// Iterations of a query at most.
    pub iterations: u32,
    /// How often the points are replaced by what leaves.
    pub passes: u32,
    /// Columns and rows of queries around each point, for programs whose queries carry offsets.
    pub pattern: Option<[u32; 2]>,
    /// Settings; others follow from the points.
    pub settings: Vec<Named>,
}

impl Default for ProcessSettings {
    fn default() -> Self {
        Self { k: None, radius: None, iterations: 16, passes: 1, pattern: None, settings: vec![] }
    }
}

/// A program, and what carries it out.
pub struct Process {
    operation: Operation,
    format: Format,
    engine: Box<dyn Engine + Send + Sync>,
}

/// What left with queries.
#[derive(Clone, Debug)]
pub struct Results {
    /// Outputs of the operation's last program, in its order.
    pub outputs: Vec<Output>,
    /// Where the queries lie in the end, if the program says so, else where they began.
    pub positions: Vec<[f64; 3]>,
    /// Iterations of each query.
    pub iterations: Vec<u32>,
    /// Neighbors of each query in its last iteration, where they were counted.
    pub neighbors: Option<Vec<u32>>,
    /// Queries that were not done, but had no iteration left.
    pub capped: Vec<bool>,
    /// Cycles of all programs, from the first query to the last result, where time was counted.
    pub cycles: Option<u64>,
    /// The report's figures, a JSON object.
    pub report: String,
}

/// What left under a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// The name.
    pub name: String,
    /// The numbers of a query: 1 or 3.
    pub components: usize,
    /// Query by query, the components of each together.
    pub numbers: Values,
}

/// Numbers of a type.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// In the coordinates of the points.
    Double(Vec<f64>),
    /// As the program's floats are.
    Float(Vec<f32>),
    /// Whole numbers.
    Int(Vec<i32>),
    /// Truth values.
    Bool(Vec<bool>),
}

impl Process {
    /// Reads a program, and finds what carries it out: the interpreter, or a point processor, which is generated when it
    /// is first used. The configuration is the point processor's, as TOML; without one it follows from the points.
    ///
    /// # Errors
    /// The program is unknown, cannot be read, or has a mistake; the configuration is none of a point processor.
    pub fn open(
        program: ProgramSource<'_>,
        configuration: Option<&str>,
        back_end: BackEnd,
    ) -> Result<Self, BindingError> {
        let operation = operation(program)?;
        let hardware = configuration.map(point_processor).transpose()?;
        let format = hardware.as_ref().map_or_else(|| Format::F32.flushed(), |hardware| hardware.search.geometry);
        let engine: Box<dyn Engine + Send + Sync> = match (back_end.process(), hardware) {
            (None, None) => Box::new(Interpreted),
            (None, Some(_)) => {
                let message = "the interpreter knows no hardware: a configuration goes with another back end";
                return Err(BindingError::input(message));
            }
            (Some(engine), hardware) => {
                let rate = hardware.as_ref().map_or(1, |hardware| hardware.process.rate);
                Box::new(Timed::new(Simulation { hardware, rate, ..Simulation::of(engine) }))
            }
        };
        Ok(Self { operation, format, engine })
    }

    /// Carries the program out for each query, or for each point without any.
    ///
    /// # Errors
    /// Names, shapes or values do not suit the program; tools are missing or fail; hardware and model differ.
    pub fn run(
        &self,
        points: &Points,
        queries: Option<&Points>,
        settings: &ProcessSettings,
    ) -> Result<Results, BindingError> {
        if settings.passes == 0 {
            return Err(BindingError::input("passes is 0: expected 1 at least"));
        }
        let cloud = self.cloud("points", points)?;
        // Without a query nothing is left to be simulated.
        let is_idle = queries.is_some_and(|queries| queries.places.is_empty());
        let has_offsets = ["u", "v"].iter().all(|name| points.has(name));
        let queries = self.queries(&cloud, queries, settings.pattern, has_offsets)?;
        let asked = Asked {
            operation: &self.operation,
            k: settings.k.unwrap_or(if settings.radius.is_some() { NEIGHBORS_LIMIT } else { NEIGHBORS }),
            // As the command's: settings that follow from it are the same bits then.
            radius: settings.radius.map(|radius| f64::from(radius as f32)),
            iterations: settings.iterations,
            passes: settings.passes,
            settings: &settings_of(&settings.settings)?,
            // Points and queries have their own.
            attributes: &BTreeMap::new(),
        };
        let engine: &dyn Engine = if is_idle { &Interpreted } else { &*self.engine };
        Ok(Results::of(process(&cloud, &queries, &asked, engine, &|_| ())?))
    }

    fn cloud(&self, name: &str, points: &Points) -> Result<Cloud, BindingError> {
        let columns = columns(&self.operation, name, points)?;
        let places = points.places.iter().copied().map(DVec3::from_array).collect();
        Ok(Cloud::of(self.format, name.to_owned(), places, columns)?)
    }

    fn queries(
        &self,
        cloud: &Cloud,
        queries: Option<&Points>,
        pattern: Option<[u32; 2]>,
        has_offsets: bool,
    ) -> Result<Queries, BindingError> {
        let name = self.operation.name();
        let wrong = |problem: String| Err(BindingError::input(problem));
        let all = || (0..cloud.len()).collect();
        match (queries, pattern) {
            (Some(_), Some(_)) => wrong("queries and a pattern are both given: expected one of them".to_owned()),
            (Some(_), None) if self.operation.stages().len() > 1 => Err(ProcessError::Queries(name.to_owned()).into()),
            (Some(queries), None) if queries.places.is_empty() => Ok(Queries::Points(vec![])),
            (Some(queries), None) => Ok(Queries::Cloud(Box::new(self.cloud("queries", queries)?))),
            (None, Some(_)) if !self.operation.has_pattern() => wrong(format!(
                "a pattern is given, but queries of `{name}` carry no offsets `u` and `v`: expected none"
            )),
            (None, Some(_)) if has_offsets => {
                wrong("`u` and `v` are attributes, and a pattern is given: expected one of them".to_owned())
            }
            (None, Some(sides)) if !sides.iter().all(|side| (1..=PATTERN_LIMIT).contains(side)) => {
                wrong(format!("the pattern is {sides:?}: expected 1 to {PATTERN_LIMIT} columns and rows"))
            }
            (None, None) if has_offsets || !self.operation.has_pattern() => Ok(Queries::Points(all())),
            (None, sides) => Ok(Queries::Pattern { points: all(), sides: sides.unwrap_or(PATTERN) }),
        }
    }
}

impl Results {
    fn of(processed: Processed) -> Self {
        let answers = processed.answers();
        let timings = &processed.summary.timings;
        let iterations = answers.iter().map(|answer| answer.iterations).collect();
        let neighbors = answers.iter().map(|answer| answer.neighbors).collect();
        let capped = answers.iter().map(|answer| answer.capped).collect();
        let cycles = (!timings.is_empty()).then(|| timings.iter().map(|timing| timing.cycles).sum());
        let report = serde_json::to_string(&processed.summary).expect("reports have string keys");
        let positions = processed.places.iter().map(DVec3::to_array).collect();
        let outputs = processed.columns.into_iter().map(Output::of).collect();
        Self { outputs, positions, iterations, neighbors, capped, cycles, report }
    }

    /// What left under a name.
    #[must_use]
    pub fn output(&self, name: &str) -> Option<&Output> {
        self.outputs.iter().find(|output| output.name == name)
    }
}

impl Values {
    /// All as doubles, each exactly.
    #[must_use]
    pub fn doubles(&self) -> Vec<f64> {
        match self {
            Self::Double(numbers) => numbers.clone(),
            Self::Float(numbers) => numbers.iter().copied().map(f64::from).collect(),
            Self::Int(numbers) => numbers.iter().copied().map(f64::from).collect(),
            Self::Bool(flags) => flags.iter().copied().map(f64::from).collect(),
        }
    }
}

impl Output {
    fn of(column: Column) -> Self {
        let Column { name, numbers, .. } = column;
        let components = numbers.len();
        let numbers = match numbers.first() {
            Some(Numbers::Int(_)) => Values::Int(rows(&numbers, |part, query| part.number(query) as i32)),
            Some(Numbers::Bool(_)) => Values::Bool(rows(&numbers, |part, query| part.number(query) == 1.0)),
            Some(Numbers::Float(_)) => Values::Float(rows(&numbers, |part, query| part.number(query) as f32)),
            _ => Values::Double(rows(&numbers, Numbers::number)),
        };
        Self { name, components, numbers }
    }
}

/// Numbers query by query, the components of each together.
fn rows<T>(parts: &[Numbers], number: impl Fn(&Numbers, usize) -> T) -> Vec<T> {
    let count = parts.first().map_or(0, Numbers::len);
    (0..count)
        .flat_map(|query| parts.iter().map(move |part| (part, query)))
        .map(|(part, query)| number(part, query))
        .collect()
}

fn operation(program: ProgramSource<'_>) -> Result<Operation, ProcessError> {
    match program {
        ProgramSource::File(path) => Operation::load(path),
        ProgramSource::Said(text) if text.contains('\n') => Operation::parse(PROGRAM, text),
        ProgramSource::Said(path) if path.ends_with(".pasm") => Operation::load(Path::new(path)),
        ProgramSource::Said(name) => Operation::named(name),
    }
}

fn point_processor(text: &str) -> Result<Config, BindingError> {
    match configuration::parse(Path::new(CONFIGURATION), text)? {
        Configuration::Points(config) => Ok(config),
        Configuration::Splat(_) | Configuration::Search(_) => {
            let problem = "is not for the point processor: programs need one with the line `kind = \"points\"`";
            Err(configuration::wrong(Path::new(CONFIGURATION), problem).into())
        }
    }
}

#[cfg(test)]
mod tests;
