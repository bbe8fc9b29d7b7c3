//! The subcommands of `pointcore` and what they share.

pub mod bench;
pub mod configuration;
pub mod generate;
pub mod inspect;
pub mod knn;
pub mod plan;
pub mod progress;
pub mod run;

use pointcore::core_a::GenerateError;
use pointcore::core_b::{Difference, Error as SearchError};
use pointcore::float_check::FloatCheckError;
use pointcore::lockstep::LockstepError;
use pointcore::picture::PictureError;
use pointcore::plan::{Plan, PlanError};
use pointcore::scene::{Scene, SceneError};
use pointcore::verilated::VerilatedError;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// How results are printed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Output {
    /// For people.
    Text,
    /// For machines.
    Json,
}

impl Output {
    /// Prints a result: `value` as JSON, or `text`.
    pub fn print(self, value: &impl Serialize, text: &str) {
        match self {
            Self::Json => println!("{}", serde_json::to_string_pretty(value).expect("results have string keys")),
            Self::Text => println!("{}", text.trim_end()),
        }
    }
}

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The scene or a model.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The hardware a scene asks for.
    #[error("{}: {source}", path.display())]
    Plan {
        /// The scene file.
        path: PathBuf,
        /// What is wrong with its overrides.
        source: PlanError,
    },
    /// A configuration file.
    #[error("{}: {problem}", path.display())]
    Configuration {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
    },
    /// Arguments that do not go together.
    #[error("{0}")]
    Usage(String),
    /// A fault of the generator.
    #[error("the hardware could not be generated: {0}")]
    Generate(#[from] GenerateError),
    /// Verilator, the compiler, or an assertion in the hardware.
    #[error(transparent)]
    Verilated(#[from] VerilatedError),
    /// Hardware and model differ, or the run did not end.
    #[error(transparent)]
    Mismatch(#[from] LockstepError),
    /// A neighbor search.
    #[error(transparent)]
    Search(#[from] SearchError),
    /// Neighbors that are not the nearest.
    #[error("{0}")]
    Neighbors(Difference),
    /// Operators that could not be compared.
    #[error(transparent)]
    Operators(#[from] FloatCheckError),
    /// A result that cannot be written.
    #[error("{}: cannot be written: {source}", path.display())]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A picture that cannot be written.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// Loads a scene and derives its hardware.
pub fn load(path: &Path, settings: &[String]) -> Result<(Scene, Plan), Failure> {
    let scene = Scene::load(path, settings)?;
    let plan = Plan::of(&scene).map_err(|source| Failure::Plan { path: path.to_owned(), source })?;
    Ok((scene, plan))
}

/// Writes a file, making its folder.
pub fn write(path: &Path, contents: &str) -> Result<(), Failure> {
    let folder = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    let written = folder.and_then(|()| std::fs::write(path, contents));
    written.map_err(|source| Failure::Write { path: path.to_owned(), source })
}

/// A scene's name: its file without folder and ending.
pub fn scene_name(path: &Path) -> String {
    path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}
