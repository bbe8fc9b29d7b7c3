//! What measures the project: figures of both cores, accuracy, stability, area and clock, operators, and the charts of all of them.

pub mod accuracy;
pub mod bench;
pub mod chart;
pub mod diagram;
mod error;
pub mod float_check;
pub mod front;
pub mod marks;
pub mod motion;
pub mod mutation;
pub mod note;
pub mod soak;
pub mod stability;
pub mod synthesis;

pub use error::LabError;

use pointcore_tb::cache::file;
use serde_json::{Map, Value};
use std::path::Path;

/// Figures by key.
pub type Figures = Map<String, Value>;

/// Writes a text file of results, making its folder.
fn write(path: &Path, contents: &str) -> Result<(), LabError> {
    let folder = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    Ok(folder.and_then(|()| std::fs::write(path, contents)).map_err(file("write", path))?)
}
