//! What accuracy costs in time and hardware (docs/accuracy.md): a sweep over the knobs that trade one for another, each point rendered on
//! the renderer and compared with a truth of 16 samples a pixel.

pub mod chart;
pub mod choice;
pub mod figures;
mod measure;
pub mod neighbors;
pub mod page;
pub mod point;
pub mod sweep;
pub mod table;

use crate::synthesis::AreaRecord;
use pointcore::area::estimate::Estimator;
use pointcore::generated::GenerateError;
use pointcore::picture::PictureError;
use pointcore::plan::PlanError;
use pointcore::scene::SceneError;
use pointcore_tb::cache::{Cache, FileError, file, key};
use pointcore_tb::lockstep::LockstepError;
use pointcore_tb::verilated::VerilatedError;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};

/// What an entry of the cache holds of its point, besides pictures.
const RESULT: &str = "figures.json";

/// Keeps a result in an entry's folder.
fn write_result(folder: &Path, result: &impl Serialize) -> Result<(), AccuracyError> {
    let path = folder.join(RESULT);
    let text = serde_json::to_string_pretty(result).expect("results have string keys");
    Ok(std::fs::write(&path, text).map_err(file("write", &path))?)
}

/// The result in an entry's folder.
fn read_result<T: DeserializeOwned>(folder: &Path) -> Result<T, AccuracyError> {
    let path = folder.join(RESULT);
    let text = std::fs::read_to_string(&path).map_err(file("read", &path))?;
    serde_json::from_str(&text).map_err(|error| AccuracyError::Damaged { path, problem: error.to_string() })
}

/// What a record of areas says of configurations that are not in it, where `text` is the record's; looking through its units takes a
/// while, so that is kept.
///
/// # Errors
/// It cannot be kept or read.
pub fn kept_estimator(record: &AreaRecord, text: &str, cache: &Cache) -> Result<Estimator, AccuracyError> {
    let content = key(["estimator", sweep::SOURCES, text]);
    read_result(&cache.entry(&content, |folder| write_result(folder, &record.estimator()))?)
}

/// Why a point could not be measured.
#[derive(Debug, thiserror::Error)]
pub enum AccuracyError {
    /// The scene, or what a setting makes of it.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The hardware that a setting asks for.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A fault of the generator.
    #[error("the hardware could not be generated: {0}")]
    Generate(#[from] GenerateError),
    /// Verilator, the compiler, or an assertion in the hardware.
    #[error(transparent)]
    Verilated(#[from] VerilatedError),
    /// Hardware and model differ, or the run did not end.
    #[error(transparent)]
    Lockstep(#[from] LockstepError),
    /// A neighbor search.
    #[error(transparent)]
    Search(#[from] pointcore::search::SearchError),
    /// Neighbors that are not the nearest, as far as they may differ.
    #[error("{0}")]
    Neighbors(pointcore::search::WrongAnswer),
    /// A picture that cannot be written.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A file of the cache.
    #[error(transparent)]
    File(#[from] FileError),
    /// A kept result that is none of ours.
    #[error("{}: {problem}; delete it to measure the point again", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
    },
}
