//! What accuracy costs in time and hardware (docs/accuracy.md): a sweep over the knobs that trade one for another, each point rendered on
//! the renderer and compared with a truth of 16 samples a pixel.

pub mod choice;
pub mod figures;
mod measure;
pub mod neighbors;
pub mod page;
pub mod point;
pub mod product;
pub mod sweep;
pub mod table;

use crate::LabError;
use crate::synthesis::AreaRecord;
use pointcore::area::estimate::Estimator;
use pointcore::area::recorded::RECORD;
use pointcore::configuration::read_text;
use pointcore_tb::cache::{Cache, file, key};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::Path;

/// What an entry of the cache holds of its point, besides pictures.
const RESULT: &str = "figures.json";

/// Keeps a result in an entry's folder.
pub(crate) fn write_result(folder: &Path, result: &impl Serialize) -> Result<(), LabError> {
    let path = folder.join(RESULT);
    let text = serde_json::to_string_pretty(result).expect("results have string keys");
    Ok(std::fs::write(&path, text).map_err(file("write", &path))?)
}

/// The result in an entry's folder.
pub(crate) fn read_result<T: DeserializeOwned>(folder: &Path) -> Result<T, LabError> {
    let path = folder.join(RESULT);
    let text = std::fs::read_to_string(&path).map_err(file("read", &path))?;
    serde_json::from_str(&text).map_err(|error| LabError::Damaged { path, problem: error.to_string() })
}

/// What a record of areas says of configurations that are not in it; the project's own if there is no such file. Looking through its
/// units takes a while, so what it says is kept.
///
/// # Errors
/// The file is no record, or what it says cannot be kept or read.
pub fn estimator(record: &Path, cache: &Cache) -> Result<Estimator, LabError> {
    let text = if record.exists() { read_text(record)? } else { RECORD.to_owned() };
    let loaded = AreaRecord::parse(record, &text)?;
    let content = key(["estimator of known units", sweep::SOURCES, &text]);
    read_result(&cache.entry(&content, |folder| write_result(folder, &loaded.estimator()))?)
}
