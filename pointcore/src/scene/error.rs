//! What can be wrong with a scene or a model: every message names the file, the place in it and the remedy.

use super::model::COORDINATE_LIMIT;
use std::path::{Path, PathBuf};

/// A scene or model that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// A file that cannot be read.
    #[error("{}: cannot be read: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A scene file that is not TOML, or lacks, misspells or mistypes a key.
    #[error("{}: {message}", path.display())]
    Syntax {
        /// The scene file.
        path: PathBuf,
        /// Line, column and what was expected there.
        message: String,
    },
    /// A key of the scene whose value makes no sense.
    #[error("{}: `{key}` {problem}", path.display())]
    Value {
        /// The scene file.
        path: PathBuf,
        /// The key, with its table and index.
        key: String,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// A setting from the command line that does not fit the scene.
    #[error("setting `{setting}`: {problem}")]
    Setting {
        /// The setting as given.
        setting: String,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// A point of a model that is nowhere.
    #[error(
        "{}: vertex {index} lies at {point:?}: coordinates must be finite and below {COORDINATE_LIMIT:e}{remedy}", path.display()
    )]
    Point {
        /// The model file.
        path: PathBuf,
        /// The point's place in it.
        index: usize,
        /// The point.
        point: [f64; 3],
        /// How whoever reads the file has such points left out, after a semicolon; may be empty.
        remedy: &'static str,
    },
    /// A model file that does not hold usable points.
    #[error("{}: {problem}", path.display())]
    Model {
        /// The model file.
        path: PathBuf,
        /// Where in it, what is wrong, and what would be right.
        problem: String,
    },
}

impl SceneError {
    pub(crate) fn model(path: &Path, problem: impl Into<String>) -> Self {
        Self::Model { path: path.to_owned(), problem: problem.into() }
    }

    /// The same error; if it is about a point that is no number, with what leaves such points out.
    #[must_use]
    pub fn remedied(self, remedy: &'static str) -> Self {
        match self {
            Self::Point { path, index, point, .. } => Self::Point { path, index, point, remedy },
            other => other,
        }
    }
}
