//! What can be wrong with a program, its settings and its points.

use super::NEIGHBORS_LIMIT;
use super::attributes::spelled;
use crate::generated::GenerateError;
use crate::scene::SceneError;
use crate::search::SearchError;
use pointcore_contract::process::{ConfigError, Field, ProgramError};
use std::path::PathBuf;

/// An operator that cannot be carried out.
#[derive(Debug, thiserror::Error)]
pub enum ProcessError {
    /// The points.
    #[error(transparent)]
    Points(#[from] SearchError),
    /// A model file.
    #[error(transparent)]
    Model(#[from] SceneError),
    /// A program file that is not there.
    #[error("{}: cannot be read: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A text that is no program.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// An operation of another name.
    #[error("there is no operation `{name}`: expected {}, or a file by --program", known.join(", "))]
    Operation {
        /// The name.
        name: String,
        /// The names that there are.
        known: Vec<&'static str>,
    },
    /// A program that the hardware has no room for.
    #[error(transparent)]
    Config(#[from] ConfigError),
    /// A setting that no program has.
    #[error("`{program}` has no setting `{name}`: its settings are {}", listed(known))]
    UnknownSetting {
        /// The operation.
        program: String,
        /// The name.
        name: String,
        /// Those that there are, with their types.
        known: Vec<String>,
    },
    /// A setting or field whose value does not fit.
    #[error("{what} `{name}` of `{program}` {problem}")]
    Value {
        /// A setting, or a field.
        what: &'static str,
        /// The operation.
        program: String,
        /// Its name.
        name: String,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// A setting that the points say nothing about.
    #[error("setting `{}` of `{program}` does not follow from the points: give --set {}={}", field.name, field.name, example(field))]
    MissingSetting {
        /// The program.
        program: String,
        /// The setting.
        field: Field,
    },
    /// A field that no attribute of the points gives.
    #[error(
        "{points}: `{program}` reads {whose}.{} ({}), but there is no {}: --attribute {}={} gives all points one value",
        field.name, field.ty, spelled(field), field.name, example(field)
    )]
    MissingAttribute {
        /// The points, as the user calls them.
        points: String,
        /// The operation.
        program: String,
        /// The query's, or the neighbor's.
        whose: &'static str,
        /// The field.
        field: Field,
    },
    /// A constant for a field that no program reads.
    #[error("`{program}` reads no field `{name}`: its fields are {}", listed(known))]
    UnknownAttribute {
        /// The operation.
        program: String,
        /// The name.
        name: String,
        /// Those that there are, with their types.
        known: Vec<String>,
    },
    /// Numbers for a field that an earlier program of the operation finds.
    #[error(
        "attribute `{name}` of `{program}` is what its program `{finder}` finds: expected none to be given, or `{reader}` alone"
    )]
    Found {
        /// The operation.
        program: String,
        /// The field.
        name: String,
        /// The program that finds it.
        finder: String,
        /// The program that reads it.
        reader: String,
    },
    /// An attribute of a point that is no number of the program's.
    #[error("{points}: {name} of vertex {index} {problem}; --attribute {name}=VALUE gives all points one value")]
    Attribute {
        /// The points, as the user calls them.
        points: String,
        /// The field.
        name: String,
        /// The point's place in its file.
        index: u32,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// Points without a spacing from which settings are derived.
    #[error(
        "{points}: all points lie in one place, so there is no spacing to derive `{setting}` from: give --radius, or --set {setting}=NUMBER"
    )]
    NoScale {
        /// The points, as the user calls them.
        points: String,
        /// The setting that needs it.
        setting: String,
    },
    /// A number of neighbors beyond the hardware.
    #[error("k is {0}: expected 1 to {NEIGHBORS_LIMIT}")]
    Neighbors(u32),
    /// A number of iterations beyond the hardware.
    #[error("{0} iterations: expected 1 to {limit}", limit = super::ITERATIONS_LIMIT)]
    Iterations(u32),
    /// Passes over points that an operation does not move.
    #[error("{passes} passes of `{program}`, which has no output `position`: expected an operation that moves points")]
    Passes {
        /// The operation.
        program: String,
        /// How many passes.
        passes: u32,
    },
    /// Queries that a later program of an operation cannot be given.
    #[error("`{0}` asks all points in their order: expected no other queries")]
    Queries(String),
    /// A fault of the generator.
    #[error("the hardware could not be generated: {0}")]
    Generate(#[from] GenerateError),
}

/// What a value of a field looks like.
const fn example(field: &Field) -> &'static str {
    if field.ty.words() > 1 { "X,Y,Z" } else { "NUMBER" }
}

/// Names in a row.
fn listed(names: &[String]) -> String {
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}
