//! What leaves with queries, by name.

use super::attributes::Bound;
use super::settings::Setting;
use super::timing::Timing;
use glam::DVec3;
use serde::Serialize;

/// Numbers of each query, or point.
#[derive(Clone, Debug, PartialEq)]
pub enum Numbers {
    /// In the coordinates of the points.
    Double(Vec<f64>),
    /// As the program's floats are.
    Float(Vec<f32>),
    /// Whole numbers.
    Int(Vec<i32>),
    /// Truth values.
    Bool(Vec<bool>),
}

/// One or three numbers of each query.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The output's name.
    pub name: String,
    /// Names of its parts: the axes' of a vector.
    pub parts: Vec<String>,
    /// Numbers of each part.
    pub numbers: Vec<Numbers>,
}

/// What became of the queries.
#[derive(Clone, Debug)]
pub struct Processed {
    /// What was asked for, query by query.
    pub columns: Vec<Column>,
    /// Where the queries lie in the end, if the operation says so, else where they began.
    pub places: Vec<DVec3>,
    /// The programs of the last pass as they were run, one at least.
    pub stages: Vec<super::Stage>,
    /// What happened, in numbers.
    pub summary: Summary,
}

/// What happened, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// The operation.
    pub operation: String,
    /// What carried it out.
    pub engine: &'static str,
    /// The points, as the user calls them.
    pub points: String,
    /// Number of points.
    pub point_count: usize,
    /// Points of the file that were left out, since they are no numbers.
    pub left_out: usize,
    /// Number of queries.
    pub queries: usize,
    /// How often the points were replaced by what left.
    pub passes: u32,
    /// Iterations of all queries.
    pub iterations: u64,
    /// Most iterations of a query.
    pub iterations_max: u32,
    /// Queries that were not done, but had no iteration left.
    pub capped: usize,
    /// Queries that say they are not valid, if the program says so.
    pub invalid: Option<usize>,
    /// Neighbors of all queries, in their last iteration, where they were counted.
    pub neighbors: Option<u64>,
    /// Queries without a neighbor, where neighbors were counted.
    pub lonely: Option<usize>,
    /// What each program took, in the order in which they ran, if time was counted.
    pub timings: Vec<Timing>,
    /// The settings of each program.
    pub settings: Vec<(String, Vec<Setting>)>,
    /// Where the fields come from.
    pub attributes: Vec<(String, String)>,
}

impl Summary {
    /// Notes where a field comes from, once.
    pub(super) fn note(&mut self, bound: &Bound) {
        let line = (bound.name.clone(), bound.from.clone());
        if !self.attributes.contains(&line) {
            self.attributes.push(line);
        }
    }
}

impl Processed {
    /// What left, in the last program's words.
    #[must_use]
    pub fn answers(&self) -> &[super::Answer] {
        self.stages.last().map_or(&[], |stage| &stage.answers)
    }

    /// The column of that name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }
}

impl Numbers {
    /// Number of them.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::Double(numbers) => numbers.len(),
            Self::Float(numbers) => numbers.len(),
            Self::Int(numbers) => numbers.len(),
            Self::Bool(numbers) => numbers.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One of them.
    ///
    /// # Panics
    /// If there are not as many.
    #[must_use]
    pub fn number(&self, index: usize) -> f64 {
        match self {
            Self::Double(numbers) => numbers[index],
            Self::Float(numbers) => numbers[index].into(),
            Self::Int(numbers) => numbers[index].into(),
            Self::Bool(numbers) => f64::from(u8::from(numbers[index])),
        }
    }
}
