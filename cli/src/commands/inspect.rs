//! `pointcore inspect MODEL`.

use super::{Failure, Output};
use serde_json::json;
use std::path::PathBuf;

/// Arguments of `inspect`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A file of points: PLY, OBJ, glTF, PCD, LAS, LAZ, XYZ or CSV.
    model: PathBuf,
}

/// Describes a model.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let inspection = pointcore::inspect::inspect(&arguments.model)?;
    let [low, high] = inspection.bounds.map(|corner| corner.to_array());
    let spacing = inspection.spacing;
    let spacing = spacing.map(|[least, mean, greatest]| json!({ "least": least, "mean": mean, "greatest": greatest }));
    let document = json!({
        "path": inspection.path,
        "points": inspection.points,
        "invalid": inspection.invalid,
        "repeated": inspection.repeated,
        "triangles": inspection.triangles,
        "colors": inspection.colors,
        "bounds": { "low": low, "high": high },
        "normals": inspection.normals.to_string(),
        "spacing": spacing,
    });
    output.print(&document, &inspection.to_string())
}
