//! What can be wrong with a scene or a model: every message names the file, the place in it and the remedy.

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
}
